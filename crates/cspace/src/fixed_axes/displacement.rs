//! Ties broken: both parts displaced a little from where they are drawn.
//!
//! Where more happens at one place than rounding can put in order (a corner that passes over a pivot, sides along which
//! two slides go at once), the partition contradicts itself. It is made again then with the parts moved by less than
//! anybody measures, in directions that no drawing has. How far that is belongs to the resolution.

use super::motion::Extent;
use super::motion::Motion;
use super::space::FixedAxesSpace;
use crate::geometry::Point;
use crate::geometry::Rotation;
use crate::geometry::Vector;
use crate::part::Part;
use crate::part::Vertex;
use core::f64::consts::TAU;

/// How the parts are displaced, as the number of the attempt. The first does not displace them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Displacement(u8);

/// The golden section: no two directions or lengths are in a simple ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Displacement {
    /// How far the parts are moved at each attempt, in the pair's frame: first not at all, then by more than what is taken
    /// for one place, and further where that does not do.
    const LENGTHS: [f64; 6] = [0.0, 1e-10, 1e-9, 1e-9, 1e-8, 1e-8];

    /// The parts where they are drawn.
    pub(super) const NONE: Self = Self(0);

    /// All others, in the order in which they are tried.
    pub(super) fn others() -> impl Iterator<Item = Self> {
        (1..Self::LENGTHS.len() as u8).map(Self)
    }

    pub(super) fn is_none(&self) -> bool {
        self.length() == 0.0
    }

    fn length(self) -> f64 {
        Self::LENGTHS[usize::from(self.0) % Self::LENGTHS.len()]
    }

    /// By which the outlines of the first and of the second part are moved.
    pub(super) fn shifts(self) -> (Vector, Vector) {
        let along = |turns: f64| Vector::from_angle(TAU * GOLDEN * turns) * self.length();
        let attempt = f64::from(self.0);
        (along(attempt) * GOLDEN, along(attempt + 0.3))
    }

    /// The motion, of which a direction is tilted: of the second part the other way.
    pub(super) fn tilted(self, motion: Motion, second: bool) -> Motion {
        match motion {
            Motion::Slide { direction } if !self.is_none() => {
                let by = if second { -GOLDEN } else { 1.0 } * self.length();
                Motion::Slide {
                    direction: Rotation::by(by) * direction,
                }
            }
            other => other,
        }
    }

    /// The second part turned about a point by as much: sides that are parallel at every position are so no more.
    ///
    /// `None` if it stays as it is, or if nothing but the last bits made it a part.
    pub(super) fn turned(self, part: &Part, about: Point) -> Option<Part> {
        if self.is_none() {
            return None;
        }
        let turn = Rotation::by(self.length());
        let vertex = |v: &Vertex| {
            let p = about + turn * (Point::new(v.x, v.y) - about);
            Vertex::new(p.x, p.y, v.bulge)
        };
        let loops = part.loops().iter();
        let loops = loops.map(|l| l.vertices().iter().map(vertex).collect());
        Part::new(part.name(), loops.collect()).ok()
    }

    /// The farthest that a place of one part is from where it should be in the other's frame, with slides of some length.
    pub(super) fn deviation(self, slide: f64) -> f64 {
        (2.0 + GOLDEN) * self.length() * (1.0 + slide)
    }
}

// Whether a partition hangs together.

/// Ends of curves that follow each other are one place within this (radians, or length of the frame): beside a tangency a
/// place is known to the square root of the rounding.
const ONE_PLACE: f64 = 1e-6;
/// An end so near to a limit is at it (radians, or length of the frame).
const AT_LIMIT: f64 = 1e-9;

impl FixedAxesSpace {
    /// The space with a conflict for each time that the partition contradicts itself: in the tests made for it, in curves that lead nowhere or to another
    /// region, in regions whose sample is blocked or that are narrower than the resolution, in gaps that hold one of the
    /// configurations at which the parts were found to overlap, in configurations that are not what the gaps say.
    pub(super) fn with_faults_counted(mut self, overlaps: &[(f64, f64)]) -> Self {
        self.data.statistics.conflicts = self.faults(overlaps);
        self
    }

    /// How often the partition contradicts itself, with the conflicts of its statistics.
    fn faults(&self, overlaps: &[(f64, f64)]) -> usize {
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

    /// How many of some configurations are not what the gaps tell. Where contact curves are lost, nothing else contradicts what is
    /// told of both their sides; and where there are none, a single test has told of the whole plane.
    fn untrue(&self) -> usize {
        // Spread evenly, in no simple ratio to anything.
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
        faults += match p.next.map(|n| &self.data.patches[n as usize]) {
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
mod contradictions_tests {
    use super::*;
    use crate::fixed_axes::Axis;
    use crate::geometry::Vector;
    use crate::part::{Part, Vertex};

    /// A square that slides up and down, and one beside it that slides to it.
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

    /// An overlap in a free gap, curves of other parts, and curves that are gone.
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
