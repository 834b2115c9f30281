//! Numbers: enclosures of real functions over intervals of orientation.

mod ball;
mod dd;
mod expansion;
mod jet;
mod least;
pub(crate) mod plane;
mod polynomial;
mod scalar;
mod series;
mod trig;

pub(crate) use ball::Ball;
pub(crate) use dd::Dd;
pub(crate) use expansion::Expansion;
pub(crate) use jet::Jet;
pub(crate) use least::{Bounded, least};
pub(crate) use polynomial::TrigPolynomial;
pub use scalar::{Dual, Scalar, SecondOrder};
pub(crate) use series::Series;
pub(crate) use trig::{Event, Known, Trig};

use core::ops::{Add, Mul, Neg, Sub};

/// What the formulas of contact need of a number, so that each formula is written once for all kinds of arithmetic.
pub(crate) trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// An exact constant.
    fn constant(value: f64) -> Self;
    /// Quotient.
    fn over(self, divisor: Self) -> Self;
    /// Square root; of the part that is not negative, if there is one.
    fn root(self) -> Self;
    /// About its value: for choosing the better of two forms that are equal.
    fn rough(self) -> f64;
}

impl Real for f64 {
    #[inline]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline]
    fn over(self, divisor: Self) -> Self {
        self / divisor
    }
    #[inline]
    fn root(self) -> Self {
        self.max(0.0).sqrt()
    }
    #[inline]
    fn rough(self) -> f64 {
        self
    }
}
