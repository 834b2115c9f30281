//! A function's values and derivatives over an interval, enclosed together.

use core::ops::{Add, Mul, Neg, Sub};

use super::{Ball, Real};

/// Enclosures of a function and of its derivative by θ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jet {
    pub(crate) value: Ball,
    pub(crate) slope: Ball,
}

impl Jet {
    /// Cosine and sine of θ.
    #[inline(always)]
    pub(crate) fn cos_sin(theta: Ball) -> (Self, Self) {
        let (cos, sin) = theta.cos_sin();
        (
            Self {
                value: cos,
                slope: -sin,
            },
            Self {
                value: sin,
                slope: cos,
            },
        )
    }
}

impl Add for Jet {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self {
            value: self.value + o.value,
            slope: self.slope + o.slope,
        }
    }
}

impl Sub for Jet {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self {
            value: self.value - o.value,
            slope: self.slope - o.slope,
        }
    }
}

impl Neg for Jet {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl Mul for Jet {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        Self {
            value: self.value * o.value,
            slope: self.slope * o.value + self.value * o.slope,
        }
    }
}

impl Real for Jet {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self {
            value: Ball::constant(value),
            slope: Ball::constant(0.0),
        }
    }

    #[inline(always)]
    fn over(self, divisor: Self) -> Self {
        let value = self.value.over(divisor.value);
        Self {
            value,
            slope: (self.slope - value * divisor.slope).over(divisor.value),
        }
    }

    #[inline(always)]
    fn root(self) -> Self {
        let value = self.value.root();
        let slope = (self.slope * Ball::constant(0.5)).over(value);
        Self { value, slope }
    }

    #[inline(always)]
    fn rough(self) -> f64 {
        self.value.mid
    }
}
