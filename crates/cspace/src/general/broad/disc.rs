//! Discs of positions that are certainly blocked.

use crate::geometry::{Point, Vector};

/// Half the extent of a curve above which discs that cover only an end of it may be missed.
pub(crate) const LONG: f64 = 0.06;

/// Disc of positions that are certainly blocked at one orientation; it moves with the orientation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Disc {
    pub(crate) center: Point,
    /// The centre of the moving part's disc, in its frame.
    pub(crate) moving: Vector,
    pub(crate) reach: f64,
}

impl Disc {
    /// A disc that contains the part of this disc outside another: centre and radius; `None` if that part is empty.
    pub(crate) fn outside(&self, other: &Self) -> Option<(Point, f64)> {
        let off = self.center - other.center;
        let (d, r, s) = (off.length(), self.reach, other.reach);
        if d + r <= s {
            return None;
        }
        // Share of the distance from the other's centre at which the circles cross, if they do.
        let along = 0.5 * (1.0 + (s - r) * (s + r) / (d * d));
        let half_chord = (s * s - along * along * d * d).max(0.0).sqrt();
        let height = d + r - along * d;
        let radius = half_chord.max(height);
        if d >= r + s || radius.is_nan() || radius >= r {
            return Some((self.center, r));
        }
        Some((other.center + off * along, radius))
    }
}
