//! Measures of a part: its box, its size, its area, and tests of whether points are in it.

use crate::boxes::Boxes;
use crate::geometry::Point;

use super::{Bounds, Edge, Loop, Part};

impl Part {
    /// The smallest box with sides along the axes that holds the part, arcs included.
    #[inline]
    pub const fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The part's size, the length of the diagonal of its box. Always positive.
    #[inline]
    pub fn size(&self) -> f64 {
        self.bounds.diagonal()
    }

    /// The area of the material; of several layers the mean over the height of the stack. Always positive.
    ///
    /// ```
    /// use cspace::{Part, Vertex};
    /// let circle = |r: f64| vec![Vertex::new(-r, 0.0, 1.0), Vertex::new(r, 0.0, 1.0)];
    /// let annulus = Part::new("annulus", vec![circle(1.0), circle(2.0)])?;
    /// assert!((annulus.area() - 3.0 * core::f64::consts::PI).abs() < 1e-14);
    /// let stepped = Part::layered("stepped", [
    ///     (Some([0.0, 1.0]), vec![circle(2.0)]),
    ///     (Some([1.0, 4.0]), vec![circle(1.0)]),
    /// ])?;
    /// assert!((stepped.area() - 1.75 * core::f64::consts::PI).abs() < 1e-14);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn area(&self) -> f64 {
        let origin = self.bounds.center();
        sum(self
            .weighted_edges()
            .map(|(edge, share)| share * edge.area_swept(origin)))
    }

    /// Whether a point lies in the material of any layer. On the boundary, up to rounding, the answer is undefined.
    ///
    /// Counts how often a ray from the point meets the boundary: the chords it meets, and for each
    /// arc once more when the point lies between chord and arc. Takes time in proportion to the
    /// number of edges.
    ///
    /// ```
    /// use cspace::{Part, Point, Vertex};
    /// let circle = |r: f64| vec![Vertex::new(-r, 0.0, 1.0), Vertex::new(r, 0.0, 1.0)];
    /// let annulus = Part::new("annulus", vec![circle(1.0), circle(2.0)])?;
    /// assert!(annulus.contains(Point::new(0.0, 1.5)));
    /// assert!(!annulus.contains(Point::ORIGIN));
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn contains(&self, p: Point) -> bool {
        let is_inside = |loops: &[Loop]| {
            let edges = loops.iter().flat_map(Loop::edges);
            edges.filter(|edge| edge.toggles(p)).count() % 2 == 1
        };
        self.bounds.contains(p)
            && (self.layers.iter()).any(|layer| is_inside(&self.loops[layer.loops()]))
    }
}

/// Spatial index of the edges of a part of one layer for repeated point-in-part tests.
#[derive(Debug)]
pub(crate) struct Inside {
    bounds: Bounds,
    edges: Vec<Edge>,
    boxes: Boxes,
}

impl Inside {
    pub(crate) fn of(part: &Part) -> Self {
        let edges: Vec<Edge> = part.edges().collect();
        Self {
            bounds: part.bounds,
            boxes: Boxes::new(edges.iter().map(Edge::bounds)),
            edges,
        }
    }

    /// As [`Part::contains`]: the ray misses edges to the left of the point, above or below it.
    pub(crate) fn contains(&self, p: Point) -> bool {
        let meets = |b: &Bounds| b.min.y <= p.y && p.y <= b.max.y && p.x <= b.max.x;
        let mut inside = false;
        self.boxes.any(meets, |i| {
            inside ^= self.edges[i as usize].toggles(p);
            false
        });
        inside && self.bounds.contains(p)
    }
}

impl Loop {
    /// The area the loop encloses, positive when the material beside the loop is inside it and
    /// negative when the loop is the edge of a hole.
    ///
    /// ```
    /// use cspace::{Part, Vertex};
    /// let circle = |r: f64| vec![Vertex::new(-r, 0.0, 1.0), Vertex::new(r, 0.0, 1.0)];
    /// let annulus = Part::new("annulus", vec![circle(1.0), circle(2.0)])?;
    /// assert!(annulus.loops()[0].signed_area() < 0.0);
    /// assert!(annulus.loops()[1].signed_area() > 0.0);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn signed_area(&self) -> f64 {
        let origin = self.vertices().first().map_or(Point::ORIGIN, |v| v.point());
        sum(self.edges().map(|edge| edge.area_swept(origin)))
    }
}

/// A sum whose rounding does not grow with the number of terms (Kahan, 1965).
pub(super) fn sum(terms: impl Iterator<Item = f64>) -> f64 {
    let (total, _) = terms.fold((0.0, 0.0), |(total, lost), term| {
        let term = term - lost;
        let next = total + term;
        (next, (next - total) - term)
    });
    total
}

impl Edge {
    /// The signed area swept by the segment from `origin` to a point that moves along the edge. The sum over a loop is its area, for any
    /// origin.
    pub fn area_swept(&self, origin: Point) -> f64 {
        0.5 * (self.start - origin).cross(self.end - origin) + self.segment_area()
    }

    /// Whether the edge, closed by two rays along the first axis, changes the parity at `p`: a point is inside loops if an odd number of
    /// their edges do.
    pub fn toggles(&self, p: Point) -> bool {
        let chord = self.end - self.start;
        let rising = chord.y > 0.0;
        let level = (self.start.y <= p.y) != (self.end.y <= p.y);
        let turn = (self.start - p).cross(self.end - p);
        // A point of the chord counts to the right of a rising one, to the left of a falling one, and
        // above a level one; all tests below use this one answer.
        let tie = chord.y < 0.0 || (chord.y == 0.0 && chord.x > 0.0);
        let left = turn > 0.0 || (turn == 0.0 && tie);
        let across = level && (rising == left);
        let arc_is_left = self.bulge < 0.0;
        let between =
            self.bulge != 0.0 && left == arc_is_left && self.level(p) * self.bulge.signum() > 0.0;
        across != between
    }
}
