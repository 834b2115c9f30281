//! Numbers that carry derivatives, for formulas that users evaluate.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// What the contact functions need of a number, so that one formula gives values and derivatives by anything.
///
/// `f64` is a value alone, [`Dual`] a value with first derivatives by N quantities, [`SecondOrder`] a value with its
/// gradient and Hessian. Other kinds, such as intervals, are implemented in the same few lines.
///
/// ```
/// use cspace::{Dual, Scalar};
/// fn area<T: Scalar>(radius: T) -> T {
///     T::constant(std::f64::consts::PI) * radius * radius
/// }
/// let a = area(Dual::<1>::variable(2.0, 0));
/// assert!((a.slope[0] - 4.0 * std::f64::consts::PI).abs() < 1e-12);
/// ```
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A number that does not depend on anything.
    fn constant(value: f64) -> Self;
    /// The value without derivatives, by which one of several forms of a formula is chosen.
    fn value(self) -> f64;
    /// The square root; of a number below zero, that of zero.
    #[must_use]
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
}

impl Scalar for f64 {
    fn constant(value: f64) -> Self {
        value
    }
    fn value(self) -> f64 {
        self
    }
    fn sqrt(self) -> Self {
        self.max(0.0).sqrt()
    }
    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
}

/// A value with its first derivatives by N quantities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<const N: usize> {
    /// The value.
    pub value: f64,
    /// The derivatives.
    pub slope: [f64; N],
}

/// A value with its first and second derivatives by N quantities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondOrder<const N: usize> {
    /// The value.
    pub value: f64,
    /// The gradient.
    pub gradient: [f64; N],
    /// The Hessian, symmetric.
    pub hessian: [[f64; N]; N],
}

impl<const N: usize> Dual<N> {
    /// The quantity number `index` itself, at a value.
    ///
    /// An index of N or more is a constant.
    pub fn variable(value: f64, index: usize) -> Self {
        Self {
            value,
            slope: core::array::from_fn(|i| f64::from(i == index)),
        }
    }

    /// A function of it, from its value and derivative there.
    fn map(self, value: f64, derivative: f64) -> Self {
        Self {
            value,
            slope: self.slope.map(|s| derivative * s),
        }
    }
}

impl<const N: usize> SecondOrder<N> {
    /// The quantity number `index` itself, at a value.
    ///
    /// An index of N or more is a constant.
    pub fn variable(value: f64, index: usize) -> Self {
        Self {
            value,
            gradient: core::array::from_fn(|i| f64::from(i == index)),
            hessian: [[0.0; N]; N],
        }
    }

    /// A function g of it, from g, g′ and g″ there: the Hessian is g′ H + g″ ∇ ∇ᵀ.
    fn map(self, value: f64, first: f64, second: f64) -> Self {
        let g = self.gradient;
        let bend = |i: usize, j: usize| first * self.hessian[i][j] + second * g[i] * g[j];
        Self {
            value,
            gradient: g.map(|s| first * s),
            hessian: core::array::from_fn(|i| core::array::from_fn(|j| bend(i, j))),
        }
    }

    fn zip(self, o: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            value: f(self.value, o.value),
            gradient: core::array::from_fn(|i| f(self.gradient[i], o.gradient[i])),
            hessian: core::array::from_fn(|i| {
                core::array::from_fn(|j| f(self.hessian[i][j], o.hessian[i][j]))
            }),
        }
    }
}

impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            value: self.value + o.value,
            slope: core::array::from_fn(|i| self.slope[i] + o.slope[i]),
        }
    }
}

#[allow(clippy::suspicious_arithmetic_impl)]
impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let slope = |i: usize| self.slope[i] * o.value + self.value * o.slope[i];
        Self {
            value: self.value * o.value,
            slope: core::array::from_fn(slope),
        }
    }
}

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(-self.value, -1.0)
    }
}

impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

#[allow(clippy::suspicious_arithmetic_impl)]
impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let inverse = 1.0 / o.value;
        let quotient = self * o.map(inverse, -inverse * inverse);
        Self {
            value: self.value / o.value,
            ..quotient
        }
    }
}

