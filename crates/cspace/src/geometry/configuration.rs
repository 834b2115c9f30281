//! Relative position and orientation of two parts.

use core::fmt;

use super::convert::write_numbers;
use super::{Point, Rotation, Vector};

/// Placement of the moving part in the fixed part's frame: its point q lies at (x, y) + `R_θ` q.
///
/// ```
/// use cspace::{Configuration, Point};
/// let quarter_turn = Configuration::new(1.0, 0.0, core::f64::consts::FRAC_PI_2);
/// let q = quarter_turn.fixed_from_moving(Point::new(2.0, 0.0));
/// assert!(q.distance(Point::new(1.0, 2.0)) < 1e-15);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Configuration {
    /// Displacement along the fixed part's first axis.
    pub x: f64,
    /// Displacement along the fixed part's second axis.
    pub y: f64,
    /// Orientation in radians, counter-clockwise.
    pub theta: f64,
}

impl Configuration {
    /// The configuration in which the two frames coincide: the position is (0, 0) and the orientation 0.
    pub const IDENTITY: Self = Self::new(0.0, 0.0, 0.0);

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

    /// Converts a point of the moving part's frame to the fixed part's frame.
    #[inline]
    pub fn fixed_from_moving(self, q: Point) -> Point {
        Rotation::by(self.theta) * q + Vector::new(self.x, self.y)
    }

    /// The configuration of the fixed part relative to the moving one: it maps a point q to R⁻¹(q − (x, y)). The orientation is −θ, not
    /// reduced modulo a turn.
    #[inline]
    pub fn inverse(self) -> Self {
        let back = Rotation::by(self.theta).inverse() * Vector::new(-self.x, -self.y);
        Self::new(back.x, back.y, -self.theta)
    }

    /// The configuration of a relative to c, where this one is that of b relative to c: for a point q in the frame of a,
    /// `c_from_b.compose(b_from_a)` is the map `b_from_a` followed by `c_from_b`. Its position is p + `R_θ` p′, its orientation θ + θ′,
    /// where this configuration is (p, θ) and the other (p′, θ′).
    ///
    /// The orientation is the sum and is not reduced modulo a turn: a part that has turned twice differs from one that has not turned.
    ///
    /// ```
    /// use cspace::{Configuration, Point};
    /// let bench_from_table = Configuration::new(3.0, 0.0, core::f64::consts::FRAC_PI_2);
    /// let table_from_block = Configuration::new(1.0, 0.0, 0.25);
    /// let bench_from_block = bench_from_table.compose(table_from_block);
    ///
    /// let q = Point::new(0.5, 0.25);
    /// let by_steps = bench_from_table.fixed_from_moving(table_from_block.fixed_from_moving(q));
    /// assert!(bench_from_block.fixed_from_moving(q).distance(by_steps) < 1e-15);
    /// ```
    #[inline]
    #[must_use]
    pub fn compose(self, b_from_a: Self) -> Self {
        let p = self.fixed_from_moving(b_from_a.position());
        Self::new(p.x, p.y, self.theta + b_from_a.theta)
    }
}

/// Text `(x, y, θ rad)`; a precision such as `{:.3}` applies to each number.
impl fmt::Display for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_numbers(f, &[self.x, self.y, self.theta], " rad")
    }
}

/// Conversion from (x, y, θ), θ in radians.
impl From<(f64, f64, f64)> for Configuration {
    #[inline]
    fn from((x, y, theta): (f64, f64, f64)) -> Self {
        Self::new(x, y, theta)
    }
}

/// Conversion from [x, y, θ], θ in radians.
impl From<[f64; 3]> for Configuration {
    #[inline]
    fn from([x, y, theta]: [f64; 3]) -> Self {
        Self::new(x, y, theta)
    }
}

/// Conversion to (x, y, θ), θ in radians.
impl From<Configuration> for (f64, f64, f64) {
    #[inline]
    fn from(c: Configuration) -> Self {
        (c.x, c.y, c.theta)
    }
}

/// Conversion to [x, y, θ], θ in radians.
impl From<Configuration> for [f64; 3] {
    #[inline]
    fn from(c: Configuration) -> Self {
        [c.x, c.y, c.theta]
    }
}
