//! Cuts pieces by each other to cells, and connects cells that follow each other.

use core::f64::consts::TAU;

use crate::parallel::prelude::*;

use crate::union_find::UnionFind;

use super::cross::crossings;
use super::motion::{Extent, brought_between};
use super::piece::{Key, Name, Pair, Piece};
use super::tolerance::MOST_MEETINGS;

/// Node or crossing at an end of a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Stop {
    /// End of the piece.
    Node(Key),
    /// A crossing, by its index.
    Crossing(u32),
}

/// A part of a piece between two crossings or ends: as a whole, it is on the boundary of free space or not.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Cell {
    pub(super) piece: u32,
    /// Range of its parameter: x of a graph, y of a vertical piece (in the piece's own turn).
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) start: Stop,
    pub(super) end: Stop,
    /// Whether its crossings show that it lies in blocked space.
    pub(super) blocked: bool,
}

/// A crossing of two pieces.
#[derive(Debug, Clone, Copy)]
struct Crossing {
    pieces: [u32; 2],
    /// Place of the crossing in the parameter of each: x of a graph, y of a vertical piece.
    at: [f64; 2],
    /// Whether each piece is outside the other's blocked side before the crossing (otherwise after it).
    outer_before: [bool; 2],
}

/// The cells, and the chains that they form.
#[derive(Debug)]
pub(super) struct Arrangement {
    pub(super) cells: Vec<Cell>,
    /// Pairs of cells, the second of which follows the first; each with a flag: whether it is left at its end, entered at its start.
    pub(super) joints: Vec<[(u32, bool); 2]>,
    /// For every cell, the smallest cell of its chain.
    pub(super) chain: Vec<u32>,
    pub(super) crossings: usize,
}

impl Arrangement {
    /// Builds the arrangement; `None` if more pieces may cross than the limit.
    pub(super) fn new(pairs: &[Pair], pieces: &[Piece], y: &Extent) -> Option<Self> {
        let crossings = all_crossings(pairs, pieces, y)?;
        let mut on_piece: Vec<(u32, f64, u32, bool)> = Vec::with_capacity(2 * crossings.len());
        for (i, c) in (0u32..).zip(&crossings) {
            for k in 0..2 {
                on_piece.push((c.pieces[k], c.at[k], i, c.outer_before[k]));
            }
        }
        on_piece.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        let mut cells: Vec<Cell> = Vec::with_capacity(pieces.len() + on_piece.len());
        // (crossing, cell, whether at its end)
        let mut outer: Vec<(u32, u32, bool)> = Vec::with_capacity(on_piece.len());
        let mut ends: Vec<(Key, u32, bool)> = Vec::with_capacity(2 * pieces.len());
        let mut next = 0;
        for (i, piece) in (0u32..).zip(pieces) {
            let (from, to) = if piece.vertical {
                piece.y_range()
            } else {
                piece.x_range()
            };
            let first = cells.len() as u32;
            let mut open = Cell {
                piece: i,
                from,
                to: from,
                start: Stop::Node(piece.start.key),
                end: Stop::Node(piece.end.key),
                blocked: false,
            };
            ends.push((piece.start.key, first, false));
            while let Some(&(_, at, crossing, before)) = on_piece.get(next).filter(|o| o.0 == i) {
                next += 1;
                // Rounding may have put it just beyond an end.
                let at = brought_between(at, from, to);
                open.to = at;
                open.end = Stop::Crossing(crossing);
                open.blocked |= !before;
                if before {
                    outer.push((crossing, cells.len() as u32, true));
                }
                cells.push(open);
                open.from = at;
                open.start = Stop::Crossing(crossing);
                open.blocked = before;
                if !before {
                    outer.push((crossing, cells.len() as u32, false));
                }
            }
            open.to = to;
            open.end = Stop::Node(piece.end.key);
            ends.push((piece.end.key, cells.len() as u32, true));
            cells.push(open);
        }
        let mut joints = Vec::new();
        outer.sort_unstable();
        for two in outer.chunk_by(|a, b| a.0 == b.0) {
            if let [a, b] = two {
                joints.push([(a.1, a.2), (b.1, b.2)]);
            }
        }
        ends.sort_unstable();
        for group in ends.chunk_by(|a, b| a.0 == b.0) {
            match group {
                [a, b] if a.0.name != Name::Limit => joints.push([(a.1, a.2), (b.1, b.2)]),
                _ => {}
            }
        }
        let mut sets = UnionFind::new(cells.len());
        for [a, b] in &joints {
            sets.union(a.0, b.0);
        }
        let chain = (0..cells.len() as u32).map(|i| sets.find(i)).collect();
        Some(Self {
            cells,
            joints,
            chain,
            crossings: crossings.len(),
        })
    }
}

/// Maximum number of turns by which one of two pieces on a circle must be shifted to meet the other: both begin in the first turn, and a
/// monotone piece rises by less than two turns, since its roots and the angles from which they are measured go around at most once each.
const MOST_SHIFTS: i32 = 2;

