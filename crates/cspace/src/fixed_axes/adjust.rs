//! Arcs that are all but straight, taken for their chords.
//!
//! Where a line touches an arc of radius r, or a large arc another, the place is told by the angle between them, and so known
//! to some ε r, which is more than the arc is off its chord, b c / 2 for the bulge b and the chord c with r = c / 4b, if b² is
//! less than some ε.

use super::motion::Motion;
use crate::geometry::Point;
use crate::geometry::Rotation;
use crate::geometry::Vector;
use crate::part::Part;
use crate::part::Vertex;
use core::f64::consts::TAU;

/// Arcs with bulges below this, sweeps of less than 2·10⁻⁷ rad, are taken for lines: √(9 ε).
const STRAIGHT: f64 = 4.5e-8;

/// The part with such arcs straight, and how far that is from the part as drawn, in the model's unit of length. `None` if
/// there are no such arcs, or if nothing but them kept its loops apart.
pub(super) fn straightened(part: &Part) -> Option<(Part, f64)> {
    let is_straight = |bulge: f64| bulge != 0.0 && bulge.abs() < STRAIGHT;
    let deviation = (part.edges())
        .filter(|e| is_straight(e.bulge))
        .map(|e| 0.5 * e.bulge.abs() * e.start.distance(e.end))
        .reduce(f64::max)?;
    let vertex = |v: &Vertex| {
        let bulge = if is_straight(v.bulge) { 0.0 } else { v.bulge };
        Vertex::new(v.x, v.y, bulge)
    };
    let loops = part.loops().iter();
    let loops = loops.map(|l| l.vertices().iter().map(vertex).collect());
    let straight = Part::new(part.name(), loops.collect()).ok()?;
    Some((straight, deviation))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn only_arcs_that_rounding_makes_straight_are() {
        let part = |bulge: f64| {
            let corners = [(0.0, 0.0, bulge), (2.0, 0.0, 0.0), (1.0, 2.0, 0.0)];
            let corners = corners.map(|(x, y, b)| Vertex::new(x, y, b));
            Part::new("part", vec![corners.to_vec()]).unwrap()
        };
        assert!(straightened(&part(0.0)).is_none());
        assert!(straightened(&part(-1e-7)).is_none());
        let (straight, deviation) = straightened(&part(-1e-8)).unwrap();
        assert_eq!(straight, part(0.0));
        // The height of the arc above its chord.
        assert!((deviation - 1e-8).abs() < 1e-20);
    }
}

// Ties broken: both parts a hair aside of where they are drawn.
//
// Where more happens at one place than rounding can put in order (a corner that passes over a pivot, sides along which
// two slides go at once), the partition contradicts itself. It is made again then with the parts moved by less than
// anybody measures, in directions that no drawing has. How far that is belongs to the resolution.

/// How often a partition has been made before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Aside(u8);

/// The golden section: no two directions or lengths are in a simple ratio.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Aside {
    /// How far the parts are moved at each attempt, in the pair's frame: first not at all, then by more than what is taken
    /// for one place, and further where that does not do.
    const LENGTHS: [f64; 6] = [0.0, 1e-10, 1e-9, 1e-9, 1e-8, 1e-8];

    /// One attempt after the other, but for the first.
    pub(super) fn attempts() -> impl Iterator<Item = Self> {
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
