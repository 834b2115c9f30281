//! The line or circle of a sheet's curve at every orientation, and the curve's ends, in numbers of any kind.

use crate::geometry::{Point, Rotation};
use crate::number::Real;

use super::carrier::Carrier;
use super::spiral::Spiral;

/// A line or circle that moves with orientation, and the two ends of the curve on it. A line is given by the curve's start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Locus<T = f64> {
    pub(crate) carrier: Carrier<T>,
    pub(crate) start: Spiral<T>,
    pub(crate) end: Spiral<T>,
}

impl<T: Real> Locus<T> {
    /// Start and end of the curve at an orientation.
    #[inline(always)]
    pub(crate) fn ends(&self, turn: Rotation<T>) -> [Point<T>; 2] {
        [self.start, self.end].map(|p| p.at(turn))
    }
}

impl Locus {
    /// The locus in a frame that does not turn and whose origin is a moving point.
    pub(crate) fn about(&self, origin: &Spiral) -> Self {
        Self {
            carrier: self.carrier.about(origin),
            start: self.start.about(origin),
            end: self.end.about(origin),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
pub(super) mod tests;
