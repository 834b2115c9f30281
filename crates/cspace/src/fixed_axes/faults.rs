//! Counts contradictions in a partition.

use super::motion::{Extent, Motion};
use super::space::FixedAxesSpace;

/// Distance within which ends of curves that follow each other are one place (radians, or length of the frame): beside a tangency a place
/// is known to the square root of the rounding.
const ONE_PLACE: f64 = 1e-6;
/// Distance within which an end is at a limit (radians, or length of the frame).
const AT_LIMIT: f64 = 1e-9;

impl FixedAxesSpace {
    /// Number of contradictions of the partition: conflicts of its statistics, curves that lead nowhere or to another region, regions whose
    /// sample is blocked or that are narrower than the resolution, gaps that contain a configuration at which the parts were found to
    /// overlap, and configurations whose class differs from that of the gaps.
    pub(super) fn faults(&self, overlaps: &[(f64, f64)]) -> usize {
        let curves = (0..self.data.patches.len()).map(|i| self.faults_of(i));
        let none = |(x, y): (f64, f64)| self.setting.bodies.overlap(x, y) || self.is_touching(x, y);
        let regions = self.data.regions.iter().filter(|r| none(r.sample));
        let overlooked = (overlaps.iter()).filter(|(x, y)| self.gaps().hold(*x, *y));
        self.data.statistics.conflicts
            + curves.sum::<usize>()
            + regions.count()
            + overlooked.count()
            + self.untrue()
    }

    /// Number of sample configurations whose class differs from that of the gaps. Where contact curves are missing, nothing else
    /// contradicts the class of both their sides; and where there are none, a single test has decided the whole plane.
    fn untrue(&self) -> usize {
        // Evenly distributed, in irrational ratios.
        const TRIED: u32 = 64;
        const SPREAD: (f64, f64) = (0.754_877_666_246_692_8, 0.569_840_290_998_053_3);
        let at = |e: &Extent, share: f64| e.lo + share.fract() * (e.hi - e.lo);
        (1..=TRIED)
            .map(|k| {
                let k = f64::from(k);
                (
                    at(&self.setting.x, k * SPREAD.0),
                    at(&self.setting.y, k * SPREAD.1),
                )
            })
            .filter(|&(x, y)| {
                let untrue = self.setting.bodies.overlap(x, y) == self.gaps().hold(x, y);
                untrue && !self.is_touching(x, y)
            })
            .count()
    }

    fn faults_of(&self, patch: usize) -> usize {
        let p = &self.data.patches[patch];
        let [start, end] =
            [p.branches.start, p.branches.end - 1].map(|b| self.data.branches[b as usize]);
        let inside = |(u, v): (f64, f64)| {
            let (x, y) = self.setting.map.inner(u, v);
            let still = [self.setting.motions.first, self.setting.motions.second]
                .map(|m| m == Motion::Still);
            let limit = |t: f64, e: &Extent, still: bool| {
                !e.is_circle() && (still || t - e.lo < AT_LIMIT || e.hi - t < AT_LIMIT)
            };
            !(limit(x, &self.setting.x, still[0]) || limit(y, &self.setting.y, still[1]))
        };
        let finite = [start.start, end.end].map(|(u, v)| u.is_finite() && v.is_finite());
        let mut faults = finite.iter().filter(|f| !**f).count();
        faults += usize::from(p.region.is_none());
        faults += usize::from(p.previous.is_none() && inside(start.start));
        faults += match p.next.map(|n| &self.data.patches[n.index()]) {
            None => usize::from(inside(end.end)),
            Some(next) => {
                let follows = self.data.branches[next.branches.start as usize].start;
                let (a, b) = (
                    self.setting.map.inner(end.end.0, end.end.1),
                    self.setting.map.inner(follows.0, follows.1),
                );
                let off = |s: f64, t: f64, e: &Extent| e.difference(s, t).abs();
                let apart = off(a.0, b.0, &self.setting.x).max(off(a.1, b.1, &self.setting.y));
                usize::from(apart.is_nan() || apart >= ONE_PLACE)
                    + usize::from(next.region != p.region)
            }
        };
        faults
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::fixed_axes::Axis;
    use crate::geometry::Vector;
    use crate::part::{Part, Vertex};

    /// A square that slides up and down, and a square beside it that slides towards it.
    fn squares(size: f64) -> FixedAxesSpace {
        let square = |x: f64| {
            let corners = [(x, 0.0), (x + size, 0.0), (x + size, size), (x, size)];
            let outline = corners.map(|(x, y)| Vertex::line(x, y)).to_vec();
            Part::new("square", vec![outline]).unwrap()
        };
        let slide = |x: f64, y: f64| Axis::prismatic(Vector::new(x, y)).within(-4.0, 4.0);
        let (up, along) = (slide(0.0, 1.0), slide(1.0, 0.0));
        FixedAxesSpace::compute(&square(0.0), up, &square(2.5), along).unwrap()
    }

    #[test]
    fn a_partition_that_is_right_has_no_faults() {
        for size in [1.0, 1.5, 2.0] {
            let space = squares(size);
            assert!(!space.data.patches.is_empty());
            assert_eq!(space.faults(&[]), 0, "{size}");
        }
    }

    /// Faults are counted: an overlap in a free gap, curves of other parts, and missing curves.
    #[test]
    fn faults_are_seen() {
        let mut space = squares(1.0);
        let free = space.data.regions[0].sample;
        assert_eq!(space.faults(&[free, free]), 2);
        space.setting.bodies = squares(2.0).setting.bodies;
        assert!(space.untrue() > 3);
        let mut space = squares(1.0);
        space.data.patches[0].next = None;
        assert!(space.faults(&[]) > 0);
    }
}
