//! Roots of α cos θ + β sin θ + γ, the form of every event between two contact curves.

use core::f64::consts::TAU;

use super::{Dd, Ordered};
use crate::geometry::Vector;

/// The function α cos θ + β sin θ + γ, of amplitude A = √(α² + β²).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Trig<T = f64> {
    pub(crate) alpha: T,
    pub(crate) beta: T,
    pub(crate) gamma: T,
    /// A bound on the sum of absolute values in any coefficient: the coefficients are right to a few ulps of it.
    pub(crate) scale: f64,
    /// Squared distances whose difference the function is, if it has this form.
    pub(crate) distances: Option<Distances<T>>,
}

/// The function |u + R w|² − d²: for circles of nearly one radius about nearly one centre the differences of lengths are accurate, those of
/// their squares are not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Distances<T> {
    pub(crate) u: Vector<T>,
    pub(crate) w: Vector<T>,
    /// d ≥ 0.
    pub(crate) distance: T,
    /// A bound on the sum of absolute values in any of the three lengths.
    pub(crate) parts: f64,
}

/// An orientation with its error, radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Event {
    pub(crate) theta: f64,
    pub(crate) error: f64,
}

impl Event {
    /// The image of the event, by whole turns, in the interval (mid − half, mid + half), if there is one within its error.
    pub(crate) fn within(self, mid: f64, half: f64) -> Option<Self> {
        let theta = self.theta - TAU * ((self.theta - mid) / TAU).round();
        ((theta - mid).abs() <= half + self.error).then_some(Self { theta, ..self })
    }
}

/// A number and a bound on its error.
pub(crate) type Known<T> = (T, f64);

/// Errors of coefficients, in units of their scale.
pub(crate) trait Errors: Ordered {
    /// Error of a coefficient.
    const COEFFICIENT: f64;
    /// Error of a length, in units of [`Distances::parts`].
    const LENGTH: f64;
}

impl Errors for f64 {
    const COEFFICIENT: f64 = 8.0 * Self::EPSILON;
    const LENGTH: f64 = 4.0 * Self::EPSILON;
}

impl Errors for Dd {
    const COEFFICIENT: f64 = 64.0 * Self::EPSILON;
    const LENGTH: f64 = 64.0 * Self::EPSILON;
}

/// Error of an angle computed from exact coefficients, radians.
const ANGLE_ERROR: f64 = 8.0 * f64::EPSILON;
/// Variation (in units of its scale) below which a function is constant up to rounding and has no roots.
const CONSTANT: f64 = 64.0 * f64::EPSILON;
/// The largest error of a reported root, radians.
///
/// Arcs of nearly equal radii that touch lose and regain contact several times within some 1e-7: one cluster contains all these events.
const LARGEST_ERROR: f64 = 1e-6;

impl<T: Errors> Trig<T> {
    /// A + γ, its largest value, and A − γ, minus its smallest.
    ///
    /// Where the function almost touches zero, A and −γ are equal except for the last digits, and the roots depend on their difference. For
    /// distances, with a = |u| and b = |w|, the values are (a + b)² − d² and d² − (a − b)², both products of lengths: this is the
    /// half-angle formula for a triangle with the sides a, b and d.
    pub(crate) fn extremes(&self) -> [Known<T>; 2] {
        let Some(Distances {
            u,
            w,
            distance: d,
            parts,
        }) = self.distances
        else {
            let amplitude = (self.alpha * self.alpha + self.beta * self.beta).sqrt();
            let error = T::COEFFICIENT * self.scale;
            return [amplitude + self.gamma, amplitude - self.gamma].map(|x| (x, error));
        };
        let (a, b) = (u.length(), w.length());
        [(a + b - d, a + b + d), (d - (a - b), d + (a - b))].map(|(x, y)| {
            let error = T::LENGTH * parts;
            let sizes = x.value().abs() + y.value().abs();
            (x * y, error * (sizes + error))
        })
    }
}

impl Trig {
    /// The function with given coefficients, which are right to a few ulps of `scale`.
    #[cfg(any(test, feature = "fuzzing"))]
    pub(crate) fn from_coefficients([alpha, beta, gamma]: [f64; 3], scale: f64) -> Self {
        Self {
            alpha,
            beta,
            gamma,
            scale,
            distances: None,
        }
    }

