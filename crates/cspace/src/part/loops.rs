//! Parts and their loops.

use crate::geometry::Configuration;

use super::check::{check_extent, check_numbers};
use super::corner::check_corners;
use super::nearness::check_vertices;
use super::outline::Outline;
use super::sweep::check_meetings;
use super::{Bounds, Edge, PartError, PartFeature, Vertex};

/// A closed loop of a part, as it was given.
#[derive(Debug, Clone, PartialEq)]
pub struct Loop {
    vertices: Vec<Vertex>,
    /// Whether the given direction has material on the right.
    reversed: bool,
}

/// A planar part: the even-odd interior of its loops, in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    name: String,
    loops: Vec<Loop>,
    /// Names of edges and vertices, in order.
    pub(super) names: Vec<(PartFeature, String)>,
    /// The box of the loops' edges; stored because it is used for every query.
    pub(super) bounds: Bounds,
}

impl Loop {
    /// The vertices, as given, except that negligible bulges are 0.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Whether the loop was given with material on its right, so that its edges are traversed backwards.
    pub fn is_reversed(&self) -> bool {
        self.reversed
    }

    /// The edges in order of travel, material on the left.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        let n = self.vertices.len();
        (0..n).filter_map(move |i| self.edge(if self.reversed { n - 1 - i } else { i }))
    }

    /// The index of the vertex at which an edge starts in the direction of travel, given the edge's own.
    pub fn start_of(&self, edge: usize) -> usize {
        (edge + usize::from(self.reversed)) % self.vertices.len()
    }

    /// The edge that a vertex describes, material on the left; `None` if there is no such vertex.
    pub fn edge(&self, index: usize) -> Option<Edge> {
        let here = self.vertices.get(index)?;
        let next = self.vertices[(index + 1) % self.vertices.len()];
        let edge = Edge {
            start: here.point(),
            end: next.point(),
            bulge: here.bulge,
            index,
        };
        Some(if self.reversed { edge.reversed() } else { edge })
    }
}

impl Part {
    /// Checks the loops and finds on which side of each the material lies.
    ///
    /// The material is the even-odd interior: the places enclosed by an odd number of loops. Loops may come in either direction, in any
    /// order, nested to any depth; they may not cross or touch themselves or each other. [`RESOLUTION`] defines what counts as touching. A
    /// bulge of magnitude up to [`FLAT_BULGE`] counts as 0, a line.
    ///
    /// Takes time in proportion to n log n for n vertices, of which there may be [`MAX_VERTICES`].
    ///
    /// # Errors
    /// The error states which loop and vertex is wrong, why, and what to do. Only one of several errors is reported.
    ///
    /// ```
    /// use cspace::{Part, PartError, Vertex};
    /// let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    /// let plate: Vec<_> = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    /// let hole = |x: f64| vec![Vertex::new(x - 1.0, 2.0, 1.0), Vertex::new(x + 1.0, 2.0, 1.0)];
    ///
    /// let part = Part::new("plate", vec![plate.clone(), hole(2.0)])?;
    /// assert!((part.area() - (16.0 - core::f64::consts::PI)).abs() < 1e-14);
    ///
    /// let error = Part::new("plate", vec![plate, hole(3.5)]);
    /// assert!(matches!(error, Err(PartError::Crossing { loop_index: 0, other_loop: 1, .. })));
    /// # Ok::<(), PartError>(())
    /// ```
    ///
    /// [`RESOLUTION`]: super::tolerance::RESOLUTION
    /// [`FLAT_BULGE`]: super::tolerance::FLAT_BULGE
    /// [`MAX_VERTICES`]: super::tolerance::MAX_VERTICES
    pub fn new(name: impl Into<String>, mut loops: Vec<Vec<Vertex>>) -> Result<Self, PartError> {
        check_numbers(&mut loops)?;
        let bounds = check_extent(&loops)?;
        let outline = Outline::new(&loops, bounds);
        check_corners(&outline)?;
        check_vertices(&outline, &loops)?;
        let reversed = check_meetings(&outline)?;
        let loops = loops
            .into_iter()
            .zip(reversed)
            .map(|(vertices, reversed)| Loop { vertices, reversed })
            .collect();
        Ok(Self {
            name: name.into(),
            loops,
            names: Vec::new(),
            bounds,
        })
    }

    /// Several parts, each moved by a configuration, as one part: they may touch, which is not checked.
    pub(crate) fn assembled(name: &str, placed: &[(&Self, Configuration)]) -> Self {
        let moved = |(part, at): &(&Self, Configuration)| {
            let vertex = |v: &Vertex| {
                let p = at.fixed_from_moving(v.point());
                Vertex::new(p.x, p.y, v.bulge)
            };
            let moved = |l: &Loop| Loop {
                vertices: l.vertices.iter().map(vertex).collect(),
                reversed: l.reversed,
            };
            part.loops.iter().map(moved).collect::<Vec<_>>()
        };
        let loops: Vec<Loop> = placed.iter().flat_map(moved).collect();
        let edges = loops.iter().flat_map(Loop::edges);
        Self {
            name: name.to_owned(),
            bounds: edges.fold(Bounds::EMPTY, |all, e| all.union(e.bounds())),
            loops,
            names: Vec::new(),
        }
    }

    /// The complement of the part within a rectangle that is larger than the part's box by `far` on every side.
    pub(crate) fn framing(&self, far: f64) -> Self {
        let (lo, hi) = (self.bounds.min, self.bounds.max);
        let around = Loop {
            vertices: vec![
                Vertex::line(lo.x - far, lo.y - far),
                Vertex::line(hi.x + far, lo.y - far),
                Vertex::line(hi.x + far, hi.y + far),
                Vertex::line(lo.x - far, hi.y + far),
            ],
            reversed: false,
        };
        let out = |l: &Loop| Loop {
            vertices: l.vertices.clone(),
            reversed: !l.reversed,
        };
        let bounds = around
            .edges()
            .fold(Bounds::EMPTY, |all, e| all.union(e.bounds()));
        Self {
            name: self.name.clone(),
            loops: core::iter::once(around)
                .chain(self.loops.iter().map(out))
                .collect(),
            names: Vec::new(),
            bounds,
        }
    }

    /// The part's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The loops, in the order given.
    pub fn loops(&self) -> &[Loop] {
        &self.loops
    }

    /// All edges of all loops, material on the left.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.loops.iter().flat_map(Loop::edges)
    }
}
