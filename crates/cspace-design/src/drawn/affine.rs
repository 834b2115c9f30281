//! Affine enclosures, which retain their dependence on a few quantities, so that common terms cancel.

use core::ops::{Add, Div, Mul, Neg, Sub};

use cspace::{Ball, Real};

/// An enclosure: arithmetic in which every result contains all possible results.
pub trait Enclosure: Real {
    /// All reals within a radius of a middle, independent of all other numbers.
    fn about(mid: f64, radius: f64) -> Self;

    /// The reals from `lo` to `hi`.
    fn from_to(lo: f64, hi: f64) -> Self {
        let ball = Ball::between(lo, hi);
        Self::about(ball.mid, ball.radius)
    }

    /// The smallest ball that contains it.
    fn ball(self) -> Ball {
        Ball::new(self.value(), self.spread())
    }
}

impl Enclosure for Ball {
    fn about(mid: f64, radius: f64) -> Self {
        Self::new(mid, radius)
    }
}

/// All reals mid + Σ cᵢ εᵢ + δ, with |εᵢ| ≤ 1 for N quantities shared by all numbers, and |δ| ≤ radius for rounding and nonlinear terms.
///
/// ```
/// use cspace::Real;
/// use cspace_design::drawn::{Affine, Enclosure};
/// let x = Affine::<2>::variable(3.0, 0.1, 0);
/// let y = Affine::<2>::variable(1.0, 0.2, 1);
/// // (x + y) − x is y, though x is not known.
/// let back = (x + y) - x;
/// assert!((back.spread() - 0.2).abs() < 1e-12);
/// assert!((x / y).ball().sign() == 1);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine<const N: usize> {
    /// The middle.
    pub mid: f64,
    /// Coefficient of each quantity.
    pub by: [f64; N],
    /// Bound of the remaining term δ.
    pub radius: f64,
}

/// Bound of the relative rounding error of the few operations on a coefficient.
const UNIT: f64 = 8.0 * f64::EPSILON;

impl<const N: usize> Affine<N> {
    /// The quantity number `index`: all reals within a radius of a middle. If `index` is N or more, it is independent of all other numbers.
    pub fn variable(mid: f64, radius: f64, index: usize) -> Self {
        let mut by = [0.0; N];
        if let Some(own) = by.get_mut(index) {
            *own = radius;
            return Self {
                mid,
                by,
                radius: 0.0,
            };
        }
        Self { mid, by, radius }
    }

    fn linear(self) -> f64 {
        self.by.iter().map(|c| c.abs()).sum()
    }

    #[inline]
    fn rounded(mid: f64, by: [f64; N], radius: f64) -> Self {
        let size: f64 = mid.abs() + by.iter().map(|c| c.abs()).sum::<f64>();
        Self {
            mid,
            by,
            radius: radius * (1.0 + UNIT) + size * UNIT + f64::MIN_POSITIVE,
        }
    }

    /// A function with the value f and the derivative f′ in the middle, and f″ ρ²/2 ≤ `rest` within ρ of it.
    fn curved(self, value: f64, slope: f64, rest: f64) -> Self {
        let by = self.by.map(|c| slope * c);
        Self::rounded(value, by, slope.abs() * self.radius + rest)
    }

    /// A line of a given slope, widened to contain the values between `ends` at 0: it encloses a function that differs from the line by no
    /// more.
    fn line(self, slope: f64, ends: [f64; 2]) -> Self {
        let [lo, hi] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let by = self.by.map(|c| slope * c);
        let size = slope.abs() * (self.mid.abs() + self.spread()) + hi.abs().max(lo.abs());
        let rest = slope.abs() * self.radius + half + size * UNIT;
        Self::rounded(slope * self.mid + middle, by, rest)
    }

    fn all(mid: f64) -> Self {
        Self::about(if mid.is_finite() { mid } else { 0.0 }, f64::INFINITY)
    }

    fn of_ball(ball: Ball) -> Self {
        Self::about(ball.mid, ball.radius)
    }
}

impl<const N: usize> Enclosure for Affine<N> {
    fn about(mid: f64, radius: f64) -> Self {
        Self {
            mid,
            by: [0.0; N],
            radius,
        }
    }
}

impl<const N: usize> Add for Affine<N> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        let by = core::array::from_fn(|i| self.by[i] + o.by[i]);
        Self::rounded(self.mid + o.mid, by, self.radius + o.radius)
    }
}

impl<const N: usize> Neg for Affine<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            mid: -self.mid,
            by: self.by.map(|c| -c),
            radius: self.radius,
        }
    }
}

impl<const N: usize> Sub for Affine<N> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl<const N: usize> Mul for Affine<N> {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        let by = core::array::from_fn(|i| self.mid * o.by[i] + self.by[i] * o.mid);
        let (a, b) = (self.spread(), o.spread());
        // Zero times an unknown number is zero.
        let product = |x: f64, y: f64| if x == 0.0 || y == 0.0 { 0.0 } else { x * y };
        let radius =
            product(self.mid.abs(), o.radius) + product(o.mid.abs(), self.radius) + product(a, b);
        Self::rounded(self.mid * o.mid, by, radius)
    }
}