    /// Calls `found` with every root in the interval (mid − half, mid + half), with its error.
    ///
    /// The roots are atan2(β, α) ± φ with tan²(φ/2) = (A + γ) / (A − γ), which is accurate for all φ if the numerator and the denominator
    /// are. Where the error of one of them exceeds its value, there may be two roots, one or none: one event then covers them.
    pub(crate) fn roots(
        &self,
        mid: f64,
        cos: f64,
        sin: f64,
        half: f64,
        mut found: impl FnMut(Event),
    ) {
        let square = self.alpha * self.alpha + self.beta * self.beta;
        let value = self.alpha * cos + self.beta * sin + self.gamma;
        let slack = f64::COEFFICIENT * self.scale;
        // |value| ≤ A half is necessary for a root within the interval.
        if (value.abs() - slack).max(0.0).powi(2) > square * half * half * (1.0 + 1e-12) {
            return;
        }
        let amplitude = square.sqrt();
        if amplitude <= CONSTANT * self.scale {
            return;
        }
        let [most, least] = self.extremes();
        let up_to = |k: Known<f64>| (k.0 + k.1).max(0.0);
        let down_to = |k: Known<f64>| (k.0 - k.1).max(0.0);
        if up_to(most) == 0.0 || up_to(least) == 0.0 {
            return;
        }
        let angle = |num: f64, den: f64| 2.0 * num.sqrt().atan2(den.sqrt());
        let (farthest, nearest) = (
            angle(up_to(most), down_to(least)),
            angle(down_to(most), up_to(least)),
        );
        let from = |aside: f64| {
            let error = (farthest - aside).max(aside - nearest);
            (aside, error + slack / amplitude + ANGLE_ERROR)
        };
        // A value that may be zero is replaced by zero: the middle of two roots, if there are any, is known best, unless it is too far from
        // them.
        let none = |k: Known<f64>| if down_to(k) > 0.0 { k.0 } else { 0.0 };
        let (aside, error) = Some(from(angle(none(most), none(least))))
            .filter(|(_, error)| *error <= LARGEST_ERROR)
            .unwrap_or_else(|| from(angle(most.0.max(0.0), least.0.max(0.0))));
        let error = error.min(LARGEST_ERROR);
        let middle = self.beta.atan2(self.alpha);
        let mut report = |theta: f64| {
            if let Some(event) = (Event { theta, error }).within(mid, half) {
                found(event);
            }
        };
        report(middle + aside);
        if aside > 0.0 {
            report(middle - aside);
        }
    }
}

/// Roots in double-double: parts are perturbed so that a double root occurs only by construction, as where two arcs face each other and the
/// contact of their ends touches the circle of their contacts. A function that only touches zero does not change sign, and has no root
/// there.
impl Trig<Dd> {
    /// Whether there is exactly one root near to one found in f64 within an error, so that [`root_near`](Self::root_near) finds it.
    pub(crate) fn is_simple(&self, theta: f64, error: f64) -> bool {
        /// Minimum angle from a double root.
        const FAR: f64 = 1e-3;
        // In double-double the cube of the distance of a root from that found in f64 is negligible.
        let near = 10.0 * error;
        let [alpha, beta, gamma] = [self.alpha, self.beta, self.gamma].map(Dd::to_f64);
        let (sin, cos) = theta.sin_cos();
        let slope = beta * cos - alpha * sin;
        let value = alpha * cos + beta * sin + gamma;
        slope.abs() > FAR * alpha.hypot(beta)
            && value.abs() <= near * slope.abs()
            && slope.abs() > FAR * self.scale
    }

    /// The root near to that found in f64: by the parabola there.
    pub(crate) fn root_near(&self, theta: f64) -> (Dd, f64) {
        let (sin, cos) = Dd::from(theta).sin_cos();
        let wave = self.alpha * cos + self.beta * sin;
        let (value, slope, bend) = (wave + self.gamma, self.beta * cos - self.alpha * sin, -wave);
        let step = -(value / slope);
        let step = step - step * step * bend / slope * 0.5;
        let error = 2.0 * Dd::COEFFICIENT * self.scale / slope.to_f64().abs() + Dd::COEFFICIENT;
        (Dd::from(theta) + step, error)
    }

