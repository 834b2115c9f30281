//! Cusps: where an outline turns back with two sides that part by their curvature alone.

use cspace::Vertex;

use crate::drawing::edge;
use crate::fit::Outline;

/// Cuts the tip off a vertex at which the outline turns back, by a length along either side, or by less where a side is short;
/// false where both sides are lines, which do not part.
pub(super) fn blunt(outline: &mut Outline, vertex: usize, by: f64) -> bool {
    let n = outline.vertices.len();
    if n < 2 || vertex >= n {
        return false;
    }
    let before = (vertex + n - 1) % n;
    let side = |i: usize| {
        let (from, to) = (outline.vertices[i], outline.vertices[(i + 1) % n]);
        edge(from.point(), to.point(), from.bulge)
    };
    let (arriving, leaving) = (side(before), side(vertex));
    if arriving.is_line() && leaving.is_line() {
        return false;
    }
    let by = by.min(arriving.length() / 2.0).min(leaving.length() / 2.0);
    let kept = |length: f64| 1.0 - by / length;
    let shorter = |bulge: f64, kept: f64| (kept * bulge.atan()).tan();
    let (first, second) = (kept(arriving.length()), kept(leaving.length()));
    let (cut, on) = (arriving.at(first), leaving.at(1.0 - second));
    outline.vertices[before].bulge = shorter(arriving.bulge, first);
    outline.vertices[vertex] = Vertex::new(on.x, on.y, shorter(leaving.bulge, second));
    outline.vertices.insert(vertex, Vertex::line(cut.x, cut.y));
    let entity = outline.entities[before];
    outline.entities.insert(vertex, entity);
    true
}
