//! The relative position and orientation of two parts.

use serde::{Deserialize, Serialize};

use super::{Point, Rotation, Vector};

/// Where the moving part is, seen from the fixed part: its point q lies at (x, y) + `R_θ` q.
///
/// ```
/// use cspace::{Configuration, Point};
/// let quarter_turn = Configuration::new(1.0, 0.0, core::f64::consts::FRAC_PI_2);
/// let q = quarter_turn.fixed_from_moving(Point::new(2.0, 0.0));
/// assert!(q.distance(Point::new(1.0, 2.0)) < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Configuration {
    /// Displacement along the fixed part's first axis.
    pub x: f64,
    /// Displacement along the fixed part's second axis.
    pub y: f64,
    /// Orientation in radians, counter-clockwise.
    pub theta: f64,
}

impl Configuration {
    /// The configuration with the given coordinates; `theta` in radians.
    #[inline]
    pub const fn new(x: f64, y: f64, theta: f64) -> Self {
        Self { x, y, theta }
    }

    /// The position (x, y).
    #[inline]
    pub const fn position(self) -> Point {
        Point::new(self.x, self.y)
    }

    /// Takes a point of the moving part's frame to the fixed part's frame.
    #[inline]
    pub fn fixed_from_moving(self, q: Point) -> Point {
        Rotation::by(self.theta) * q + Vector::new(self.x, self.y)
    }

    /// The configuration of the fixed part seen from the moving one: R⁻¹(q − (x, y)).
    #[inline]
    pub fn inverse(self) -> Self {
        let back = Rotation::by(self.theta).inverse() * Vector::new(-self.x, -self.y);
        Self::new(back.x, back.y, -self.theta)
    }
}
