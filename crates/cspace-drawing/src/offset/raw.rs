//! Curves at a distance from single edges and vertices, which the offset outline consists of.

use cspace::{Edge, Part, Vector};

use super::tolerance::SMOOTH;

/// A curve at the distance from an edge, or about a vertex.
#[derive(Debug, Clone, Copy)]
pub(super) struct Raw {
    pub(super) curve: Edge,
    /// The loop and the edge of the part that it belongs to: of a vertex the edge that comes before it.
    pub(super) of: (usize, usize),
}

/// Edges of each loop with the material to be grown on the left: the part's, or for a negative distance the outside.
pub(super) fn around(part: &Part, by: f64) -> Vec<Vec<Edge>> {
    (part.loops().iter())
        .map(|l| {
            let edges: Vec<Edge> = l.edges().collect();
            if by > 0.0 {
                edges
            } else {
                edges.iter().rev().map(Edge::reversed).collect()
            }
        })
        .collect()
}

/// Curves at a distance to the right of all edges. Those of concave arcs with a smaller radius are never the nearest,
/// and left out; between the curves of edges that meet in a convex corner there is an arc about the corner.
pub(super) fn raw(loops: &[Vec<Edge>], distance: f64, near: f64) -> Vec<Raw> {
    let mut raw = Vec::new();
    for (number, edges) in loops.iter().enumerate() {
        for (i, edge) in edges.iter().enumerate() {
            let of = (number, edge.index);
            let is_left = edge.bulge < 0.0 && edge.radius() - distance > near;
            if edge.bulge >= 0.0 || is_left {
                let curve = Edge {
                    start: edge.start + edge.start_direction().right() * distance,
                    end: edge.end + edge.end_direction().right() * distance,
                    ..*edge
                };
                raw.push(Raw { curve, of });
            }
            let next = &edges[(i + 1) % edges.len()];
            let (before, after) = (edge.end_direction(), next.start_direction());
            let turn = turn(before, after);
            if turn > SMOOTH {
                let curve = Edge {
                    start: edge.end + before.right() * distance,
                    end: edge.end + after.right() * distance,
                    bulge: (turn / 4.0).tan(),
                    index: edge.index,
                };
                raw.push(Raw { curve, of });
            }
        }
    }
    raw
}

/// The angle from one direction to another, positive to the left.
fn turn(from: Vector, to: Vector) -> f64 {
    from.cross(to).atan2(from.dot(to))
}
