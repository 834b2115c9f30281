//! A part at a place.

use cspace::{Part, Point, Vector};

use super::pose::Placed;

/// A part at a place.
pub(super) struct At<'a> {
    pub(super) part: &'a Part,
    pub(super) placed: Placed,
    /// Origin of the placed frame, as a point of the part's own: points of the first are those of the second less this.
    pub(super) origin: Vector,
}

impl At<'_> {
    /// Where a point of the part is.
    pub(super) fn out(&self, q: Point) -> Point {
        self.placed.point(q - self.origin).at
    }

    /// The point of the part that is at a place.
    pub(super) fn back(&self, p: Point) -> Point {
        self.placed.back(p) + self.origin
    }
}
