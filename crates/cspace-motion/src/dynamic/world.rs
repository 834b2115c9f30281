//! What moves, as the integrator sees it: coordinates with masses and forces, constraints, and contacts that may open and close.

use nalgebra::{DMatrix, DVector};

/// A contact as a function of the coordinates, at one configuration.
#[derive(Debug, Clone)]
pub struct Touch {
    /// How far the features are apart, along their common normal.
    pub gap: f64,
    /// ∂gap/∂q: the rate of the gap is `normal · v`.
    pub normal: DVector<f64>,
    /// The rate at which the features slide past each other is `tangent · v`.
    pub tangent: DVector<f64>,
}

/// A mechanical system with contacts:
///
/// ```text
/// M v̇ = h(t, q, v) + Jᵀ μ + Σ λ_N n + Σ λ_T τ,   q̇ = v
/// ```
///
/// M is constant; contacts are numbered and stay the same.
pub trait World {
    /// The mass matrix M.
    fn mass(&self) -> &DMatrix<f64>;

    /// The forces h.
    fn force(&self, t: f64, q: &DVector<f64>, v: &DVector<f64>) -> DVector<f64>;

    /// Constraints that hold always: the values that are 0, and their rows J by the coordinates. A rate that depends on time alone, of
    /// a drive, and its derivative are those of [`drift`](Self::drift).
    fn joints(&self, t: f64, q: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>);

    /// Of constraints that depend on time: the rates −∂c/∂t that J v has, and what J v̇ has beside −J̇ v.
    fn drift(&self, t: f64) -> (DVector<f64>, DVector<f64>);

    /// How many contacts there are.
    fn contacts(&self) -> usize;

    /// A contact at a configuration.
    fn touch(&self, contact: usize, q: &DVector<f64>) -> Touch;

    /// The coefficients of friction and of restitution of a contact.
    fn surface(&self, contact: usize) -> Surface;

    /// What counts as a length of 1: contacts are closed to `CLOSED` of it.
    fn size(&self) -> f64;
}

/// What happens between two surfaces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Coulomb's coefficient of friction.
    pub friction: f64,
    /// Newton's coefficient of restitution.
    pub restitution: f64,
}

/// Time, coordinates and rates.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// s.
    pub t: f64,
    /// Coordinates.
    pub q: DVector<f64>,
    /// Their rates.
    pub v: DVector<f64>,
}
