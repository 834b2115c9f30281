//! Position of the centre of the moving part without evaluating sine and cosine, accurate enough to find a cell.

use crate::geometry::{Rotation, Vector};
use crate::space::ContactSpace;

use super::grid::{Grid, MARGIN};
use super::slab::{Home, Slab};

/// Admissible error of the centre (length of the pair's frame): patches are entered in cells a whole [`MARGIN`] away, and contact is much
/// narrower.
const OFF: f64 = 0.25 * MARGIN;

/// Centre of the moving part relative to its origin as drawn, at every orientation.
#[derive(Debug, Clone)]
pub(super) enum Centers {
    /// The part is drawn about its centre.
    Centred,
    /// The centre in the middle of each interval; the rest of the turn is computed by a series.
    BySlot(Vec<Vector>),
    /// The centre is turned by sine and cosine.
    Turned,
}

impl Centers {
    pub(super) fn new(space: &ContactSpace, grid: &Grid, slab: &Slab) -> Self {
        let center = space.data().frame.moving_center.to_vector();
        let far = center.length() * space.data().frame.scale;
        if far <= OFF {
            return Self::Centred;
        }
        // First term omitted by the series: δ⁸ / 8!.
        let half = grid.middle(0);
        if slab.count > 1 || far * half.powi(8) / 40320.0 > OFF {
            return Self::Turned;
        }
        let middle = |slot| Rotation::by(slab.lo + grid.middle(slot)) * center;
        Self::BySlot((0..grid.slots).map(middle).collect())
    }

    /// The centre at an orientation that has been reduced to an interval (model length).
    #[inline]
    pub(super) fn center(
        &self,
        space: &ContactSpace,
        grid: &Grid,
        (theta, home, slot): (f64, Home, usize),
    ) -> Vector {
        match self {
            Self::Centred => Vector::ZERO,
            Self::BySlot(middles) => {
                let d = home.from_lo - grid.middle(slot);
                let s = d * d;
                let cos = 1.0 - s / 2.0 * (1.0 - s / 12.0 * (1.0 - s / 30.0));
                let sin = d * (1.0 - s / 6.0 * (1.0 - s / 20.0 * (1.0 - s / 42.0)));
                Rotation { cos, sin } * middles[slot]
            }
            Self::Turned => Rotation::by(theta) * space.data().frame.moving_center.to_vector(),
        }
    }

    /// Number of bytes in memory, without itself.
    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::BySlot(middles) => size_of_val(middles.as_slice()),
            Self::Centred | Self::Turned => 0,
        }
    }
}
