//! Polygons of `geo-types`, which have straight sides alone.

use geo_types::{Coord, LineString, MultiPolygon, Polygon};

use crate::geometry::Point;
use crate::part::{Loop, Part, PartError, Vertex};

impl From<Coord> for Point {
    fn from(c: Coord) -> Self {
        Self::new(c.x, c.y)
    }
}

impl From<Point> for Coord {
    fn from(p: Point) -> Self {
        Self { x: p.x, y: p.y }
    }
}

impl From<geo_types::Point> for Point {
    fn from(p: geo_types::Point) -> Self {
        p.0.into()
    }
}

impl From<Point> for geo_types::Point {
    fn from(p: Point) -> Self {
        Self(p.into())
    }
}

impl Part {
    /// The part that polygons cover: a loop for each exterior and each interior ring, without the vertex that closes it.
    ///
    /// # Errors
    /// As of [`Part::new`]: polygons may not touch each other.
    ///
    /// ```
    /// use cspace::Part;
    /// use geo_types::{line_string, polygon};
    /// let plate = polygon![
    ///     exterior: [(x: 0.0, y: 0.0), (x: 4.0, y: 0.0), (x: 4.0, y: 4.0), (x: 0.0, y: 4.0)],
    ///     interiors: [[(x: 1.0, y: 1.0), (x: 2.0, y: 1.0), (x: 2.0, y: 2.0)]],
    /// ];
    /// assert_eq!(Part::from_polygons("plate", plate)?.area(), 15.5);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn from_polygons(
        name: impl Into<String>,
        polygons: impl Into<MultiPolygon>,
    ) -> Result<Self, PartError> {
        let rings = polygons.into().0.into_iter().flat_map(|polygon| {
            let (exterior, interiors) = polygon.into_inner();
            core::iter::once(exterior).chain(interiors)
        });
        Self::new(name, rings.map(loop_of).collect())
    }

    /// The part as polygons, one for each outer loop, with chords no farther than `tolerance` from the arcs, a length: layer after layer,
    /// of which polygons may overlap those of another.
    ///
    /// ```
    /// use cspace::Part;
    /// let ring = Part::new("ring", vec![
    ///     cspace::part::circle_loop([0.0, 0.0], 3.0)?,
    ///     cspace::part::circle_loop([0.0, 0.0], 2.0)?,
    /// ])?;
    /// let polygons = ring.to_polygons(1e-3);
    /// assert_eq!((polygons.0.len(), polygons.0[0].interiors().len()), (1, 1));
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn to_polygons(&self, tolerance: f64) -> MultiPolygon {
        let ring = |l: &Loop| LineString::from(l.points(tolerance));
        let mut polygons = Vec::new();
        for layer in self.layers() {
            let loops = &self.loops()[layer.loops()];
            let encloses = |outer: &Loop, inner: &Loop| {
                let edges = outer.edges();
                let p = inner.vertices()[0].point();
                edges.filter(|edge| edge.toggles(p)).count() % 2 == 1
            };
            // Loops neither cross nor touch: a loop within an even number of others is an outer one, and a hole is in the smallest of the
            // loops around it.
            let around = |l: &Loop| -> Vec<usize> {
                let others = loops.iter().enumerate();
                (others.filter(|(_, other)| !core::ptr::eq(*other, l) && encloses(other, l)))
                    .map(|(i, _)| i)
                    .collect()
            };
            let around: Vec<Vec<usize>> = loops.iter().map(around).collect();
            for (outer, within) in around.iter().enumerate() {
                if within.len() % 2 == 1 {
                    continue;
                }
                let holes = (around.iter().enumerate())
                    .filter(|(_, a)| a.len() == within.len() + 1 && a.contains(&outer))
                    .map(|(hole, _)| ring(&loops[hole]));
                polygons.push(Polygon::new(ring(&loops[outer]), holes.collect()));
            }
        }
        MultiPolygon(polygons)
    }
}

/// The loop of a ring, whose last vertex is its first.
fn loop_of(ring: LineString) -> Vec<Vertex> {
    let mut vertices: Vec<Vertex> = (ring.0.iter()).map(|c| Vertex::line(c.x, c.y)).collect();
    if ring.is_closed() {
        vertices.pop();
    }
    vertices
}
