//! A vertex of a loop, with the edge that starts there.

use crate::geometry::Point;

/// A vertex of a loop. The bulge belongs to the edge that starts there.
///
/// The bulge is tan(sweep / 4): positive counter-clockwise, 0 a line, ±1 a half circle (as in DXF).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Vertex<T = f64> {
    /// First coordinate.
    pub x: T,
    /// Second coordinate.
    pub y: T,
    /// tan(sweep / 4) of the edge that starts at the vertex.
    pub bulge: T,
}

impl<T: Copy> Vertex<T> {
    /// A vertex at which an arc starts, or a line when `bulge` is 0.
    #[inline]
    pub const fn new(x: T, y: T, bulge: T) -> Self {
        Self { x, y, bulge }
    }

    /// Position of the vertex.
    #[inline]
    pub const fn point(self) -> Point<T> {
        Point::new(self.x, self.y)
    }
}

impl Vertex {
    /// A vertex at which a line starts.
    #[inline]
    pub const fn line(x: f64, y: f64) -> Self {
        Self::new(x, y, 0.0)
    }
}
