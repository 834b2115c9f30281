//! The curve of a sheet at one orientation in double-double: places on it, and crossings.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::Dd;

use super::super::cycle::Cycle;

/// The curve of a sheet at one orientation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactCurve {
    pub(super) cycle: Cycle<Dd>,
    pub(super) start: Point<Dd>,
    pub(super) end: Point<Dd>,
    /// The place of its middle; of a circle by its centre the direction to about there, of length about one.
    pub(super) middle: Vector<Dd>,
}

/// A crossing of two curves.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactCrossing {
    /// Where it is on the first curve: a place of its cycle.
    pub(crate) on: Vector<Dd>,
    pub(crate) point: Point<Dd>,
    pub(crate) enters: bool,
}

impl ExactCurve {
    /// Length of travel from about the middle of the curve to a place of its cycle.
    pub(crate) fn length_of(&self, place: Vector<Dd>) -> Dd {
        if self.cycle.is_centred() {
            let (x, y) = (self.middle.dot(place), self.middle.cross(place));
            return Dd::atan2(y, x) * self.cycle.radius();
        }
        place.x - self.middle.x
    }

    /// What grows with the length of travel to a place: see [`Cycle::rank`].
    pub(crate) fn rank(&self, place: Vector<Dd>) -> Dd {
        self.cycle.rank(place, self.middle)
    }

    /// The places of its ends.
    pub(crate) fn ends(&self) -> (Dd, Dd) {
        self.ends_by(|v| self.length_of(v))
    }

    /// The ends by a number that grows with the length of travel, and is its negative as far before the middle.
    fn ends_by(&self, number: impl Fn(Vector<Dd>) -> Dd) -> (Dd, Dd) {
        let [start, end] = [self.start, self.end].map(|p| number(self.cycle.place(p)));
        // All of a circle ends where it starts, half a turn from the middle.
        if !self.cycle.is_centred() || start <= end {
            (start, end)
        } else if start.abs() > end.abs() {
            (-start.abs(), end)
        } else {
            (start, end.abs())
        }
    }

    /// Whether a place of its cycle is between its ends.
    pub(super) fn holds(&self, place: Vector<Dd>) -> bool {
        let (rank, (lo, hi)) = (self.rank(place), self.ends_by(|v| self.rank(v)));
        lo < rank && rank < hi
    }

    /// The point at a length of travel from about the middle.
    pub(crate) fn point(&self, length: Dd) -> Point<Dd> {
        if !self.cycle.is_centred() {
            let place = Vector::new(length + self.middle.x, Dd::ZERO);
            return self.cycle.at(place);
        }
        let way = Rotation::by(length / self.cycle.radius()) * self.middle;
        self.cycle.through + way * (self.cycle.size / way.length())
    }

    /// Where it starts and ends.
    pub(crate) fn end_points(&self) -> [Point<Dd>; 2] {
        [self.start, self.end]
    }

    /// All of its line or circle.
    pub(crate) fn cycle(&self) -> &Cycle<Dd> {
        &self.cycle
    }

    /// Whether a point beside it is on its free side; `None` of a point beyond its ends.
    pub(crate) fn is_free(&self, p: Point<Dd>) -> Option<bool> {
        self.holds(self.cycle.place(p))
            .then(|| !self.cycle.level(p).is_negative())
    }

    /// The crossing with the given name, wherever it lies on the lines or circles.
    pub(crate) fn crossing(&self, other: &Self, root: u8) -> Option<ExactCrossing> {
        /// Lines at a smaller angle are parallel (radians).
        const PARALLEL: f64 = 1e-28;
        let (f, g) = (&self.cycle, &other.cycle);
        let (on, enters) = f.crossing(g, root, PARALLEL)?;
        Some(ExactCrossing {
            on,
            point: f.at(on),
            enters,
        })
    }

    /// How far outward along a direction from a point its line or circle lies, near that point and at right angles to it.
    pub(crate) fn height(&self, p: Point<Dd>, outward: Vector<Dd>) -> Dd {
        -self.cycle.distance(p) / self.cycle.normal_at(p).dot(outward)
    }
}
