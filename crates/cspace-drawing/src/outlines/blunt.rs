//! Places where an outline turns back: cusps, whose sides part by their curvature alone, and spikes, whose sides are one line.

use cspace::{Point, Vertex};

use crate::drawing::edge;
use crate::fit::Outline;
use crate::join::ROUND;

/// A tip that was taken from an outline.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tip {
    pub(super) entity: u32,
    pub(super) at: Point,
    /// Whether the tip is a line drawn forth and back, which encloses nothing.
    pub(super) is_spike: bool,
}

/// Takes the tip off a vertex at which the outline turns back: of a cusp a length along either side, or less where a side is
/// short; of a spike, whose sides are two lines, as far as they go along each other. None where nothing would be left.
pub(super) fn blunt(outline: &mut Outline, vertex: usize, by: f64) -> Option<Tip> {
    let n = outline.vertices.len();
    if n < 2 || vertex >= n {
        return None;
    }
    let before = (vertex + n - 1) % n;
    let side = |i: usize| {
        let (from, to) = (outline.vertices[i], outline.vertices[(i + 1) % n]);
        edge(from.point(), to.point(), from.bulge)
    };
    let (arriving, leaving) = (side(before), side(vertex));
    let is_spike = arriving.is_line() && leaving.is_line();
    let tip = Tip {
        entity: outline.entities[before],
        at: outline.vertices[vertex].point(),
        is_spike,
    };
    if is_spike {
        let round = ROUND * arriving.length().max(leaving.length());
        let comes_back = arriving.start.distance(leaving.end) <= round;
        if n < if comes_back { 4 } else { 3 } {
            return None;
        }
        // The remainder of the two sides continues as the one that leaves.
        let next = (vertex + 1) % n;
        if comes_back {
            outline.vertices[before].bulge = outline.vertices[next].bulge;
            outline.entities[before] = outline.entities[next];
        }
        let is_kept: Vec<bool> = (0..n)
            .map(|i| i != vertex && !(comes_back && i == next))
            .collect();
        let (mut a, mut b) = (is_kept.iter(), is_kept.iter());
        outline.vertices.retain(|_| a.next() == Some(&true));
        outline.entities.retain(|_| b.next() == Some(&true));
        return Some(tip);
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
    Some(tip)
}
