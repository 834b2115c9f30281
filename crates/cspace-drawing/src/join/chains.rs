//! Closed chains of pieces are loops; open ones are problems.

use std::collections::HashSet;

use cspace::Point;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::bridges::Bridges;
use super::centre_lines::Centres;
use super::joined::{Chain, ChainPiece, Joined, origin_of};
use super::pieces::{End, Pieces, ROUND, Segment, Shape, end, of_end};
use crate::drawing::{Drawing, Problem};
use crate::shown;

impl Segment<'_> {
    pub(super) fn is_line(&self) -> bool {
        matches!(self.shape, Shape::Edge(bulge) if bulge == 0.0)
    }
}

/// Follows the links. Open chains with an ambiguous end, which is reported already, cause no further problem.
pub(super) fn collect<'d>(
    pieces: &Pieces<'d>,
    drawing: &Drawing,
    ambiguous: &HashSet<usize>,
    [round, join]: [f64; 2],
    joined: &mut Joined<'d>,
) {
    let mut is_done = vec![false; pieces.segments.len()];
    let mut open: Vec<([End; 2], usize)> = Vec::new();
    let alive = |i: &usize| !pieces.segments[*i].is_removed;
    // Open chains first, from their ends: what is left then is closed.
    for i in (0..pieces.segments.len()).filter(alive) {
        let Some(side) = (0..2).find(|&side| pieces.linked(end(i, side)).is_none()) else {
            continue;
        };
        if is_done[i] {
            continue;
        }
        let chain = follow(pieces, end(i, side), &mut is_done);
        let entities = chain.iter().map(|&e| pieces.segments[of_end(e).0].entity);
        joined.unused.extend(entities);
        let of_chain = chain.iter().map(|&e| piece(pieces, e)).collect();
        joined.open.push(Chain {
            first: chain[0],
            pieces: of_chain,
        });
        let last = chain[chain.len() - 1];
        let ends = [end(i, side), last ^ 1];
        if !ends.iter().any(|&e| ambiguous.contains(&of_end(e).0)) {
            open.push((ends, joined.open.len() - 1));
        }
    }
    for i in (0..pieces.segments.len()).filter(alive) {
        if is_done[i] {
            continue;
        }
        let chain = follow(pieces, end(i, 0), &mut is_done);
        let pieces = chain.iter().map(|&e| piece(pieces, e)).collect();
        let chain = Chain {
            first: chain[0],
            pieces,
        };
        if chain.encloses_nothing(round) {
            joined.tiny += chain.pieces.len();
        } else {
            joined.loops.push(chain);
        }
    }
    tell_open(
        pieces,
        drawing,
        &open,
        [round / ROUND, join.max(round)],
        joined,
    );
}

/// The pieces from an end on, each by the end at which it is entered.
fn follow(pieces: &Pieces<'_>, first: End, is_done: &mut [bool]) -> Vec<End> {
    let mut chain = Vec::new();
    let mut next = Some(first);
    while let Some(entered) = next {
        let number = of_end(entered).0;
        if is_done[number] {
            break;
        }
        is_done[number] = true;
        chain.push(entered);
        next = pieces.linked(entered ^ 1);
    }
    chain
}

fn piece<'d>(pieces: &Pieces<'d>, entered: End) -> ChainPiece<'d> {
    let segment = &pieces.segments[of_end(entered).0];
    let is_backward = of_end(entered).1 == 1;
    ChainPiece {
        start: pieces.point(entered),
        end: pieces.point(entered ^ 1),
        shape: match segment.shape {
            Shape::Edge(bulge) if is_backward => Shape::Edge(-bulge),
            shape => shape,
        },
        is_backward,
        entity: segment.entity,
    }
}

