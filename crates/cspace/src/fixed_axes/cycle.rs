//! Lines, circles and points as one kind of thing, of which nothing is large where a circle is.
//!
//! A *cycle* is an oriented circle, as in Lie's geometry of circles. It has a point s, the outward normal n there, a weight λ and
//! a size ρ. A line has λ = 0, and an arc of signed radius r whose centre is far away λ = 1/r, both with ρ = 1: they are as exact
//! as s is. Any other circle has its centre for s, no normal, λ = 1 and ρ = r, and a concave one λ = −1 and ρ = −r. Seen from a
//! point o, with d = s − o,
//!
//! a = λ d − n  (1)  is its *arm*, λ times the vector to the centre if it has one,
//!
//! m = λ d²/2 − n·d − \[n = 0\] λ ρ²/2  (2)  its *moment*, with |a|² = ρ² + 2 λ m, and
//!
//! e = (|a| − ρ) / λ = 2 m / (|a| + ρ)  (3)  how far o is outside.
//!
//! Two cycles touch from outside, their normals opposite, where
//!
//! F = λ₁ m₂ + λ₂ m₁ − a₁·a₂ − ρ₁ ρ₂  (4)
//!
//! vanishes, from wherever both are seen; it is positive where they are apart. It is λ₁ λ₂ / 2 times what the square of the
//! distance of the centres is more than that of the sum of the radii, and with K = λ₁ ρ₂ + λ₂ ρ₁, the sum of the radii times
//! λ₁ λ₂, the distance along the common normal is
//!
//! 2 F / (K + √(K² + 2 λ₁ λ₂ F))  (5).
//!
//! Those that can touch have K > 0.

use super::motion::{Motion, Placement};
use super::scene::Side;
use crate::feature::Feature;
use crate::geometry::{Point, Rotation, Vector};

/// A line, a circle or a point.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Cycle {
    /// A point of it, or its centre.
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
            None => Self::about(feature.center(), feature.radius()),
        }
    }

    pub(super) fn bow(through: Point, normal: Vector, curvature: f64) -> Self {
        Self {
            through,
            normal,
            weight: curvature,
            size: 1.0,
        }
    }

    pub(super) fn about(center: Point, radius: f64) -> Self {
        Self {
            through: center,
            normal: Vector::ZERO,
            weight: if radius < 0.0 { -1.0 } else { 1.0 },
            size: radius.abs(),
        }
    }

    /// Whether it is given by its centre.
    pub(super) fn is_centred(&self) -> bool {
        self.normal == Vector::ZERO
    }

    /// Whether it is an arc that is given by a point of it.
    pub(super) fn is_bow(&self) -> bool {
        self.weight != 0.0 && !self.is_centred()
    }

    /// Where it is when its part has moved.
    #[inline]
    pub(super) fn moved(&self, motion: Motion, t: f64) -> Self {
        match motion {
            Motion::Still => *self,
            Motion::Turn { center } => {
                let turn = Rotation::by(t);
                Self {
                    through: center + turn * (self.through - center),
                    normal: turn * self.normal,
                    ..*self
                }
            }
            Motion::Slide { direction } => Self {
                through: self.through + direction * t,
                ..*self
            },
        }
    }

    pub(super) fn placed(&self, place: Placement) -> Self {
        Self {
            through: place.point(self.through),
            normal: place.turn * self.normal,
            ..*self
        }
    }

    /// a of (1).
    pub(super) fn arm(&self, from: Point) -> Vector {
        (self.through - from) * self.weight - self.normal
    }

    /// m of (2).
    pub(super) fn moment(&self, from: Point) -> f64 {
        let d = self.through - from;
        0.5 * self.weight * d.length_squared() - self.normal.dot(d) + self.own_moment()
    }

    /// The moment seen from `through`.
    fn own_moment(&self) -> f64 {
        if self.is_centred() {
            -0.5 * self.weight * self.size * self.size
        } else {
            0.0
        }
    }

    /// e of (3), of the length of the arm and the moment.
    #[inline]
    pub(super) fn outside(&self, arm: f64, moment: f64) -> f64 {
        if self.is_centred() {
            (arm - self.size) * self.weight
        } else {
            2.0 * moment / (arm + self.size)
        }
    }

    /// ρ + u·a for a unit vector u: λ times how far the tangent with the normal −u is from a point. Nothing cancels if u is almost
    /// the normal of a large arc.
    pub(super) fn support(&self, from: Point, u: Vector) -> f64 {
        let own = if self.is_centred() {
            self.size
        } else {
            0.5 * (u - self.normal).length_squared()
        };
        own + self.weight * u.dot(self.through - from)
    }
}

/// K: the sum of the radii, times both weights.
pub(super) fn total(a: &Cycle, b: &Cycle) -> f64 {
    a.weight * b.size + b.weight * a.size
}

/// The terms of F that depend neither on the vector from `through` to `through` nor on the normals.
fn still(a: &Cycle, b: &Cycle) -> f64 {
    if a.is_centred() && b.is_centred() {
        // −λ₁ λ₂ K² / 2: radii that all but cancel leave no rounding.
        let total = total(a, b);
        -0.5 * a.weight * b.weight * total * total
    } else {
        b.weight * a.own_moment() + a.weight * b.own_moment() - a.size * b.size
    }
}

/// F as (4) has it, without a₁·a₂, from the point about which one of both turns.
pub(super) fn level(a: &Cycle, b: &Cycle, from: Point) -> f64 {
    let moment = |c: &Cycle| c.moment(from) - c.own_moment();
    b.weight * moment(a) + a.weight * moment(b) + still(a, b)
}

/// F. Seen from the first it is λ₁ λ₂ d²/2 + (λ₂ n₁ − λ₁ n₂)·d − n₁·n₂ and constants, for the vector d to the second.
pub(super) fn between(a: &Cycle, b: &Cycle) -> f64 {
    let d = b.through - a.through;
    let still = if a.is_centred() || b.is_centred() {
        still(a, b)
    } else {
        // 1 + n₁·n₂, without the cancelling.
        -0.5 * (a.normal + b.normal).length_squared()
    };
    0.5 * a.weight * b.weight * d.length_squared()
        + (a.normal * b.weight - b.normal * a.weight).dot(d)
        + still
}

/// The distance (5) of two cycles, positive where they are apart.
pub(super) fn distance(a: &Cycle, b: &Cycle) -> f64 {
    let (f, k) = (between(a, b), total(a, b));
    let square = k * k + 2.0 * a.weight * b.weight * f;
    2.0 * f / (k + square.max(0.0).sqrt())
}

/// V = λ₁ a₂ − λ₂ a₁: from centre to centre, times both weights, with V² = K² + 2 λ₁ λ₂ F. Where they touch it is K times the
/// first one's normal.
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

/// K − u·V for a unit vector u, times which K + u·V is K² − (u·V)².
pub(super) fn beside(a: &Cycle, b: &Cycle, u: Vector) -> f64 {
    a.weight * b.support(a.through, -u) + b.weight * a.support(a.through, u)
}
