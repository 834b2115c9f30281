//! Closed-form solutions of contact conditions for one coordinate.

use crate::geometry::Vector;

use super::condition::{Carriers, Condition};
use super::cycle::{self, Cycle};
use super::equation::Equation;
use super::motion::{Motion, Motions};
use super::tolerance::INDEPENDENT;

impl Condition {
    /// Whether the root exists at x.
    pub(super) fn exists(&self, x: f64, root: u8) -> bool {
        let rises = root == 0;
        match (self.carriers, self.motions.second) {
            (_, Motion::Still) => false,
            (Carriers::FirstLine { .. }, Motion::Turn { .. }) => {
                self.arm >= self.line_offset(x).abs()
            }
            (Carriers::SecondLine { .. }, Motion::Turn { .. }) => {
                self.bearing.vector(x).length() >= self.offset.abs()
            }
            (Carriers::Circles { radius, .. }, Motion::Turn { .. }) => {
                let m = self.bearing.vector(x).length();
                let (q, r) = (self.arm, radius.abs());
                (q - r).abs() <= m && m <= q + r
            }
            (Carriers::FirstLine { normal, .. }, Motion::Slide { direction }) => {
                let rate = self.motions.first.vector(x, normal).dot(direction);
                if rises { rate > 0.0 } else { rate < 0.0 }
            }
            (Carriers::SecondLine { normal, .. }, Motion::Slide { direction }) => {
                let rate = -normal.dot(direction);
                if rises { rate > 0.0 } else { rate < 0.0 }
            }
            (
                Carriers::Circles {
                    first,
                    second,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let p = self.motions.first.point(x, first);
                direction.cross(p - second).abs() <= radius.abs()
            }
            (Carriers::Cycles { .. }, Motion::Turn { .. }) => {
                self.turned(x).is_some_and(|t| t.0 >= 0.0)
            }
            (Carriers::Cycles { first, second }, Motion::Slide { direction }) => {
                let (square, slope, still) =
                    cycle::along(&first.moved(self.motions.first, x), &second, direction);
                if square != 0.0 {
                    slope * slope >= 2.0 * square * still
                } else if rises {
                    slope > 0.0
                } else {
                    slope < 0.0
                }
            }
        }
    }

    /// n(x)·(l(x) − c₂) + ρ: how far the line, moved out by the radius, is from the second part's pivot.
    fn line_offset(&self, x: f64) -> f64 {
        let (
            Carriers::FirstLine {
                normal,
                through,
                radius,
                ..
            },
            Motion::Turn { center },
        ) = (self.carriers, self.motions.second)
        else {
            return f64::NAN;
        };
        let n = self.motions.first.vector(x, normal);
        n.dot(self.motions.first.point(x, through) - center) + radius
    }

    /// The root at x: continuous in x where it exists; where rounding has just lost it, the double root.
    ///
    /// For a turning second part the condition is a cos (y − φ) = c with y = φ ± acos (c / a), and φ continuous.
    pub(super) fn y(&self, x: f64, root: u8) -> f64 {
        // Root 0 is φ − acos for lines and concave circles, φ + acos for convex ones.
        let sign = if root == 0 { 1.0 } else { -1.0 };
        match (self.carriers, self.motions.second) {
            (_, Motion::Still) => f64::NAN,
            (Carriers::FirstLine { .. }, Motion::Turn { .. }) => {
                let (q, c) = (self.arm, self.line_offset(x));
                let middle = self.motions.first.angle(x) + self.angle;
                middle - sign * root_of((q - c) * (q + c)).atan2(c)
            }
            (Carriers::SecondLine { .. }, Motion::Turn { .. }) => {
                let v = self.bearing.vector(x);
                let (m, c) = (v.length(), self.offset);
                let aside = (c, root_of((m - c) * (m + c)));
                self.angle + self.bearing.turned(x, v, aside, -sign)
            }
            (Carriers::Circles { radius, .. }, Motion::Turn { .. }) => {
                let v = self.bearing.vector(x);
                let (m, q, r) = (v.length(), self.arm, radius.abs());
                // Heron: (2 m q)² − (m² + q² − r²)² = ((m + q)² − r²) (r² − (m − q)²).
                let square = (m + q - r) * (m + q + r) * (r - m + q) * (r + m - q);
                let aside = (m * m + (q - r) * (q + r), root_of(square));
                let sign = sign * radius.signum();
                self.angle + self.bearing.turned(x, v, aside, sign)
            }
            (
                Carriers::FirstLine {
                    normal,
                    through,
                    point,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let n = self.motions.first.vector(x, normal);
                let l = self.motions.first.point(x, through);
                (radius + n.dot(l - point)) / n.dot(direction)
            }
            (
                Carriers::SecondLine {
                    normal,
                    through,
                    point,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let p = self.motions.first.point(x, point);
                (normal.dot(p - through) - radius) / normal.dot(direction)
            }
            (
                Carriers::Circles {
                    first,
                    second,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let v = self.motions.first.point(x, first) - second;
                let (aside, r) = (direction.cross(v), radius.abs());
                direction.dot(v) + sign * radius.signum() * root_of((r - aside) * (r + aside))
            }
            (Carriers::Cycles { .. }, Motion::Turn { .. }) => {
                let Some((room, level)) = self.turned(x) else {
                    return f64::NAN;
                };
                let v = self.bearing.vector(x);
                self.angle + self.bearing.turned(x, v, (level, root_of(room)), sign)
            }
            (Carriers::Cycles { first, second }, Motion::Slide { direction }) => {
                let (square, slope, still) =
                    cycle::along(&first.moved(self.motions.first, x), &second, direction);
                let rate = sign * root_of(slope * slope - 2.0 * square * still);
                // Of two forms that are equal the one in which nothing cancels.
                if (slope < 0.0) == (rate < 0.0) {
                    -2.0 * still / (slope + rate)
                } else {
                    (rate - slope) / square
                }
            }
        }
    }

    /// Calls `found` with every x at which the roots may come or go: where they are double, or infinite.
    pub(super) fn turnings(&self, mut found: impl FnMut(f64)) {
        let Motions { first, second } = self.motions;
        let mut solve = |equation: Equation| equation.roots(&mut found);
        match (self.carriers, second) {
            (_, Motion::Still) | (Carriers::SecondLine { .. }, Motion::Slide { .. }) => {}
            (
                Carriers::FirstLine {
                    normal,
                    through,
                    radius,
                    ..
                },
                Motion::Turn { center },
            ) => {
                let offset = Equation::line_offset(first, normal, through, center);
                solve(offset.plus(radius - self.arm));
                solve(offset.plus(radius + self.arm));
            }
            (Carriers::SecondLine { point, .. }, Motion::Turn { center }) => {
                let square = Equation::distance_squared(first, point, center);
                solve(square.plus(-self.offset * self.offset));
            }
            (
                Carriers::Circles {
                    first: p, radius, ..
                },
                Motion::Turn { center },
            ) => {
                let square = Equation::distance_squared(first, p, center);
                let (q, r) = (self.arm, radius.abs());
                solve(square.plus(-(q + r) * (q + r)));
                solve(square.plus(-(q - r) * (q - r)));
            }
            (Carriers::FirstLine { normal, .. }, Motion::Slide { direction }) => {
                solve(Equation::direction(first, normal, direction));
            }
            (
                Carriers::Circles {
                    first: p,
                    second: q,
                    radius,
                },
                Motion::Slide { direction },
            ) => {
                let aside = Equation::position(first, p, direction.left(), q);
                solve(aside.plus(-radius));
                solve(aside.plus(radius));
            }
            (
                Carriers::Cycles {
                    first: a,
                    second: b,
                },
                Motion::Turn { center },
            ) => {
                let moment = Equation::moment(first, &a, center);
                for level in cycle::turning_moments(&a, &b, (self.arm, self.offset)) {
                    solve(moment.plus(-level));
                }
            }
            (
                Carriers::Cycles {
                    first: a,
                    second: b,
                },
                Motion::Slide { direction },
            ) => {
                turnings_of_slides(first, &a, &b, direction, &mut found);
            }
        }
    }

    /// With a second part that turns, for cycles at x: what is left of the product of their arms, squared, beside what does not
    /// depend on y, and that.
    fn turned(&self, x: f64) -> Option<(f64, f64)> {
        let (Carriers::Cycles { first, second }, Motion::Turn { center }) =
            (self.carriers, self.motions.second)
        else {
            return None;
        };
        let moments = (
            first.moved(self.motions.first, x).moment(center),
            self.offset,
        );
        Some((
            cycle::room(&first, &second, moments),
            cycle::level(&first, &second, moments),
        ))
    }
}

/// Where the second of two cycles, which slides, passes along the first: (e × V)² = K², V being what [`cycle::centres`] is.
fn turnings_of_slides(first: Motion, a: &Cycle, b: &Cycle, e: Vector, found: &mut impl FnMut(f64)) {
    let total = cycle::total(a, b);
    if b.weight == 0.0 {
        return;
    }
    if a.weight == 0.0 {
        // Along a line.
        Equation::direction(first, a.normal, e).roots(found);
        return;
    }
    match first {
        Motion::Turn { center } => {
            // e × V = λ₁ e × a₂ − λ₂ e × R a₁, seen from the pivot: with T = |e × a₂| and τ = ±T − ρ₂ it is ±K where
            // λ₂ e × R a₁ is λ₁ τ − λ₂ ρ₁, but for the sign. One τ is a difference: both together are ρ₂² − T².
            let (arm, other) = (a.arm(center), b.arm(center));
            let (aside, along) = (e.cross(other), e.dot(other));
            let product = along * along - 2.0 * b.weight * b.moment(center);
            let most = -(aside.abs().copysign(b.size) + b.size);
            let least = if most == 0.0 { 0.0 } else { product / most };
            for (tau, side) in [(most, -b.size), (least, b.size)] {
                let side = 1.0_f64.copysign(side) * 1.0_f64.copysign(aside);
                let equation = Equation::Trig {
                    alpha: -b.weight * e.cross(arm),
                    beta: -b.weight * e.cross(arm.left()),
                    gamma: side * (a.weight * tau - b.weight * a.size),
                };
                // λ₂² |a₁|² − (λ₁ τ − λ₂ ρ₁)², with |a₁|² = ρ₁² + 2 λ₁ m₁.
                let square = a.weight
                    * (2.0 * b.weight * (b.weight * a.moment(center) + a.size * tau)
                        - a.weight * tau * tau);
                equation.roots_of(square, found);
            }
        }
        Motion::Slide { direction } => {
            // e × V changes by −λ₁ λ₂ e × d.
            let rate = a.weight * b.weight * e.cross(direction);
            if e.cross(direction).abs() < INDEPENDENT {
                return;
            }
            let (square, slope, level) = cycle::along(a, b, e);
            let left = slope * slope - 2.0 * square * level;
            let aside = e.cross(cycle::centres(a, b));
            // (K − e × V) (K + e × V) is what is left.
            let far = total.copysign(aside) + aside;
            found(far / rate);
            found(-left / (far * rate));
        }
        Motion::Still => {}
    }
}

fn root_of(square: f64) -> f64 {
    square.max(0.0).sqrt()
}
