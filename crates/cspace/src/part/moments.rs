//! The moments of a part's area, in closed form: area, centre, and second moment.
//!
//! By Green's theorem each is a sum over the edges, material on the left. An edge from a to b, as seen from the origin,
//! contributes the triangle (origin, a, b) and, if it is an arc, the segment between its chord and itself. With c = a × b
//! the triangle has
//!
//! - area c / 2,
//! - first moment c (a + b) / 6,
//! - second moment about the origin c (a·a + a·b + b·b) / 12.
//!
//! A segment with a chord of length L and the bulge b = tan(sweep / 4) has, with u = b² and the function w of [`shape`],
//!
//! - area L² b (1/3 + u w),
//! - first moment about the middle of the chord L³ u (1/12 − (1 − u) w / 4), to the right of the chord,
//! - second moment about the middle of the chord L⁴ b (1/3 + u + w (3 − 2u + 3u²)) / 32.
//!
//! They follow from a sector minus a triangle, with the centre and radius of the arc eliminated: there is no cancellation when the arc is
//! almost flat.

use crate::geometry::{Point, Vector};

use super::measure::sum;
use super::{Edge, Part};

/// |bulge| below which [`shape`] sums a series (dimensionless).
///
/// The closed form loses a factor of 45 of its accuracy at this limit, and less above; the moments lose a quarter of that.
const SERIES_BULGE: f64 = 0.5;

/// Terms of the series: at [`SERIES_BULGE`] the first one left out is 4⁻²² / 10⁵ ≈ 6·10⁻¹⁹, of a sum of about 1/15.
const SERIES_TERMS: u32 = 22;

/// Area of a part, its centroid, and its second moment.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AreaMoments {
    /// The area A, in the square of the model's unit. Always positive.
    pub area: f64,
    /// The centroid g = ∫ q dA / A, in the part's frame.
    pub centroid: Point,
    /// The polar second moment about the centroid, ∫ |q − g|² dA, in the fourth power of the model's unit.
    pub second: f64,
}

impl AreaMoments {
    /// The polar second moment about another point p of the part's frame: that about the centroid, plus A |p − g|².
    ///
    /// ```
    /// use cspace::{Part, Point};
    /// let rod = Part::rectangle("rod", (0.0, 0.0), 6.0, 1.0)?;
    /// let about_end = rod.moments().second_about(Point::new(3.0, 0.0));
    /// assert!((about_end - 6.0 * (37.0 / 12.0 + 9.0)).abs() < 1e-12);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn second_about(&self, p: Point) -> f64 {
        self.second + self.area * (p - self.centroid).length_squared()
    }
}

impl Part {
    /// Area, centroid and second moment of the material, exact up to rounding: arcs are integrated as arcs, holes count
    /// as holes. Of several layers they are the means over the height of the stack.
    ///
    /// Times a mass per area, the second moment is the moment of inertia about the centroid. Takes time in proportion to
    /// the number of edges.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use cspace::{Part, Vertex};
    /// let circle = |r: f64| vec![Vertex::new(5.0 - r, 0.0, 1.0), Vertex::new(5.0 + r, 0.0, 1.0)];
    /// let ring = Part::new("ring", vec![circle(1.0), circle(2.0)])?.moments();
    /// assert!((ring.area - 3.0 * PI).abs() < 1e-13);
    /// assert!((ring.centroid.x - 5.0).abs() < 1e-15);
    /// // π (2⁴ − 1⁴) / 2.
    /// assert!((ring.second - 7.5 * PI).abs() < 1e-13);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn moments(&self) -> AreaMoments {
        // First about the middle of the box, then about the centroid found: a second moment about a point far from the centroid would lose
        // digits.
        let rough = self.moments_from(self.bounds.center());
        let exact = self.moments_from(rough.centroid);
        AreaMoments {
            area: self.area(),
            ..exact
        }
    }

    /// The moments, summed about a point.
    fn moments_from(&self, origin: Point) -> AreaMoments {
        let all: Vec<Moments> = self
            .weighted_edges()
            .map(|(e, share)| Moments::swept(&e, origin).times(share))
            .collect();
        let area = sum(all.iter().map(|m| m.area));
        let first = Vector::new(
            sum(all.iter().map(|m| m.first.x)),
            sum(all.iter().map(|m| m.first.y)),
        );
        let second = sum(all.iter().map(|m| m.second));
        let offset = first * (1.0 / area);
        AreaMoments {
            area,
            centroid: origin + offset,
            second: second - area * offset.length_squared(),
        }
    }
}

/// The moments of a signed area about a point.
struct Moments {
    area: f64,
    first: Vector,
    second: f64,
}

impl Moments {
    fn times(self, share: f64) -> Self {
        Self {
            area: self.area * share,
            first: self.first * share,
            second: self.second * share,
        }
    }

    /// Moments, about `origin`, of the area swept by the segment from `origin` to a point that moves along the edge.
    fn swept(edge: &Edge, origin: Point) -> Self {
        let (a, b) = (edge.start - origin, edge.end - origin);
        let c = a.cross(b);
        let squares = a.length_squared() + a.dot(b) + b.length_squared();
        let triangle = Self {
            area: 0.5 * c,
            first: (a + b) * (c / 6.0),
            second: c * squares / 12.0,
        };
        if edge.is_line() {
            return triangle;
        }
        let segment = Self::segment(edge);
        let middle = edge.start.midpoint(edge.end) - origin;
        Self {
            area: triangle.area + segment.area,
            first: triangle.first + segment.first + middle * segment.area,
            second: triangle.second
                + segment.second
                + 2.0 * middle.dot(segment.first)
                + middle.length_squared() * segment.area,
        }
    }

    /// Moments of the area between an arc and its chord, about the middle of the chord.
    fn segment(edge: &Edge) -> Self {
        let chord = edge.end - edge.start;
        let square = chord.length_squared();
        let (b, w) = (edge.bulge, shape(edge.bulge));
        let u = b * b;
        let second = b * (1.0 / 3.0 + u + w * (3.0 - u * (2.0 - 3.0 * u))) / 32.0;
        Self {
            area: square * b * (1.0 / 3.0 + u * w),
            first: chord.right() * (square * u * (1.0 / 12.0 - 0.25 * (1.0 - u) * w)),
            second: square * square * second,
        }
    }
}

/// w(b) = ((1 + u)² atan(b) / b − 1 − 5u/3) / (8 u²) with u = b², which is
/// Σ (−u)ᵏ / ((2k + 1)(2k + 3)(2k + 5)).
fn shape(b: f64) -> f64 {
    let u = b * b;
    if b.abs() < SERIES_BULGE {
        let term = |k: u32| {
            let odd = f64::from(2 * k + 1);
            1.0 / (odd * (odd + 2.0) * (odd + 4.0))
        };
        return (0..SERIES_TERMS).rev().fold(0.0, |s, k| term(k) - u * s);
    }
    let q = 1.0 + u;
    (q * q * b.atan() / b - 1.0 - 5.0 * u / 3.0) / (8.0 * u * u)
}

#[cfg(test)]
mod tests {
    use super::{SERIES_BULGE, shape};

    #[test]
    fn series_and_closed_form_agree_where_they_meet() {
        let (below, at) = (SERIES_BULGE * (1.0 - f64::EPSILON), SERIES_BULGE);
        assert!((shape(below) - shape(at)).abs() < 1e-14 * shape(at));
        assert_eq!(shape(0.0), 1.0 / 15.0);
    }
}
