//! Contact condition of two features: the contact function of their cycles, and y where it vanishes at a given x.

use super::bearing::{Bearing, Seen};
use super::motion::{Motion, Motions};
use super::tolerance::INDEPENDENT;
use crate::contact::Cycle;
use crate::geometry::Point;
use crate::number::Real;

/// A condition prepared to be solved for y.
///
/// At root 0 the contact function increases with y (free space above), at root 1 it decreases.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Condition {
    /// The cycles at zero coordinates.
    pub(super) first: Cycle,
    pub(super) second: Cycle,
    pub(super) motions: Motions,
    /// Bearing of the first cycle as seen from the second part's pivot.
    pub(super) bearing: Bearing,
    /// Position of the second cycle as seen from its part's pivot: the angle by which its arm is to be turned back, the length of the arm,
    /// and the distance of the pivot outside.
    angle: f64,
    arm: f64,
    pub(super) outside: f64,
    /// 1, or −1 if y is measured from the opposite arm of one of the two cycles.
    side: f64,
}

impl Condition {
    pub(super) fn new(first: Cycle, second: Cycle, motions: Motions) -> Self {
        let pivot = match motions.second {
            Motion::Turn { center } => center,
            _ => Point::ORIGIN,
        };
        // The turn of a root is part of saved spaces: it is counted from the normal of a line, not from its arm, and from the centre of a
        // concave arc, unless a centre is far away.
        let far = first.is_large() || second.is_large();
        let side = |c: &Cycle| if far || c.weight > 0.0 { 1.0 } else { -1.0 };
        let sides = (side(&first), side(&second));
        let arm = second.arm(pivot);
        Self {
            first,
            second,
            motions,
            bearing: Bearing::new(motions.first, &first, pivot, sides.0),
            angle: -(arm * sides.1).angle(),
            arm: arm.length(),
            outside: second.off(arm.length(), second.level(pivot)),
            side: sides.0 * sides.1,
        }
    }

    /// The condition prepared to be solved for x.
    pub(super) fn swapped(&self) -> Self {
        Self::new(self.second, self.first, self.motions.swapped())
    }

    /// Both cycles after the motions x and y.
    pub(super) fn moved<T: Real>(&self, x: T, y: T) -> (Cycle<T>, Cycle<T>) {
        let Motions { first, second } = self.motions;
        (first.moved(x, &self.first), second.moved(y, &self.second))
    }

    /// The contact function: the distance of the cycles along the normal, positive where the parts are apart.
    pub(super) fn value(&self, x: f64, y: f64) -> f64 {
        let (a, b) = self.moved(x, y);
        a.gap(&b)
    }

    /// Its derivatives by x and y.
    pub(super) fn gradient(&self, x: f64, y: f64) -> (f64, f64) {
        let (a, b) = self.moved(x, y);
        let (by_x, by_y) = self.slopes(&a, &b);
        // G is K d + λ₁ λ₂ d²/2 for the distance d.
        let rate = a.between(&b).length();
        (by_x / rate, by_y / rate)
    }

    /// The derivatives of G by x and y, given both cycles after their motions.
    pub(super) fn slopes<T: Real>(&self, a: &Cycle<T>, b: &Cycle<T>) -> (T, T) {
        let slope = |p: &Cycle<T>, q: &Cycle<T>, motion: Motion| match motion {
            Motion::Still => T::constant(0.0),
            Motion::Turn { center } => {
                let center = center.map(T::constant);
                -p.arm(center).dot(q.arm(center).left())
            }
            Motion::Slide { direction } => direction.map(T::constant).dot(p.between(q)),
        };
        let Motions { first, second } = self.motions;
        (slope(b, a, first), slope(a, b, second))
    }

    /// Whether the condition does not depend on y: its curves are x = constant.
    pub(super) fn is_vertical(&self) -> bool {
        match self.motions.second {
            Motion::Still => true,
            Motion::Turn { .. } => self.arm < INDEPENDENT || self.bearing.is_nothing(INDEPENDENT),
            Motion::Slide { direction } => {
                let along =
                    |c: &Cycle| c.weight == 0.0 && c.normal.dot(direction).abs() < INDEPENDENT;
                !self.motions.first.turns() && along(&self.first) || along(&self.second)
            }
        }
    }

    /// Whether the root exists at x.
    pub(super) fn exists(&self, x: f64, root: u8) -> bool {
        match self.motions.second {
            Motion::Still => false,
            Motion::Turn { .. } => {
                let (sum, difference) = self.product(&self.bearing.seen(x));
                sum * difference >= 0.0
            }
            Motion::Slide { direction } => {
                let a = self.motions.first.moved(x, &self.first);
                if a.weight * self.second.weight != 0.0 {
                    let side = direction.left();
                    let room = |u| a.beside(&self.second, u);
                    return room(side) * room(-side) >= 0.0;
                }
                let slope = direction.dot(a.between(&self.second));
                if root == 0 { slope > 0.0 } else { slope < 0.0 }
            }
        }
    }

