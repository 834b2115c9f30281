//! Trigonometric polynomials of degree four, and intervals that contain their roots.

use std::sync::LazyLock;

use super::{Dd, Real};
use crate::geometry::Rotation;

/// Highest frequency.
const DEGREE: usize = 4;
/// Number of orientations at which a polynomial is sampled; enough for its coefficients.
const SAMPLES: usize = 2 * DEGREE + 1;

/// Orientations and weights from which a polynomial's coefficients are computed.
struct Sampling {
    /// Cosine and sine of the sampled orientations.
    turns: [(Dd, Dd); SAMPLES],
    /// By sample and frequency, the weights of a value in the coefficients of the cosine and of the sine.
    weights: [[(Dd, Dd); DEGREE + 1]; SAMPLES],
}

static SAMPLING: LazyLock<Sampling> = LazyLock::new(|| {
    let turns: [(Dd, Dd); SAMPLES] = core::array::from_fn(|j| {
        let (sin, cos) = (Dd::TAU * j as f64 / SAMPLES as f64).sin_cos();
        (cos, sin)
    });
    let weights = core::array::from_fn(|j| {
        core::array::from_fn(|k| {
            let share = if k == 0 { 1.0 } else { 2.0 };
            let factor = Dd::from(share) / SAMPLES as f64;
            let (cos, sin) = turns[j * k % SAMPLES];
            (cos * factor, sin * factor)
        })
    });
    Sampling { turns, weights }
});

/// Σ aₖ cos kθ + bₖ sin kθ, k = 0 … 4, known up to an error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TrigPolynomial<T = f64> {
    a: [T; DEGREE + 1],
    b: [T; DEGREE + 1],
    /// Bound on the third derivative.
    twist: f64,
    /// Bound on the error of a value.
    error: f64,
}

impl<T: Real> TrigPolynomial<T> {
    /// The polynomial with the values of `f`, which must have degree four at most.
    ///
    /// `f` also returns the size of the terms that were added up in its value; the error is a small multiple of the rounding of the
    /// largest.
    pub(crate) fn sampled(f: impl Fn(Rotation<T>) -> (T, f64)) -> Self {
        /// Errors of the values and of the sums over the samples, in units of rounding.
        const ERROR: f64 = 64.0;
        let zero = T::constant(0.0);
        let (mut a, mut b) = ([zero; DEGREE + 1], [zero; DEGREE + 1]);
        let mut size: f64 = 0.0;
        let Sampling { turns, weights } = &*SAMPLING;
        for (&(cos, sin), weights) in turns.iter().zip(weights) {
            let (cos, sin) = (cos.to_real(), sin.to_real());
            let (value, terms) = f(Rotation { cos, sin });
            size = size.max(terms);
            for (k, w) in weights.iter().enumerate() {
                a[k] = a[k] + value * w.0.to_real();
                b[k] = b[k] + value * w.1.to_real();
            }
        }
        let twist: f64 = (0..=DEGREE)
            .map(|k| (k * k * k) as f64 * a[k].value().hypot(b[k].value()))
            .sum();
        Self {
            a,
            b,
            twist: twist * (1.0 + 1e-12),
            error: ERROR * T::ROUNDING * size,
        }
    }

    /// Value and first two derivatives at the orientation with the given cosine and sine.
    #[inline]
    fn jet(&self, cos: T, sin: T) -> [T; 3] {
        let zero = T::constant(0.0);
        let (mut c, mut s) = (cos, sin);
        let (mut value, mut slope, mut bend) = (self.a[0], zero, zero);
        for k in 1..=DEGREE {
            let f = T::constant(k as f64);
            let wave = self.a[k] * c + self.b[k] * s;
            value = value + wave;
            slope = slope + f * (self.b[k] * c - self.a[k] * s);
            bend = bend - f * f * wave;
            (c, s) = (c * cos - s * sin, s * cos + c * sin);
        }
        [value, slope, bend]
    }

