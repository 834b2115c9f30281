//! A piece of a way through free space.

use crate::legs::Coords;

/// A piece of a way, run through by a parameter from 0 to 1.
pub(crate) trait Piece {
    /// The configuration at a parameter. A piece along a surface keeps off it, as far as there is room, times a share of that
    /// height.
    fn at(&self, s: f64, height: f64) -> Coords;
}

/// A straight piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Straight {
    pub(super) from: Coords,
    pub(super) to: Coords,
}

impl Piece for Straight {
    fn at(&self, s: f64, _: f64) -> Coords {
        along(self.from, self.to, s)
    }
}

/// The configuration at a share of a leg.
pub(crate) fn along(from: Coords, to: Coords, s: f64) -> Coords {
    core::array::from_fn(|k| from[k] + (to[k] - from[k]) * s)
}
