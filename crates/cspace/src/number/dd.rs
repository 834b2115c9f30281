//! Double-double numbers: about 106 bits, as the unevaluated sum of two doubles.
//!
//! Sums and products are those of Dekker (1971) and Knuth: the rounding error of the leading part is kept in the trailing part. The error
//! of an operation is a few units of 2⁻¹⁰⁴ of its result.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Ordered, Real};

/// A number hi + lo with |lo| ≤ ulp(hi) / 2.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Dd {
    hi: f64,
    lo: f64,
}

/// a + b and its rounding error.
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let v = s - a;
    (s, (a - (s - v)) + (b - v))
}

/// a + b and its rounding error, for |a| ≥ |b|.
#[inline(always)]
fn quick_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, b - (s - a))
}

/// The leading and the trailing half of the digits of a number.
#[inline(always)]
fn split(a: f64) -> (f64, f64) {
    /// 2²⁷ + 1.
    const SPLITTER: f64 = 134_217_729.0;
    let t = SPLITTER * a;
    let hi = t - (t - a);
    (hi, a - hi)
}

/// a b and its rounding error.
#[inline(always)]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    // Two operations are enough where the target processor has fused multiply-add.
    if cfg!(any(target_feature = "fma", target_arch = "aarch64")) {
        return (p, a.mul_add(b, -p));
    }
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

impl Dd {
    pub(crate) const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    pub(crate) const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    pub(crate) const PI: Self = Self {
        hi: core::f64::consts::PI,
        lo: 1.224_646_799_147_353_2e-16,
    };
    pub(crate) const TAU: Self = Self {
        hi: core::f64::consts::TAU,
        lo: 2.449_293_598_294_706_4e-16,
    };
    /// The rounding of an operation, relative to its result.
    pub(crate) const EPSILON: f64 = 1.0 / (1u128 << 102) as f64;

    /// The nearest f64.
    #[inline]
    pub(crate) fn to_f64(self) -> f64 {
        self.hi
    }

    /// The number converted to another arithmetic.
    #[inline]
    pub(crate) fn to_real<T: Real>(self) -> T {
        T::constant(self.hi) + T::constant(self.lo)
    }

    #[inline]
    pub(crate) fn is_negative(self) -> bool {
        self.hi < 0.0
    }

    #[inline]
    pub(crate) fn is_zero(self) -> bool {
        self.hi == 0.0
    }

    /// The product with a power of two.
    #[inline]
    pub(crate) fn scaled(self, power: f64) -> Self {
        Self {
            hi: self.hi * power,
            lo: self.lo * power,
        }
    }

    /// The square root; 0 for a number that is not positive.
    pub(crate) fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self::ZERO;
        }
        // One step of Newton's method for 1/√x, after Karp.
        let x = 1.0 / self.hi.sqrt();
        let ax = self.hi * x;
        let (p, e) = two_product(ax, ax);
        let rest = (self - Self { hi: p, lo: e }).hi;
        let (hi, lo) = two_sum(ax, rest * (x * 0.5));
        Self { hi, lo }
    }

    /// Sine and cosine of an angle in radians.
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        // By the nearest multiple of π/128 and a series for the remainder, which is at most 0.0123.
        let turns = (self.hi / core::f64::consts::TAU).round();
        let angle = if turns == 0.0 {
            self
        } else {
            self - Self::TAU * turns
        };
        let step = (angle.hi * (STEPS / core::f64::consts::PI)).round();
        let x = angle - Self::PI * (step / STEPS);
        let (s, c) = x.sin_cos_of_little();
        let (s0, c0) = multiples(step as i32);
        (s0 * c + c0 * s, c0 * c - s0 * s)
    }

    /// Sine and cosine for |x| ≤ 0.0123.
    fn sin_cos_of_little(self) -> (Self, Self) {
        /// 1/3! and 1/5!.
        const SIXTH: Dd = Dd {
            hi: 0.16666666666666666,
            lo: 9.25185853854297e-18,
        };
        const OVER_120: Dd = Dd {
            hi: 0.008333333333333333,
            lo: 1.1564823173178714e-19,
        };
        /// 1/7!, 1/9! and 1/11!: f64 is enough for these terms, which are below 1e-15.
        const REST: [f64; 3] = [
            0.0001984126984126984,
            2.7557319223985893e-06,
            2.505210838544172e-08,
        ];
        let square = self * self;
        let q = square.hi;
        // x (1 − x²/3! + x⁴/5! …): the omitted terms are below 1e-32.
        let rest = REST[0] - q * (REST[1] - q * REST[2]);
        let sum = OVER_120 - square * rest;
        let sum = SIXTH - sum * square;
        let sum = Self::ONE - sum * square;
        let sin = sum * self;
        // 1 − 2 sin²(x/2) would need another series; the root is accurate because |sin| is small.
        let cos = (Self::ONE - sin * sin).sqrt();
        (sin, cos)
    }

    /// The angle of (x, y), in (−π, π].
    pub(crate) fn atan2(y: Self, x: Self) -> Self {
        let rough = y.hi.atan2(x.hi);
        let first = Self::from(rough);
        let (s, c) = first.sin_cos();
        // The remainder is the angle of (x, y) turned back: so small that it equals its tangent, and f64 is enough.
        let (along, across) = (x.hi * c.hi + y.hi * s.hi, y * c - x * s);
        first + across.hi / along
    }
}

