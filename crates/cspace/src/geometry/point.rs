//! Points and vectors. They differ: a point has a place, a vector has only a direction and a length.

use core::ops::{Add, AddAssign, Mul, Neg, Sub};

use crate::number::Real;

/// A place in the plane, in some frame, in the model's unit of length; in numbers of any kind.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Point<T = f64> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
}

/// A displacement in the plane; in numbers of any kind.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Vector<T = f64> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
}

impl Point {
    /// The origin of the frame.
    pub const ORIGIN: Self = Self { x: 0.0, y: 0.0 };

    /// Whether both coordinates are finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl<T> Point<T> {
    /// The point with the given coordinates.
    #[inline]
    pub const fn new(x: T, y: T) -> Self {
        Self { x, y }
    }

    /// The point with each coordinate converted to another kind of number.
    #[inline]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Point<U> {
        Point::new(f(self.x), f(self.y))
    }
}

impl<T: Copy> Point<T> {
    /// The displacement from the origin to this point.
    #[inline]
    pub const fn to_vector(self) -> Vector<T> {
        Vector::new(self.x, self.y)
    }
}

impl<T: Real> Point<T> {
    /// The distance to another point.
    #[inline]
    pub fn distance(self, other: Self) -> T {
        (self - other).length()
    }

    /// The point half way to another.
    #[inline]
    pub fn midpoint(self, other: Self) -> Self {
        let half = T::constant(0.5);
        Self::new(half * (self.x + other.x), half * (self.y + other.y))
    }

    /// The point at fraction `s` of the way to another: `self + s (other − self)`.
    #[inline]
    pub fn lerp(self, other: Self, s: T) -> Self {
        self + (other - self) * s
    }
}

impl Vector {
    /// The vector of length zero.
    pub const ZERO: Self = Self { x: 0.0, y: 0.0 };

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
}

impl<T> Vector<T> {
    /// The vector with the given coordinates.
    #[inline]
    pub const fn new(x: T, y: T) -> Self {
        Self { x, y }
    }

    /// The vector with each coordinate converted to another kind of number.
    #[inline]
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> Vector<U> {
        Vector::new(f(self.x), f(self.y))
    }
}

impl<T: Real> Vector<T> {
    /// The inner product.
    #[inline]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y
    }

    /// The signed area spanned with `other`: positive when `other` is to the left.
    #[inline]
    pub fn cross(self, other: Self) -> T {
        self.x * other.y - self.y * other.x
    }

    /// A quarter turn counter-clockwise.
    #[inline]
    #[must_use]
    pub fn left(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// A quarter turn clockwise.
    #[inline]
    #[must_use]
    pub fn right(self) -> Self {
        Self::new(self.y, -self.x)
    }

    /// The squared length.
    #[inline]
    pub fn length_squared(self) -> T {
        self.dot(self)
    }

    /// The length.
    #[inline]
    pub fn length(self) -> T {
        let square = self.length_squared();
        // Squares of numbers beyond some 1e±154 overflow or underflow.
        if square.value().is_normal() {
            square.sqrt()
        } else {
            self.x.hypot(self.y)
        }
    }

    /// The vector of length one in this direction. Not finite for the zero vector.
    #[inline]
    #[must_use]
    pub fn unit(self) -> Self {
        self * (T::constant(1.0) / self.x.hypot(self.y))
    }
}

impl<T: Real> Add<Vector<T>> for Point<T> {
    type Output = Self;
    #[inline]
    fn add(self, v: Vector<T>) -> Self {
        Self::new(self.x + v.x, self.y + v.y)
    }
}

impl<T: Real> AddAssign<Vector<T>> for Point<T> {
    #[inline]
    fn add_assign(&mut self, v: Vector<T>) {
        *self = *self + v;
    }
}

impl<T: Real> Sub<Vector<T>> for Point<T> {
    type Output = Self;
    #[inline]
    fn sub(self, v: Vector<T>) -> Self {
        Self::new(self.x - v.x, self.y - v.y)
    }
}

impl<T: Real> Sub for Point<T> {
    type Output = Vector<T>;
    #[inline]
    fn sub(self, other: Self) -> Vector<T> {
        Vector::new(self.x - other.x, self.y - other.y)
    }
}

impl<T: Real> Add for Vector<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl<T: Real> Sub for Vector<T> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl<T: Real> Neg for Vector<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl<T: Real> Mul<T> for Vector<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}
