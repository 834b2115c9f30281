//! Outlines that are left out because they are not closed, and what lies within them.

use cspace::{Edge, Vertex};

use crate::arrange::{Faces, split};
use crate::drawing::edge;
use crate::join::{Chain, Shape};
use crate::nest::Ring;

/// The faces that open chains enclose.
pub(super) struct LeftOut {
    faces: Option<Faces>,
}

impl LeftOut {
    /// The faces between open chains; ends nearer than `near` are one.
    pub(super) fn of(chains: &[Chain<'_>], near: f64) -> Self {
        /// The gap of a chain that nearly closes, at most, as a share of its length.
        const NEARLY: f64 = 0.25;
        let mut edges: Vec<Edge> = Vec::new();
        for chain in chains {
            let mut vertices = corners(chain);
            let (Some(first), Some(last)) = (chain.pieces.first(), chain.pieces.last()) else {
                continue;
            };
            vertices.push(Vertex::line(last.end.x, last.end.y));
            let pairs = vertices.windows(2);
            let of_chain: Vec<Edge> = pairs
                .map(|v| edge(v[0].point(), v[1].point(), v[0].bulge))
                .collect();
            let length: f64 = of_chain.iter().map(Edge::length).sum();
            let gap = edge(last.end, first.start, 0.0);
            edges.extend(of_chain);
            if gap.length() > 0.0 && gap.length() <= NEARLY * length {
                edges.push(gap);
            }
        }
        Self {
            faces: split(&edges, near).ok().map(Faces::of),
        }
    }

    /// Whether most of a loop is in these faces: such as a hole, whose outline is left out.
    pub(super) fn holds(&self, ring: &Ring) -> bool {
        let Some(faces) = self.faces.as_ref().filter(|f| !f.faces.is_empty()) else {
            return false;
        };
        let (inside, count) = ring.places().fold((0, 0), |(inside, count), p| {
            (inside + usize::from(faces.at(p).is_some()), count + 1)
        });
        2 * inside > count
    }
}

/// Vertices of a chain whose curves are not fitted: some points of each curve, since nesting does not depend on its
/// exact shape.
pub(super) fn corners(chain: &Chain<'_>) -> Vec<Vertex> {
    /// Places on a span.
    const PLACES: u32 = 4;
    let mut vertices = Vec::new();
    for piece in &chain.pieces {
        match piece.shape {
            Shape::Edge(bulge) => {
                vertices.push(Vertex::new(piece.start.x, piece.start.y, bulge));
            }
            Shape::Curve(curve) => {
                let first = vertices.len();
                for span in 0..curve.spans() {
                    vertices.extend((0..PLACES).map(|k| {
                        let p = curve.at(span, f64::from(k) / f64::from(PLACES)).0;
                        Vertex::line(p.x, p.y)
                    }));
                }
                if piece.is_backward {
                    let end = curve.end();
                    vertices.push(Vertex::line(end.x, end.y));
                    vertices[first..].reverse();
                    vertices.pop();
                }
                vertices[first] = Vertex::line(piece.start.x, piece.start.y);
            }
        }
    }
    vertices
}
