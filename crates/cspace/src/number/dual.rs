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
