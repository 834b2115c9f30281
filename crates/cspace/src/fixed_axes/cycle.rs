//! Lines, circles and points as one kind of thing, of which nothing is large where a circle is.
//!
//! A circle of signed radius r about a centre far away is told by a point s of it, the outward normal n there and its
//! curvature κ = 1/r: as exact as s is. So that all pairs have one condition, a *cycle* (an oriented circle, as in Lie's
//! geometry of circles) has a weight λ and a size ρ, which are κ and 1 there; a line is one with λ = 0, a circle that is
//! not large has its centre for s, no normal, λ = 1 and ρ = r. Seen from a point o, with d = s − o,
//!
//! a = λ d − n  (its *arm*: λ times the centre, if it has one)  and  m = λ d²/2 − n·d − \[n = 0\] ρ²/2  (its *moment*),
//!
//! with |a|² = ρ² + 2 λ m. Two cycles touch from outside, their normals opposite, where
//!
//! F = λ₁ m₂ + λ₂ m₁ − a₁·a₂ − ρ₁ ρ₂
//!
//! vanishes, from wherever both are seen; it is positive where they are apart. It is λ₁ λ₂ / 2 times what the square of the
//! distance of the centres is more than that of the sum of the radii, and with K = λ₁ ρ₂ + λ₂ ρ₁, the sum of the radii times
//! λ₁ λ₂, the distance is 2 F / (K + √(K² + 2 λ₁ λ₂ F)).

use super::motion::Motion;
use super::scene::Side;
use crate::feature::Feature;
use crate::geometry::Point;
use crate::geometry::Rotation;
use crate::geometry::Vector;
use core::f64::consts::FRAC_PI_2;
use core::f64::consts::TAU;

/// A line, a circle or a point.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Cycle {
    /// A point of it; of a circle that is not large its centre.
    pub(super) through: Point,
    /// The outward normal there; none at a centre.
    pub(super) normal: Vector,
    pub(super) weight: f64,
    pub(super) size: f64,
}

impl Cycle {
    /// The carrier of a feature at zero motion.
    pub(super) fn of(side: &Side, feature: &Feature) -> Self {
        if feature.is_line() {
            let joint = side.outline.start(feature);
            return Self::bow(joint.point, joint.normal, 0.0);
        }
        match feature.near {
            Some(near) => Self::bow(near.point, near.normal, 1.0 / feature.radius()),
            None => Self {
                through: feature.center(),
                normal: Vector::ZERO,
                weight: 1.0,
                size: feature.radius(),
            },
        }
    }

    fn bow(through: Point, normal: Vector, curvature: f64) -> Self {
        Self {
            through,
            normal,
            weight: curvature,
            size: 1.0,
        }
    }

    /// Whether it is told by its centre.
    pub(super) fn is_centred(&self) -> bool {
        self.normal == Vector::ZERO
    }

    /// Where it is when its part has moved.
    pub(super) fn moved(&self, motion: Motion, t: f64) -> Self {
        self.placed(|p| motion.point(t, p), |v| motion.vector(t, v))
    }

    pub(super) fn placed(
        &self,
        point: impl Fn(Point) -> Point,
        vector: impl Fn(Vector) -> Vector,
    ) -> Self {
        Self {
            through: point(self.through),
            normal: vector(self.normal),
            ..*self
        }
    }

    pub(super) fn arm(&self, from: Point) -> Vector {
        (self.through - from) * self.weight - self.normal
    }

    pub(super) fn moment(&self, from: Point) -> f64 {
        let d = self.through - from;
        0.5 * self.weight * d.length_squared() - self.normal.dot(d) + self.own_moment()
    }

    /// The moment seen from the point that it is told by.
    fn own_moment(&self) -> f64 {
        if self.is_centred() {
            -0.5 * self.size * self.size
        } else {
            0.0
        }
    }
}

/// K: the sum of the radii, times both weights. Positive, of two that can touch.
pub(super) fn total(a: &Cycle, b: &Cycle) -> f64 {
    a.weight * b.size + b.weight * a.size
}

/// F. Seen from the first it is λ₁ λ₂ d²/2 + (λ₂ n₁ − λ₁ n₂)·d − n₁·n₂ and what does not move, for the way d to the second.
pub(super) fn between(a: &Cycle, b: &Cycle) -> f64 {
    let d = b.through - a.through;
    let still = if a.is_centred() || b.is_centred() {
        b.weight * a.own_moment() + a.weight * b.own_moment() - a.size * b.size
    } else {
        // 1 + n₁·n₂, without the cancelling.
        -0.5 * (a.normal + b.normal).length_squared()
    };
    0.5 * a.weight * b.weight * d.length_squared()
        + (a.normal * b.weight - b.normal * a.weight).dot(d)
        + still
}

