//! A part with its boundary moved inward.

use cspace::{Edge, Part, PartError, Vector, Vertex};

/// The part with every edge moved inward along its normals by a distance, in the model's unit of length. Corners stay corners, where
/// the moved edges meet, and loops and vertices keep their numbers. It lies within the part, everywhere at least the distance from its
/// boundary but for the square of the distance times the curvature of arcs. `None` if an edge vanishes.
///
/// At a vertex between edges with outward normals n and m the boundary moves by −d (n + m) / (1 + n · m).
pub(crate) fn inset(part: &Part, distance: f64) -> Result<Option<Part>, PartError> {
    /// Edges that turn back on each other have no corner: what 1 + n · m is at least.
    const SHARPEST: f64 = 1e-6;
    let mut loops = Vec::with_capacity(part.loops().len());
    for outline in part.loops() {
        let edges: Vec<Edge> = outline.edges().collect();
        let n = edges.len();
        // In order of travel, material on the left: where the edges start.
        let mut starts = Vec::with_capacity(n);
        for (i, after) in edges.iter().enumerate() {
            let before = &edges[(i + n - 1) % n];
            let (a, b) = (
                before.end_direction().right(),
                after.start_direction().right(),
            );
            let opening = 1.0 + a.dot(b);
            if opening < SHARPEST {
                return Ok(None);
            }
            starts.push(after.start - (a + b) * (distance / opening));
        }
        let mut vertices = vec![Vertex::line(0.0, 0.0); n];
        for (i, edge) in edges.iter().enumerate() {
            let (start, end) = (starts[i], starts[(i + 1) % n]);
            if (end - start).dot(edge.end - edge.start) <= 0.0 && n > 2 {
                return Ok(None);
            }
            let mut bulge = 0.0;
            if !edge.is_line() {
                if edge.bulge > 0.0 && edge.radius() <= 2.0 * distance {
                    return Ok(None);
                }
                let center = edge.center();
                let turned = |from: Vector, to: Vector| from.cross(to).atan2(from.dot(to));
                let first = turned(edge.start - center, start - center);
                let last = turned(edge.end - center, end - center);
                bulge = ((edge.sweep() + last - first) / 4.0).tan();
            }
            // The vertex that the edge leaves as it was given, with its bulge.
            vertices[edge.index] = if outline.is_reversed() {
                Vertex::new(end.x, end.y, -bulge)
            } else {
                Vertex::new(start.x, start.y, bulge)
            };
        }
        loops.push(vertices);
    }
    part.redrawn(loops).map(Some)
}
