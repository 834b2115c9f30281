//! Bounds of a distance over an interval of time.

/// Directions and places are taken to belong to a piece up to this far beyond its end (radians; parts of a length), so that
/// rounding makes no gap between one piece and the next.
pub(super) const ROUNDING: f64 = 1e-12;

/// Bounds of a distance over an interval of time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Apart {
    /// It is nowhere less.
    pub(super) least: f64,
    /// In the middle of the interval; infinite where the pieces have no common normal there.
    pub(super) here: f64,
}

impl Apart {
    pub(super) const NONE: Self = Self {
        least: f64::INFINITY,
        here: f64::INFINITY,
    };

    pub(super) fn and(self, other: Self) -> Self {
        Self {
            least: self.least.min(other.least),
            here: self.here.min(other.here),
        }
    }
}
