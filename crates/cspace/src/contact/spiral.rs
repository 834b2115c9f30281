//! Points that move with orientation: the ends of contact curves, and the centres of circular ones.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::Real;

/// A point that moves with orientation, in numbers of any kind: p(θ) = u + `R_θ` w + (1 − `R_{θ−t}`) a.
///
/// So move the ends of all contact curves (one normal there is that of a joint, fixed or turning with the moving
/// part), and the centres of the circular ones. The last term is there for arcs of large radius only: see [`Swing`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spiral<T = f64> {
    /// The part that stays.
    pub u: Point<T>,
    /// The part that turns.
    pub w: Vector<T>,
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
    fn moved<T: Real>(&self, turn: Rotation<T>) -> Vector<T> {
        let real = T::constant;
        let rest = Rotation::by(self.rest);
        let (rest, arm) = (
            Rotation {
                cos: real(rest.cos),
                sin: real(-rest.sin),
            },
            self.arm.map(real),
        );
        let Vector { x: c, y: s } = rest * Vector::new(turn.cos, turn.sin);
        let less = s * s / (real(1.0) + c);
        arm * less + arm.right() * s
    }
}

impl<T: Real> Spiral<T> {
    /// u + `R_θ` w.
    #[inline]
    pub const fn new(u: Point<T>, w: Vector<T>) -> Self {
        Self {
            u,
            w,
            swing: Swing::NONE,
        }
    }

    /// Where it is at an orientation.
    #[inline(always)]
    pub(crate) fn at(&self, turn: Rotation<T>) -> Point<T> {
        let p = self.u + turn * self.w;
        if self.swing.is_none() {
            p
        } else {
            p + self.swing.moved(turn)
        }
    }
}

impl Spiral {
    /// The spiral in numbers of another kind.
    #[inline(always)]
    pub(crate) fn lift<T: Real>(&self) -> Spiral<T> {
        Spiral {
            u: self.u.map(T::constant),
            w: self.w.map(T::constant),
            swing: self.swing,
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
