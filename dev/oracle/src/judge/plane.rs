//! Points, and boxes about things, of the plane.

use core::ops::{Add, Sub};

use super::real::Real;

/// A point or a vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Place<S> {
    pub(super) x: S,
    pub(super) y: S,
}

impl<S: Real> Place<S> {
    #[inline]
    pub(super) fn new(x: S, y: S) -> Self {
        Self { x, y }
    }

    #[inline]
    pub(super) fn dot(self, other: Self) -> S {
        self.x * other.x + self.y * other.y
    }

    #[inline]
    pub(super) fn cross(self, other: Self) -> S {
        self.x * other.y - self.y * other.x
    }

    #[inline]
    pub(super) fn times(self, factor: S) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }

    #[inline]
    pub(super) fn left(self) -> Self {
        Self::new(-self.y, self.x)
    }

    #[inline]
    pub(super) fn length(self) -> S {
        self.dot(self).root()
    }

    #[inline]
    pub(super) fn rough(self) -> Place<f64> {
        Place::new(self.x.to_f64(), self.y.to_f64())
    }

    /// Turned by the angle with the given sine and cosine, then moved by `shift`.
    #[inline]
    pub(super) fn moved(self, (sin, cos): (S, S), shift: Self) -> Self {
        Self::new(cos * self.x - sin * self.y, sin * self.x + cos * self.y) + shift
    }
}

impl<S: Real> Add for Place<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl<S: Real> Sub for Place<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

/// An axis-aligned box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl Frame {
    pub(super) const EMPTY: Self = Self {
        low: [f64::INFINITY; 2],
        high: [f64::NEG_INFINITY; 2],
    };

    #[inline]
    pub(super) fn around(a: Place<f64>, b: Place<f64>) -> Self {
        Self {
            low: [a.x.min(b.x), a.y.min(b.y)],
            high: [a.x.max(b.x), a.y.max(b.y)],
        }
    }

    #[inline]
    pub(super) fn with(self, other: Self) -> Self {
        Self {
            low: [self.low[0].min(other.low[0]), self.low[1].min(other.low[1])],
            high: [
                self.high[0].max(other.high[0]),
                self.high[1].max(other.high[1]),
            ],
        }
    }

    /// Square of the distance between two boxes: never more than that of their content.
    #[inline]
    pub(super) fn distance_squared(&self, other: &Self) -> f64 {
        let gap = |i: usize| {
            (self.low[i] - other.high[i])
                .max(other.low[i] - self.high[i])
                .max(0.0)
        };
        let (x, y) = (gap(0), gap(1));
        x * x + y * y
    }

    pub(super) fn diagonal(&self) -> f64 {
        (self.high[0] - self.low[0]).hypot(self.high[1] - self.low[1])
    }
}