/// Steps per half turn at which sines and cosines are stored.
const STEPS: f64 = 128.0;

/// Sine and cosine of a multiple of π/128.
fn multiples(step: i32) -> (Dd, Dd) {
    /// Steps per quarter turn, and per turn.
    const QUARTER: i32 = STEPS as i32 / 2;
    const WHOLE: i32 = 4 * QUARTER;
    static TABLE: std::sync::LazyLock<Vec<(Dd, Dd)>> = std::sync::LazyLock::new(|| {
        (0..WHOLE)
            .map(|k| {
                let (s, c) = series(Dd::PI * (f64::from(k % QUARTER) / STEPS));
                match k / QUARTER {
                    0 => (s, c),
                    1 => (c, -s),
                    2 => (-s, -c),
                    _ => (-c, s),
                }
            })
            .collect()
    });
    TABLE[step.rem_euclid(WHOLE) as usize]
}

/// Sine and cosine by their series, for angles of at most a quarter turn.
fn series(x: Dd) -> (Dd, Dd) {
    let mut sums = (Dd::ZERO, Dd::ONE);
    let mut term = Dd::ONE;
    for n in 1..40 {
        term = term * x / f64::from(n);
        match n % 4 {
            0 => sums.1 = sums.1 + term,
            1 => sums.0 = sums.0 + term,
            2 => sums.1 = sums.1 - term,
            _ => sums.0 = sums.0 - term,
        }
    }
    sums
}

impl From<f64> for Dd {
    #[inline]
    fn from(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }
}

impl PartialOrd for Dd {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&other.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&other.lo),
            unequal => unequal,
        }
    }
}

impl Dd {
    /// The order of two finite numbers.
    #[inline]
    pub(crate) fn total_cmp(&self, other: &Self) -> Ordering {
        (self.hi.total_cmp(&other.hi)).then(self.lo.total_cmp(&other.lo))
    }
}

impl Neg for Dd {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Add for Dd {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        let (s, e) = two_sum(self.hi, o.hi);
        let (t, f) = two_sum(self.lo, o.lo);
        let (s, e) = quick_two_sum(s, e + t);
        let (hi, lo) = quick_two_sum(s, e + f);
        Self { hi, lo }
    }
}

impl Sub for Dd {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Mul for Dd {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        let (p, e) = two_product(self.hi, o.hi);
        let (hi, lo) = quick_two_sum(p, e + (self.hi * o.lo + self.lo * o.hi));
        Self { hi, lo }
    }
}

impl Div for Dd {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        let q1 = self.hi / o.hi;
        let r = self - o * q1;
        let q2 = r.hi / o.hi;
        let (hi, lo) = quick_two_sum(q1, q2);
        Self { hi, lo }
    }
}

impl Add<f64> for Dd {
    type Output = Self;
    #[inline]
    fn add(self, o: f64) -> Self {
        self + Self::from(o)
    }
}

