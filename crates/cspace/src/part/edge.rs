//! Edges of a loop, oriented so that material is on the left.

use crate::geometry::{Point, Vector};
use crate::number::Real;

/// A line segment or circular arc of a part's boundary, traversed with material on the left.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Edge<T = f64> {
    /// Start of the edge.
    pub start: Point<T>,
    /// End of the edge.
    pub end: Point<T>,
    /// tan(sweep / 4), positive counter-clockwise; 0 for a line.
    pub bulge: T,
    /// Index, in the loop as given, of the vertex whose bulge describes this edge.
    pub index: usize,
}

impl Edge {
    /// The line or arc of a bulge between two points, with index 0.
    #[inline]
    pub const fn between(start: Point, end: Point, bulge: f64) -> Self {
        Self {
            start,
            end,
            bulge,
            index: 0,
        }
    }

    /// The edge with its ends placed by a motion or a scaling, which keeps its shape.
    #[inline]
    #[must_use]
    pub fn placed(self, place: impl Fn(Point) -> Point) -> Self {
        Self {
            start: place(self.start),
            end: place(self.end),
            ..self
        }
    }

    /// Whether the edge is a line segment.
    #[inline]
    pub fn is_line(&self) -> bool {
        self.bulge == 0.0
    }

    /// The arc's centre: midpoint + left(chord) (1 − b²) / (4 b). Not finite for a line.
    #[inline]
    pub fn center(&self) -> Point {
        let chord = self.end - self.start;
        self.start.midpoint(self.end)
            + chord.left() * ((1.0 - self.bulge) * (1.0 + self.bulge) / (4.0 * self.bulge))
    }

    /// The arc's radius: chord (1 + b²) / (4 |b|). Infinite for a line.
    #[inline]
    pub fn radius(&self) -> f64 {
        let chord = self.end - self.start;
        chord.x.hypot(chord.y) * (1.0 + self.bulge * self.bulge) / (4.0 * self.bulge.abs())
    }

    /// The arc's sweep in radians, positive counter-clockwise; 0 for a line.
    #[inline]
    pub fn sweep(&self) -> f64 {
        4.0 * self.bulge.atan()
    }
}

impl<T: Real> Edge<T> {
    /// The unit direction of travel at the start.
    ///
    /// It is the chord turned clockwise by half the sweep: with b = tan(sweep/4),
    /// cos(sweep/2) = (1 − b²)/(1 + b²) and sin(sweep/2) = 2b/(1 + b²).
    #[inline]
    pub fn start_direction(&self) -> Vector<T> {
        let (cos, sin) = self.half_sweep();
        let d = (self.end - self.start).unit();
        Vector::new(cos * d.x + sin * d.y, cos * d.y - sin * d.x)
    }

    /// The unit direction of travel at the end: the chord turned counter-clockwise by half the sweep.
    #[inline]
    pub fn end_direction(&self) -> Vector<T> {
        let (cos, sin) = self.half_sweep();
        let d = (self.end - self.start).unit();
        Vector::new(cos * d.x - sin * d.y, cos * d.y + sin * d.x)
    }

    fn half_sweep(&self) -> (T, T) {
        let (b, one) = (self.bulge, T::constant(1.0));
        let q = one + b * b;
        ((one - b) * (one + b) / q, (b + b) / q)
    }

    /// The length of the curve: chord (1 + b²) atan(b) / b.
    #[inline]
    pub fn length(&self) -> T {
        let (chord, b) = (self.chord(), self.bulge);
        if b.value() == 0.0 {
            return chord;
        }
        chord * (T::constant(1.0) + b * b) * (b.atan() / b)
    }

    /// The curvature, positive where the edge turns left: 4 b / (chord (1 + b²)).
    #[inline]
    pub fn curvature(&self) -> T {
        let (b, real) = (self.bulge, T::constant);
        real(4.0) * b / (self.chord() * (real(1.0) + b * b))
    }

    /// The length of the chord.
    #[inline]
    pub(super) fn chord(&self) -> T {
        (self.end - self.start).length()
    }
}