    /// Calls `found` with the roots up to whole turns, and their errors, as in f64.
    pub(crate) fn exact_roots(&self, mut found: impl FnMut(Dd, f64)) {
        let (alpha, beta) = (self.alpha, self.beta);
        let a = (alpha * alpha + beta * beta).sqrt().to_f64();
        let error = Dd::COEFFICIENT * self.scale;
        if a <= 4.0 * error {
            return;
        }
        let [(most, most_error), (least, least_error)] = self.extremes();
        let (m, l) = (most.to_f64(), least.to_f64());
        if m <= most_error || l <= least_error {
            return;
        }
        let middle = Dd::atan2(beta, alpha);
        let aside = Dd::atan2(most.sqrt(), least.sqrt()).scaled(2.0);
        // By the derivatives of twice the angle whose tangent is √(most / least).
        let of_aside = (m * l).sqrt() / (m + l) * (most_error / m + least_error / l);
        let error = 2.0 * (of_aside + error / a) + Dd::COEFFICIENT;
        found(middle + aside, error);
        if !aside.is_zero() {
            found(middle - aside, error);
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn roots(t: Trig) -> Vec<Event> {
        let mut all = Vec::new();
        t.roots(0.1, 0.1_f64.cos(), 0.1_f64.sin(), 0.5 * TAU, |e| {
            all.push(e);
        });
        all
    }

    fn cosine(alpha: f64, gamma: f64, scale: f64) -> Trig {
        Trig::from_coefficients([alpha, 0.0, gamma], scale)
    }

    #[test]
    fn finds_both_roots_of_a_cosine() {
        let t = cosine(2.0, -1.0, 2.0);
        let mut r: Vec<f64> = roots(t).iter().map(|e| e.theta).collect();
        r.sort_by(f64::total_cmp);
        assert!((r[0] + core::f64::consts::FRAC_PI_3).abs() < 1e-15);
        assert!((r[1] - core::f64::consts::FRAC_PI_3).abs() < 1e-15);
    }

    #[test]
    fn covers_a_double_root_that_rounding_splits() {
        for nudge in [-2e-16, 0.0, 2e-16] {
            let r = roots(cosine(1.0, -1.0 + nudge, 1.0));
            assert!(!r.is_empty());
            assert!(r.iter().all(|e| e.theta.abs() <= e.error + 1e-300));
        }
        assert_eq!(roots(cosine(1.0, -1.0, 1.0)).len(), 1);
    }

    #[test]
    fn has_none_when_constant_or_out_of_reach() {
        assert!(roots(cosine(1e-15, 0.0, 1.0)).is_empty());
        assert!(roots(cosine(1.0, 1.1, 1.0)).is_empty());
    }

    /// Interval and root may be one point: rounding must not lose it.
    #[test]
    fn finds_a_root_in_an_interval_of_no_length() {
        let t = cosine(1.0, -0.5, 1.5);
        let at = core::f64::consts::FRAC_PI_3;
        let mut all = Vec::new();
        t.roots(at, at.cos(), at.sin(), 0.0, |e| all.push(e));
        assert_eq!(all.len(), 1);
    }

    /// Errors e of the coefficients move a root of amplitude A by 2e/A where the value passes zero; the reported error is not much larger.
    #[test]
    fn errors_are_what_coefficients_leave_open() {
        for (amplitude, scale) in [(1.0, 1.0), (1e-3, 1.0), (1.0, 3.0)] {
            let open = 2.0 * f64::COEFFICIENT * scale / amplitude;
            let all = roots(cosine(amplitude, 0.0, scale));
            assert_eq!(all.len(), 2);
            for e in all {
                assert!((0.99 * open..2.0 * open).contains(&e.error), "{e:?} {open}");
            }
        }
    }

    /// The value in the middle of the interval may be larger than the amplitude.
    #[test]
    fn finds_roots_far_from_the_middle() {
        let all = roots(cosine(1.0, 0.9, 1.0));
        assert_eq!(all.len(), 2);
        assert!((all.iter()).all(|e| (e.theta.abs() - (-0.9_f64).acos()).abs() < 1e-14));
    }
}
