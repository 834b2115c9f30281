//! Crossings that curves have, and such as only the pieces have that were fitted to them.

use cspace::part::Edge;
use cspace::{PartError, Point, Vertex};

use crate::drawing::edge;

/// Whether the curves may be separate although their fitted edges cross or touch. They are not if two edges cross and
/// both continue, in both directions, to where they are farther apart than the tolerance of the fit: then the curves
/// cross too.
pub(super) fn may_be_of_fit(vertices: &[Vertex], error: &PartError, fit: f64) -> bool {
    let (edge_index, other_edge, at) = match *error {
        PartError::Touching { .. } => return true,
        PartError::Crossing {
            edge_index,
            other_edge,
            at,
            ..
        } => (edge_index, other_edge, at),
        _ => return false,
    };
    let n = vertices.len();
    let edges = [edge_index, other_edge].map(|i| {
        let (from, to) = (vertices[i % n], vertices[(i + 1) % n]);
        edge(from.point(), to.point(), from.bulge)
    });
    let sine = direction(&edges[0], at)
        .cross(direction(&edges[1], at))
        .abs();
    let shortest = (edges.iter())
        .flat_map(|e| [e.start, e.end])
        .map(|end| end.distance(at))
        .fold(f64::INFINITY, f64::min);
    shortest * sine <= 2.0 * fit
}

/// The direction of an edge at a point on it.
fn direction(edge: &Edge, at: Point) -> cspace::Vector {
    let (before, after) = (edge.start.distance(at), edge.end.distance(at));
    edge.direction_at(before / (before + after))
}