    /// The root at x: continuous in x where it exists; where rounding has just removed it, the double root.
    ///
    /// With the arms a of the first and R b of the second, which turns, G is C − a·R b. It vanishes where the angle from one arm
    /// to the other has the cosine C / (|a| |b|).
    pub(super) fn y(&self, x: f64, root: u8) -> f64 {
        self.solved(x, if root == 0 { 1.0 } else { -1.0 })
    }

    /// The double root at a turning, without the square root of rounding that separates both roots.
    pub(super) fn double_y(&self, x: f64) -> f64 {
        self.solved(x, 0.0)
    }

    fn solved(&self, x: f64, sign: f64) -> f64 {
        match self.motions.second {
            Motion::Still => f64::NAN,
            Motion::Turn { .. } => {
                let seen = self.bearing.seen(x);
                let (sum, difference) = self.product(&seen);
                let level = 0.5 * (sum - difference) * self.side;
                self.angle + seen.turned((level, root_of(sum * difference)), sign * self.side)
            }
            Motion::Slide { direction } => {
                // G is λ₁ λ₂ y²/2 + (e·V) y + its value at 0, with V² = (e·V)² + (e × V)².
                let a = self.motions.first.moved(x, &self.first);
                let square = a.weight * self.second.weight;
                let slope = direction.dot(a.between(&self.second));
                let still = a.apart(&self.second);
                if square == 0.0 {
                    return -still / slope;
                }
                let side = direction.left();
                let room = |u| a.beside(&self.second, u);
                let rate = sign * root_of(room(side) * room(-side));
                // Of two equivalent forms, the one without cancellation.
                if slope * rate > 0.0 {
                    -2.0 * still / (slope + rate)
                } else {
                    (rate - slope) / square
                }
            }
        }
    }

    /// The values |a| |b| + C and |a| |b| − C, for arms a and b and G = C − a·R b.
    ///
    /// With the distances e and f of the pivot from both cycles they are (e + f) (2 K + λ₁ λ₂ (e + f)) / 2 and (2 ρ₁ + λ₁ (e − f)) (2 ρ₂ +
    /// λ₂ (f − e)) / 2: for circles the four factors are those of Heron's formula.
    fn product(&self, seen: &Seen) -> (f64, f64) {
        let (a, b) = (&self.first, &self.second);
        let outside = a.off(seen.arm.length(), seen.moment);
        let (sum, difference) = (outside + self.outside, outside - self.outside);
        (
            sum * (a.total(b) + 0.5 * a.weight * b.weight * sum),
            (a.size + 0.5 * a.weight * difference) * (2.0 * b.size - b.weight * difference),
        )
    }
}