/// What F is from the point that the second turns about: C − a₁·a₂, in which C does not depend on how far it has turned.
pub(super) fn level(a: &Cycle, b: &Cycle, moments: (f64, f64)) -> f64 {
    b.weight * moments.0 + a.weight * moments.1 - a.size * b.size
}

/// |a₁|² |a₂|² − C², as it is without differences of what is nearly the same.
pub(super) fn room(a: &Cycle, b: &Cycle, moments: (f64, f64)) -> f64 {
    let skew = b.weight * moments.0 - a.weight * moments.1;
    2.0 * total(a, b) * (moments.0 * b.size + moments.1 * a.size) - skew * skew
}

/// The distance of two cycles, positive where they are apart.
pub(super) fn distance(a: &Cycle, b: &Cycle) -> f64 {
    let (f, k) = (between(a, b), total(a, b));
    let square = k * k + 2.0 * a.weight * b.weight * f;
    2.0 * f / (k + square.max(0.0).sqrt())
}

/// λ₁ a₂ − λ₂ a₁: from centre to centre, times both weights. Where they touch it is K times the first one's normal.
pub(super) fn centres(a: &Cycle, b: &Cycle) -> Vector {
    (b.through - a.through) * (a.weight * b.weight) + a.normal * b.weight - b.normal * a.weight
}

/// The derivatives of F by the coordinates of two cycles that have moved.
pub(super) fn slopes(a: &Cycle, first: Motion, b: &Cycle, second: Motion) -> (f64, f64) {
    let slope = |p: &Cycle, q: &Cycle, motion: Motion| match motion {
        Motion::Still => 0.0,
        Motion::Turn { center } => -p.arm(center).dot(q.arm(center).left()),
        Motion::Slide { direction } => direction.dot(centres(p, q)),
    };
    (slope(b, a, first), slope(a, b, second))
}

/// Of the second sliding: F is p y²/2 + q y + r, by how far it has gone; p, q and r.
pub(super) fn along(a: &Cycle, b: &Cycle, direction: Vector) -> (f64, f64, f64) {
    let slope = direction.dot(centres(a, b));
    (a.weight * b.weight, slope, between(a, b))
}

/// The moments of the first, seen from the pivot of the second, at which [`room`] is none; given the second's arm and moment.
///
/// That is λ₂² m₁² − 2 (K ρ₂ + λ₁ λ₂ m₂) m₁ + λ₁² m₂² − 2 K ρ₁ m₂ = 0, with the roots (K ρ₂ + λ₁ λ₂ m₂ ± K |a₂|) / λ₂².
pub(super) fn turning_moments(
    a: &Cycle,
    b: &Cycle,
    (arm, moment): (f64, f64),
) -> impl Iterator<Item = f64> {
    let total = total(a, b);
    let middle = total * b.size + a.weight * b.weight * moment;
    let far = middle + (total * arm).copysign(middle);
    let product = moment * (a.weight * a.weight * moment - 2.0 * total * a.size);
    // The first is not there if the second is a line.
    [far / (b.weight * b.weight), product / far]
        .into_iter()
        .filter(|m| m.is_finite())
}

// The direction of what one part carries, seen from the other part's pivot, without jumps by whole turns.

/// The direction of a point that the first part carries, seen from a centre that stays: continuous in x, without
/// jumps by whole turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bearing {
    motion: Motion,
    point: Point,
    center: Point,
    /// The direction whose angle `angle` is.
    about: Vector,
    angle: f64,
    /// Whether `about` turns with the first part.
    turning: bool,
}

impl Bearing {
    pub(super) fn new(motion: Motion, point: Point, center: Point) -> Self {
        let (about, turning) = match motion {
            Motion::Still => (point - center, false),
            // c₁ − c₂ + R p: the longer of the two never lies a quarter turn or more from their sum.
            Motion::Turn { center: own } => {
                let (between, arm) = (own - center, point - own);
                if arm.length_squared() < between.length_squared() {
                    (between, false)
                } else {
                    (arm, true)
                }
            }
            Motion::Slide { direction } => {
                let side = direction.left();
                let side = if side.dot(point - center) < 0.0 {
                    -side
                } else {
                    side
                };
                (side, false)
            }
        };
        Self {
            motion,
            point,
            center,
            about,
            angle: about.angle(),
            turning,
        }
    }

    /// The direction of the arm of a cycle that the first part carries.
    pub(super) fn of_arm(motion: Motion, cycle: &Cycle, center: Point) -> Self {
        if cycle.is_centred() {
            return Self::new(motion, cycle.through, center);
        }
        // Arms are as many times smaller than what they stand for as the weight says, and so are ways.
        match motion {
            Motion::Turn { center: own } => {
                let own_arm = Point::ORIGIN + (own - center) * cycle.weight;
                let turning = Motion::Turn { center: own_arm };
                Self::new(turning, own_arm + cycle.arm(own), Point::ORIGIN)
            }
            Motion::Slide { .. } | Motion::Still => {
                let arm = cycle.arm(center);
                let motion = match motion {
                    Motion::Slide { direction } => Motion::Slide {
                        direction: direction * cycle.weight,
                    },
                    other => other,
                };
                // It turns by little: to a quarter turn it is as far as to the centre.
                Self {
                    motion,
                    point: Point::ORIGIN + arm,
                    center: Point::ORIGIN,
                    about: arm,
                    angle: arm.angle(),
                    turning: false,
                }
            }
        }
    }

