//! Whether two parts overlap at a configuration at which they do not just touch.

use cspace::{Part, Point};

use super::at::{At, Layers, any_layers};
use super::search::Search;

/// Whether the boundaries cross at the start of a search, or a loop of one part is within the other.
pub(super) fn overlap(search: &Search<'_>, a: &At<'_>, b: &At<'_>) -> bool {
    let is_within = |l: &Layers<'_>| within(&l.a, &l.b) || within(&l.b, &l.a);
    search.crosses() || any_layers(a, b, is_within)
}

/// Whether some loop of a part begins in the material of another.
fn within(loops: &At<'_>, material: &At<'_>) -> bool {
    starts(loops.part).any(|q| material.part.contains(material.back(loops.out(q))))
}

fn starts(part: &Part) -> impl Iterator<Item = Point> {
    (part.loops().iter()).filter_map(|l| l.vertices().first().map(|v| v.point()))
}

/// Whether what is just inside of the middle of some edge of the first part is in the second: an edge that does not cross the other
/// boundary is in the other part, or along its boundary with material on the same side, as a whole or not at all.
pub(super) fn coincide(a: &At<'_>, b: &At<'_>, depth: f64) -> bool {
    /// How far beside the boundary, in the depths that count.
    const BESIDE: f64 = 4.0;
    a.part.edges().any(|edge| {
        let inward = edge.direction_at(0.5).left();
        let beside = edge.at(0.5) + inward * (BESIDE * depth);
        b.part.contains(b.back(a.out(beside)))
    })
}
