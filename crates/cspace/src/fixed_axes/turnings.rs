//! Places at which the roots of a condition appear and disappear, and the condition as an equation for y.

use super::condition::Condition;
use super::equation::Equation;
use super::motion::{Motion, Placement};
use super::tolerance::INDEPENDENT;
use crate::geometry::Vector;

impl Condition {
    /// G as a function of y, for a given placement of the first part.
    pub(super) fn in_y(&self, first: Placement) -> Equation {
        let (a, b) = (self.first.moved(first.turn, first.shift), &self.second);
        match self.motions.second {
            Motion::Turn { center } => {
                let (p, q) = (a.arm(center), b.arm(center));
                Equation::Trig {
                    alpha: -p.dot(q),
                    beta: -p.dot(q.left()),
                    gamma: a.still_about(b, center),
                }
            }
            Motion::Slide { direction } => Equation::Quadratic {
                a: 0.5 * a.weight * b.weight,
                b: direction.dot(a.between(b)),
                c: a.apart(b),
            },
            Motion::Still => Equation::constant(a.apart(b)),
        }
    }

    /// Calls `found` with every x at which roots may appear or disappear: where they are double, or infinite.
    pub(super) fn turnings(&self, mut found: impl FnMut(f64)) {
        match self.motions.second {
            Motion::Still => {}
            Motion::Turn { .. } => self.turnings_of_turns(&mut found),
            Motion::Slide { direction } => self.turnings_of_slides(direction, &mut found),
        }
    }

    /// Turnings if the second part turns: with f, the distance of its pivot outside the second cycle, and g = f + 2 ρ₂ / λ₂, its distance
    /// from the far side, the first's moment is f (λ₁ f / 2 − ρ₁) or g (λ₁ g / 2 + ρ₁) there. A line has no far side.
    fn turnings_of_turns(&self, found: &mut impl FnMut(f64)) {
        let (a, b, near) = (&self.first, &self.second, self.outside);
        let half = 0.5 * a.weight * near;
        let far = (near + 2.0 * b.size / b.weight) * (a.total(b) / b.weight + half);
        // Roots are numbered in the order in which they are found, and saved spaces contain these numbers.
        let mut levels = [far, near * (half - a.size)];
        if self.bearing.side < 0.0 {
            levels.reverse();
        }
        for level in levels.into_iter().filter(|l| l.is_finite()) {
            self.bearing.moment_less(level).roots(found);
        }
    }

    /// Turnings if the second part slides along e: it is tangent to the first where e × V is K or −K; for a line, where e·V is zero.
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
                    let outside = a.off(length, a.level(center));
                    let product = (b.weight * outside - s) * (b.weight * length + still);
                    equation.roots_of(a.weight * product, found);
                }
                Motion::Slide { direction } => {
                    // V changes by −λ₁ λ₂ times the distance.
                    if u.dot(direction).abs() >= INDEPENDENT {
                        let rate = a.weight * b.weight * u.dot(direction);
                        found(-a.beside(b, u) / rate);
                    }
                }
                Motion::Still => {}
            }
        }
    }
}
