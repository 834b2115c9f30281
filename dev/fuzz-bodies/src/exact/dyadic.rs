//! Numbers m 2^e with whole m and e.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use num_bigint::{BigInt, Sign};

/// A dyadic rational, exactly.
#[derive(Debug, Clone)]
pub struct Dyadic {
    mantissa: BigInt,
    exponent: i64,
}

impl Dyadic {
    /// m 2^e.
    pub fn new(mantissa: BigInt, exponent: i64) -> Self {
        Self { mantissa, exponent }
    }

    /// A finite number, exactly; 0 for what is not finite.
    ///
    /// ```
    /// use cspace_fuzz::exact::Dyadic;
    /// let (tenth, fifth) = (Dyadic::of(0.1), Dyadic::of(0.2));
    /// assert!(&tenth + &fifth < Dyadic::of(0.3).plus_ulp()); // the sum is between 0.3 and the next double
    /// assert!(&tenth + &fifth > Dyadic::of(0.3));
    /// ```
    pub fn of(value: f64) -> Self {
        if !value.is_finite() {
            return Self::zero();
        }
        let bits = value.to_bits();
        let biased = (bits >> 52 & 0x7ff) as i64;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        let (mantissa, exponent) = if biased == 0 {
            (fraction, -1074)
        } else {
            (fraction | 1 << 52, biased - 1075)
        };
        let signed = if value < 0.0 { -mantissa } else { mantissa };
        Self::new(BigInt::from(signed), exponent)
    }

    /// The next larger number of the form m 2^e with this one's e.
    #[must_use]
    pub fn plus_ulp(&self) -> Self {
        Self::new(&self.mantissa + 1, self.exponent)
    }

    /// 0.
    pub fn zero() -> Self {
        Self::new(BigInt::ZERO, 0)
    }

    /// The sign: 1, 0 or −1.
    pub fn sign(&self) -> i8 {
        match self.mantissa.sign() {
            Sign::Plus => 1,
            Sign::NoSign => 0,
            Sign::Minus => -1,
        }
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.sign() < 0 { -self } else { self.clone() }
    }

    /// The square.
    #[must_use]
    pub fn square(&self) -> Self {
        self * self
    }

    /// 2^k times it.
    #[must_use]
    pub fn shifted(&self, k: i64) -> Self {
        Self::new(self.mantissa.clone(), self.exponent + k)
    }

    /// The largest multiple of 2^−`bits` that is not above the root; 0 of what is negative.
    ///
    /// ```
    /// use cspace_fuzz::exact::Dyadic;
    /// let root = Dyadic::of(2.0).root(60);
    /// assert!(root.square() <= Dyadic::of(2.0) && root.plus_ulp().square() > Dyadic::of(2.0));
    /// ```
    #[must_use]
    pub fn root(&self, bits: i64) -> Self {
        if self.sign() <= 0 {
            return Self::zero();
        }
        Self::new(self.scaled(2 * bits).sqrt(), -bits)
    }

    /// 2^`bits` times it, rounded downwards.
    pub(super) fn scaled(&self, bits: i64) -> BigInt {
        let shift = self.exponent + bits;
        if shift >= 0 {
            &self.mantissa << shift
        } else {
            &self.mantissa >> -shift
        }
    }

    /// A double near it.
    pub fn near(&self) -> f64 {
        let bits = self.mantissa.bits() as i64;
        let cut = (bits - 64).max(0);
        // The magnitude is cut: a negative number would be rounded away from zero, perhaps to one bit more.
        let top = self.mantissa.magnitude() >> cut;
        let value = top.to_u64_digits().first().map_or(0.0, |&d| d as f64);
        let exponent = (self.exponent + cut).clamp(-2000, 2000) as i32;
        // In two steps: one power of two alone may underflow.
        let value = value * 2f64.powi(exponent / 2) * 2f64.powi(exponent - exponent / 2);
        if self.sign() < 0 { -value } else { value }
    }

    /// Both with one exponent.
    fn aligned(&self, other: &Self) -> (BigInt, BigInt, i64) {
        let exponent = self.exponent.min(other.exponent);
        (
            &self.mantissa << (self.exponent - exponent),
            &other.mantissa << (other.exponent - exponent),
            exponent,
        )
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, o: Self) -> Dyadic {
        let (a, b, exponent) = self.aligned(o);
        Dyadic::new(a + b, exponent)
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, o: Self) -> Dyadic {
        let (a, b, exponent) = self.aligned(o);
        Dyadic::new(a - b, exponent)
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, o: Self) -> Dyadic {
        Dyadic::new(&self.mantissa * &o.mantissa, self.exponent + o.exponent)
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic::new(-&self.mantissa, self.exponent)
    }
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Dyadic {}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        let (a, b, _) = self.aligned(other);
        a.cmp(&b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubles_are_taken_exactly() {
        for x in [1.0, -0.1, 5e-324, f64::MAX, 1.5e-310, 0.0] {
            assert_eq!(Dyadic::of(x).near(), x);
        }
        // −(2⁷⁰ − 1) has more bits than are looked at.
        let many = &Dyadic::of(1.0).shifted(70) - &Dyadic::of(1.0);
        assert_eq!((-&many).near(), -(2f64.powi(70)));
        // (1 + 2⁻⁵²)² is no double.
        let square = Dyadic::of(1.0 + f64::EPSILON).square();
        assert!(square > Dyadic::of((1.0 + f64::EPSILON).powi(2)));
    }
}
