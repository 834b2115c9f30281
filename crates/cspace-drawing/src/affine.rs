//! Affine maps of the plane.

use cspace::{Point, Vector};

/// The map (x, y) ↦ (a x + c y + e, b x + d y + f).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Affine {
    /// Image of the first axis.
    pub x: Vector,
    /// Image of the second axis.
    pub y: Vector,
    /// Image of the origin.
    pub origin: Point,
}

impl Affine {
    /// The map that leaves everything where it is.
    pub const IDENTITY: Self = Self {
        x: Vector::new(1.0, 0.0),
        y: Vector::new(0.0, 1.0),
        origin: Point::ORIGIN,
    };

    /// The mirror image at the second axis.
    pub const MIRROR_X: Self = Self {
        x: Vector::new(-1.0, 0.0),
        ..Self::IDENTITY
    };

    /// The image of a point.
    pub fn point(&self, p: Point) -> Point {
        self.origin + self.vector(p.to_vector())
    }

    /// The image of a vector.
    pub fn vector(&self, v: Vector) -> Vector {
        self.x * v.x + self.y * v.y
    }

    /// First the other map, then this one.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        Self {
            x: self.vector(first.x),
            y: self.vector(first.y),
            origin: self.point(first.origin),
        }
    }

    /// The area that a unit square has afterwards, negative where it is mirrored.
    pub fn determinant(&self) -> f64 {
        self.x.cross(self.y)
    }

    /// Whether circles are mapped to circles, to rounding.
    pub fn is_similarity(&self) -> bool {
        /// Rounding of numbers in files, as a share of the scale.
        const ROUND: f64 = 1e-12;
        let (xx, yy) = (self.x.length_squared(), self.y.length_squared());
        (xx - yy).abs() <= 2.0 * ROUND * xx && self.x.dot(self.y).abs() <= ROUND * xx
    }

    /// Whether all images are finite numbers and no area vanishes.
    pub fn is_usable(&self) -> bool {
        let area = self.determinant();
        area != 0.0 && area.is_finite() && self.origin.is_finite()
    }
}