impl Sub<f64> for Dd {
    type Output = Self;
    #[inline]
    fn sub(self, o: f64) -> Self {
        self + Self::from(-o)
    }
}

impl Mul<f64> for Dd {
    type Output = Self;
    #[inline]
    fn mul(self, o: f64) -> Self {
        let (p, e) = two_product(self.hi, o);
        let (hi, lo) = quick_two_sum(p, e + self.lo * o);
        Self { hi, lo }
    }
}

impl Div<f64> for Dd {
    type Output = Self;
    #[inline]
    fn div(self, o: f64) -> Self {
        self / Self::from(o)
    }
}

impl Ordered for Dd {}

impl Real for Dd {
    const ROUNDING: f64 = Self::EPSILON;
    #[inline]
    fn constant(value: f64) -> Self {
        Self::from(value)
    }
    #[inline]
    fn value(self) -> f64 {
        self.hi
    }
    #[inline]
    fn atan2(self, x: Self) -> Self {
        Self::atan2(self, x)
    }
    #[inline]
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a number that should be 0 is, up to a small multiple of the rounding of double-double.
    fn is_none(x: Dd) -> bool {
        x.hi.abs() < 2e-31
    }

    #[test]
    fn sums_and_products_keep_what_doubles_lose() {
        let tiny = 1.0 / (1u64 << 60) as f64;
        let x = Dd::from(1.0) + tiny;
        assert_eq!(x.to_f64(), 1.0);
        assert_eq!((x - 1.0).to_f64(), tiny);
        // (1 + t)² = 1 + 2 t + t², the last term of which is beyond the precision.
        assert_eq!((x * x - 1.0).to_f64(), 2.0 * tiny);
        assert!(x > Dd::ONE && -x < Dd::ONE && (-x).abs() == x);
        assert!(Dd::from(-2.0).is_negative() && Dd::ZERO.is_zero());
        assert_eq!(x.scaled(4.0), x * 4.0);
    }

    #[test]
    fn quotients_and_roots_are_inverse() {
        for (a, b) in [(1.0, 3.0), (-2.0, 7.0), (1e10, 1e-7), (0.1, 0.3)] {
            let (a, b) = (Dd::from(a) / 7.0, Dd::from(b) / 11.0);
            assert!(is_none((a / b * b - a) / a));
            let root = b.abs().sqrt();
            assert!(is_none((root * root - b.abs()) / b));
        }
        assert_eq!(Dd::from(-1.0).sqrt(), Dd::ZERO);
    }

    /// The addition theorem, sin² + cos², known angles; and π from Machin's formula.
    #[test]
    fn sines_and_angles_belong_together() {
        for i in -40..40 {
            let t = Dd::from(f64::from(i)) / 7.0;
            let (s, c) = t.sin_cos();
            assert!(is_none(s * s + c * c - 1.0));
            let (s2, c2) = (t * 2.0).sin_cos();
            assert!(
                is_none(s2 - s * c * 2.0) && is_none(c2 - (c * c - s * s)),
                "{i}"
            );
            let back = Dd::atan2(s * 3.0, c * 3.0);
            let turns = ((t - back) / Dd::TAU).to_f64().round();
            assert!(is_none(t - back - Dd::TAU * turns), "{i}");
        }
        let sixth = (Dd::PI / 6.0).sin_cos().0;
        assert!(is_none(sixth - 0.5));
        let atan = |n: f64| Dd::atan2(Dd::ONE, Dd::from(n));
        assert!(is_none(atan(5.0) * 4.0 - atan(239.0) - Dd::PI / 4.0));
        // The series of the sine at 1/32, in quotients of whole numbers.
        let x = Dd::ONE / 32.0;
        let mut sum = Dd::ZERO;
        let mut term = x;
        for k in 0..12 {
            sum = sum + term;
            let n = f64::from(2 * k + 2);
            term = -(term * x * x) / (n * (n + 1.0));
        }
        assert!(is_none(x.sin_cos().0 - sum));
        let (s, c) = (Dd::atan2(Dd::from(0.0), Dd::from(-1.0)), Dd::PI);
        assert!(is_none(s - c));
    }
}
