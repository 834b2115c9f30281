//! The two bodies, for honest tests of overlap.

use crate::contact::{Body, overlap};

use super::motion::Motions;

/// Both parts, ready to be placed.
#[derive(Debug)]
pub(super) struct Bodies {
    pub(super) first: Body,
    pub(super) second: Body,
    pub(super) motions: Motions,
}

impl Bodies {
    /// Whether the parts overlap at (x, y). Certain away from contact.
    pub(super) fn overlap(&self, x: f64, y: f64) -> bool {
        let (p, theta) = self.motions.relative(x, y);
        overlap(&self.first, &self.second, p, theta)
    }
}
