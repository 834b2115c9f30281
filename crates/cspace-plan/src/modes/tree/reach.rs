//! Ranges of the cells of a tree, a configuration in each, and the cell that holds a configuration.

use core::f64::consts::TAU;

use crate::modes::plane::{Plane, turns_onto};
use crate::modes::tree::branch::{Branch, Instance, Piece};
use crate::modes::tree::turning::{Turning, Whole};
use crate::modes::turns::plus;

/// A configuration of a cell, with the smallest of its intervals as a share of what there is of the coordinate.
pub(crate) struct Sample {
    pub(crate) at: Vec<f64>,
    pub(crate) room: f64,
}

/// The part of an interval of y that a cell of a child is in, as the cell counts its turns.
fn within(child: &Branch, instance: &Instance, y: Option<(f64, f64)>) -> (f64, f64) {
    let slab = child.slab_of(instance.cell);
    let by = TAU * f64::from(instance.turns);
    y.map_or((slab.lo, slab.hi), |(lo, hi)| {
        (slab.lo.max(lo - by), slab.hi.min(hi - by))
    })
}

impl Branch {
    /// Extends the ranges of the coordinates of this part and of those on it by what a cell, moved by some turns, has over an interval.
    /// Ends of gaps are monotone, so what they reach over an interval is between what they are at its ends.
    pub(crate) fn reach(
        &self,
        cell: usize,
        (lo, hi): (f64, f64),
        (at, turning): (&Whole, &Turning),
        ranges: &mut [(f64, f64)],
    ) {
        let slab = self.slab_of(cell);
        let (lo, hi) = (lo.max(slab.lo), hi.min(slab.hi));
        let by = turning.angle(self.coordinate, at);
        let range = &mut ranges[self.coordinate];
        *range = (range.0.min(lo + by), range.1.max(hi + by));
        for ((plane, child), piece) in self.children.iter().zip(slab.pieces_of(cell)) {
            let hull = plane.span(piece.gap).map(|span| span.hull((lo, hi)));
            for instance in &piece.cells {
                let y = within(child, instance, hull);
                if y.0 < y.1 {
                    let at = plus(*at, instance.at);
                    child.reach(instance.cell, y, (&at, turning), ranges);
                }
            }
        }
    }

    /// A configuration of a cell, moved by some turns, in the middle of all intervals.
    pub(crate) fn sample(&self, cell: usize, at: &Whole, turning: &Turning, n: usize) -> Sample {
        let slab = self.slab_of(cell);
        let mut sample = Sample {
            at: vec![0.0; n],
            room: (slab.hi - slab.lo) / (self.x.hi - self.x.lo),
        };
        self.fill(cell, 0.5 * (slab.lo + slab.hi), (at, turning), &mut sample);
        sample
    }

    fn fill(&self, cell: usize, x: f64, (at, turning): (&Whole, &Turning), sample: &mut Sample) {
        sample.at[self.coordinate] = x + turning.angle(self.coordinate, at);
        let pieces = self.slab_of(cell).pieces_of(cell);
        for ((plane, child), piece) in self.children.iter().zip(pieces) {
            let y = plane.span(piece.gap).map(|span| span.at(x));
            let width = |(lo, hi): (f64, f64)| hi - lo;
            let all = piece.cells.iter().map(|c| (c, within(child, c, y)));
            let widest = all.max_by(|a, b| width(a.1).total_cmp(&width(b.1)));
            if let Some((instance, y)) = widest {
                sample.room = sample.room.min(width(y) / width((child.x.lo, child.x.hi)));
                let at = plus(*at, instance.at);
                child.fill(instance.cell, 0.5 * (y.0 + y.1), (&at, turning), sample);
            }
        }
    }

    /// The cells that hold a configuration: one, or one on each side of where slabs meet.
    pub(crate) fn cells_at(&self, at: &[f64]) -> Vec<usize> {
        let (t, e) = (at[self.coordinate], &self.x);
        let x = match e.circle {
            true => t - TAU * ((t - e.lo) / TAU).floor(),
            // Beyond the window of an open coordinate all goes on.
            false => t.clamp(e.lo, e.hi),
        };
        let below: Vec<Vec<usize>> = (self.children.iter())
            .map(|(_, child)| child.cells_at(at))
            .collect();
        let after = self.slabs.partition_point(|slab| slab.hi < x);
        let near = after.saturating_sub(1)..(after + 1).min(self.slabs.len());
        let mut cells = Vec::new();
        for slab in self.slabs[near].iter().rev() {
            // In a slab, or between two of them.
            let is_near = slab.lo - e.narrowest <= x && x <= slab.hi + e.narrowest;
            let of: Option<Vec<usize>> = (self.children.iter().enumerate())
                .map(|(k, (plane, child))| {
                    let (x, y) = (x.clamp(slab.lo, slab.hi), at[child.coordinate]);
                    let held = |piece: &Piece| child.holds(plane, piece, (x, y), &below[k]);
                    slab.pieces[k].iter().position(held)
                })
                .collect();
            if let (true, Some(of)) = (is_near, of) {
                cells.push(slab.cell(&of));
            }
        }
        cells
    }

    /// Whether a piece has one of some cells of this child where y, with x, is in its gap.
    fn holds(&self, plane: &Plane, piece: &Piece, (x, y): (f64, f64), cells: &[usize]) -> bool {
        let e = &self.x;
        let y = match e.circle {
            true => y - TAU * ((y - e.lo) / TAU).floor(),
            false => y.clamp(e.lo, e.hi),
        };
        let Some(gap) = plane.span(piece.gap).map(|span| span.at(x)) else {
            return piece.cells.iter().any(|c| cells.contains(&c.cell));
        };
        turns_onto(e.circle, (y, y), gap).any(|turns| {
            let y = y + TAU * f64::from(turns);
            let is = |c: &Instance| c.turns == turns && cells.contains(&c.cell);
            gap.0 <= y && y <= gap.1 && piece.cells.iter().any(is)
        })
    }
}
