//! Everything about a pair of parts that does not depend on the orientation.

use crate::feature::{Outline, PairFrame};
use crate::geometry::{Point, Rotation};
use crate::part::Part;

use super::build::{Contacts, Span};
use super::overlap::{Body, overlap};

/// A pair in its own frame: outlines, sheets of contact, and the bodies for tests of overlap.
#[derive(Debug)]
pub(crate) struct Geometry {
    pub(crate) frame: PairFrame,
    pub(crate) fixed: Outline,
    pub(crate) moving: Outline,
    pub(crate) contacts: Contacts,
    fixed_body: Body,
    moving_body: Body,
}

impl Geometry {
    /// Prepares a pair. `window` of `None` is the full turn.
    pub(crate) fn new(fixed_part: &Part, moving_part: &Part, window: Option<(f64, f64)>) -> Self {
        let frame = PairFrame::new(fixed_part, moving_part);
        let fixed = Outline::new(fixed_part, frame.fixed_center, frame.scale, true);
        let moving = Outline::new(moving_part, frame.moving_center, frame.scale, false);
        let fixed_body = Body::new(&fixed, fixed_part, frame.fixed_center, frame.scale);
        let moving_body = Body::new(&moving, moving_part, frame.moving_center, frame.scale);
        let span = match window {
            Some((lo, hi)) => Span {
                lo,
                hi,
                full: false,
            },
            None => Span::full_turn(&fixed, &moving),
        };
        let contacts = Contacts::new(&fixed, &moving, span);
        Self {
            frame,
            fixed,
            moving,
            contacts,
            fixed_body,
            moving_body,
        }
    }

    pub(crate) fn fixed_part(&self) -> &Part {
        self.fixed_body.part()
    }

    pub(crate) fn moving_part(&self) -> &Part {
        self.moving_body.part()
    }

    /// Whether the parts overlap with the moving one at `p` in the pair's frame.
    pub(crate) fn overlaps(&self, p: Point, theta: f64) -> bool {
        overlap(&self.fixed_body, &self.moving_body, p, theta)
    }

    /// Where the centre of the moving part's inscribed disc meets that of the fixed part, and how near is blocked.
    pub(crate) fn core(&self, turn: Rotation) -> (Point, f64) {
        let ((a, ra), (b, rb)) = (self.fixed.disc, self.moving.disc);
        (a + (-(turn * b.to_vector())), ra + rb)
    }
}