    /// Value and derivative.
    #[inline]
    pub(crate) fn at(&self, theta: T) -> (T, T) {
        let (sin, cos) = theta.sin_cos();
        let [value, slope, _] = self.jet(cos, sin);
        (value, slope)
    }

    /// Bound on the error of a value.
    pub(crate) fn error(&self) -> f64 {
        self.error
    }

    /// Calls `found` with intervals that contain all roots between `lo` and `hi`, each with a change of sign.
    ///
    /// On (m − h, m + h) the polynomial differs from f(m) + f′(m) x + f″(m) x² / 2 by at most M h³ / 6, and its derivative from f′(m) by at
    /// most |f″(m)| h + M h² / 2, with M the bound on the third derivative: so there is no root where the distance of the parabola from
    /// zero is larger, and at most one where |f′(m)| is larger. Otherwise the interval is halved, down to `narrowest`, where a double root
    /// may be missed; between two such roots the value is of the order of |f″| h².
    ///
    /// Where the sign of the value is unknown on a whole interval, `vague` is called with it instead.
    pub(crate) fn brackets(
        &self,
        lo: T,
        hi: T,
        narrowest: f64,
        found: &mut impl FnMut(T, T),
        vague: &mut impl FnMut(T, T),
    ) {
        let middle = T::constant(0.5) * (lo + hi);
        let half = 0.5 * (hi - lo).value();
        let within = self.within(middle, half);
        match within {
            Within::None => {}
            Within::Unknown => vague(lo, hi),
            Within::Several if half >= narrowest => {
                self.brackets(lo, middle, narrowest, found, vague);
                self.brackets(middle, hi, narrowest, found, vague);
            }
            Within::Several | Within::One => {
                let (at_lo, at_hi) = (self.at(lo).0.value(), self.at(hi).0.value());
                if at_lo * at_hi <= 0.0 || at_lo.abs() < self.error || at_hi.abs() < self.error {
                    found(lo, hi);
                }
            }
        }
    }

    /// Whether `admits` holds for an interval around every root between `lo` and `hi`, in which the polynomial certainly has no other root
    /// and changes its sign; false if that is not certain on an interval as short as `narrowest`.
    pub(crate) fn changes_sign_only(
        &self,
        lo: T,
        hi: T,
        narrowest: f64,
        admits: &impl Fn(T, T) -> bool,
    ) -> bool {
        let middle = T::constant(0.5) * (lo + hi);
        let half = 0.5 * (hi - lo).value();
        match self.within(middle, half) {
            Within::None => true,
            Within::Unknown => false,
            Within::Several => {
                half >= narrowest
                    && self.changes_sign_only(lo, middle, narrowest, admits)
                    && self.changes_sign_only(middle, hi, narrowest, admits)
            }
            Within::One => {
                let [at_lo, at_hi] = [lo, hi].map(|t| self.at(t).0.value());
                let is_certain = at_lo.abs() > self.error && at_hi.abs() > self.error;
                is_certain && ((at_lo > 0.0) == (at_hi > 0.0) || admits(lo, hi))
            }
        }
    }

    /// The roots within `half` of an orientation.
    fn within(&self, middle: T, half: f64) -> Within {
        // If numbers overflow, nothing is known, on however short an interval.
        if !self.twist.is_finite() {
            return Within::Unknown;
        }
        let (sin, cos) = middle.sin_cos();
        let [value, slope, bend] = self.jet(cos, sin).map(Real::value);
        let rest = self.twist * half.powi(3) * (1.0 / 6.0);
        // The parabola on the side of zero of f(m): it is nearest to zero at an end, or where its slope vanishes.
        let (side, along) = (value.abs(), slope.abs() * half);
        let bow = 0.5 * value.signum() * bend * half * half;
        let least = if bow > 0.5 * along {
            side - 0.25 * along * along / bow
        } else {
            side - along + bow
        };
        if least > rest + self.error {
            return Within::None;
        }
        if side + along + bow.abs() + rest <= self.error {
            return Within::Unknown;
        }
        let change = bend.abs() * half + 0.5 * self.twist * half * half;
        if slope.abs() > change {
            Within::One
        } else {
            Within::Several
        }
    }
}

