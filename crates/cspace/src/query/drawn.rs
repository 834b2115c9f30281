//! Where the centre of the moving part is, well enough to find a cell: without a sine and a cosine.

use crate::geometry::{Rotation, Vector};
use crate::space::ContactSpace;

use super::grid::{Grid, MARGIN};
use super::slab::{Home, Slab};

/// The centre may be off its place by so much (length of the pair's frame): cells are entered a whole [`MARGIN`] wider, and
/// contact is far narrower.
const OFF: f64 = 0.25 * MARGIN;

/// The centre of the moving part about its origin as drawn, at every orientation.
#[derive(Debug, Clone)]
pub(super) enum Drawn {
    /// The part is drawn about its centre.
    Centred,
    /// In the middle of each slot; a little turn is made of it by a series.
    BySlot(Vec<Vector>),
    /// Turned as it is.
    Turned,
}

impl Drawn {
    pub(super) fn new(space: &ContactSpace, grid: &Grid, slab: &Slab) -> Self {
        let center = space.data.frame.moving_center.to_vector();
        let far = center.length() * space.data.frame.scale;
        if far <= OFF {
            return Self::Centred;
        }
        // The first terms that the series have not: δ⁸ / 8!, and less.
        let half = grid.middle(0);
        if slab.count > 1 || far * half.powi(8) / 40320.0 > OFF {
            return Self::Turned;
        }
        let middle = |slot| Rotation::by(slab.lo + grid.middle(slot)) * center;
        Self::BySlot((0..grid.slots).map(middle).collect())
    }

    /// The centre at an orientation, which comes home to a slot (model length).
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
            Self::Turned => Rotation::by(theta) * space.data.frame.moving_center.to_vector(),
        }
    }

    /// Number of bytes in memory, beside itself.
    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::BySlot(middles) => size_of_val(middles.as_slice()),
            Self::Centred | Self::Turned => 0,
        }
    }
}
