//! Equations in one coordinate: trigonometric for a part that turns, quadratic for one that slides.

use super::tolerance::INDEPENDENT;

/// A function of one coordinate whose roots have a closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Equation {
    /// α cos t + β sin t + γ.
    Trig { alpha: f64, beta: f64, gamma: f64 },
    /// a t² + b t + c.
    Quadratic { a: f64, b: f64, c: f64 },
}

impl Equation {
    /// A function that does not depend on the coordinate.
    pub(super) fn constant(c: f64) -> Self {
        Self::Quadratic { a: 0.0, b: 0.0, c }
    }

    /// Calls `found` with the roots, at most two; with none if the function is constant.
    pub(super) fn roots(self, found: &mut impl FnMut(f64)) {
        match self {
            Self::Trig { alpha, beta, gamma } => {
                let amplitude = alpha.hypot(beta);
                let square = (amplitude - gamma) * (amplitude + gamma);
                if amplitude >= INDEPENDENT {
                    self.roots_of(square, found);
                }
            }
            Self::Quadratic { a, b, c } => {
                if a == 0.0 {
                    if b.abs() >= INDEPENDENT {
                        found(-c / b);
                    }
                    return;
                }
                let square = b * b - 4.0 * a * c;
                if square < 0.0 {
                    return;
                }
                let sum = -0.5 * (b + square.sqrt().copysign(b));
                let (s, t) = if sum == 0.0 {
                    (0.0, 0.0)
                } else {
                    (sum / a, c / sum)
                };
                found(s.min(t));
                found(s.max(t));
            }
        }
    }

    /// Calls `found` with the roots of a trigonometric equation whose α² + β² − γ² is known; a double root is reported once.
    pub(super) fn roots_of(self, square: f64, found: &mut impl FnMut(f64)) {
        let Self::Trig { alpha, beta, gamma } = self else {
            return;
        };
        if square >= 0.0 {
            let middle = beta.atan2(alpha);
            let aside = square.sqrt().atan2(-gamma);
            if square > 0.0 {
                found(middle - aside);
            }
            found(middle + aside);
        }
    }
}
