//! What formulas need of a number, so that each is written once for all kinds of arithmetic.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or what stands for one.
///
/// `f64` is a value alone, [`Dual`](crate::Dual) a value with first derivatives by N quantities,
/// [`SecondOrder`](crate::SecondOrder) a value with its gradient and Hessian. Within the library also numbers of 106 bits and
/// enclosures are of this kind; others are implemented in the same few lines.
///
/// ```
/// use cspace::{Dual, Real};
/// fn area<T: Real>(radius: T) -> T {
///     T::constant(std::f64::consts::PI) * radius * radius
/// }
/// let a = area(Dual::<1>::variable(2.0, 0));
/// assert!((a.slope[0] - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// ```
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Rounding error of an operation, relative to its result.
    const ROUNDING: f64;
    /// A number that does not depend on anything.
    fn constant(value: f64) -> Self;
    /// An f64 approximation without derivatives: selects the numerically better of several equal formulas.
    fn value(self) -> f64;
    /// The square root; of a number below zero, that of zero.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The absolute value.
    #[must_use]
    #[inline]
    fn abs(self) -> Self {
        if self.value() < 0.0 { -self } else { self }
    }
    /// The length of a vector with these two coordinates.
    #[must_use]
    #[inline]
    fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }
    /// A function of this number that has a value and a slope here: f(x₀) + f′(x₀) (x − x₀), which has the first derivatives of f(x).
    /// It encloses nothing, and second derivatives are not those of f.
    #[must_use]
    #[inline]
    fn function(self, value: f64, slope: f64) -> Self {
        let moved = self - Self::constant(self.value());
        // An infinite slope times a value that does not move were no number.
        Self::constant(value) + moved * Self::constant(slope.clamp(f64::MIN, f64::MAX))
    }
}

impl Real for f64 {
    const ROUNDING: f64 = Self::EPSILON;
    #[inline]
    fn constant(value: f64) -> Self {
        value
    }
    #[inline]
    fn value(self) -> f64 {
        self
    }
    #[inline]
    fn sqrt(self) -> Self {
        self.max(0.0).sqrt()
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
    #[inline]
    fn hypot(self, other: Self) -> Self {
        self.hypot(other)
    }
    #[inline]
    fn function(self, value: f64, _: f64) -> Self {
        value
    }
}

/// A real number by which places on a curve can be ordered: doubles and double-double.
pub(crate) trait Ordered: Real + PartialOrd {
    /// The angle of the vector (x, y), in (−π, π].
    fn atan2(y: Self, x: Self) -> Self;
}

impl Ordered for f64 {
    #[inline]
    fn atan2(y: Self, x: Self) -> Self {
        y.atan2(x)
    }
}
