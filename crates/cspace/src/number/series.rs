//! A number with its first two derivatives by θ.

use core::ops::{Add, Mul, Neg, Sub};

use super::Real;

/// A value and its first two derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Series<T = f64> {
    pub(crate) value: T,
    pub(crate) slope: T,
    pub(crate) bend: T,
}

impl<T: Real> Series<T> {
    /// Cosine and sine of θ.
    pub(crate) fn turn(cos: T, sin: T) -> (Self, Self) {
        let series = |value, slope, bend| Self { value, slope, bend };
        (series(cos, -sin, -cos), series(sin, cos, -sin))
    }
}

impl Series {
    /// Cosine and sine of θ.
    pub(crate) fn cos_sin(theta: f64) -> (Self, Self) {
        let (sin, cos) = theta.sin_cos();
        Self::turn(cos, sin)
    }
}

impl<T: Real> Add for Series<T> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            value: self.value + o.value,
            slope: self.slope + o.slope,
            bend: self.bend + o.bend,
        }
    }
}

impl<T: Real> Sub for Series<T> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl<T: Real> Neg for Series<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
            bend: -self.bend,
        }
    }
}

impl<T: Real> Mul for Series<T> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let twice = T::constant(2.0);
        Self {
            value: self.value * o.value,
            slope: self.slope * o.value + self.value * o.slope,
            bend: self.bend * o.value + twice * self.slope * o.slope + self.value * o.bend,
        }
    }
}

impl<T: Real> Real for Series<T> {
    fn constant(value: f64) -> Self {
        let zero = T::constant(0.0);
        Self {
            value: T::constant(value),
            slope: zero,
            bend: zero,
        }
    }

    fn over(self, divisor: Self) -> Self {
        let twice = T::constant(2.0);
        let value = self.value.over(divisor.value);
        let slope = (self.slope - value * divisor.slope).over(divisor.value);
        let bend = self.bend - twice * slope * divisor.slope - value * divisor.bend;
        let bend = bend.over(divisor.value);
        Self { value, slope, bend }
    }

    fn root(self) -> Self {
        let half = T::constant(0.5);
        let value = self.value.root();
        let slope = (half * self.slope).over(value);
        let bend = (half * self.bend - slope * slope).over(value);
        Self { value, slope, bend }
    }

    fn rough(self) -> f64 {
        self.value.rough()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_agree_with_differences() {
        fn f<T: Real>(cos: T, sin: T) -> T {
            (cos * sin + T::constant(2.0)).over((T::constant(1.5) - sin).root())
        }
        let at = |t: f64| f(t.cos(), t.sin());
        let (cos, sin) = Series::cos_sin(0.3);
        let s = f(cos, sin);
        let h = 1e-4;
        assert!((s.value - at(0.3)).abs() < 1e-15);
        assert!((s.slope - (at(0.3 + h) - at(0.3 - h)) / (2.0 * h)).abs() < 1e-7);
        assert!((s.bend - (at(0.3 + h) - 2.0 * at(0.3) + at(0.3 - h)) / (h * h)).abs() < 1e-6);
    }

    /// The derivatives of sums, products, quotients and roots of functions of one variable, by difference quotients.
    #[test]
    fn slopes_agree_with_differences() {
        fn f<T: Real>(x: T) -> [T; 5] {
            let (a, b) = (x * x, T::constant(3.0) - x * x * x);
            [a + b, a - b, -a * b, a.over(b), (a * a + b).root()]
        }
        let (x, h) = (0.7, 1e-5);
        let (at, below, above) = (
            f(Series {
                value: x,
                slope: 1.0,
                bend: 0.0,
            }),
            f(x - h),
            f(x + h),
        );
        // x² = 0.49 and 3 − x³ = 2.657.
        let (a, b) = (0.49_f64, 2.657);
        let values: [f64; 5] = [a + b, a - b, -a * b, a / b, (a * a + b).sqrt()];
        for i in 0..5 {
            assert!((at[i].value - values[i]).abs() < 1e-14, "{i}");
            assert!((f(x)[i] - values[i]).abs() < 1e-14, "{i}");
            let slope = (above[i] - below[i]) / (2.0 * h);
            assert!(
                (at[i].slope - slope).abs() < 1e-8,
                "{i}: {slope} {:?}",
                at[i]
            );
        }
    }

    #[test]
    fn what_is_negative_has_no_root_but_that_of_zero() {
        assert_eq!(<Series>::constant(-4.0).root().value, 0.0);
        assert_eq!((-4.0_f64).root(), 0.0);
    }
}
