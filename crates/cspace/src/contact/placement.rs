//! Placement of one part relative to another, in numbers of any kind.

use crate::geometry::Configuration;
use crate::number::Real;

/// A rotation and a displacement: q is mapped to (x, y) + R q.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement<T> {
    /// The displacement (x, y).
    pub position: [T; 2],
    /// Cosine of the angle of rotation.
    pub cos: T,
    /// Sine of the angle of rotation.
    pub sin: T,
}

impl<T: Real> Placement<T> {
    /// The placement by a position and an angle in radians.
    pub fn new(position: [T; 2], theta: T) -> Self {
        let (sin, cos) = theta.sin_cos();
        Self { position, cos, sin }
    }

    /// The identity.
    pub fn identity() -> Self {
        let zero = T::constant(0.0);
        Self {
            position: [zero; 2],
            cos: T::constant(1.0),
            sin: zero,
        }
    }

    /// A turn about a point, by an angle in radians: q is mapped to c + R (q − c).
    pub fn turn(center: [T; 2], angle: T) -> Self {
        let turned = Self::new([T::constant(0.0); 2], angle);
        let c = turned.vector(center);
        Self {
            position: [center[0] - c[0], center[1] - c[1]],
            ..turned
        }
    }

    /// A displacement by a length along a direction, whose own length does not matter.
    pub fn slide(direction: [T; 2], by: T) -> Self {
        let [x, y] = direction;
        let share = by / (x * x + y * y).sqrt();
        Self {
            position: [x * share, y * share],
            ..Self::identity()
        }
    }

    /// Image of a point.
    pub fn point(&self, q: [T; 2]) -> [T; 2] {
        let v = self.vector(q);
        [self.position[0] + v[0], self.position[1] + v[1]]
    }

    /// Image of a vector, which is only turned.
    pub fn vector(&self, [x, y]: [T; 2]) -> [T; 2] {
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }

    /// The inverse placement: `b_from_a` of `a_from_b`.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let back = Self {
            position: [T::constant(0.0); 2],
            cos: self.cos,
            sin: -self.sin,
        };
        let [x, y] = back.vector(self.position);
        Self {
            position: [-x, -y],
            ..back
        }
    }

    /// The composition: `a_from_c` of `a_from_b` and `b_from_c`.
    #[must_use]
    pub fn compose(&self, b_from_c: &Self) -> Self {
        Self {
            position: self.point(b_from_c.position),
            cos: self.cos * b_from_c.cos - self.sin * b_from_c.sin,
            sin: self.sin * b_from_c.cos + self.cos * b_from_c.sin,
        }
    }
}

impl From<Configuration> for Placement<f64> {
    fn from(c: Configuration) -> Self {
        Self::new([c.x, c.y], c.theta)
    }
}
