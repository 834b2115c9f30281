//! Boxes with sides along the axes.

use crate::geometry::Point;

/// An axis-aligned box: the smallest that contains something.
///
/// ```
/// use cspace::{Part, Vertex};
/// let circle = vec![Vertex::new(-2.0, 0.0, 1.0), Vertex::new(2.0, 0.0, 1.0)];
/// let bounds = Part::new("disc", vec![circle])?.bounds();
/// assert_eq!((bounds.min.y, bounds.max.y), (-2.0, 2.0));
/// # Ok::<(), cspace::PartError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bounds {
    /// The corner with the least coordinates.
    pub min: Point,
    /// The corner with the greatest coordinates.
    pub max: Point,
}

impl Bounds {
    /// The empty box; the neutral element of [`Bounds::union`].
    pub const EMPTY: Self = Self {
        min: Point::new(f64::INFINITY, f64::INFINITY),
        max: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    /// The box of two points.
    #[inline]
    pub fn of(p: Point, q: Point) -> Self {
        Self {
            min: Point::new(p.x.min(q.x), p.y.min(q.y)),
            max: Point::new(p.x.max(q.x), p.y.max(q.y)),
        }
    }

    /// The smallest box that contains this one and another.
    #[inline]
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: Self::of(self.min, other.min).min,
            max: Self::of(self.max, other.max).max,
        }
    }

    /// The length of the diagonal. 0 for a single point; meaningless for [`Bounds::EMPTY`].
    #[inline]
    pub fn diagonal(self) -> f64 {
        (self.max.x - self.min.x).hypot(self.max.y - self.min.y)
    }

    /// The four corners, counter-clockwise from `min`.
    #[inline]
    pub fn corners(self) -> [Point; 4] {
        let (min, max) = (self.min, self.max);
        [min, Point::new(max.x, min.y), max, Point::new(min.x, max.y)]
    }

    /// The middle of the box.
    #[inline]
    pub fn center(self) -> Point {
        self.min.midpoint(self.max)
    }

    /// Whether a point lies in the box, its sides included.
    #[inline]
    pub fn contains(self, p: Point) -> bool {
        self.min.x <= p.x && p.x <= self.max.x && self.min.y <= p.y && p.y <= self.max.y
    }

    /// Distance of a point from the box; 0 inside.
    #[inline]
    pub fn distance(self, p: Point) -> f64 {
        let beyond = |lo: f64, t: f64, hi: f64| (lo - t).max(t - hi).max(0.0);
        let across = beyond(self.min.x, p.x, self.max.x);
        across.hypot(beyond(self.min.y, p.y, self.max.y))
    }

    /// Whether the gap between two boxes is more than `gap` along some axis.
    #[inline]
    pub fn is_apart(self, other: Self, gap: f64) -> bool {
        self.min.x - other.max.x > gap
            || other.min.x - self.max.x > gap
            || self.min.y - other.max.y > gap
            || other.min.y - self.max.y > gap
    }
}
