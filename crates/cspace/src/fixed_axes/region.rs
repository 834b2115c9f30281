//! The connected components of free space, as the user sees them.

use super::domain::Extent;
use super::domain::ExtentKind;
use super::motion::Motion;
use super::space::FixedAxesSpace;
use core::f64::consts::TAU;

/// A connected component of free space.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesRegion {
    /// A configuration (u, v) within it, between the least and greatest u and v below.
    pub sample: (f64, f64),
    /// Least and largest u, in radians or the model's unit of length; unrolled where it goes on past a turn.
    pub u: (f64, f64),
    /// Least and largest v.
    pub v: (f64, f64),
    /// Whether u goes on without limit below its least and beyond its greatest value: nothing touches there.
    pub open_u: (bool, bool),
    /// Whether v does.
    pub open_v: (bool, bool),
    /// Whether the part called fixed can turn for ever within it.
    pub around_u: bool,
    /// Whether the moving part can.
    pub around_v: bool,
}

impl FixedAxesSpace {
    /// The connected components of free space.
    pub fn regions(&self) -> Vec<AxesRegion> {
        self.bands
            .regions
            .iter()
            .map(|r| {
                let (x, open_x) = reached(r.x, &self.x, self.motions.first);
                let (y, open_y) = reached(r.y, &self.y, self.motions.second);
                let (lo, hi) = (self.map.outer(x.0, y.0), self.map.outer(x.1, y.1));
                let open = if self.map.swapped {
                    (open_y, open_x)
                } else {
                    (open_x, open_y)
                };
                let around = if self.map.swapped {
                    (r.around_y, r.around_x)
                } else {
                    (r.around_x, r.around_y)
                };
                AxesRegion {
                    sample: self.outer(r.sample.0, r.sample.1),
                    u: (lo.0, hi.0),
                    v: (lo.1, hi.1),
                    open_u: open.0,
                    open_v: open.1,
                    around_u: around.0,
                    around_v: around.1,
                }
            })
            .collect()
    }
}

impl FixedAxesSpace {
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
        let (x, y) = self.placed(u, v)?;
        if self.touching(x, y).next().is_some() {
            return None;
        }
        // Beyond the window nothing touches: a way leads straight to its border.
        let into = |t: f64, extent: &Extent| t.clamp(extent.lo, extent.hi);
        let gap = self.gap(into(x, &self.x), into(y, &self.y))?;
        self.bands.gaps.get(gap as usize).map(|g| g.region)
    }
}

/// The values of a coordinate that a region reaches, and whether it goes on without limit at either end.
fn reached(range: (f64, f64), extent: &Extent, motion: Motion) -> ((f64, f64), (bool, bool)) {
    if motion == Motion::Still {
        return ((0.0, 0.0), (false, false));
    }
    let open = extent.kind == ExtentKind::Open;
    let ends = (range.0 <= extent.lo, range.1 >= extent.hi);
    (range, (open && ends.0, open && ends.1))
}

// What is needed to draw the plane of the motions.

impl FixedAxesSpace {
    /// Least and greatest u and v of a picture: the ranges of motion, a turn, or as far as parts that slide can touch. For a
    /// part that does not move it is a strip about 0 of no meaning, so that there is something to see.
    pub fn extent(&self) -> [(f64, f64); 2] {
        let (lo, hi) = (
            self.map.outer(self.x.lo, self.y.lo),
            self.map.outer(self.x.hi, self.y.hi),
        );
        [(lo.0, hi.0), (lo.1, hi.1)]
    }

    /// Free space as polygons of points (u, v), for pictures: every side is a contact curve sampled at `points` places, or
    /// straight. On a circle a polygon may reach beyond the extent; it then comes once more, a turn lower. Along the coordinate
    /// of a part that does not move it is as wide as the extent and stands for the coordinate 0.
    pub fn free_areas(&self, points: usize) -> Vec<Vec<(f64, f64)>> {
        let graphs = self.graphs();
        let points = points.max(1);
        let mut areas = Vec::new();
        for band in &self.bands.bands {
            for gap in &self.bands.gaps[band.gaps.start as usize..band.gaps.end as usize] {
                let x = |k: usize| band.lo + (band.hi - band.lo) * k as f64 / points as f64;
                let ends: Vec<(f64, (f64, f64))> = (0..=points)
                    .map(|k| (x(k), graphs.interval(gap, x(k))))
                    .collect();
                let highest = ends.iter().map(|e| e.1.1).fold(f64::NEG_INFINITY, f64::max);
                let copies = if self.y.is_circle() && highest > self.y.hi {
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
                            .map(|(x, y)| self.map.outer(x, y))
                            .collect(),
                    );
                }
            }
        }
        areas
    }
}
