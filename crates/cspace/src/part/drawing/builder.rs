//! Outlines drawn edge by edge.

use crate::geometry::Point;
use crate::number::Real;
use crate::part::tolerance::RESOLUTION;
use crate::part::{Bounds, Edge, Vertex};

use super::arc::{ArcError, ArcSize, Direction, bulge_about, bulge_through, bulge_with_radius};
use super::fillet::{FilletError, fillet};

/// Draws a loop edge by edge: lines, arcs from various data, and rounded corners.
///
/// The vertices are counted as they are drawn: the start is vertex 0, and every edge leads to the next. Fillets do not count.
/// [`close`](Self::close) gives the loop, or the first error.
///
/// ```
/// use cspace::part::{Direction, OutlineBuilder};
/// use cspace::Part;
/// // A plate 4 by 2 with a half round end and two rounded corners.
/// let plate = OutlineBuilder::start([0.0, 0.0])
///     .fillet(0.5)
///     .line_to([4.0, 0.0])
///     .arc_to_center([4.0, 2.0], [4.0, 1.0], Direction::CounterClockwise)
///     .line_to([0.0, 2.0])
///     .fillet(0.5)
///     .close()?;
/// let part = Part::new("plate", vec![plate])?;
/// let pi = core::f64::consts::PI;
/// assert!((part.area() - (8.0 + pi / 2.0 - 2.0 * (0.25 - pi / 16.0))).abs() < 1e-14);
/// # Ok::<(), cspace::PartError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use = "nothing is drawn before `close`"]
pub struct OutlineBuilder<T = f64> {
    vertices: Vec<Drawn<T>>,
    /// The first error.
    error: Option<OutlineError>,
}

/// A vertex as drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Drawn<T> {
    at: Point<T>,
    /// Bulge of the edge that leaves it.
    bulge: T,
    /// The radius of its fillet.
    fillet: Option<T>,
}

/// Reasons for which an outline cannot be drawn. Vertices are counted from 0 as they are drawn, without fillets.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OutlineError {
    /// A coordinate or a bulge is not a finite number.
    #[error("vertex {vertex_index}: a coordinate or bulge is not a finite number: give numbers")]
    NotFinite {
        /// The vertex.
        vertex_index: usize,
    },
    /// A vertex and the next are at one place.
    #[error(
        "vertex {vertex_index}: the next vertex is at the same place: remove one of them, or draw a full circle as two half circles"
    )]
    NoEdge {
        /// The vertex that the edge leaves.
        vertex_index: usize,
    },
    /// There are fewer than two vertices, or two that are joined by lines only.
    #[error(
        "the outline has {count} vertices and encloses nothing: give three, or two of which one is left by an arc"
    )]
    TooFewVertices {
        /// Number of vertices.
        count: usize,
    },
    /// An arc cannot be drawn.
    #[error("the arc from vertex {vertex_index} to {}: {error}", vertex_index + 1)]
    Arc {
        /// The vertex that the arc leaves.
        vertex_index: usize,
        /// Reason.
        error: ArcError,
    },
    /// A corner cannot be rounded.
    #[error("vertex {vertex_index}: {error}")]
    Fillet {
        /// The vertex.
        vertex_index: usize,
        /// Reason.
        error: FilletError,
    },
    /// A corner has two fillets.
    #[error("vertex {vertex_index} has two fillets: remove one of them")]
    TwoFillets {
        /// The vertex.
        vertex_index: usize,
    },
}

impl<T: Real> OutlineBuilder<T> {
    /// Starts at a vertex, to which [`close`](Self::close) returns.
    pub fn start(at: impl Into<Point<T>>) -> Self {
        let at = at.into();
        let error =
            (!at.map(T::value).is_finite()).then_some(OutlineError::NotFinite { vertex_index: 0 });
        Self {
            vertices: vec![Drawn::new(at)],
            error,
        }
    }

