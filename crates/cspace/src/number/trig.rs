//! Roots of α cos θ + β sin θ + γ: every event between two contact curves is one.

use core::f64::consts::TAU;

/// The function α cos θ + β sin θ + γ, with the size of the terms its coefficients were summed from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Trig {
    pub(crate) alpha: f64,
    pub(crate) beta: f64,
    pub(crate) gamma: f64,
    /// A bound on the absolute values added up in any coefficient: the coefficients are right to a few ulps of it.
    pub(crate) scale: f64,
}

/// An orientation known up to an error: radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Event {
    pub(crate) theta: f64,
    pub(crate) error: f64,
}

/// Error of a coefficient, in units of its scale.
const COEFFICIENT_ERROR: f64 = 8.0 * f64::EPSILON;
/// Error of an angle computed from exact coefficients, radians.
const ANGLE_ERROR: f64 = 8.0 * f64::EPSILON;
/// A function that varies by less than this (in units of its scale) is constant up to rounding and has no roots.
const CONSTANT: f64 = 64.0 * f64::EPSILON;
/// The largest error with which a root is reported, radians.
///
/// Arcs of nearly equal radii that touch lose and regain each other several times within some 1e-7: one cluster has them
/// all.
const LARGEST_ERROR: f64 = 1e-6;

impl Trig {
    /// Calls `found` with every root in the interval (mid − half, mid + half), with its error.
    ///
    /// With A = √(α² + β²) and x = −γ / A the roots are atan2(β, α) ± acos x. An error e of x moves acos x by at most
    /// e / √(1 − x²) and, near x = ±1, by √(2 e). A pair of roots that rounding may have removed is reported as one
    /// event that covers both.
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
        let slack = COEFFICIENT_ERROR * self.scale;
        // |value| ≤ A half is necessary for a root within the interval.
        if (value.abs() - slack).max(0.0).powi(2) > square * half * half * (1.0 + 1e-12) {
            return;
        }
        let amplitude = square.sqrt();
        if amplitude <= CONSTANT * self.scale {
            return;
        }
        let x = -self.gamma / amplitude;
        let e = 2.0 * slack / amplitude + 2.0 * f64::EPSILON;
        if x.abs() > 1.0 + e {
            return;
        }
        let inside = (1.0 - x * x).max(0.0);
        let spread = (2.0 * e).sqrt();
        let error = if inside > e {
            (e / inside.sqrt()).min(spread)
        } else {
            2.0 * spread
        };
        let error = (error + ANGLE_ERROR).min(LARGEST_ERROR);
        let middle = self.beta.atan2(self.alpha);
        let aside = x.clamp(-1.0, 1.0).acos();
        let mut report = |theta: f64| {
            let theta = theta - TAU * ((theta - mid) / TAU).round();
            if (theta - mid).abs() <= half + error {
                found(Event { theta, error });
            }
        };
        report(middle + aside);
        if aside > 0.0 {
            report(middle - aside);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn roots(t: Trig) -> Vec<Event> {
        let mut all = Vec::new();
        t.roots(
            0.1,
            0.1_f64.cos(),
            0.1_f64.sin(),
            core::f64::consts::PI,
            |e| all.push(e),
        );
        all
    }

    #[test]
    fn finds_both_roots_of_a_cosine() {
        let t = Trig {
            alpha: 2.0,
            beta: 0.0,
            gamma: -1.0,
            scale: 2.0,
        };
        let mut r: Vec<f64> = roots(t).iter().map(|e| e.theta).collect();
        r.sort_by(f64::total_cmp);
        assert!((r[0] + core::f64::consts::FRAC_PI_3).abs() < 1e-15);
        assert!((r[1] - core::f64::consts::FRAC_PI_3).abs() < 1e-15);
    }

    #[test]
    fn covers_a_double_root_that_rounding_splits() {
        for nudge in [-2e-16, 0.0, 2e-16] {
            let t = Trig {
                alpha: 1.0,
                beta: 0.0,
                gamma: -1.0 + nudge,
                scale: 1.0,
            };
            let r = roots(t);
            assert!(!r.is_empty());
            assert!(r.iter().all(|e| e.theta.abs() <= e.error + 1e-300));
        }
    }

    #[test]
    fn has_none_when_constant_or_out_of_reach() {
        assert!(
            roots(Trig {
                alpha: 1e-15,
                beta: 0.0,
                gamma: 0.0,
                scale: 1.0
            })
            .is_empty()
        );
        assert!(
            roots(Trig {
                alpha: 1.0,
                beta: 0.0,
                gamma: 1.1,
                scale: 1.0
            })
            .is_empty()
        );
    }
}
