//! Enclosures: a midpoint and a radius, with rounding accounted for.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::Real;

/// All reals within `radius` of `mid`. Every operation returns an enclosure of all its results.
///
/// ```
/// use cspace::{Ball, Real};
/// let side = Ball::between(2.9, 3.1);
/// let diagonal = (side * side + Ball::constant(16.0)).sqrt();
/// let [lo, hi] = diagonal.ends();
/// assert!(lo <= 2.9_f64.hypot(4.0) && 3.1_f64.hypot(4.0) <= hi && hi - lo < 0.13);
/// assert_eq!(diagonal.sign(), 1);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// The middle.
    pub mid: f64,
    /// Largest distance of a member from the middle; infinite or NaN where nothing is known.
    pub radius: f64,
}

/// Bound of the relative rounding error of one operation, with a margin for that of the radius itself.
const UNIT: f64 = 2.0 * f64::EPSILON;
/// Bound of any error by underflow.
const TINY: f64 = f64::MIN_POSITIVE;

impl Ball {
    /// The reals within a radius of a middle.
    #[inline(always)]
    pub const fn new(mid: f64, radius: f64) -> Self {
        Self { mid, radius }
    }

    /// Encloses every real, about the value of a formula in the middle, if that is a number.
    #[inline]
    const fn all(mid: f64) -> Self {
        Self::new(if mid.is_finite() { mid } else { 0.0 }, f64::INFINITY)
    }

    #[inline(always)]
    fn rounded(mid: f64, radius: f64) -> Self {
        Self::new(mid, radius * (1.0 + 4.0 * UNIT) + mid.abs() * UNIT + TINY)
    }

    /// The interval from `lo` to `hi`.
    #[inline(always)]
    pub fn between(lo: f64, hi: f64) -> Self {
        Self::rounded(0.5 * (lo + hi), 0.5 * (hi - lo))
    }

    /// A monotonous function of all members, with the value `mid` in the middle; nothing is known beyond the ends of its domain.
    fn rising(self, mid: f64, from: f64, to: f64, f: impl Fn(f64) -> f64) -> Self {
        let [lo, hi] = self.ends();
        if !(from <= lo && hi <= to) {
            return Self::all(mid);
        }
        let (below, above) = (f(lo), f(hi));
        let middle = f(self.mid);
        Self::rounded(
            mid,
            (above - middle).max(middle - below) + UNIT * (below.abs() + above.abs()),
        )
    }

    /// The smallest and the largest member, rounded outwards.
    pub fn ends(self) -> [f64; 2] {
        if self.radius == 0.0 {
            return [self.mid; 2];
        }
        [
            (self.mid - self.radius).next_down(),
            (self.mid + self.radius).next_up(),
        ]
    }

    /// The sign of all its members, if they have one sign: 1 or −1; otherwise 0.
    #[inline(always)]
    pub fn sign(self) -> i8 {
        if self.mid > self.radius {
            1
        } else if -self.mid > self.radius {
            -1
        } else {
            0
        }
    }
}

impl Add for Ball {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Self::rounded(self.mid + o.mid, self.radius + o.radius)
    }
}

impl Sub for Ball {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Self::rounded(self.mid - o.mid, self.radius + o.radius)
    }
}

impl Neg for Ball {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.mid, self.radius)
    }
}

impl Mul for Ball {
    type Output = Self;
    #[inline(always)]
    fn mul(self, o: Self) -> Self {
        Self::rounded(
            self.mid * o.mid,
            self.mid.abs() * o.radius + self.radius * (o.mid.abs() + o.radius),
        )
    }
}

impl Div for Ball {
    type Output = Self;
    #[inline(always)]
    fn div(self, divisor: Self) -> Self {
        let least = divisor.mid.abs() - divisor.radius;
        let mid = self.mid / divisor.mid;
        if least.is_nan() || least <= 0.0 {
            return Self::all(mid);
        }
        // The quotient enlarges the underflow error of the product.
        let spread = self.radius + mid.abs() * divisor.radius + TINY;
        Self::rounded(mid, spread / least)
    }
}

