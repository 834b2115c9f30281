//! A number with its derivative by θ.

use core::ops::{Add, Mul, Neg, Sub};

use super::Real;

/// A value and its derivative.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dual {
    pub(crate) value: f64,
    pub(crate) slope: f64,
}

impl Add for Dual {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            value: self.value + o.value,
            slope: self.slope + o.slope,
        }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self {
            value: self.value - o.value,
            slope: self.slope - o.slope,
        }
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self {
            value: self.value * o.value,
            slope: self.slope * o.value + self.value * o.slope,
        }
    }
}

impl Real for Dual {
    fn constant(value: f64) -> Self {
        Self { value, slope: 0.0 }
    }

    fn over(self, divisor: Self) -> Self {
        let value = self.value / divisor.value;
        Self {
            value,
            slope: (self.slope - value * divisor.slope) / divisor.value,
        }
    }

    fn root(self) -> Self {
        let value = self.value.max(0.0).sqrt();
        Self {
            value,
            slope: 0.5 * self.slope / value,
        }
    }

    fn rough(self) -> f64 {
        self.value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The derivatives of sums, products, quotients and roots of functions of one variable, by difference quotients.
    #[test]
    fn slopes_agree_with_differences() {
        fn f<T: Real>(x: T) -> [T; 5] {
            let (a, b) = (x * x, T::constant(3.0) - x * x * x);
            [a + b, a - b, -a * b, a.over(b), (a * a + b).root()]
        }
        let (x, h) = (0.7, 1e-5);
        let (at, below, above) = (
            f(Dual {
                value: x,
                slope: 1.0,
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
        let below = Dual {
            value: -4.0,
            slope: 1.0,
        };
        assert_eq!(below.root().value, 0.0);
        assert_eq!((-4.0_f64).root(), 0.0);
    }
}