    /// The vector from the centre to the point.
    #[inline]
    pub(super) fn vector(&self, x: f64) -> Vector {
        self.motion.point(x, self.point) - self.center
    }

    /// The angle of the vector, plus the angle of (c, s) where `sign` is 1, less it where it is −1; s is not negative.
    ///
    /// The first is less than a quarter turn from the direction it is measured by, the second at most half a turn: so the
    /// angle of their product, which is computed, is their sum but for a turn that its quadrant tells.
    #[inline]
    pub(super) fn turned(&self, x: f64, v: Vector, (c, s): (f64, f64), sign: f64) -> f64 {
        let (about, angle) = if self.turning {
            (Rotation::by(x) * self.about, self.angle + x)
        } else {
            (self.about, self.angle)
        };
        let (along, aside) = (about.dot(v), about.cross(v));
        let s = sign * s;
        let sum = (aside * c + along * s).atan2(along * c - aside * s);
        let sum = if sign * sum < -FRAC_PI_2 {
            sum + sign * TAU
        } else {
            sum
        };
        angle + sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixed_axes::condition::Carriers;
    use crate::fixed_axes::condition::Condition;
    use crate::fixed_axes::motion::Motions;
    use crate::fixed_axes::motion::wrapped;

    /// A circle by a point of it, which may be anywhere on it.
    fn bow(center: Point, radius: f64, at: f64) -> Cycle {
        let normal = Vector::from_angle(at);
        Cycle::bow(center + normal * radius, normal, 1.0 / radius)
    }

    fn centred(center: Point, radius: f64) -> Cycle {
        Cycle {
            through: center,
            normal: Vector::ZERO,
            weight: 1.0,
            size: radius,
        }
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

    fn assert_same(by_cycles: &Condition, by_centres: &Condition) {
        let turnings = |c: &Condition| {
            let mut all = Vec::new();
            c.turnings(|x| all.push(wrapped(x)));
            all.sort_by(f64::total_cmp);
            all
        };
        let (found, expected) = (turnings(by_cycles), turnings(by_centres));
        assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
        for (a, b) in found.iter().zip(&expected) {
            assert!((a - b).abs() < 1e-7, "{found:?} {expected:?}");
        }
        for k in 0..40 {
            let x = -3.0 + 0.15 * f64::from(k);
            let y = 0.37 * x - 0.2;
            assert!((by_cycles.value(x, y) - by_centres.value(x, y)).abs() < 1e-12);
            let (a, b) = (by_cycles.gradient(x, y), by_centres.gradient(x, y));
            assert!((a.0 - b.0).hypot(a.1 - b.1) < 1e-11);
            for root in [0, 1] {
                let exists = by_cycles.exists(x, root);
                assert_eq!(exists, by_centres.exists(x, root));
                if exists {
                    let y = by_cycles.y(x, root);
                    let off = y - by_centres.y(x, root);
                    let turns = by_cycles.motions.second.turns();
                    let off = if turns { wrapped(off) } else { off };
                    assert!(off.abs() < 1e-11, "{x} {root}");
                    assert!(by_cycles.value(x, y).abs() < 1e-12);
                    assert_eq!(by_cycles.gradient(x, y).1 > 0.0, root == 0);
                }
            }
        }
    }

    /// However circles are told, they touch at the same places.
    #[test]
    fn cycles_are_circles() {
        let (p, q) = (Point::new(0.3, -0.8), Point::new(0.9, 0.4));
        for motions in motions() {
            for (r, s) in [(0.7, 0.9), (0.7, -1.9), (-2.3, 0.8)] {
                let by_centres = Condition::new(
                    Carriers::Circles {
                        first: p,
                        second: q,
                        radius: r + s,
                    },
                    motions,
                );
                // The point of a circle near to which it is looked at.
                let (a, b) = (bow(p, r, 0.4), bow(q, s, 2.5));
                for (first, second) in [(a, b), (a, centred(q, s)), (centred(p, r), b)] {
                    // It is the larger one whose centre is far away.
                    if total(&first, &second) < 0.0 {
                        continue;
                    }
                    let by_cycles = Condition::new(Carriers::Cycles { first, second }, motions);
                    assert_same(&by_cycles, &by_centres);
                    assert_same(&by_cycles.swapped(), &by_centres.swapped());
                }
            }
        }
    }
}