impl Real for Ball {
    const ROUNDING: f64 = f64::EPSILON;

    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self::new(value, 0.0)
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self.mid
    }

    #[inline(always)]
    fn spread(self) -> f64 {
        self.radius
    }

    #[inline(always)]
    fn unknown(self) -> Self {
        Self::new(self.mid, f64::INFINITY)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let hi = self.mid + self.radius;
        let lo = self.mid - self.radius;
        if !hi.is_finite() {
            // Too large, or NaN after a quotient by zero: the larger of that and 0 would be 0.
            return Self::all(self.mid.max(0.0).sqrt());
        }
        if lo > 0.0 {
            // √(m ± r) differs from √m by at most r / √lo / (1 + √(m / lo)) ≤ r / (√m + √lo).
            let mid = self.mid.sqrt();
            Self::rounded(mid, self.radius / (mid + lo.sqrt()))
        } else {
            let top = hi.max(0.0).sqrt();
            Self::rounded(0.5 * top, 0.5 * top)
        }
    }

    /// With the middle m and the radius h: |cos x − cos m| ≤ |sin m| h + h² / 2, and likewise for the sine.
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.mid.sin_cos();
        let h = self.radius.min(4.0);
        let rest = 0.5 * h * h;
        (
            Self::rounded(s, (c.abs() * h + rest).min(2.0)),
            Self::rounded(c, (s.abs() * h + rest).min(2.0)),
        )
    }

    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    fn acos(self) -> Self {
        self.rising(self.mid.acos(), -1.0, 1.0, |x| -x.acos())
    }

    fn asin(self) -> Self {
        self.rising(self.mid.asin(), -1.0, 1.0, f64::asin)
    }

    fn atan(self) -> Self {
        self.rising(self.mid.atan(), f64::MIN, f64::MAX, f64::atan)
    }

    /// As seen from the origin, a disc of radius r at the distance d is within asin(r / d) ≤ (π/2) r / d of its middle.
    fn atan2(self, x: Self) -> Self {
        let share = self.radius.hypot(x.radius) / self.mid.hypot(x.mid);
        let mid = self.mid.atan2(x.mid);
        let is_cut = x.mid <= 0.0 && self.sign() == 0;
        if share < 1.0 && !is_cut {
            Self::rounded(mid, core::f64::consts::FRAC_PI_2 * share)
        } else {
            Self::all(mid)
        }
    }

    /// Encloses the absolute values of all its members.
    #[inline(always)]
    fn abs(self) -> Self {
        match self.sign() {
            1 => self,
            -1 => -self,
            _ if !self.radius.is_finite() => Self::all(self.mid.abs()),
            _ => Self::between(0.0, self.mid.abs() + self.radius),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn encloses_results_at_sampled_members() {
        let a = Ball::between(0.3, 0.5);
        let b = Ball::between(-2.0, -1.5);
        for i in 0..=10 {
            for j in 0..=10 {
                let (x, y) = (0.3 + 0.02 * f64::from(i), -2.0 + 0.05 * f64::from(j));
                for (ball, value) in [
                    (a + b, x + y),
                    (a - b, x - y),
                    (a * b, x * y),
                    (a / b, x / y),
                    (a.sqrt(), x.sqrt()),
                    (a.sin_cos().1, x.cos()),
                    (a.sin_cos().0, x.sin()),
                    (a.tan(), x.tan()),
                    (a.acos(), x.acos()),
                    (a.asin(), x.asin()),
                    (b.atan(), y.atan()),
                    (a.atan2(b), x.atan2(y)),
                ] {
                    assert!((ball.mid - value).abs() <= ball.radius, "{ball:?} {value}");
                }
            }
        }
    }

    #[test]
    fn has_no_sign_when_it_contains_zero() {
        assert_eq!(Ball::between(-1.0, 1.0).sign(), 0);
        assert_eq!(Ball::between(0.0, 1.0).sign(), 0);
        assert_eq!(Ball::between(0.1, 1.0).sign(), 1);
        assert_eq!(Ball::between(-1.0, -0.1).sign(), -1);
        assert_eq!(a_quotient_by_zero().sign(), 0);
        // Unknown numbers stay unknown: ∞ − ∞ and its root are NaN, or enclose all reals.
        let root = a_quotient_by_zero().sqrt();
        let unknown = (root - root).sqrt();
        assert!(!(unknown.mid.abs() > unknown.radius || unknown.radius < 1e300));
    }

    #[test]
    fn encloses_no_more_than_its_formulas_say() {
        let is = |ball: Ball, mid: f64, radius: f64| {
            assert!((ball.mid - mid).abs() < 1e-15, "{ball:?}");
            assert!((ball.radius - radius).abs() < 1e-14, "{ball:?}");
        };
        let (sin, cos) = Ball::new(0.0, 1e-3).sin_cos();
        is(cos, 1.0, 0.5e-6);
        is(sin, 0.0, 1e-3 + 0.5e-6);
        is(Ball::new(1.5, 2.5).sqrt(), 1.0, 1.0);
        is(Ball::new(2.0, 2.0).sqrt(), 1.0, 1.0);
        is(
            Ball::new(5.0, 4.0).sqrt(),
            5.0_f64.sqrt(),
            4.0 / (5.0_f64.sqrt() + 1.0),
        );
        is(
            Ball::new(3.0, 0.5) * Ball::new(-2.0, 0.25),
            -6.0,
            0.75 + 0.5 * 2.25,
        );
        is(
            Ball::new(3.0, 0.5) / Ball::new(-2.0, 0.25),
            -1.5,
            (0.5 + 1.5 * 0.25) / 1.75,
        );
    }

    fn a_quotient_by_zero() -> Ball {
        Ball::constant(1.0) / Ball::between(-1.0, 1.0)
    }
}
