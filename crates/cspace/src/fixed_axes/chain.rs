//! Free cells in order along the boundary of free space.

use super::arrange::{Cell, Stop};
use super::domain::Extent;
use super::gaps::Graphs;
use super::piece::{Name, Pair, Piece};

/// Ends that no name joins, but no farther apart than this (radians or length), follow each other: three curves through one
/// point, or lines that continue each other.
const SAME_PLACE: f64 = 1e-8;

/// One contact curve: consecutive free cells of one pair of features, in order of travel.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    pub(super) pair: u32,
    pub(super) cells: Vec<u32>,
    pub(super) previous: Option<u32>,
    pub(super) next: Option<u32>,
}

/// Whether travel along a cell, blocked space on the left and free space on the right, goes up in its parameter.
pub(super) fn goes_up(piece: &Piece) -> bool {
    // Above is right of travel to the left; right is right of travel upwards.
    (piece.root == 0) == piece.vertical
}

/// The configuration at an end of a cell.
pub(super) fn end_of(cell: &Cell, piece: &Piece, pairs: &[Pair], at_end: bool) -> (f64, f64) {
    let t = if at_end { cell.to } else { cell.from };
    if piece.vertical {
        (piece.start.x, t)
    } else {
        (t, piece.y(pairs, t))
    }
}

/// Finds which cell follows which, all being free, and gathers those of the same features, as `same` tells, to curves.
pub(super) fn chains(
    graphs: &Graphs<'_>,
    x: &Extent,
    joints: &[[(u32, bool); 2]],
    same: impl Fn(&Pair, &Pair) -> bool,
) -> Vec<Chain> {
    const NONE: u32 = u32::MAX;
    let (cells, pairs) = (graphs.cells, graphs.pairs);
    let piece = |i: u32| graphs.piece(i);
    let leaves = |(i, at_end): (u32, bool)| goes_up(piece(i)) == at_end;
    let mut next = vec![NONE; cells.len()];
    let mut previous = vec![NONE; cells.len()];
    for &[a, b] in joints {
        if leaves(a) == leaves(b) {
            continue;
        }
        let (from, to) = if leaves(a) { (a.0, b.0) } else { (b.0, a.0) };
        next[from as usize] = to;
        previous[to as usize] = from;
    }
    // What is left over, by place.
    let all = || 0..cells.len() as u32;
    let place = |i: u32, leaving: bool| {
        end_of(
            &cells[i as usize],
            piece(i),
            pairs,
            goes_up(piece(i)) == leaving,
        )
    };
    let stop = |i: u32, leaving: bool| {
        let c = &cells[i as usize];
        if goes_up(piece(i)) == leaving {
            c.end
        } else {
            c.start
        }
    };
    let at_limit = |i: u32, leaving: bool| matches!(stop(i, leaving), Stop::Node(key) if key.name == Name::Limit);
    let open: Vec<u32> = all()
        .filter(|&i| previous[i as usize] == NONE && !at_limit(i, false))
        .collect();
    let leaving: Vec<u32> = all()
        .filter(|&i| next[i as usize] == NONE && !at_limit(i, true))
        .collect();
    for i in leaving {
        let (u, v) = place(i, true);
        let near = open
            .iter()
            .copied()
            .filter(|&j| previous[j as usize] == NONE)
            .map(|j| {
                let (s, t) = place(j, false);
                (x.apart(s, u).hypot(graphs.y.apart(t, v)), j)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        if let Some((_, j)) = near.filter(|n| n.0 < SAME_PLACE) {
            next[i as usize] = j;
            previous[j as usize] = i;
        }
    }
    let pair = |i: u32| piece(i).pair;
    // A curve starts where the pair of features changes, and where it crosses itself.
    let continues = |from: u32, to: u32| {
        same(&pairs[pair(from) as usize], &pairs[pair(to) as usize])
            && matches!(stop(from, true), Stop::Node(_))
            && matches!(stop(to, false), Stop::Node(_))
    };
    let mut of_cell = vec![NONE; cells.len()];
    let mut chains: Vec<Chain> = Vec::new();
    let first = |i: u32| {
        let before = previous[i as usize];
        before == NONE || !continues(before, i)
    };
    // Curves with a beginning, then those that close upon themselves.
    for i in all().filter(|&i| first(i)).chain(all()) {
        if of_cell[i as usize] != NONE {
            continue;
        }
        let mut members = Vec::new();
        let mut at = i;
        loop {
            of_cell[at as usize] = chains.len() as u32;
            members.push(at);
            let after = next[at as usize];
            if after == NONE || of_cell[after as usize] != NONE || !continues(at, after) {
                break;
            }
            at = after;
        }
        chains.push(Chain {
            pair: pair(i),
            cells: members,
            previous: None,
            next: None,
        });
    }
    for chain in &mut chains {
        let (Some(&from), Some(&to)) = (chain.cells.first(), chain.cells.last()) else {
            continue;
        };
        // No neighbour is told by `None`, never by the mark of this function.
        let of = |i: u32| {
            let chain = of_cell.get(i as usize).copied();
            chain.filter(|&c| c != NONE)
        };
        chain.previous = of(previous[from as usize]);
        chain.next = of(next[to as usize]);
    }
    chains
}