/// Margin for the rounding of boxes (radians): they are compared first.
const ROOM: f64 = 1e-9;

fn all_crossings(pairs: &[Pair], pieces: &[Piece], y: &Extent) -> Option<Vec<Crossing>> {
    let mut order: Vec<u32> = (0..pieces.len() as u32).collect();
    order.sort_by(|&a, &b| {
        let (p, q) = (&pieces[a as usize], &pieces[b as usize]);
        p.start.x.total_cmp(&q.start.x).then(a.cmp(&b))
    });
    let boxes: Vec<(f64, f64)> = pieces.iter().map(Piece::y_range).collect();
    let mut candidates: Vec<(u32, u32, i32)> = Vec::new();
    // Upper end of each piece and its box, side by side: most of the work is a scan of this list.
    let mut active: Vec<(f64, f64, f64, u32)> = Vec::new();
    for i in order {
        let p = &pieces[i as usize];
        active.retain(|a| a.0 >= p.start.x);
        let (p_lo, p_hi) = boxes[i as usize];
        for &(_, q_lo, q_hi, j) in &active {
            if !y.is_circle() {
                if p_lo <= q_hi && q_lo <= p_hi {
                    candidates.push((i, j, 0));
                }
                continue;
            }
            // The lower ends are in the first turn, so no other shifts need to be examined. One test for all shifts: the distance of q's
            // box ahead of p's on the circle, and of p's ahead of q's.
            let (p_size, q_size) = (p_hi - p_lo, q_hi - q_lo);
            let apart = q_lo - p_lo;
            let apart = if apart < 0.0 { apart + TAU } else { apart };
            if apart > p_size + ROOM && TAU - apart > q_size + ROOM {
                continue;
            }
            for shift in -MOST_SHIFTS..=MOST_SHIFTS {
                let by = TAU * f64::from(shift);
                if p_lo <= q_hi + by && q_lo + by <= p_hi {
                    candidates.push((i, j, shift));
                }
            }
        }
        active.push((p.end.x, p_lo, p_hi, i));
        if candidates.len() > MOST_MEETINGS {
            return None;
        }
    }
    let crossings = (candidates.par_iter())
        .with_min_len(64)
        .flat_map_iter(|&(i, j, shift)| {
            let mut found = Vec::new();
            let (p, q) = (&pieces[i as usize], &pieces[j as usize]);
            cross(pairs, pieces, (i, p), (j, q), shift, &mut found);
            found
        });
    Some(crossings.collect())
}

fn cross(
    pairs: &[Pair],
    pieces: &[Piece],
    (i, p): (u32, &Piece),
    (j, q): (u32, &Piece),
    shift: i32,
    found: &mut Vec<Crossing>,
) {
    match (p.vertical, q.vertical) {
        (false, false) => crossings(pairs, p, q, shift, |x, before| {
            let p_above_before = before > 0;
            found.push(Crossing {
                pieces: [i, j],
                at: [x, x],
                outer_before: [
                    (q.root == 0) == p_above_before,
                    (p.root == 0) != p_above_before,
                ],
            });
        }),
        (true, true) => {}
        (true, false) => cross_vertical(pairs, pieces, i, j, shift, found),
        (false, true) => cross_vertical(pairs, pieces, j, i, -shift, found),
    }
}

/// Crosses a vertical piece and a graph, the graph shifted by a number of turns.
fn cross_vertical(
    pairs: &[Pair],
    pieces: &[Piece],
    i: u32,
    j: u32,
    shift: i32,
    found: &mut Vec<Crossing>,
) {
    let (v, g) = (&pieces[i as usize], &pieces[j as usize]);
    let x = v.start.x;
    // A place exactly on the vertical counts as left of it, for all graphs.
    if (g.start.x > x) == (g.end.x > x) {
        return;
    }
    let h = g.height(pairs, x);
    let node = [&g.start, &g.end].into_iter().find(|e| e.x == x);
    let above = |end: &super::piece::End| {
        let d = (end.base - h.value) + TAU * f64::from(end.turns - h.turns - shift);
        // As for two graphs: a node is above a curve that passes through it, and nodes are ordered by name.
        d > 0.0 || d == 0.0 && node.is_none_or(|n| end.key > n.key)
    };
    if node.is_some_and(|n| n.key == v.start.key || n.key == v.end.key) {
        return;
    }
    let (start_above, end_above) = (above(&v.start), above(&v.end));
    if start_above == end_above {
        return;
    }
    let y = h.value + TAU * f64::from(h.turns + shift);
    let v_free_right = v.root == 0;
    let g_free_above = g.root == 0;
    found.push(Crossing {
        pieces: [i, j],
        at: [brought_between(y, v.start.y(), v.end.y()), x],
        // Before the crossing the vertical is below the graph; the graph is left of the vertical.
        outer_before: [!g_free_above, !v_free_right],
    });
}
