//! Points that move with orientation: the ends of contact curves, and the centres of circular ones.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::Real;

/// A point that moves with orientation: p(θ) = u + `R_θ` w + (1 − `R_{θ−t}`) a.
///
/// So move the ends of all contact curves (one normal there is that of a joint, fixed or turning with the moving
/// part), and the centres of the circular ones. The last term is there for arcs of large radius only: see [`Swing`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spiral {
    /// The part that stays.
    pub u: Point,
    /// The part that turns.
    pub w: Vector,
    /// How the end of a long arm swings.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Swing::is_none")
    )]
    pub swing: Swing,
}

/// How the end of an arm moves that turns about its other end: (1 − `R_{θ−t}`) a, nothing at the orientation t.
///
/// Where an arc of radius r touches, the contact is at r (n + R m) from a point of the arc, with opposing normals n and m
/// of the parts. The two terms cancel. Of an arc much larger than the parts all digits would be lost; so the difference is
/// written down as one.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Swing {
    /// The arm a; zero for none.
    pub arm: Vector,
    /// The orientation t, radians.
    pub rest: f64,
}

impl Swing {
    /// No arm.
    pub const NONE: Self = Self {
        arm: Vector::ZERO,
        rest: 0.0,
    };

    /// Whether there is no arm.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.arm.x == 0.0 && self.arm.y == 0.0
    }

    /// With φ = θ − t, (1 − cos φ) a − sin φ left(a); 1 − cos φ from the sine, so that it is as exact as that is.
    #[cold]
    #[inline(never)]
    fn moved<T: Real>(&self, cos: T, sin: T) -> (T, T) {
        let real = T::constant;
        let (st, ct) = self.rest.sin_cos();
        let c = cos * real(ct) + sin * real(st);
        let s = sin * real(ct) - cos * real(st);
        let less = s * s / (real(1.0) + c);
        let (x, y) = (real(self.arm.x), real(self.arm.y));
        (x * less + y * s, y * less - x * s)
    }
}

/// A vector turned by the orientation with the given cosine and sine.
#[inline(always)]
pub(super) fn turned<T: Real>(v: Vector, cos: T, sin: T) -> (T, T) {
    let real = T::constant;
    (
        cos * real(v.x) - sin * real(v.y),
        sin * real(v.x) + cos * real(v.y),
    )
}

impl Spiral {
    /// u + `R_θ` w.
    #[inline]
    pub const fn new(u: Point, w: Vector) -> Self {
        Self {
            u,
            w,
            swing: Swing::NONE,
        }
    }

    /// The way to it from another, which does not swing.
    pub(crate) fn about(&self, other: &Self) -> Self {
        Self {
            u: self.u - other.u.to_vector(),
            w: self.w - other.w,
            ..*self
        }
    }

    #[inline(always)]
    pub(crate) fn at(&self, turn: Rotation) -> Point {
        let p = self.u + turn * self.w;
        if self.swing.is_none() {
            p
        } else {
            let (x, y) = self.swing.moved(turn.cos, turn.sin);
            p + Vector::new(x, y)
        }
    }

    /// Its place at the orientation with the given cosine and sine, in any arithmetic.
    #[inline(always)]
    pub(crate) fn place<T: Real>(&self, cos: T, sin: T) -> (T, T) {
        let p = self.unswung(cos, sin);
        if self.swing.is_none() {
            p
        } else {
            let v = self.swing.moved(cos, sin);
            (p.0 + v.0, p.1 + v.1)
        }
    }

    /// The same of one that does not swing, such as the centre of a circle.
    #[inline(always)]
    pub(crate) fn unswung<T: Real>(&self, cos: T, sin: T) -> (T, T) {
        let real = T::constant;
        let w = turned(self.w, cos, sin);
        (real(self.u.x) + w.0, real(self.u.y) + w.1)
    }

    /// All of it that turns: it moves by left(R v) per radian.
    #[inline]
    pub(crate) fn turning(&self) -> Vector {
        if self.swing.is_none() {
            return self.w;
        }
        self.w - Rotation::by(-self.swing.rest) * self.swing.arm
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arm and its swing are a spiral as any other.
    #[test]
    fn a_swing_is_a_difference() {
        let arm = Vector::new(3.0, -2.0);
        let spiral = Spiral {
            u: Point::new(0.3, -0.2),
            w: Vector::new(0.5, 0.1),
            swing: Swing { arm, rest: 0.7 },
        };
        let plain = Spiral::new(spiral.u + arm, spiral.turning());
        for theta in [-1.0, 0.0, 0.7, 0.71, 2.0] {
            let turn = Rotation::by(theta);
            assert!(spiral.at(turn).distance(plain.at(turn)) < 1e-14);
        }
        assert_eq!(
            spiral.at(Rotation::by(0.7)).x,
            Spiral::new(spiral.u, spiral.w).at(Rotation::by(0.7)).x
        );
    }
}
