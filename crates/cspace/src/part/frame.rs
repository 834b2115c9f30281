//! A frame in which every part is near the origin and of a size between 1 and 2.

use crate::geometry::Point;

use super::tolerance::RESOLUTION;
use super::{Bounds, Edge, Vertex};

/// Moves and scales a part, exactly, so that its size is in [1, 2) and it is near the origin.
///
/// A coordinate is shifted only where the part is at least two sizes away from the axis. Then coordinate and shift differ by less than a
/// factor of two and the difference is not rounded; the factor is a power of two.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    center: Point,
    factor: f64,
    /// The resolution, in this frame's unit of length.
    pub(super) tolerance: f64,
}

impl Frame {
    /// The frame for a part with the given box, whose diagonal is positive.
    pub(super) fn new(bounds: Bounds) -> Self {
        let (size, center) = (bounds.diagonal(), bounds.center());
        let shift = |c: f64| if c.abs() >= 2.0 * size { c } else { 0.0 };
        let factor = 2.0_f64.powi(-(size.log2().floor() as i32));
        Self {
            center: Point::new(shift(center.x), shift(center.y)),
            factor,
            tolerance: RESOLUTION * size * factor,
        }
    }

    /// Converts from the part's coordinates to this frame.
    pub(super) fn enter(&self, p: Point) -> Point {
        Point::ORIGIN + (p - self.center) * self.factor
    }

    /// Converts from this frame's coordinates to the part's.
    pub(super) fn leave(&self, p: Point) -> Point {
        self.center + p.to_vector() * (1.0 / self.factor)
    }

    /// The edge from a vertex to the next, in this frame.
    pub(super) fn edge(&self, from: Vertex, to: Vertex, index: usize) -> Edge {
        Edge {
            start: self.enter(from.point()),
            end: self.enter(to.point()),
            bulge: from.bulge,
            index,
        }
    }
}
