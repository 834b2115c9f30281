//! Breaks ties by moving both parts by less than the resolution, and retrying.
//!
//! Where more events coincide at one place than rounding can order (a corner that passes over a pivot, sides along which two slides go at
//! once), the partition contradicts itself. It is then recomputed with the parts moved by a length below any measurement, in directions
//! that no drawing has. That length is included in the resolution.

use super::motion::Motion;
use crate::geometry::{Point, Rotation, Vector};
use crate::part::{Part, Vertex};
use core::f64::consts::TAU;

/// Displacement of the parts, as the number of the attempt. The first attempt does not displace them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Displacement(u8);

/// The golden ratio: no two directions or lengths are in a simple ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Displacement {
    /// Displacement of the parts in each attempt, in the pair's frame: first none, then more than the tolerance for one place, then larger
    /// ones.
    const LENGTHS: [f64; 6] = [0.0, 1e-10, 1e-9, 1e-9, 4e-9, 4e-9];

    /// No displacement.
    pub(super) const NONE: Self = Self(0);

    /// All other displacements, in the order in which they are tried.
    pub(super) fn others() -> impl Iterator<Item = Self> {
        (1..Self::LENGTHS.len() as u8).map(Self)
    }

    pub(super) fn is_none(&self) -> bool {
        self.length() == 0.0
    }

    fn length(self) -> f64 {
        Self::LENGTHS[usize::from(self.0) % Self::LENGTHS.len()]
    }

    /// Displacement of the outlines of the first and of the second part.
    pub(super) fn shifts(self) -> (Vector, Vector) {
        let along = |turns: f64| Vector::from_angle(TAU * GOLDEN * turns) * self.length();
        let attempt = f64::from(self.0);
        (along(attempt) * GOLDEN, along(attempt + 0.3))
    }

    /// The motion with its direction tilted; for the second part in the opposite sense.
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

    /// The second part turned about a point by as much: sides that were parallel at every position no longer are.
    ///
    /// `None` if it is not turned, or if the turned loops are not a part, which rounding can bring about.
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
        part.redrawn(loops.collect()).ok()
    }

    /// Largest displacement of a place of one part in the other's frame, for slides up to a given length.
    pub(super) fn deviation(self, slide: f64) -> f64 {
        (2.0 + GOLDEN) * self.length() * (1.0 + slide)
    }
}