/// Roots in an interval, as far as they are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Within {
    /// There is none.
    None,
    /// There is one at most, and it is simple.
    One,
    /// There may be several.
    Several,
    /// The sign of the value is unknown in the whole interval.
    Unknown,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_roots_of_a_product() {
        // sin(θ − 0.3) sin(θ − 1.1) sin 2θ, of degree four.
        let f = |Rotation { cos: c, sin: s }: Rotation| {
            let turned = |a: f64| s * a.cos() - c * a.sin();
            (turned(0.3) * turned(1.1) * 2.0 * s * c, 1.0)
        };
        let p = TrigPolynomial::sampled(f);
        let mut roots = Vec::new();
        p.brackets(
            0.1,
            2.9,
            1e-9,
            &mut |lo, hi| roots.push((lo, hi)),
            &mut |_, _| panic!("it is not zero"),
        );
        let expected = [0.3, 1.1, core::f64::consts::FRAC_PI_2];
        assert_eq!(roots.len(), 3);
        for ((lo, hi), x) in roots.into_iter().zip(expected) {
            assert!(lo <= x && x <= hi);
        }
    }

    /// Two roots near each other are not overlooked, on however long an interval, and a change of sign is admitted or not.
    #[test]
    fn every_change_of_sign_is_admitted_or_not() {
        let narrowest = 1e-3;
        for apart in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6] {
            for (middle, hi) in [(3.0, 6.0), (1.5, 3.0), (0.5, 1.0)] {
                let top = f64::cos(0.5 * apart);
                let f = |Rotation { cos, sin }: Rotation| {
                    (top - (cos * f64::cos(middle) + sin * f64::sin(middle)), 2.0)
                };
                let p = TrigPolynomial::sampled(f);
                assert!(!p.changes_sign_only(0.0, hi, narrowest, &|_, _| false));
                assert!(p.changes_sign_only(0.0, middle - apart, narrowest, &|_, _| false));
            }
        }
        let p = TrigPolynomial::sampled(|t: Rotation| (t.sin, 1.0));
        assert!(p.changes_sign_only(-1.0, 2.0, narrowest, &|a, b| a < 0.0 && 0.0 < b));
        assert!(!p.changes_sign_only(-1.0, 2.0, narrowest, &|_, _| false));
        assert!(!p.changes_sign_only(0.0, 2.0, narrowest, &|_, _| true));
    }

    /// Its root at 0 is known to 64 roundings: if it lies outside by less, it may as well lie inside.
    #[test]
    fn a_root_at_an_end_is_in_both_intervals() {
        let p = TrigPolynomial::sampled(|t: Rotation| (t.sin, 1.0));
        let brackets = |lo, hi| {
            let mut all = Vec::new();
            p.brackets(lo, hi, 1e-9, &mut |a, b| all.push((a, b)), &mut |_, _| {
                panic!("it is not zero")
            });
            all
        };
        for off in [0.0, 1e-15, 1e-14] {
            assert_eq!(brackets(off, 0.5), [(off, 0.5)]);
            assert_eq!(brackets(-0.5, -off), [(-0.5, -off)]);
        }
        assert!(brackets(1e-13, 0.5).is_empty() && brackets(-0.5, -1e-13).is_empty());
    }

    /// 1.5 + cos θ − 2 sin 3θ + sin 4θ, with all frequencies except 2, compared with its known derivatives.
    #[test]
    fn values_and_slopes_are_those_of_the_function() {
        let p = TrigPolynomial::sampled(|Rotation { cos: c, sin: s }: Rotation| {
            let theta = s.atan2(c);
            let value = 1.5 + theta.cos() - 2.0 * (3.0 * theta).sin() + (4.0 * theta).sin();
            (value, 4.0)
        });
        for k in 0..20 {
            let t = 0.3 * f64::from(k);
            let (value, slope) = p.at(t);
            let expected = 1.5 + t.cos() - 2.0 * (3.0 * t).sin() + (4.0 * t).sin();
            assert!((value - expected).abs() < 1e-13);
            let expected = -t.sin() - 6.0 * (3.0 * t).cos() + 4.0 * (4.0 * t).cos();
            assert!((slope - expected).abs() < 1e-13);
            let bend = p.jet(t.cos(), t.sin())[2];
            let expected = -t.cos() + 18.0 * (3.0 * t).sin() - 16.0 * (4.0 * t).sin();
            assert!((bend - expected).abs() < 1e-12);
        }
        // 1³ + 2 · 3³ + 4³
        assert!((p.twist - 119.0).abs() < 1e-9 && p.twist >= 119.0);
        assert!((p.error / f64::EPSILON - 256.0).abs() < 1e-9);
    }

    /// However narrow the interval, a simple root has a certain change of sign.
    #[test]
    fn a_simple_root_is_not_vague() {
        let p = TrigPolynomial::sampled(|t: Rotation| (t.sin, 1.0));
        for (lo, hi) in [(-1e-8, 1.1e-8), (-1e-8, 1e-8), (-1e-12, 2e-12)] {
            let mut found = false;
            p.brackets(
                lo,
                hi,
                1e-9,
                &mut |a, b| found |= a <= 0.0 && 0.0 <= b,
                &mut |_, _| panic!("it is not zero"),
            );
            assert!(found);
        }
    }

    /// A polynomial that is zero within its error gives one interval, not roots.
    #[test]
    fn nothing_is_known_of_what_vanishes() {
        let p = TrigPolynomial::sampled(|_: Rotation| (1e-16, 1.0));
        let mut all = Vec::new();
        p.brackets(
            0.0,
            1.0,
            1e-9,
            &mut |_, _| panic!("no root"),
            &mut |a, b| {
                all.push((a, b));
            },
        );
        assert_eq!(all, [(0.0, 1.0)]);
    }

    /// cos θ − 1 ± d has two roots or none, however near to each other, for any factor and interval.
    #[test]
    fn roots_that_are_nearly_one_are_told_apart() {
        for (d, factor) in [(1e-3, 1.0), (1e-6, 1.0), (1e-10, 1.0), (1e-6, 100.0)] {
            for (lo, hi) in [(-0.7, 1.0), (-0.1, 0.22), (-0.05, 0.25)] {
                let count = |shift: f64| {
                    let p = TrigPolynomial::sampled(|t: Rotation| {
                        (factor * (t.cos - 1.0 + shift), 2.0 * factor)
                    });
                    let mut all = Vec::new();
                    p.brackets(lo, hi, 1e-9, &mut |a, b| all.push((a, b)), &mut |_, _| ());
                    let root = (1.0 - shift).acos();
                    for (lo, hi) in &all {
                        assert!([root, -root].iter().any(|r| lo <= r && r <= hi));
                    }
                    all.len()
                };
                assert_eq!((count(d), count(-d)), (2, 0), "{d} {factor} {lo} {hi}");
            }
        }
    }

    /// A double root is resolved except where its parabola is within the error.
    #[test]
    fn what_is_vague_about_a_double_root_is_narrow() {
        let p = TrigPolynomial::sampled(|t: Rotation| (t.cos - 1.0, 2.0));
        for half in [0.5, 1e-3] {
            let mut seen = false;
            let narrow = |lo: f64, hi: f64| assert!(hi - lo < 1e-6, "{lo} {hi}");
            p.brackets(
                -half,
                half,
                1e-9,
                &mut |lo, hi| narrow(lo, hi),
                &mut |lo, hi| {
                    narrow(lo, hi);
                    seen |= lo <= 0.0 && 0.0 <= hi;
                },
            );
            assert!(seen);
        }
    }
}
