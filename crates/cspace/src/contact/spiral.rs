//! Points that move with orientation: the ends of contact curves, and the centres of circular ones.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::Real;

/// A point that moves with orientation, in numbers of any kind: p(θ) = u + `R_θ` w + (1 − `R_{θ−t}`) a.
///
/// The ends of all contact curves are of this form (one normal there is that of a joint, fixed or turning with the moving part), and so are
/// the centres of circular curves. The last term occurs only for arcs of large radius: see [`Swing`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spiral<T = f64> {
    /// Constant part.
    pub u: Point<T>,
    /// Turning part.
    pub w: Vector<T>,
    /// Swing of the end of a long arm.
    #[cfg_attr(
        feature = "serde",
        serde(default, skip_serializing_if = "Swing::is_none")
    )]
    pub swing: Swing,
}

/// Displacement of the end of an arm that turns about its other end: (1 − `R_{θ−t}`) a, zero at the orientation t.
///
/// Where an arc of radius r touches, the contact is at r (n + R m) from a point of the arc, with opposing normals n and m of the parts. The
/// two terms cancel. For an arc much larger than the parts all digits would be lost; so the difference is stored as one term.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Swing {
    /// The arm a; zero if there is no swing.
    pub arm: Vector,
    /// The orientation t, radians.
    pub rest: f64,
}

impl Swing {
    /// No swing.
    pub const NONE: Self = Self {
        arm: Vector::ZERO,
        rest: 0.0,
    };

    /// Whether there is no swing.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.arm.x == 0.0 && self.arm.y == 0.0
    }

    /// Value, with φ = θ − t, of (1 − cos φ) a − sin φ left(a); 1 − cos φ is computed from the sine, so that it is as accurate as that.
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
    /// The spiral u + `R_θ` w.
    #[inline]
    pub const fn new(u: Point<T>, w: Vector<T>) -> Self {
        Self {
            u,
            w,
            swing: Swing::NONE,
        }
    }

    /// Position at an orientation.
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

    /// The spiral relative to another one, which must not swing.
    pub(crate) fn about(&self, other: &Self) -> Self {
        Self {
            u: self.u - other.u.to_vector(),
            w: self.w - other.w,
            ..*self
        }
    }

    /// The whole turning part v: the point moves by left(R v) per radian.
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

    /// A spiral with a swing equals the spiral of its two terms.
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
