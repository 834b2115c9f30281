//! Ends that nearly meet are joined, the nearest first.

use std::collections::HashSet;

use cspace::Point;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::joined::{Joined, origin_of};
use super::pieces::{End, Pieces, end, of_end};
use crate::drawing::{Drawing, Problem};

/// Largest number of ends at one place that are distinguished.
const MOST_NEAR: usize = 16;

type Near = GeomWithData<[f64; 2], End>;

/// Joins ends; returns the pieces whose ends could be joined in several ways, and adds a problem for each such place.
pub(super) fn join(
    pieces: &mut Pieces<'_>,
    drawing: &Drawing,
    round: f64,
    join: f64,
    joined: &mut Joined<'_>,
) -> HashSet<usize> {
    let loose: Vec<End> = (0..pieces.segments.len())
        .filter(|&i| !pieces.segments[i].is_removed)
        .flat_map(|i| [end(i, 0), end(i, 1)])
        .filter(|&e| pieces.linked(e).is_none())
        .collect();
    let at = |e: End| {
        let p = pieces.point(e);
        [p.x, p.y]
    };
    let tree = RTree::bulk_load(loose.iter().map(|&e| Near::new(at(e), e)).collect());
    let reach = join.max(round);
    let mut candidates: Vec<(f64, End, End)> = Vec::new();
    for &a in &loose {
        let near = tree.locate_within_distance(at(a), reach * reach);
        for b in near.take(MOST_NEAR) {
            if a < b.data {
                let apart = pieces.point(a).distance(pieces.point(b.data));
                candidates.push((apart, a, b.data));
            }
        }
    }
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut ambiguous: HashSet<usize> = HashSet::new();
    let mut is_told: HashSet<End> = HashSet::new();
    for (apart, a, b) in candidates {
        if [a, b]
            .iter()
            .any(|e| pieces.linked(*e).is_some() || is_told.contains(e))
        {
            continue;
        }
        // Another end that is about as near could be meant as well.
        let about = (2.0 * apart + round).min(reach);
        let mut rivals: Vec<End> = [a, b]
            .into_iter()
            .flat_map(|e| tree.locate_within_distance(at_of(pieces, e), about * about))
            .take(2 * MOST_NEAR)
            .map(|n| n.data)
            .filter(|&e| e != a && e != b && pieces.linked(e).is_none())
            .collect();
        rivals.sort_unstable();
        rivals.dedup();
        if rivals.is_empty() {
            close(pieces, a, b, apart, round, joined);
            continue;
        }
        let ends: Vec<End> = [a, b].into_iter().chain(rivals).collect();
        // Of lines that go nowhere, as the stubs of dimensions do, none belongs to an outline.
        let goes_nowhere = |&e: &End| {
            let (piece, other) = (of_end(e).0, e ^ 1);
            let mut near = tree.locate_within_distance(at_of(pieces, other), reach * reach);
            pieces.segments[piece].is_line()
                && pieces.linked(other).is_none()
                && near.all(|n| n.data == other)
        };
        let going: Vec<End> = ends.iter().copied().filter(|e| !goes_nowhere(e)).collect();
        if let &[c, d] = &going[..] {
            let apart = pieces.point(c).distance(pieces.point(d));
            close(pieces, c, d, apart, round, joined);
            continue;
        }
        ambiguous.extend(ends.iter().map(|&e| of_end(e).0));
        is_told.extend(&ends);
        joined.problems.push(problem(pieces, drawing, &ends));
    }
    ambiguous
}

fn at_of(pieces: &Pieces<'_>, e: End) -> [f64; 2] {
    let p = pieces.point(e);
    [p.x, p.y]
}

/// Joins two ends: if an arc closes to a full circle, on this circle; otherwise at the end of a line, whose coordinates
/// are in the file, or else in the middle between the two.
fn close(pieces: &mut Pieces<'_>, a: End, b: End, apart: f64, round: f64, joined: &mut Joined<'_>) {
    let (p, q) = (pieces.point(a), pieces.point(b));
    let piece = of_end(a).0;
    if piece == of_end(b).0 && pieces.close_circle(piece) {
        if apart > round {
            joined.gaps.push((apart, p.midpoint(q)));
        }
        return;
    }
    let is_line = |e: End| pieces.segments[of_end(e).0].is_line();
    let at = match (is_line(a), is_line(b)) {
        (true, false) => p,
        (false, true) => q,
        _ if apart <= round => p,
        _ => p.midpoint(q),
    };
    pieces.move_end(a, at);
    pieces.move_end(b, at);
    pieces.link(a, b);
    if apart > round {
        joined.gaps.push((apart, at));
    }
}

fn problem(pieces: &Pieces<'_>, drawing: &Drawing, ends: &[End]) -> Problem {
    let mut entities: Vec<u32> = (ends.iter())
        .map(|&e| pieces.segments[of_end(e).0].entity)
        .collect();
    entities.sort_unstable();
    entities.dedup();
    let mut origins = entities.iter().map(|&e| origin_of(drawing, e).clone());
    let at: Point = pieces.point(ends[0]);
    Problem {
        origin: origins.next().unwrap_or_default(),
        with: origins.collect(),
        at: Some(at),
        to: None,
        reason: format!("{} ends meet here, and which belong together cannot be told", ends.len()),
        help: "remove what is no outline, or read its layers alone with --layer; for ends that are only near, give a smaller --join".to_owned(),
    }
}
