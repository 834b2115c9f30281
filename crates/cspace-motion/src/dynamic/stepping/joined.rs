//! Rates and coordinates brought to where joints hold, in the metric of the masses.

use nalgebra::{DMatrix, DVector};

use super::super::world::{Joints, World};

/// Directions that joints hold twice have singular values below this share of the largest.
const TWICE: f64 = 1e-9;
/// Largest violation of joints that hold, as a share of the size.
const HOLDS: f64 = 1e-12;
/// Newton's method comes to that in two or three steps.
const MOST_STEPS: usize = 10;

/// The joints at a configuration, with what inverts them.
pub(super) struct Joined {
    pub(super) joints: Joints,
    /// M⁻¹ Jᵀ (J M⁻¹ Jᵀ)⁺.
    back: DMatrix<f64>,
}

impl Joined {
    pub(super) fn at<W: World + ?Sized>(
        world: &W,
        inverse: &DMatrix<f64>,
        t: f64,
        q: &DVector<f64>,
    ) -> Option<Self> {
        let joints = world.joints(t, q);
        let moved = inverse * joints.rows.transpose();
        if joints.values.is_empty() {
            return Some(Self {
                back: moved,
                joints,
            });
        }
        let square = &joints.rows * &moved;
        let largest = square.amax();
        let pseudo = square.pseudo_inverse(TWICE * largest).ok()?;
        Some(Self {
            back: moved * pseudo,
            joints,
        })
    }

    /// A change of rates that changes J v by these numbers.
    pub(super) fn change(&self, of: &DVector<f64>) -> DVector<f64> {
        &self.back * of
    }

    /// Violation of the joints' equations by rates.
    pub(super) fn missed(&self, v: &DVector<f64>) -> DVector<f64> {
        &self.joints.rows * v - &self.joints.rates
    }

    /// The rates that joints allow which are nearest to others.
    pub(super) fn allowed(&self, v: &DVector<f64>) -> DVector<f64> {
        v - self.change(&self.missed(v))
    }

    /// Projects changes of rates, the columns of a matrix, on those that joints allow.
    pub(super) fn free(&self, changes: &DMatrix<f64>) -> DMatrix<f64> {
        changes - &self.back * (&self.joints.rows * changes)
    }

    /// The multipliers of a change of rates by joints: M Δv = Jᵀ μ.
    pub(super) fn multipliers(&self, mass: &DMatrix<f64>, change: &DVector<f64>) -> DVector<f64> {
        // backᵀ M M⁻¹ Jᵀ μ = (J M⁻¹ Jᵀ)⁺ (J M⁻¹ Jᵀ) μ.
        self.back.transpose() * (mass * change)
    }
}

/// Nearest coordinates at which joints hold. `None` if there are none.
pub(super) fn held<W: World + ?Sized>(
    world: &W,
    inverse: &DMatrix<f64>,
    t: f64,
    mut q: DVector<f64>,
) -> Option<DVector<f64>> {
    for _ in 0..MOST_STEPS {
        let joined = Joined::at(world, inverse, t, &q)?;
        if joined.joints.values.is_empty() || joined.joints.values.amax() <= HOLDS * world.size() {
            return Some(q);
        }
        q -= joined.change(&joined.joints.values);
    }
    None
}