    /// Adds a line to the next vertex.
    pub fn line_to(self, to: impl Into<Point<T>>) -> Self {
        self.arc_to(to, T::constant(0.0))
    }

    /// Adds an arc with a given bulge, tan(sweep / 4), to the next vertex.
    pub fn arc_to(self, to: impl Into<Point<T>>, bulge: T) -> Self {
        self.edge_to(to.into(), |_, _| Ok(bulge))
    }

    /// Adds an arc about a centre to the next vertex; see [`bulge_about`].
    pub fn arc_to_center(
        self,
        to: impl Into<Point<T>>,
        center: impl Into<Point<T>>,
        direction: Direction,
    ) -> Self {
        let center = center.into();
        self.edge_to(to.into(), |from, to| {
            bulge_about(from, to, center, direction)
        })
    }

    /// Adds an arc with a given radius to the next vertex; see [`bulge_with_radius`].
    pub fn arc_to_radius(
        self,
        to: impl Into<Point<T>>,
        radius: T,
        direction: Direction,
        size: ArcSize,
    ) -> Self {
        self.edge_to(to.into(), |from, to| {
            bulge_with_radius(from, to, radius, direction, size)
        })
    }

    /// Adds an arc through a point to the next vertex; see [`bulge_through`].
    pub fn arc_through(self, to: impl Into<Point<T>>, through: impl Into<Point<T>>) -> Self {
        let through = through.into();
        self.edge_to(to.into(), |from, to| bulge_through(from, to, through))
    }

    /// Rounds the corner at the vertex drawn last by an arc tangent to both its edges; see
    /// [`fillet`](super::fillet()).
    ///
    /// Corners are rounded one after another in the order of vertices: a fillet uses the parts of its edges that previous fillets have
    /// left.
    pub fn fillet(mut self, radius: T) -> Self {
        let vertex_index = self.vertices.len() - 1;
        if let Some(last) = self.vertices.last_mut() {
            if last.fillet.is_some() {
                self.fail(OutlineError::TwoFillets { vertex_index });
            } else {
                last.fillet = Some(radius);
            }
        }
        self
    }

    /// The loop. It returns to the start by a line, unless the last edge ends there already, within [`RESOLUTION`] of the
    /// size of the box of all vertices.
    ///
    /// [`Part::new`](crate::Part::new) checks that the loop's edges do not meet each other, nor those of other loops.
    ///
    /// # Errors
    /// The first vertex or edge that cannot be drawn, why, and what to do.
    pub fn close(self) -> Result<Vec<Vertex<T>>, OutlineError> {
        Ok(self.close_numbered()?.into_iter().map(|(v, _)| v).collect())
    }

    /// The loop, as [`close`](Self::close) gives it, and for each vertex the number of the drawn vertex it comes from: a fillet replaces
    /// one vertex by two.
    ///
    /// # Errors
    /// As for [`close`](Self::close).
    ///
    /// ```
    /// use cspace::part::OutlineBuilder;
    /// let start = OutlineBuilder::start([0.0, 0.0]);
    /// let outline = start.line_to([4.0, 0.0]).fillet(1.0).line_to([4.0, 3.0]).close_numbered()?;
    /// let numbers: Vec<usize> = outline.iter().map(|(_, drawn)| *drawn).collect();
    /// assert_eq!(numbers, [0, 1, 1, 2]);
    /// # Ok::<(), cspace::part::OutlineError>(())
    /// ```
    pub fn close_numbered(mut self) -> Result<Vec<(Vertex<T>, usize)>, OutlineError> {
        if let Some(error) = self.error {
            return Err(error);
        }
        self.join_ends()?;
        let vertices = self.vertices;
        let count = vertices.len();
        if count < 2 || (count == 2 && vertices.iter().all(|v| v.bulge.value() == 0.0)) {
            return Err(OutlineError::TooFewVertices { count });
        }
        let next = vertices.iter().cycle().skip(1);
        let edges = (vertices.iter().zip(next).enumerate()).map(|(index, (here, next))| Edge {
            start: here.at,
            end: next.at,
            bulge: here.bulge,
            index,
        });
        rounded(edges.map(Some).collect(), &vertices)
    }

