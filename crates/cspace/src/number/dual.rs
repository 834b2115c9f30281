//! Numbers that carry derivatives.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Real;

/// A value with its first derivatives by N quantities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<const N: usize, T = f64> {
    /// The value.
    pub value: T,
    /// The derivatives.
    pub slope: [T; N],
}

/// A value with its first and second derivatives by N quantities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SecondOrder<const N: usize, T = f64> {
    /// The value.
    pub value: T,
    /// The gradient.
    pub gradient: [T; N],
    /// The Hessian, symmetric.
    pub hessian: [[T; N]; N],
}

fn array<T, const N: usize>(f: impl FnMut(usize) -> T) -> [T; N] {
    core::array::from_fn(f)
}

fn matrix<T, const N: usize>(f: impl Fn(usize, usize) -> T) -> [[T; N]; N] {
    array(|i| array(|j| f(i, j)))
}

impl<const N: usize, T: Real> Dual<N, T> {
    /// The quantity number `index` itself, at a value.
    ///
    /// An index of N or more is a constant.
    #[inline]
    pub fn variable(value: T, index: usize) -> Self {
        Self {
            value,
            slope: array(|i| T::constant(f64::from(i == index))),
        }
    }

    /// A function of this number, given its value and derivative there.
    #[inline]
    fn map(self, value: T, derivative: T) -> Self {
        Self {
            value,
            slope: self.slope.map(|s| derivative * s),
        }
    }
}

impl<const N: usize, T: Real> SecondOrder<N, T> {
    /// The quantity number `index` itself, at a value.
    ///
    /// An index of N or more is a constant.
    #[inline]
    pub fn variable(value: T, index: usize) -> Self {
        Self {
            value,
            gradient: array(|i| T::constant(f64::from(i == index))),
            hessian: [[T::constant(0.0); N]; N],
        }
    }

    /// A function g of this number, given g, g′ and g″ there: the Hessian is g′ H + g″ ∇ ∇ᵀ.
    #[inline]
    fn map(self, value: T, first: T, second: T) -> Self {
        let g = self.gradient;
        Self {
            value,
            gradient: g.map(|s| first * s),
            hessian: matrix(|i, j| first * self.hessian[i][j] + second * g[i] * g[j]),
        }
    }

    #[inline]
    fn zip(self, o: Self, f: impl Fn(T, T) -> T) -> Self {
        Self {
            value: f(self.value, o.value),
            gradient: array(|i| f(self.gradient[i], o.gradient[i])),
            hessian: matrix(|i, j| f(self.hessian[i][j], o.hessian[i][j])),
        }
    }
}

impl<const N: usize, T: Real> Add for Dual<N, T> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self {
            value: self.value + o.value,
            slope: array(|i| self.slope[i] + o.slope[i]),
        }
    }
}

impl<const N: usize, T: Real> Sub for Dual<N, T> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self {
            value: self.value - o.value,
            slope: array(|i| self.slope[i] - o.slope[i]),
        }
    }
}

impl<const N: usize, T: Real> Neg for Dual<N, T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: self.slope.map(Neg::neg),
        }
    }
}

#[allow(clippy::suspicious_arithmetic_impl)]
impl<const N: usize, T: Real> Mul for Dual<N, T> {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self {
            value: self.value * o.value,
            slope: array(|i| self.slope[i] * o.value + self.value * o.slope[i]),
        }
    }
}

/// q = a / b has the derivatives (a′ − q b′) / b.
#[allow(clippy::suspicious_arithmetic_impl)]
impl<const N: usize, T: Real> Div for Dual<N, T> {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self {
            value,
            slope: array(|i| (self.slope[i] - value * o.slope[i]) / o.value),
        }
    }
}

