//! Operations that formulas need of a number, so that each formula is written once for all kinds of arithmetic.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A real number, or a type that stands for one.
///
/// `f64` is a value alone, [`Dual`](crate::Dual) a value with first derivatives by N quantities, [`SecondOrder`](crate::SecondOrder) a
/// value with its gradient and Hessian. Within the library, numbers of 106 bits and enclosures also implement it; others take the same few
/// lines.
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
    /// A constant: all derivatives are zero.
    fn constant(value: f64) -> Self;
    /// An f64 approximation without derivatives, used only to pick the numerically better of several equivalent formulas.
    fn value(self) -> f64;
    /// Square root, with negative values (or the negative part of an interval) clamped to zero.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The absolute value.
    #[must_use]
    #[inline]
    fn abs(self) -> Self {
        let abs = if self.value() < 0.0 { -self } else { self };
        if self.spread() > self.value().abs() {
            abs.unknown()
        } else {
            abs
        }
    }
    /// Bound of the distance of the number from its [value](Self::value): the radius of an enclosure, 0 for other numbers.
    #[inline]
    fn spread(self) -> f64 {
        0.0
    }
    /// An enclosure of all reals about the same value, for formulas that enclose nothing; other numbers are unchanged.
    #[must_use]
    #[inline]
    fn unknown(self) -> Self {
        self
    }
    /// The length of a vector with these two coordinates.
    #[must_use]
    #[inline]
    fn hypot(self, other: Self) -> Self {
        (self * self + other * other).sqrt()
    }
    /// The tangent of an angle in radians.
    #[must_use]
    fn tan(self) -> Self {
        let tan = self.value().tan();
        self.function(tan, 1.0 + tan * tan)
    }
    /// The angle from 0 to π with this cosine.
    #[must_use]
    fn acos(self) -> Self {
        let x = self.value();
        self.function(x.acos(), -1.0 / ((1.0 - x) * (1.0 + x)).sqrt())
    }
    /// The angle from −π/2 to π/2 with this sine.
    #[must_use]
    fn asin(self) -> Self {
        let x = self.value();
        self.function(x.asin(), 1.0 / ((1.0 - x) * (1.0 + x)).sqrt())
    }
    /// The angle from −π/2 to π/2 with this tangent.
    #[must_use]
    fn atan(self) -> Self {
        let x = self.value();
        self.function(x.atan(), 1.0 / (1.0 + x * x))
    }
    /// The angle from −π to π of the vector (x, y), with this number for y.
    #[must_use]
    fn atan2(self, x: Self) -> Self {
        let (sin, cos) = (self.value(), x.value());
        let square = cos * cos + sin * sin;
        self.function(sin.atan2(cos), cos / square) + x.function(0.0, -sin / square)
    }
    /// A function of this number, given its value and slope here: f(x₀) + f′(x₀) (x − x₀), which has the first derivatives of f(x). Second
    /// derivatives are not those of f, and an enclosure becomes that of all reals.
    #[must_use]
    #[inline]
    fn function(self, value: f64, slope: f64) -> Self {
        let moved = self - Self::constant(self.value());
        // An infinite slope times a value without derivative would be NaN.
        let tangent =
            Self::constant(value) + moved * Self::constant(slope.clamp(f64::MIN, f64::MAX));
        if self.spread() > 0.0 {
            tangent.unknown()
        } else {
            tangent
        }
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
    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }
    #[inline]
    fn function(self, value: f64, _: f64) -> Self {
        value
    }
}

/// A real number by which places on a curve can be ordered: f64 and double-double.
pub(crate) trait Ordered: Real + PartialOrd {}

impl Ordered for f64 {}