    /// Adds an edge to the next vertex; `bulge` computes the bulge from its ends.
    fn edge_to(
        mut self,
        to: Point<T>,
        bulge: impl FnOnce(Point<T>, Point<T>) -> Result<T, ArcError>,
    ) -> Self {
        let vertex_index = self.vertices.len() - 1;
        let Some(last) = self.vertices.last_mut() else {
            return self;
        };
        let from = last.at;
        let found = if !to.map(T::value).is_finite() {
            Err(OutlineError::NotFinite {
                vertex_index: vertex_index + 1,
            })
        } else if from.map(T::value) == to.map(T::value) {
            Err(OutlineError::NoEdge { vertex_index })
        } else {
            match bulge(from, to) {
                Ok(bulge) if bulge.value().is_finite() => Ok(bulge),
                Ok(_) => Err(OutlineError::NotFinite { vertex_index }),
                Err(error) => Err(OutlineError::Arc {
                    vertex_index,
                    error,
                }),
            }
        };
        match found {
            Ok(bulge) => last.bulge = bulge,
            Err(error) => self.fail(error),
        }
        self.vertices.push(Drawn::new(to));
        self
    }

    fn fail(&mut self, error: OutlineError) {
        self.error.get_or_insert(error);
    }

    /// Merges the first and the last vertex if they are at one place.
    fn join_ends(&mut self) -> Result<(), OutlineError> {
        let [first, .., last] = self.vertices[..] else {
            return Ok(());
        };
        let place = |v: &Drawn<T>| v.at.map(T::value);
        let boxes = (self.vertices.iter()).map(|v| Bounds::of(place(v), place(v)));
        let size = boxes.fold(Bounds::EMPTY, Bounds::union).diagonal();
        if place(&first).distance(place(&last)) > RESOLUTION * size {
            return Ok(());
        }
        if first.fillet.is_some() && last.fillet.is_some() {
            return Err(OutlineError::TwoFillets { vertex_index: 0 });
        }
        self.vertices.pop();
        self.vertices[0].fillet = first.fillet.or(last.fillet);
        Ok(())
    }
}

impl<T: Real> Drawn<T> {
    fn new(at: Point<T>) -> Self {
        Self {
            at,
            bulge: T::constant(0.0),
            fillet: None,
        }
    }
}

/// The vertices of a loop and their numbers as drawn, given its edges, after corners are rounded. Edges consumed by a fillet become `None`.
fn rounded<T: Real>(
    mut edges: Vec<Option<Edge<T>>>,
    vertices: &[Drawn<T>],
) -> Result<Vec<(Vertex<T>, usize)>, OutlineError> {
    let mut arcs: Vec<Option<Edge<T>>> = vec![None; vertices.len()];
    for (vertex_index, vertex) in vertices.iter().enumerate() {
        let Some(radius) = vertex.fillet else {
            continue;
        };
        let previous = vertex_index.checked_sub(1).unwrap_or(edges.len() - 1);
        let result = match (edges[previous], edges[vertex_index]) {
            (Some(before), Some(after)) => fillet(&before, &after, radius),
            _ => Err(FilletError::NoEdgeLeft),
        };
        let rounded = result.map_err(|error| OutlineError::Fillet {
            vertex_index,
            error,
        })?;
        edges[previous] = rounded.before;
        edges[vertex_index] = rounded.after;
        arcs[vertex_index] = Some(rounded.arc);
    }
    let both = arcs.into_iter().zip(edges);
    let all = both.flat_map(|(arc, edge)| [arc, edge]).flatten();
    Ok(all
        .map(|e| (Vertex::new(e.start.x, e.start.y, e.bulge), e.index))
        .collect())
}
