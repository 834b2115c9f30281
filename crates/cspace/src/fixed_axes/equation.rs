//! Equations in one coordinate: trigonometric for a part that turns, quadratic for one that slides.

use super::condition::Condition;
use super::cycle;
use super::motion::{Motion, Placement};
use super::tolerance::INDEPENDENT;
use crate::geometry::Vector;

/// A function of one coordinate whose roots have a closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Equation {
    /// α cos t + β sin t + γ.
    Trig { alpha: f64, beta: f64, gamma: f64 },
    /// a t² + b t + c.
    Quadratic { a: f64, b: f64, c: f64 },
}

impl Equation {
    /// Does not depend on the coordinate.
    pub(super) fn constant(c: f64) -> Self {
        Self::Quadratic { a: 0.0, b: 0.0, c }
    }

    /// The roots of a trigonometric equation as directions (cos t, sin t), not quite of length one; none of another.
    pub(super) fn directions(self) -> [Option<Vector>; 2] {
        let Self::Trig { alpha, beta, gamma } = self else {
            return [None, None];
        };
        let amplitude = alpha.hypot(beta);
        let square = (amplitude - gamma) * (amplitude + gamma);
        if amplitude < INDEPENDENT || square < 0.0 {
            return [None, None];
        }
        let unit = Vector::new(alpha, beta) * (1.0 / amplitude);
        let (along, aside) = (-gamma / amplitude, square.sqrt() / amplitude);
        [-aside, aside].map(|a| Some(unit * along + unit.left() * a))
    }

    /// Calls `found` with the roots, at most two; with none if the function is constant.
    fn roots(self, found: &mut impl FnMut(f64)) {
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

    /// The roots of a trigonometric equation of which α² + β² − γ² is known; a double one once.
    fn roots_of(self, square: f64, found: &mut impl FnMut(f64)) {
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

impl Condition {
    /// F by y, the first part being at a place.
    pub(super) fn in_y(&self, first: Placement) -> Equation {
        let (a, b) = (self.first.placed(first), &self.second);
        match self.motions.second {
            Motion::Turn { center } => {
                let (p, q) = (a.arm(center), b.arm(center));
                Equation::Trig {
                    alpha: -p.dot(q),
                    beta: -p.dot(q.left()),
                    gamma: cycle::level(&a, b, center),
                }
            }
            Motion::Slide { direction } => Equation::Quadratic {
                a: 0.5 * a.weight * b.weight,
                b: direction.dot(cycle::centres(&a, b)),
                c: cycle::between(&a, b),
            },
            Motion::Still => Equation::constant(cycle::between(&a, b)),
        }
    }

    /// Calls `found` with every x at which the roots may come or go: where they are double, or infinite.
    pub(super) fn turnings(&self, mut found: impl FnMut(f64)) {
        match self.motions.second {
            Motion::Still => {}
            Motion::Turn { .. } => self.turnings_of_turns(&mut found),
            Motion::Slide { direction } => self.turnings_of_slides(direction, &mut found),
        }
    }

    /// Where the second turns: with f, how far its pivot is outside of it, and g = f + 2 ρ₂ / λ₂, how far from the far side, the
    /// first's moment is f (λ₁ f / 2 − ρ₁) or g (λ₁ g / 2 + ρ₁) there. A line has no far side.
    fn turnings_of_turns(&self, found: &mut impl FnMut(f64)) {
        let (a, b, near) = (&self.first, &self.second, self.outside);
        let half = 0.5 * a.weight * near;
        let far = (near + 2.0 * b.size / b.weight) * (cycle::total(a, b) / b.weight + half);
        // Roots are numbered as they are found, and saved spaces have their numbers.
        let mut levels = [far, near * (half - a.size)];
        if self.bearing.side < 0.0 {
            levels.reverse();
        }
        for level in levels.into_iter().filter(|l| l.is_finite()) {
            self.bearing.moment_less(level).roots(found);
        }
    }

    /// Where the second slides along e it passes by the first where e × V is K or −K, and along a line where e·V is none.
    fn turnings_of_slides(&self, e: Vector, found: &mut impl FnMut(f64)) {
        let (a, b) = (&self.first, &self.second);
        if b.weight == 0.0 {
            return;
        }
        for u in [e.right(), e.left()] {
            match self.motions.first {
                Motion::Turn { center } => {
                    // K − u·V = λ₁ s + λ₂ ρ₁ + λ₂ u·R a, with s = ρ₂ − u·b and the arms a and b.
                    let arm = a.arm(center);
                    let (length, s) = (arm.length(), b.support(center, -u));
                    let still = a.weight * s + b.weight * a.size;
                    let equation = Equation::Trig {
                        alpha: b.weight * u.dot(arm),
                        beta: b.weight * u.dot(arm.left()),
                        gamma: still,
                    };
                    // λ₂² |a|² − (λ₁ s + λ₂ ρ₁)², with |a| = ρ₁ + λ₁ e.
                    let outside = a.outside(length, a.moment(center));
                    let product = (b.weight * outside - s) * (b.weight * length + still);
                    equation.roots_of(a.weight * product, found);
                }
                Motion::Slide { direction } => {
                    // V changes by −λ₁ λ₂ of the way.
                    if u.dot(direction).abs() >= INDEPENDENT {
                        let rate = a.weight * b.weight * u.dot(direction);
                        found(-cycle::beside(a, b, u) / rate);
                    }
                }
                Motion::Still => {}
            }
        }
    }
}