impl<const N: usize> Div for Affine<N> {
    type Output = Self;
    #[inline]
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn div(self, o: Self) -> Self {
        let (m, spread) = (o.mid, o.spread());
        let least = (m.abs() - spread) * (1.0 - UNIT);
        let most = (m.abs() + spread) * (1.0 + UNIT);
        if least.is_nan() || least <= 0.0 || !most.is_finite() {
            return Self::all(self.mid / m);
        }
        // On [a, b] 1/x + x/b² decreases from its value at a to that at b: a line in the middle has the sign of 1/x wherever that is
        // certain.
        let slope = -1.0 / (most * most);
        let ends = [1.0 / least - slope * least, 2.0 / most];
        let inverse = if m > 0.0 { o } else { -o }.line(slope, ends);
        self * if m > 0.0 { inverse } else { -inverse }
    }
}

impl<const N: usize> Real for Affine<N> {
    const ROUNDING: f64 = f64::EPSILON;

    #[inline]
    fn constant(value: f64) -> Self {
        Self::about(value, 0.0)
    }

    #[inline]
    fn value(self) -> f64 {
        self.mid
    }

    #[inline]
    fn spread(self) -> f64 {
        self.linear() * (1.0 + UNIT) + self.radius
    }

    fn unknown(self) -> Self {
        Self::about(self.mid, f64::INFINITY)
    }

    fn sqrt(self) -> Self {
        let spread = self.spread();
        let lo = (self.mid - spread) * (1.0 - UNIT);
        if lo > 0.0 && spread.is_finite() {
            // On [a, b] √x − x/(2√b) increases from its value at a to that at b.
            let root = ((self.mid + spread) * (1.0 + UNIT)).sqrt();
            let slope = 0.5 / root;
            self.line(slope, [lo.sqrt() - slope * lo, 0.5 * root])
        } else {
            Self::of_ball(self.ball().sqrt())
        }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.mid.sin_cos();
        let spread = self.spread();
        if spread > 1.0 || spread.is_nan() {
            let (sin, cos) = self.ball().sin_cos();
            return (Self::of_ball(sin), Self::of_ball(cos));
        }
        let rest = 0.5 * spread * spread;
        (self.curved(s, c, rest), self.curved(c, -s, rest))
    }

    fn abs(self) -> Self {
        match self.ball().sign() {
            1 => self,
            -1 => -self,
            _ => Self::of_ball(self.ball().abs()),
        }
    }

    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    fn acos(self) -> Self {
        Self::of_ball(self.ball().acos())
    }

    fn asin(self) -> Self {
        Self::of_ball(self.ball().asin())
    }

    fn atan(self) -> Self {
        Self::of_ball(self.ball().atan())
    }

    fn atan2(self, x: Self) -> Self {
        Self::of_ball(self.ball().atan2(x.ball()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Formulas of two quantities, at many values of both, with other quantities held.
    #[test]
    fn encloses_results_at_sampled_members() {
        type A = Affine<2>;
        fn formulas<T: Real>(x: T, y: T) -> [T; 9] {
            let (sin, cos) = (x * y).sin_cos();
            [
                x * y - x,
                (x + y) / (x - y),
                (x * x + y * y).sqrt(),
                sin,
                cos * x - y,
                x.hypot(y) - x,
                (y - x).abs(),
                y.atan2(x),
                (x / (x + y)).acos(),
            ]
        }
        let found = formulas(A::variable(1.3, 0.2, 0), A::variable(-0.4, 0.1, 1));
        for i in 0..=20 {
            for j in 0..=20 {
                let (x, y) = (1.1 + 0.02 * f64::from(i), -0.5 + 0.01 * f64::from(j));
                for (k, (enclosure, value)) in found.iter().zip(formulas(x, y)).enumerate() {
                    let off = (enclosure.mid - value).abs();
                    assert!(
                        off <= enclosure.spread() || value.is_nan(),
                        "{k} {x} {y}: {enclosure:?} {value}"
                    );
                }
            }
        }
        // First order in the widths: a tenth of the width gives a tenth of the uncertainty, and common terms cancel.
        let cancelled = A::variable(1.3, 0.2, 0) * A::constant(3.0) - A::variable(3.9, 0.6, 0);
        assert!(cancelled.spread() < 1e-12);
    }

    #[test]
    fn what_is_not_known_stays_so() {
        type A = Affine<1>;
        let x = A::variable(0.0, 1.0, 0);
        let none = A::constant(1.0) / x;
        assert_eq!(none.ball().sign(), 0);
        assert_eq!((none - none).ball().sign(), 0);
        assert_eq!((none * A::constant(0.0)).mid, 0.0);
        let root = (x - A::constant(0.5)).sqrt();
        assert!(root.mid + root.spread() >= 0.7);
    }
}