/// Every open chain is a problem; what to do depends on how far its ends are from the nearest other ones.
fn tell_open(
    pieces: &Pieces<'_>,
    drawing: &Drawing,
    open: &[([End; 2], usize)],
    [size, reach]: [f64; 2],
    joined: &mut Joined<'_>,
) {
    type Near = GeomWithData<[f64; 2], End>;
    let at = |e: End| {
        let p = pieces.point(e);
        [p.x, p.y]
    };
    let tree: RTree<Near> = RTree::bulk_load(
        open.iter()
            .flat_map(|(ends, _)| ends)
            .map(|&e| Near::new(at(e), e))
            .collect(),
    );
    if open.is_empty() {
        return;
    }
    let mut bridges = Bridges::of(drawing, &joined.loops, reach);
    /// Gaps smaller than that share of the drawing may be meant to be closed.
    const SMALL: f64 = 0.01;
    let mut small: Vec<(usize, f64)> = Vec::new();
    let centres = Centres::of(&joined.loops, reach);
    let (mut loose, mut problems, known) = (Vec::new(), Vec::new(), joined.problems.len());
    for &(ends, chain) in open {
        let chain = &joined.open[chain];
        if centres.has_line(chain) {
            loose.extend(chain.pieces.iter().map(|p| p.entity));
            continue;
        }
        let nearest = |e: End| {
            (tree.nearest_neighbor_iter(at(e)).find(|n| n.data != e))
                .map(|n| pieces.point(e).distance(pieces.point(n.data)))
        };
        let [first, last] = ends.map(nearest);
        // The end whose gap is wider decides whether the chain closes.
        let gap = first
            .unwrap_or(f64::INFINITY)
            .max(last.unwrap_or(f64::INFINITY));
        let [a, b] = ends.map(|e| of_end(e).0);
        let [from, to] = ends.map(|e| pieces.point(e));
        let mut with = Vec::new();
        if pieces.segments[a].entity != pieces.segments[b].entity {
            with.push(origin_of(drawing, pieces.segments[b].entity).clone());
        }
        let mut told: Vec<String> = Vec::new();
        let mut ways: Vec<String> = Vec::new();
        let mut bridged: Option<Point> = None;
        for (e, piece) in ends.iter().zip([a, b]) {
            let (from, layer) = (
                pieces.point(*e),
                &origin_of(drawing, pieces.segments[piece].entity).layer,
            );
            // A gap between the two ends of the chain is reported once.
            if bridged.is_some_and(|p| p.distance(from) <= reach) {
                break;
            }
            let is_end = |p: Point| {
                let mut near = tree.locate_within_distance([p.x, p.y], reach * reach);
                near.any(|n| n.data != *e)
            };
            if let Some(bridge) = bridges.from(from, layer, is_end) {
                told.push(format!("; {}", bridge.told(from)));
                ways.extend(bridge.ways(layer));
                bridged = Some(bridge.to);
            }
        }
        ways.dedup();
        problems.push(Problem {
            origin: origin_of(drawing, pieces.segments[a].entity).clone(),
            with,
            at: Some(from),
            to: Some(to),
            reason: format!(
                "the chain from here to {} is open: its ends are {} from the nearest other ones{}",
                shown::point(to),
                shown::number(gap),
                told.concat()
            ),
            help: if !ways.is_empty() {
                ways.join("; ")
            } else if gap < SMALL * size {
                // What closes all such gaps is known after the last.
                small.push((known + problems.len(), gap));
                String::new()
            } else {
                "close it in the drawing; if it is no outline, remove it, or read the other layers alone with --layer".to_owned()
            },
        });
    }
    joined.centre_lines = loose;
    joined.problems.extend(problems);
    let widest = small.iter().fold(0.0, |most: f64, s| most.max(s.1));
    let what = match small.len() {
        1 => "close the gap in the drawing, or join it",
        _ => "close the gaps in the drawing, or join all of them",
    };
    let is_all = small.len() == joined.problems.len();
    joined.closes = Some(1.01 * widest).filter(|_| is_all);
    joined.small = small.len();
    for &(problem, _) in &small {
        joined.problems[problem].help = format!(
            "{what} with --join {gap} (in a model: join = {gap})",
            gap = shown::number(1.01 * widest)
        );
    }
}
