//! Edges of a loop, oriented so that material is on the left.

use crate::geometry::{Point, Rotation, Vector};
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

impl<T> Edge<T> {
    /// The line or arc of a bulge between two points, with index 0.
    #[inline]
    pub const fn between(start: Point<T>, end: Point<T>, bulge: T) -> Self {
        Self {
            start,
            end,
            bulge,
            index: 0,
        }
    }
}

impl Edge {
    /// The arc's radius: chord (1 + b²) / (4 |b|). Infinite for a line.
    #[inline]
    pub fn radius(&self) -> f64 {
        self.signed_radius().abs()
    }

    /// The arc's sweep in radians, positive counter-clockwise; 0 for a line.
    #[inline]
    pub fn sweep(&self) -> f64 {
        4.0 * self.bulge.atan()
    }
}

impl<T: Real> Edge<T> {
    /// Whether the edge is a line segment.
    #[inline]
    pub fn is_line(&self) -> bool {
        self.bulge.value() == 0.0
    }

    /// The edge moved, turned or scaled: `place` keeps angles and their sense.
    #[inline]
    #[must_use]
    pub fn placed(&self, place: impl Fn(Point<T>) -> Point<T>) -> Self {
        Self {
            start: place(self.start),
            end: place(self.end),
            ..*self
        }
    }

    /// The point half way along the curve: half a chord times b to the right of the chord's middle.
    #[inline]
    pub fn middle(&self) -> Point<T> {
        let right = (self.end - self.start).right();
        self.start.midpoint(self.end) + right * (T::constant(0.5) * self.bulge)
    }

    /// The height of the curve over its chord: chord |b| / 2.
    #[inline]
    pub fn height(&self) -> T {
        T::constant(0.5) * self.bulge.abs() * self.chord()
    }

    /// The arc's centre: midpoint + left(chord) (1 − b²) / (4 b). Not finite for a line.
    #[inline]
    pub fn center(&self) -> Point<T> {
        let (b, real) = (self.bulge, T::constant);
        let up = (real(1.0) - b) * (real(1.0) + b) / (real(4.0) * b);
        self.start.midpoint(self.end) + (self.end - self.start).left() * up
    }

    /// The arc's radius, negative where the edge turns right: chord (1 + b²) / (4 b).
    #[inline]
    pub fn signed_radius(&self) -> T {
        let (b, real, chord) = (self.bulge, T::constant, self.end - self.start);
        chord.x.hypot(chord.y) * (real(1.0) + b * b) / (real(4.0) * b)
    }

    /// The unit direction of travel at the start: the chord turned clockwise by half the sweep.
    #[inline]
    pub fn start_direction(&self) -> Vector<T> {
        let (half, chord) = self.half_sweep();
        half.inverse() * chord
    }

    /// The unit direction of travel at the end: the chord turned counter-clockwise by half the sweep.
    #[inline]
    pub fn end_direction(&self) -> Vector<T> {
        let (half, chord) = self.half_sweep();
        half * chord
    }

    /// The rotation by half the sweep, and the direction of the chord: with b = tan(sweep/4), cos(sweep/2) = (1 − b²)/(1 + b²) and
    /// sin(sweep/2) = 2b/(1 + b²).
    #[inline]
    pub(crate) fn half_sweep(&self) -> (Rotation<T>, Vector<T>) {
        let (b, one) = (self.bulge, T::constant(1.0));
        let q = one + b * b;
        let half = Rotation {
            cos: (one - b) * (one + b) / q,
            sin: (b + b) / q,
        };
        (half, (self.end - self.start).unit())
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
    pub(crate) fn chord(&self) -> T {
        (self.end - self.start).length()
    }
}
