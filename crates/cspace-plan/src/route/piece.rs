//! A piece of a way through free space.

use crate::legs::Coords;

/// A piece of a way, run through by a parameter from 0 to 1.
pub(crate) trait Piece {
    /// The place at a parameter.
    fn at(&self, s: f64) -> Lifted;
}

/// A place of a way. One on a surface is lifted off it, as far as there is room.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lifted {
    /// On the surface.
    pub(super) low: Coords,
    /// Off it.
    pub(super) high: Coords,
}

impl Lifted {
    /// The configuration at a share of the height.
    pub(crate) fn at(&self, height: f64) -> Coords {
        if height == 1.0 {
            self.high
        } else {
            along(self.low, self.high, height)
        }
    }
}

/// A straight piece.
#[derive(Debug, Clone, Copy)]
pub(super) struct Straight {
    pub(super) from: Coords,
    pub(super) to: Coords,
}

impl Piece for Straight {
    fn at(&self, s: f64) -> Lifted {
        let at = along(self.from, self.to, s);
        Lifted { low: at, high: at }
    }
}

/// The configuration at a share of a leg.
pub(crate) fn along(from: Coords, to: Coords, s: f64) -> Coords {
    core::array::from_fn(|k| from[k] + (to[k] - from[k]) * s)
}