fn root_of(square: f64) -> f64 {
    square.max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Vector, wrap};

    /// A circle written by a point on it, at any angle.
    fn bow(center: Point, radius: f64, at: f64) -> Cycle {
        let normal = Vector::from_angle(at);
        Cycle::flat(center + normal * radius, normal, 1.0 / radius)
    }

    fn motions() -> Vec<Motions> {
        let turn = |x: f64, y: f64| Motion::Turn {
            center: Point::new(x, y),
        };
        let slide = |angle: f64| Motion::Slide {
            direction: Vector::from_angle(angle),
        };
        let pair = |first, second| Motions { first, second };
        vec![
            pair(turn(0.1, 0.2), turn(-0.4, 0.3)),
            pair(turn(0.1, 0.2), slide(0.7)),
            pair(slide(2.1), turn(-0.4, 0.3)),
            pair(slide(2.1), slide(0.7)),
            pair(turn(0.1, 0.2), Motion::Still),
            pair(Motion::Still, slide(0.7)),
        ]
    }

    /// Pairs of all kinds that can touch, with small and large circles.
    fn pairs() -> Vec<(Cycle, Cycle)> {
        let (p, q) = (Point::new(0.3, -0.8), Point::new(0.9, 0.4));
        let line = Cycle::flat(p, Vector::from_angle(0.4), 0.0);
        let large =
            |at: Point, r: f64, normal: f64| Cycle::flat(at, Vector::from_angle(normal), 1.0 / r);
        vec![
            (Cycle::round(p, 0.7), Cycle::round(q, 0.9)),
            (Cycle::round(p, 1e-9), Cycle::round(q, 0.0)),
            (Cycle::round(p, -1.9), Cycle::round(q, 0.3)),
            (Cycle::round(p, 0.3), Cycle::round(q, -1.9)),
            (line, Cycle::round(q, 0.2)),
            (line, Cycle::round(q, 1e-9)),
            (line, large(q, 300.0, 3.3)),
            (large(p, -300.0, 0.2), Cycle::round(q, 0.4)),
            (large(p, 2000.0, 0.2), large(q, -1e6, 3.5)),
        ]
    }

    /// The contact function by centres and radii. The centre of a line is far away.
    fn by_centres(condition: &Condition, x: f64, y: f64) -> f64 {
        let (a, b) = condition.moved(x, y);
        let (line, other) = if a.weight == 0.0 { (a, b) } else { (b, a) };
        let center = |c: &Cycle| c.through - c.normal * (1.0 / c.weight);
        let radius = |c: &Cycle| c.size / c.weight;
        if line.weight == 0.0 {
            return line.normal.dot(center(&other) - line.through) - radius(&other);
        }
        let sum = radius(&a) + radius(&b);
        ((center(&b) - center(&a)).length() - sum.abs()) * sum.signum()
    }

    #[test]
    fn contact_functions_are_those_of_centres_and_radii_and_gradients_their_differences() {
        const STEP: f64 = 1e-5;
        for motions in motions() {
            for (first, second) in pairs() {
                for condition in [
                    Condition::new(first, second, motions),
                    Condition::new(first, second, motions.swapped()).swapped(),
                ] {
                    // Rounding at the distance of a centre, and of differences of such distances.
                    let size = |c: &Cycle| {
                        if c.weight == 0.0 {
                            1.0
                        } else {
                            c.size / c.weight.abs()
                        }
                    };
                    let near = 1e-13 * (1.0 + size(&condition.first) + size(&condition.second));
                    for k in 0..40 {
                        let (x, y) = (0.31 * f64::from(k) - 6.0, 0.17 * f64::from(k) - 2.0);
                        let value = condition.value(x, y);
                        let off = (value - by_centres(&condition, x, y)).abs();
                        assert!(off < near, "{condition:?} {x} {y} {off} {near}");
                        let by_x = condition.value(x + STEP, y) - condition.value(x - STEP, y);
                        let by_y = condition.value(x, y + STEP) - condition.value(x, y - STEP);
                        let gradient = condition.gradient(x, y);
                        let off = (by_x / (2.0 * STEP) - gradient.0)
                            .hypot(by_y / (2.0 * STEP) - gradient.1);
                        assert!(off < 1e5 * near, "{condition:?} {x} {y} {off}");
                    }
                }
            }
        }
    }

    #[test]
    fn roots_are_where_features_touch_and_double_at_turnings() {
        for motions in motions() {
            for (first, second) in pairs() {
                let condition = Condition::new(first, second, motions);
                for condition in [condition, condition.swapped()] {
                    let turns = condition.motions.second.turns();
                    for k in 0..200 {
                        let x = 0.031 * f64::from(k) - 3.1;
                        for root in [0, 1] {
                            if condition.is_vertical() || !condition.exists(x, root) {
                                continue;
                            }
                            let y = condition.y(x, root);
                            if turns || y.abs() < 100.0 {
                                assert!(condition.value(x, y).abs() < 1e-12, "{condition:?} {x}");
                                assert_eq!(condition.gradient(x, y).1 > 0.0, root == 0);
                            }
                        }
                    }
                    condition.turnings(|x| {
                        let y = condition.double_y(x);
                        if x.abs().max(y.abs()) < 100.0 {
                            assert!(condition.value(x, y).abs() < 1e-12, "{condition:?} {x}");
                            let by_y = condition.gradient(x, y).1; // Of a circle of 1e-9 the rounding of x, 1e-16, is that much.
                            assert!(by_y.abs() < 1e-6, "{condition:?} {x} {by_y}");
                        }
                    });
                }
            }
        }
    }

    fn assert_same(by_points: &Condition, by_centres: &Condition) {
        let turnings = |c: &Condition| {
            let mut all = Vec::new();
            c.turnings(|x| all.push(wrap(x)));
            all.sort_by(f64::total_cmp);
            all
        };
        let (found, expected) = (turnings(by_points), turnings(by_centres));
        assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
        for (a, b) in found.iter().zip(&expected) {
            assert!((a - b).abs() < 1e-7, "{found:?} {expected:?}");
        }
        for k in 0..40 {
            let x = -3.0 + 0.15 * f64::from(k);
            for root in [0, 1] {
                let exists = by_points.exists(x, root);
                assert_eq!(exists, by_centres.exists(x, root));
                if exists {
                    let off = by_points.y(x, root) - by_centres.y(x, root);
                    let turns = by_points.motions.second.turns();
                    let off = if turns { wrap(off) } else { off };
                    assert!(off.abs() < 1e-11, "{x} {root}");
                }
            }
        }
    }

    /// A circle written by its centre, or by a point on it, touches at the same places.
    #[test]
    fn circles_may_be_given_by_points_or_centres() {
        let (p, q) = (Point::new(0.3, -0.8), Point::new(0.9, 0.4));
        for motions in motions() {
            for (r, s) in [(0.7, 0.9), (0.7, -1.9), (-2.3, 0.8)] {
                let by_centres = Condition::new(Cycle::round(p, r), Cycle::round(q, s), motions);
                let (a, b) = (bow(p, r, 0.4), bow(q, s, 2.5));
                for (first, second) in [(a, b), (a, Cycle::round(q, s)), (Cycle::round(p, r), b)] {
                    let by_points = Condition::new(first, second, motions);
                    assert_same(&by_points, &by_centres);
                    assert_same(&by_points.swapped(), &by_centres.swapped());
                }
            }
        }
    }
}
