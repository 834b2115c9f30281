//! Index of ranges of a coordinate.

use super::motion::Extent;
use super::tolerance::NEAR;
use crate::boxes::{Boxes, Volume};
use core::f64::consts::TAU;

/// Lower and upper end.
type Range = (f64, f64);

impl Volume for Range {
    const EMPTY: Self = (f64::INFINITY, f64::NEG_INFINITY);

    fn with(self, other: Self) -> Self {
        (self.0.min(other.0), self.1.max(other.1))
    }

    fn middle(&self) -> [f64; 3] {
        [0.5 * (self.0 + self.1), 0.0, 0.0]
    }
}

/// Ranges by number.
#[derive(Debug)]
pub(super) struct Ranges {
    circle: bool,
    tree: Boxes<Range>,
}

impl Ranges {
    pub(super) fn new(extent: Extent, ranges: impl Iterator<Item = Range>) -> Self {
        Self {
            circle: extent.is_circle(),
            tree: Boxes::new(ranges),
        }
    }

    /// Whether `hit` is true for a range that overlaps an interval, extended by rounding; on a circle also after shifts by whole turns.
    /// Stops at the first.
    pub(super) fn any(&self, lo: f64, hi: f64, hit: impl FnMut(u32) -> bool) -> bool {
        let reaches = |&(from, to): &Range| {
            let turn = if self.circle {
                TAU * ((from - NEAR - hi) / TAU).ceil()
            } else {
                0.0
            };
            from - NEAR <= hi + turn && lo + turn <= to + NEAR
        };
        self.tree.any(reaches, hit)
    }

    /// All ranges that overlap an interval, in order.
    pub(super) fn between(&self, lo: f64, hi: f64) -> Vec<u32> {
        let mut found = Vec::new();
        self.any(lo, hi, |i| {
            found.push(i);
            false
        });
        found.sort_unstable();
        found
    }
}
