//! A part at a place.

use std::ops::Range;

use cspace::{Part, Point, Vector};

use super::pose::Placed;

/// A part at a place.
pub(super) struct At<'a> {
    pub(super) part: &'a Part,
    pub(super) placed: Placed,
    /// Origin of the placed frame, as a point of the part's own: points of the first are those of the second less this.
    pub(super) origin: Vector,
}

/// Two layers that meet, with the numbers of their loops in the parts.
pub(super) struct Layers<'a> {
    pub(super) a: At<'a>,
    pub(super) b: At<'a>,
    pub(super) loops: (Range<usize>, Range<usize>),
}

/// Whether something holds of any two layers of placed parts that meet.
pub(super) fn any_layers(
    a: &At<'_>,
    b: &At<'_>,
    mut holds: impl FnMut(&Layers<'_>) -> bool,
) -> bool {
    let meeting = a.part.meeting_layers(b.part);
    meeting.into_iter().any(|(i, j)| {
        let (first, second) = (a.part.layer(i), b.part.layer(j));
        holds(&Layers {
            a: At { part: &first, ..*a },
            b: At {
                part: &second,
                ..*b
            },
            loops: (a.part.layers()[i].loops(), b.part.layers()[j].loops()),
        })
    })
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
