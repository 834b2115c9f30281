//! Whether two parts overlap at a configuration at which they do not just touch.

use cspace::{Part, Point};

use super::at::At;
use super::search::Search;

/// Whether the boundaries cross at the start of a search, or a loop of one part is within the other.
pub(super) fn overlap(search: &Search<'_>, a: &At<'_>, b: &At<'_>) -> bool {
    search.crosses() || within(a, b) || within(b, a)
}

/// Whether some loop of a part begins in the material of another.
fn within(loops: &At<'_>, material: &At<'_>) -> bool {
    starts(loops.part).any(|q| material.part.contains(material.back(loops.out(q))))
}

fn starts(part: &Part) -> impl Iterator<Item = Point> {
    (part.loops().iter()).filter_map(|l| l.vertices().first().map(|v| v.point()))
}