impl<const N: usize, T: Real> Real for Dual<N, T> {
    const ROUNDING: f64 = T::ROUNDING;
    #[inline]
    fn constant(value: f64) -> Self {
        Self {
            value: T::constant(value),
            slope: [T::constant(0.0); N],
        }
    }
    #[inline]
    fn value(self) -> f64 {
        self.value.value()
    }
    #[inline]
    fn spread(self) -> f64 {
        self.value.spread()
    }
    #[inline]
    fn unknown(self) -> Self {
        Self {
            value: self.value.unknown(),
            slope: self.slope.map(Real::unknown),
        }
    }
    fn tan(self) -> Self {
        let tan = self.value.tan();
        self.map(tan, T::constant(1.0) + tan * tan)
    }
    fn acos(self) -> Self {
        let (x, one) = (self.value, T::constant(1.0));
        self.map(x.acos(), -(one / ((one - x) * (one + x)).sqrt()))
    }
    fn asin(self) -> Self {
        let (x, one) = (self.value, T::constant(1.0));
        self.map(x.asin(), one / ((one - x) * (one + x)).sqrt())
    }
    fn atan(self) -> Self {
        let (x, one) = (self.value, T::constant(1.0));
        self.map(x.atan(), one / (one + x * x))
    }
    fn atan2(self, o: Self) -> Self {
        let (y, x) = (self.value, o.value);
        let square = x * x + y * y;
        Self {
            value: y.atan2(x),
            slope: array(|i| (self.slope[i] * x - y * o.slope[i]) / square),
        }
    }
    #[inline]
    fn sqrt(self) -> Self {
        let (root, half) = (self.value.sqrt(), T::constant(0.5));
        Self {
            value: root,
            slope: self.slope.map(|s| half * s / root),
        }
    }
    #[inline]
    fn hypot(self, o: Self) -> Self {
        let value = self.value.hypot(o.value);
        let [x, y] = [self.value / value, o.value / value];
        Self {
            value,
            slope: array(|i| x * self.slope[i] + y * o.slope[i]),
        }
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.map(sin, cos), self.map(cos, -sin))
    }
}

impl<const N: usize, T: Real> Add for SecondOrder<N, T> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        self.zip(o, |a, b| a + b)
    }
}

impl<const N: usize, T: Real> Sub for SecondOrder<N, T> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        self.zip(o, |a, b| a - b)
    }
}

impl<const N: usize, T: Real> Neg for SecondOrder<N, T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.zip(self, |a, _| -a)
    }
}

#[allow(clippy::suspicious_arithmetic_impl)]
impl<const N: usize, T: Real> Mul for SecondOrder<N, T> {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        let (a, b) = (self.value, o.value);
        let (f, g) = (self.gradient, o.gradient);
        Self {
            value: a * b,
            gradient: array(|i| f[i] * b + a * g[i]),
            hessian: matrix(|i, j| {
                self.hessian[i][j] * b + f[i] * g[j] + f[j] * g[i] + a * o.hessian[i][j]
            }),
        }
    }
}

/// q = a / b has the derivatives q′ = (a′ − q b′) / b and (a″ − q′ b′ − b′ q′ − q b″) / b.
#[allow(clippy::suspicious_arithmetic_impl)]
impl<const N: usize, T: Real> Div for SecondOrder<N, T> {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        let (b, g) = (o.value, o.gradient);
        let value = self.value / b;
        let gradient: [T; N] = array(|i| (self.gradient[i] - value * g[i]) / b);
        let bend = |i: usize, j: usize| {
            let cross = gradient[i] * g[j] + gradient[j] * g[i];
            (self.hessian[i][j] - cross - value * o.hessian[i][j]) / b
        };
        Self {
            value,
            gradient,
            hessian: matrix(bend),
        }
    }
}

impl<const N: usize, T: Real> Real for SecondOrder<N, T> {
    const ROUNDING: f64 = T::ROUNDING;
    #[inline]
    fn constant(value: f64) -> Self {
        Self::variable(T::constant(value), N)
    }
    #[inline]
    fn value(self) -> f64 {
        self.value.value()
    }
    #[inline]
    fn spread(self) -> f64 {
        self.value.spread()
    }
    #[inline]
    fn unknown(self) -> Self {
        Self {
            value: self.value.unknown(),
            gradient: self.gradient.map(Real::unknown),
            hessian: self.hessian.map(|row| row.map(Real::unknown)),
        }
    }
    /// r = √a has the derivatives r′ = a′ / 2r and (a″ / 2 − r′ r′) / r.
    #[inline]
    fn sqrt(self) -> Self {
        let (value, half) = (self.value.sqrt(), T::constant(0.5));
        let gradient = self.gradient.map(|s| half * s / value);
        let bend =
            |i: usize, j: usize| (half * self.hessian[i][j] - gradient[i] * gradient[j]) / value;
        Self {
            value,
            gradient,
            hessian: matrix(bend),
        }
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.map(sin, cos, -sin), self.map(cos, -sin, -cos))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formula<T: Real>([x, y]: [T; 2]) -> T {
        let (sin, cos) = (x * y).sin_cos();
        (sin + T::constant(2.0)) / (x * x + y * y).sqrt() - cos * x
    }

    #[test]
    fn what_is_negative_has_no_root_but_that_of_zero() {
        assert_eq!(Dual::<1>::constant(-4.0).sqrt().value, 0.0);
        assert_eq!(SecondOrder::<1>::constant(-4.0).sqrt().value, 0.0);
        assert_eq!(Real::sqrt(-4.0_f64), 0.0);
    }

    /// Gradient and Hessian compared with differences of values.
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
