//! The numbers the judge computes with: doubles, and pairs of doubles for what doubles leave open.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A real number to some precision.
pub(super) trait Real:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number itself.
    fn of(value: f64) -> Self;
    /// The nearest double.
    fn to_f64(self) -> f64;
    /// Square root; 0 for negative numbers.
    fn root(self) -> Self;
    /// Sine and cosine of an angle.
    fn sin_cos(angle: f64) -> (Self, Self);

    /// Zero.
    fn zero() -> Self {
        Self::of(0.0)
    }

    /// The absolute value.
    fn magnitude(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }
}

impl Real for f64 {
    #[inline]
    fn of(value: f64) -> Self {
        value
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self
    }
    #[inline]
    fn root(self) -> Self {
        self.max(0.0).sqrt()
    }
    #[inline]
    fn sin_cos(angle: f64) -> (Self, Self) {
        f64::sin_cos(angle)
    }
    #[inline]
    fn magnitude(self) -> Self {
        self.abs()
    }
}

/// The unevaluated sum of two doubles, the second below half a unit in the last place of the first: about 31 digits.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(super) struct Double {
    high: f64,
    low: f64,
}

#[inline]
fn two_sum(a: f64, b: f64) -> Double {
    let high = a + b;
    let bb = high - a;
    Double {
        high,
        low: (a - (high - bb)) + (b - bb),
    }
}

/// As [`two_sum`], for |a| ≥ |b|.
#[inline]
fn quick_two_sum(a: f64, b: f64) -> Double {
    let high = a + b;
    Double {
        high,
        low: b - (high - a),
    }
}

#[inline]
fn split(a: f64) -> (f64, f64) {
    let t = 134_217_729.0 * a;
    let high = t - (t - a);
    (high, a - high)
}

#[inline]
fn two_product(a: f64, b: f64) -> Double {
    let high = a * b;
    let (ah, al) = split(a);
    let (bh, bl) = split(b);
    Double {
        high,
        low: ((ah * bh - high) + ah * bl + al * bh) + al * bl,
    }
}

impl Add for Double {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let s = two_sum(self.high, other.high);
        let t = two_sum(self.low, other.low);
        let u = quick_two_sum(s.high, s.low + t.high);
        quick_two_sum(u.high, u.low + t.low)
    }
}

impl Neg for Double {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for Double {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + (-other)
    }
}

impl Mul for Double {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let p = two_product(self.high, other.high);
        quick_two_sum(
            p.high,
            p.low + (self.high * other.low + self.low * other.high),
        )
    }
}

impl Div for Double {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let q1 = self.high / other.high;
        let r = self - other * Self::of(q1);
        let q2 = r.high / other.high;
        let r = r - other * Self::of(q2);
        let q3 = r.high / other.high;
        quick_two_sum(q1, q2) + Self::of(q3)
    }
}

impl Real for Double {
    #[inline]
    fn of(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
        }
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.high
    }

    #[inline]
    fn root(self) -> Self {
        if self.high <= 0.0 {
            return Self::zero();
        }
        // Two Newton steps from the double's root; the first already has nearly all digits.
        let mut x = Self::of(self.high.sqrt());
        for _ in 0..2 {
            x = (x + self / x) * Self::of(0.5);
        }
        x
    }

    fn sin_cos(angle: f64) -> (Self, Self) {
        let quarter = Self {
            high: core::f64::consts::FRAC_PI_2,
            low: 6.123_233_995_736_766e-17,
        };
        let turns = (angle / quarter.high).round();
        let x = Self::of(angle) - quarter * Self::of(turns);
        let square = -(x * x);
        let (mut sin, mut cos) = (x, Self::of(1.0));
        let (mut sin_term, mut cos_term) = (x, Self::of(1.0));
        for k in 1..16 {
            let n = 2.0 * f64::from(k);
            cos_term = cos_term * square / Self::of(n * (n - 1.0));
            sin_term = sin_term * square / Self::of(n * (n + 1.0));
            cos = cos + cos_term;
            sin = sin + sin_term;
        }
        match turns.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(a: Double, b: Double, tolerance: f64) {
        assert!((a - b).to_f64().abs() < tolerance, "{a:?} {b:?}");
    }

    #[test]
    fn thirds_and_roots() {
        let third = Double::of(1.0) / Double::of(3.0);
        close(third * Double::of(3.0), Double::of(1.0), 1e-31);
        let root = Double::of(2.0).root();
        close(root * root, Double::of(2.0), 1e-30);
        assert_eq!(Double::of(-1.0).root(), Double::zero());
        assert!(third < Double::of(1.0 / 3.0 + 1e-16));
    }

    #[test]
    fn sines() {
        for i in -40..40 {
            let angle = 0.37 * f64::from(i);
            let (sin, cos) = <Double as Real>::sin_cos(angle);
            let (s, c) = f64::sin_cos(angle);
            assert!((sin.to_f64() - s).abs() < 3e-16 && (cos.to_f64() - c).abs() < 3e-16);
            close(sin * sin + cos * cos, Double::of(1.0), 1e-30);
            // sin 2a = 2 sin a cos a
            let (sin2, _) = <Double as Real>::sin_cos(2.0 * angle);
            close(Double::of(2.0) * sin * cos, sin2, 1e-30);
        }
    }
}