impl<const N: usize> Scalar for Dual<N> {
    fn constant(value: f64) -> Self {
        Self {
            value,
            slope: [0.0; N],
        }
    }
    fn value(self) -> f64 {
        self.value
    }
    fn sqrt(self) -> Self {
        let root = self.value.max(0.0).sqrt();
        self.map(root, 0.5 / root)
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.map(sin, cos), self.map(cos, -sin))
    }
}

impl<const N: usize> Add for SecondOrder<N> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        self.zip(o, |a, b| a + b)
    }
}

impl<const N: usize> Sub for SecondOrder<N> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self.zip(o, |a, b| a - b)
    }
}

impl<const N: usize> Neg for SecondOrder<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(-self.value, -1.0, 0.0)
    }
}

#[allow(clippy::suspicious_arithmetic_impl)]
impl<const N: usize> Mul for SecondOrder<N> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let (a, b) = (self.value, o.value);
        let (f, g) = (self.gradient, o.gradient);
        let bend = |i: usize, j: usize| {
            self.hessian[i][j] * b + f[i] * g[j] + f[j] * g[i] + a * o.hessian[i][j]
        };
        Self {
            value: a * b,
            gradient: core::array::from_fn(|i| f[i] * b + a * g[i]),
            hessian: core::array::from_fn(|i| core::array::from_fn(|j| bend(i, j))),
        }
    }
}

#[allow(clippy::suspicious_arithmetic_impl)]
impl<const N: usize> Div for SecondOrder<N> {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let inverse = 1.0 / o.value;
        let square = inverse * inverse;
        let quotient = self * o.map(inverse, -square, 2.0 * square * inverse);
        Self {
            value: self.value / o.value,
            ..quotient
        }
    }
}

impl<const N: usize> Scalar for SecondOrder<N> {
    fn constant(value: f64) -> Self {
        Self::variable(value, N)
    }
    fn value(self) -> f64 {
        self.value
    }
    fn sqrt(self) -> Self {
        let root = self.value.max(0.0).sqrt();
        self.map(root, 0.5 / root, -0.25 / (root * self.value))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.map(sin, cos, -sin), self.map(cos, -sin, -cos))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formula<T: Scalar>([x, y]: [T; 2]) -> T {
        let (sin, cos) = (x * y).sin_cos();
        (sin + T::constant(2.0)) / (x * x + y * y).sqrt() - cos * x
    }

    /// Gradient and Hessian against differences of values.
    #[test]
    fn derivatives_agree_with_differences() {
        let (x, y, h) = (0.7, -1.2, 1e-4);
        let at = |dx: f64, dy: f64| formula([x + dx, y + dy]);
        let f = formula([
            SecondOrder::<2>::variable(x, 0),
            SecondOrder::variable(y, 1),
        ]);
        let d = formula([Dual::<2>::variable(x, 0), Dual::variable(y, 1)]);
        assert_eq!((f.value, d.value), (at(0.0, 0.0), at(0.0, 0.0)));
        let slopes = [
            (at(h, 0.0) - at(-h, 0.0)) / (2.0 * h),
            (at(0.0, h) - at(0.0, -h)) / (2.0 * h),
        ];
        for (i, slope) in slopes.into_iter().enumerate() {
            assert!((f.gradient[i] - slope).abs() < 1e-7);
            assert!((d.slope[i] - f.gradient[i]).abs() < 1e-14);
        }
        let second = |i: usize, j: usize| {
            let step = |k: usize, by: f64| if k == 0 { (by, 0.0) } else { (0.0, by) };
            let sum = |a: f64, b: f64| {
                let (p, q) = (step(i, a), step(j, b));
                at(p.0 + q.0, p.1 + q.1)
            };
            (sum(h, h) - sum(h, -h) - sum(-h, h) + sum(-h, -h)) / (4.0 * h * h)
        };
        for i in 0..2 {
            for j in 0..2 {
                assert!((f.hessian[i][j] - second(i, j)).abs() < 1e-5, "{i} {j}");
                assert!((f.hessian[i][j] - f.hessian[j][i]).abs() < 1e-14);
            }
        }
    }
}
