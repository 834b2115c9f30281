//! Classifies each chain of cells as free or blocked by one exact overlap test at a representative point.

use super::arrange::{Arrangement, Cell};
use super::motion::Extent;
use super::piece::Piece;
use super::place::crossing_of_level;
use super::ranges::Ranges;
use super::setup::Bodies;
use super::sweep::Graphs;
use super::tolerance::COINCIDENT;
use crate::parallel::prelude::*;
use core::f64::consts::TAU;

/// Largest distance searched on the free side (radians or length).
const STEP: f64 = 1.0 / 256.0;
/// Slope above which a cell is left sideways.
const STEEP: f64 = 1e3;
/// Number of cells of a chain, the largest ones, that are tested; if they disagree, all are.
const TRIED: usize = 3;
/// Distance from the next curve from which a place is away from all curves (radians or length): no rounding puts it into another gap.
const CLEAR: f64 = 1e-8;

pub(super) struct Judge<'a> {
    graphs: Graphs<'a>,
    bodies: &'a Bodies,
    x: Extent,
    /// Pieces, indexed by x.
    by_x: Ranges,
}

/// The class of every cell.
pub(super) struct Verdicts {
    pub(super) free: Vec<bool>,
    pub(super) tests: usize,
    pub(super) conflicts: usize,
    /// Configurations beside cells, away from all curves, at which the parts overlap.
    pub(super) overlaps: Vec<(f64, f64)>,
}

/// The class of a chain.
struct Judged {
    free: Vec<u32>,
    tests: usize,
    /// Whether tests contradicted each other, or the chain's bounds.
    conflict: bool,
    overlaps: Vec<(f64, f64)>,
}

impl<'a> Judge<'a> {
    pub(super) fn new(graphs: Graphs<'a>, bodies: &'a Bodies, x: Extent) -> Self {
        let ranges = graphs.pieces.iter().map(Piece::x_range);
        Self {
            graphs,
            bodies,
            x,
            by_x: Ranges::new(x, ranges),
        }
    }

    pub(super) fn verdicts(&self, arrangement: &Arrangement) -> Verdicts {
        let n = arrangement.cells.len();
        let mut order: Vec<u32> = (0..n as u32).collect();
        order.sort_by_key(|&i| (arrangement.chain[i as usize], i));
        let mut verdicts = Verdicts {
            free: vec![false; n],
            tests: 0,
            conflicts: 0,
            overlaps: Vec::new(),
        };
        let chain = |i: &u32| arrangement.chain[*i as usize];
        let chains: Vec<&[u32]> = order.chunk_by(|a, b| chain(a) == chain(b)).collect();
        let judged: Vec<Judged> = chains
            .par_iter()
            .map(|members| self.judge_chain(&arrangement.cells, members))
            .collect();
        for chain in judged {
            verdicts.tests += chain.tests;
            verdicts.conflicts += usize::from(chain.conflict);
            verdicts.overlaps.extend(chain.overlaps);
            for i in chain.free {
                verdicts.free[i as usize] = true;
            }
        }
        verdicts
    }

    /// Whether every cell bounds free space, by a test beside it alone, independent of its crossings and neighbours.
    pub(super) fn one_by_one(&self, cells: &[Cell]) -> Vec<bool> {
        cells.par_iter().map(|c| self.tests_free(c)).collect()
    }

    /// Whether the free side of a cell is free.
    fn tests_free(&self, cell: &Cell) -> bool {
        self.beside(cell)
            .is_some_and(|(x, y, _)| !self.bodies.overlap(x, y))
    }

    fn judge_chain(&self, cells: &[Cell], members: &[u32]) -> Judged {
        let blocked = members.iter().any(|&i| cells[i as usize].blocked);
        let mut open: Vec<(f64, u32)> = members
            .iter()
            .filter(|&&i| !cells[i as usize].blocked)
            .map(|&i| (self.size(&cells[i as usize]), i))
            .collect();
        open.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut judged = Judged {
            free: Vec::new(),
            tests: 0,
            conflict: false,
            overlaps: Vec::new(),
        };
        // The largest cells: a place far enough from other curves is most likely beside one of them.
        let mut verdicts: Vec<bool> = Vec::new();
        for o in &open[..open.len().min(TRIED)] {
            if let Some((x, y, reach)) = self.beside(&cells[o.1 as usize]) {
                let free = !self.bodies.overlap(x, y);
                verdicts.push(free);
                if !free && reach > CLEAR {
                    judged.overlaps.push((x, y));
                }
            }
        }
        judged.tests = verdicts.len();
        if !verdicts.contains(&true) {
            return judged;
        }
        if !blocked && !verdicts.contains(&false) {
            judged.free = members.to_vec();
            return judged;
        }
        // All cells should be free or blocked, and blocked if one is: rounding is too large, or features are closer than the resolution.
        judged.conflict = true;
        judged.tests += open.len();
        let free = open.iter().map(|o| o.1);
        judged.free = free
            .filter(|&i| self.tests_free(&cells[i as usize]))
            .collect();
        judged
    }

