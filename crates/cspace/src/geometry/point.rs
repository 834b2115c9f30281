//! Points and vectors. They differ: a point has a place, a vector has only a direction and a length.

use core::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A place in the plane, in some frame, in the model's unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Point {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
}

/// A displacement in the plane.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Vector {
    /// First coordinate.
    pub x: f64,
    /// Second coordinate.
    pub y: f64,
}

impl Point {
    /// The origin of the frame.
    pub const ORIGIN: Self = Self { x: 0.0, y: 0.0 };

    /// The point with the given coordinates.
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The displacement from the origin to this point.
    #[inline]
    pub const fn to_vector(self) -> Vector {
        Vector::new(self.x, self.y)
    }

    /// The distance to another point.
    #[inline]
    pub fn distance(self, other: Self) -> f64 {
        (self - other).length()
    }

    /// The point half way to another.
    #[inline]
    pub fn midpoint(self, other: Self) -> Self {
        Self::new(0.5 * (self.x + other.x), 0.5 * (self.y + other.y))
    }

    /// The point at fraction `s` of the way to another: `self + s (other − self)`.
    #[inline]
    pub fn lerp(self, other: Self, s: f64) -> Self {
        self + (other - self) * s
    }

    /// Whether both coordinates are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Vector {
    /// The vector of length zero.
    pub const ZERO: Self = Self { x: 0.0, y: 0.0 };

    /// The vector with the given coordinates.
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The unit vector at `angle` radians from the first axis.
    #[inline]
    pub fn from_angle(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self::new(cos, sin)
    }

    /// The angle from the first axis, in (−π, π].
    #[inline]
    pub fn angle(self) -> f64 {
        self.y.atan2(self.x)
    }

    /// The inner product.
    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The signed area spanned with `other`: positive when `other` is to the left.
    #[inline]
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// A quarter turn counter-clockwise.
    #[inline]
    pub const fn left(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// A quarter turn clockwise.
    #[inline]
    pub const fn right(self) -> Self {
        Self::new(self.y, -self.x)
    }

    /// The squared length.
    #[inline]
    pub fn length_squared(self) -> f64 {
        self.dot(self)
    }

    /// The length.
    #[inline]
    pub fn length(self) -> f64 {
        let square = self.length_squared();
        // Beyond the numbers whose squares are normal numbers, some 1e±154.
        if square.is_normal() {
            square.sqrt()
        } else {
            self.x.hypot(self.y)
        }
    }

    /// The vector of length one in this direction. Not finite for the zero vector.
    #[inline]
    pub fn unit(self) -> Self {
        self * (1.0 / self.x.hypot(self.y))
    }
}

impl Add<Vector> for Point {
    type Output = Self;
    #[inline]
    fn add(self, v: Vector) -> Self {
        Self::new(self.x + v.x, self.y + v.y)
    }
}

impl AddAssign<Vector> for Point {
    #[inline]
    fn add_assign(&mut self, v: Vector) {
        *self = *self + v;
    }
}

impl Sub<Vector> for Point {
    type Output = Self;
    #[inline]
    fn sub(self, v: Vector) -> Self {
        Self::new(self.x - v.x, self.y - v.y)
    }
}

impl Sub for Point {
    type Output = Vector;
    #[inline]
    fn sub(self, other: Self) -> Vector {
        Vector::new(self.x - other.x, self.y - other.y)
    }
}

impl Add for Vector {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Vector {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl Neg for Vector {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl Mul<f64> for Vector {
    type Output = Self;
    #[inline]
    fn mul(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}
