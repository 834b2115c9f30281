//! Ties broken: both parts displaced a little from where they are drawn.
//!
//! Where more happens at one place than rounding can put in order (a corner that passes over a pivot, sides along which
//! two slides go at once), the partition contradicts itself. It is made again then with the parts moved by less than
//! anybody measures, in directions that no drawing has. How far that is belongs to the resolution.

use super::motion::Motion;
use crate::geometry::{Point, Rotation, Vector};
use crate::part::{Part, Vertex};
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
