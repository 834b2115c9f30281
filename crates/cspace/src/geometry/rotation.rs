//! Rotations of the plane.

use core::f64::consts::{PI, TAU};
use core::ops::Mul;

use super::{Point, Vector};
use crate::number::Real;

/// The largest angle that is reduced to the first turn, in radians, in either direction: about 160 thousand turns.
///
/// An angle is reduced by subtracting whole turns, and a turn in `f64` has an error of 2.4·10⁻¹⁶. At 10⁶ rad neighbouring doubles are
/// 1.2·10⁻¹⁰ rad apart and the error of the subtracted turns is 4·10⁻¹¹ rad; both are still near the 1.2·10⁻¹⁰ rad to which critical
/// orientations are resolved. Far beyond, an angle does not determine the position of a part.
pub const LARGEST_ANGLE: f64 = 1e6;

/// A rotation about the origin, kept as the cosine and sine of its angle; in numbers of any kind.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rotation<T = f64> {
    /// Cosine of the angle.
    pub cos: T,
    /// Sine of the angle.
    pub sin: T,
}

impl Rotation {
    /// The identity.
    pub const IDENTITY: Self = Self { cos: 1.0, sin: 0.0 };
}

impl<T: Real> Rotation<T> {
    /// The rotation by `angle` radians, counter-clockwise.
    #[inline]
    pub fn by(angle: T) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { cos, sin }
    }

    /// The inverse rotation.
    #[inline]
    #[must_use]
    pub fn inverse(self) -> Self {
        Self {
            cos: self.cos,
            sin: -self.sin,
        }
    }
}

impl<T: Real> Mul<Vector<T>> for Rotation<T> {
    type Output = Vector<T>;
    #[inline(always)]
    fn mul(self, v: Vector<T>) -> Vector<T> {
        Vector::new(
            self.cos * v.x - self.sin * v.y,
            self.sin * v.x + self.cos * v.y,
        )
    }
}

impl<T: Real> Mul<Point<T>> for Rotation<T> {
    type Output = Point<T>;
    #[inline]
    fn mul(self, p: Point<T>) -> Point<T> {
        let v = self * p.to_vector();
        Point::new(v.x, v.y)
    }
}

/// The images of an angle, by whole turns, within half a turn of an interval of angles; all radians.
pub(crate) fn images(angle: f64, (lo, hi): (f64, f64)) -> impl Iterator<Item = f64> {
    let first = lo - PI + (angle - (lo - PI)).rem_euclid(TAU);
    let count = ((hi + PI - first) / TAU).floor() as u32;
    (0..=count).map(move |k| first + TAU * f64::from(k))
}

/// Reduces an angle to (−π, π].
#[inline]
pub(crate) fn wrap(angle: f64) -> f64 {
    let a = angle - TAU * (angle / TAU).round();
    if a <= -PI { a + TAU } else { a }
}

/// The angle that differs from `angle` by whole turns and is nearest to `near`.
pub(crate) fn unwrap_near(angle: f64, near: f64) -> f64 {
    angle + TAU * ((near - angle) / TAU).round()
}

/// The time at which an angle of a constant rate (radians per unit of time) exceeds [`LARGEST_ANGLE`]: −∞ if it exceeds it at the start, ∞
/// if it never does.
pub(crate) fn time_of_known_angle(angle: f64, rate: f64) -> f64 {
    if angle.abs() > LARGEST_ANGLE {
        f64::NEG_INFINITY
    } else if rate == 0.0 {
        f64::INFINITY
    } else {
        (LARGEST_ANGLE - angle * rate.signum()) / rate.abs()
    }
}
