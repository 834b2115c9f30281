//! What is needed to draw the plane of the motions.

use core::f64::consts::TAU;

use super::space::FixedAxesSpace;

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
