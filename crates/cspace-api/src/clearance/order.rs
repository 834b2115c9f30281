//! The order in which pairs are told, and what they come to together.

use crate::outcome::Outcome as _;

use super::{Outcome, Row};

/// The worst first: what overlaps, the deepest first; what stops a part, and what could not be decided; what touches; what turns only together;
/// what is clear, the tightest first; what is joined.
pub(super) fn sort(rows: &mut [Row]) {
    let rank = |row: &Row| match row.outcome {
        Outcome::Overlaps => 0,
        _ if is_stopped(row) => 1,
        Outcome::Undecided => 2,
        Outcome::Stopped | Outcome::Touches | Outcome::Meets if row.content.stopped.is_empty() => 4,
        Outcome::Stopped | Outcome::Touches | Outcome::Meets => 3,
        Outcome::Meshes => 5,
        Outcome::Clear => 6,
        Outcome::Done | Outcome::Joined => 7,
    };
    let depth = |row: &Row| row.content.depth.unwrap_or(f64::INFINITY);
    let gap = |row: &Row| row.content.gap.unwrap_or(0.0);
    rows.sort_by(|a, b| {
        (rank(a).cmp(&rank(b)))
            .then(depth(b).total_cmp(&depth(a)))
            .then(gap(a).total_cmp(&gap(b)))
    });
}

/// Whether a part with a range does not come to an end of it.
fn is_stopped(row: &Row) -> bool {
    row.content.stopped.iter().any(|stop| stop.of.is_some())
}

/// The worst outcome of all pairs.
pub(super) fn of_all(rows: &[Row]) -> Outcome {
    let of = |row: &Row| match row.outcome {
        Outcome::Touches | Outcome::Meshes if is_stopped(row) => Outcome::Stopped,
        outcome => outcome,
    };
    let worse = |a: Outcome, b: Outcome| match (a, b) {
        (Outcome::Overlaps, _) | (_, Outcome::Overlaps) => Outcome::Overlaps,
        _ if b.is() > a.is() => b,
        _ => a,
    };
    rows.iter()
        .map(of)
        .reduce(worse)
        .unwrap_or(Outcome::NOTHING)
}