    /// Extent of a cell.
    fn size(&self, c: &Cell) -> f64 {
        let p = &self.graphs.pieces[c.piece as usize];
        if p.vertical {
            c.to - c.from
        } else {
            (c.to - c.from)
                .max((p.y(self.graphs.pairs, c.to) - p.y(self.graphs.pairs, c.from)).abs())
        }
    }

    /// A configuration beside the middle of a cell, half way to the next curve on its free side, and its distance.
    fn beside(&self, c: &Cell) -> Option<(f64, f64, f64)> {
        let p = &self.graphs.pieces[c.piece as usize];
        let middle = 0.5 * (c.from + c.to);
        let free_up = p.root == 0;
        if p.vertical {
            return self.beside_steep(c, p.start.x, middle, free_up);
        }
        let (at_from, at_to) = (p.y(self.graphs.pairs, c.from), p.y(self.graphs.pairs, c.to));
        let y = p.y(self.graphs.pairs, middle);
        if (at_to - at_from).abs() > STEEP * (c.to - c.from) {
            let level = 0.5 * (at_from + at_to);
            let x = crossing_of_level(p, self.graphs.pairs, p.x_range(), level);
            let rising = at_to > at_from;
            return self.beside_steep(c, x, level, free_up != rising);
        }
        // Up or down to the next curve at this x.
        let sign = if free_up { 1.0 } else { -1.0 };
        let mut reach = STEP;
        for j in self.by_x.between(middle, middle) {
            let q = &self.graphs.pieces[j as usize];
            if j == c.piece || q.vertical || !(q.start.x..=q.end.x).contains(&middle) {
                continue;
            }
            let ahead = |to: f64| {
                let d = sign * (to - y);
                if self.graphs.y.is_circle() {
                    d - TAU * (d / TAU).floor()
                } else {
                    d
                }
            };
            // A piece is not within reach if both ends of its box are beyond, the nearer one first.
            let (lo, hi) = q.y_range();
            let (near, far) = if free_up { (lo, hi) } else { (hi, lo) };
            let to_near = ahead(near);
            if to_near > reach
                && (!self.graphs.y.is_circle() || ahead(far) >= to_near && hi - lo < TAU)
            {
                continue;
            }
            let d = ahead(q.y(self.graphs.pairs, middle));
            // A curve that coincides with this piece and faces the same way does not end the free side.
            if d > 0.0 && !(d < COINCIDENT && q.root == p.root) {
                reach = reach.min(d);
            }
        }
        if !self.graphs.y.is_circle() {
            reach = reach.min(if free_up {
                self.graphs.y.hi - y
            } else {
                y - self.graphs.y.lo
            });
        }
        (reach > COINCIDENT).then_some((middle, y + 0.5 * sign * reach, reach))
    }

    /// Left or right to the next curve at this y.
    fn beside_steep(&self, c: &Cell, x: f64, y: f64, right: bool) -> Option<(f64, f64, f64)> {
        let sign = if right { 1.0 } else { -1.0 };
        // Not beyond the end of the window.
        let end = if right { self.x.hi - x } else { x - self.x.lo };
        let mut reach = STEP.min(end);
        let (a, b) = (x.min(x + sign * STEP), x.max(x + sign * STEP));
        for j in self.by_x.between(a, b) {
            let q = &self.graphs.pieces[j as usize];
            if j == c.piece || q.end.x < a || q.start.x > b {
                continue;
            }
            let (lo, hi) = q.y_range();
            let shift = if self.graphs.y.is_circle() {
                TAU * ((lo - y) / TAU).ceil()
            } else {
                0.0
            };
            let level = y + shift;
            if level < lo || level > hi {
                continue;
            }
            let Some(d) = self.ahead_at_level(q, level, x, sign, reach) else {
                continue;
            };
            let q_right = if q.vertical {
                q.root == 0
            } else {
                (q.root == 0) != (q.start.y() < q.end.y())
            };
            if d > 0.0 && !(d < COINCIDENT && q_right == right) {
                reach = reach.min(d);
            }
        }
        (reach > COINCIDENT).then_some((x + 0.5 * sign * reach, y, reach))
    }

    /// Distance from x, at most `reach`, at which a piece comes to a level. It is used for the middle of the free interval, so an accuracy
    /// of a thousandth is enough.
    fn ahead_at_level(&self, q: &Piece, level: f64, x: f64, sign: f64, reach: f64) -> Option<f64> {
        if q.vertical {
            let d = sign * (q.start.x - x);
            return (d > 0.0).then_some(d);
        }
        // The part of the piece that lies ahead and within reach.
        let ahead = |at: f64| sign * (at - x);
        let (near, far) = if sign > 0.0 {
            (q.start.x, q.end.x)
        } else {
            (q.end.x, q.start.x)
        };
        let (mut near, mut far) = (ahead(near).max(0.0), ahead(far).min(reach));
        if near > far {
            return None;
        }
        let above = |d: f64| q.y(self.graphs.pairs, x + sign * d) > level;
        let begins = above(near);
        if above(far) == begins {
            return None;
        }
        while far - near > 1e-3 * near && far > COINCIDENT {
            let middle = 0.5 * (near + far);
            if above(middle) == begins {
                near = middle;
            } else {
                far = middle;
            }
        }
        Some(if near > 0.0 { near } else { far })
    }
}
