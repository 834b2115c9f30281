//! Free space in the plane of the motions: its regions, and its picture.

use super::motion::Extent;
use super::region::AxesRegion;
use super::setup::Setting;
use super::space::FixedAxesSpace;
use core::f64::consts::TAU;

impl FixedAxesSpace {
    /// The connected components of free space.
    pub fn regions(&self) -> Vec<AxesRegion> {
        let regions = self.data.regions.iter();
        regions.map(|r| AxesRegion::new(r, &self.setting)).collect()
    }

    /// The free region that holds a configuration, an index into [`regions`](Self::regions): two free configurations can
    /// be joined by a motion if and only if theirs is the same. `None` where the parts touch or overlap, and outside the
    /// ranges of motion.
    ///
    /// ```
    /// use cspace::{Axis, FixedAxesSpace, Part, Vector, Vertex};
    /// let square = |name: &str, x: f64| {
    ///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slide = Axis::prismatic(Vector::new(1.0, 0.0));
    /// let space = FixedAxesSpace::compute(&square("wall", 0.0)?, Axis::FIXED, &square("slider", 5.0)?, slide)?;
    /// // It cannot come to the other side of the wall.
    /// assert_ne!(space.region_at(0.0, 0.0), space.region_at(0.0, -10.0));
    /// assert_eq!(space.region_at(0.0, -5.0), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn region_at(&self, u: f64, v: f64) -> Option<u32> {
        let (x, y) = self.setting.placed(u, v)?;
        if self.is_touching(x, y) {
            return None;
        }
        // Beyond the window nothing touches: a way leads straight to its border.
        let into = |t: f64, extent: &Extent| t.clamp(extent.lo, extent.hi);
        let (x, y) = (into(x, &self.setting.x), into(y, &self.setting.y));
        self.gaps().region(x, y)
    }

    /// Least and greatest u and v of a picture: the ranges of motion, a turn, or as far as parts that slide can touch. For a
    /// part that does not move it is a strip about 0 of no meaning, so that there is something to see.
    pub fn extent(&self) -> [(f64, f64); 2] {
        let Setting { map, x, y, .. } = &self.setting;
        let (lo, hi) = (map.outer(x.lo, y.lo), map.outer(x.hi, y.hi));
        [(lo.0, hi.0), (lo.1, hi.1)]
    }

    /// Free space as polygons of points (u, v), for pictures: every side is a contact curve sampled at `points` places, or
    /// straight. On a circle a polygon may reach beyond the extent; it then comes once more, a turn lower. Along the coordinate
    /// of a part that does not move it is as wide as the extent and stands for the coordinate 0.
    pub fn free_areas(&self, points: usize) -> Vec<Vec<(f64, f64)>> {
        let graphs = self.graphs();
        let points = points.max(1);
        let mut areas = Vec::new();
        for band in &self.data.bands {
            for gap in &self.data.gaps[band.gaps.start as usize..band.gaps.end as usize] {
                let x = |k: usize| band.lo + (band.hi - band.lo) * k as f64 / points as f64;
                let ends: Vec<(f64, (f64, f64))> = (0..=points)
                    .map(|k| (x(k), graphs.interval(gap, x(k))))
                    .collect();
                let highest = ends.iter().map(|e| e.1.1).fold(f64::NEG_INFINITY, f64::max);
                let copies = if self.setting.y.is_circle() && highest > self.setting.y.hi {
                    2
                } else {
                    1
                };
                for copy in 0..copies {
                    let down = TAU * f64::from(copy);
                    let lower = ends.iter().map(|&(x, (lo, _))| (x, lo - down));
                    let upper = ends.iter().rev().map(|&(x, (_, hi))| (x, hi - down));
                    areas.push(
                        lower
                            .chain(upper)
                            .map(|(x, y)| self.setting.map.outer(x, y))
                            .collect(),
                    );
                }
            }
        }
        areas
    }
}
