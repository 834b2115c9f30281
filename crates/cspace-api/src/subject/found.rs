//! A configuration space that was computed or kept, and where it is from.

use cspace::PairSpace;

/// A configuration space that was computed or kept.
pub(super) struct Found {
    pub(super) space: PairSpace,
    pub(super) source: Source,
    /// How long it took, by the clock of the program that asks.
    pub(super) seconds: f64,
}

/// Where a space is from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// The file that was read.
    File,
    /// It was computed before, and kept.
    Kept,
    /// It was computed.
    Computed,
}

impl Source {
    pub(super) fn of(kept: bool) -> Self {
        match kept {
            true => Self::Kept,
            false => Self::Computed,
        }
    }
}
