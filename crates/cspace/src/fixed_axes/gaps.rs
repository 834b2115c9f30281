//! The free gaps of y at every x, between cells of the free boundary, and which of them holds a configuration.

use core::f64::consts::TAU;

use super::arrange::Cell;
use super::condition::Condition;
use super::domain::{Extent, brought_between};
use super::piece::{Pair, Piece};

/// A free interval of y over a band.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Gap {
    /// The cell below it, or none at a limit of y, and where nothing touches.
    pub(super) lower: Option<u32>,
    /// The cell above it.
    pub(super) upper: Option<u32>,
    /// Turns to add to y of the lower and of the upper cell: the lower end is in the first turn at the band's middle.
    pub(super) turns: (i32, i32),
    pub(super) region: u32,
}

/// An interval of x in which the order of the free boundary's cells does not change.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Band {
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// Indices of its gaps, from the lowest.
    pub(super) gaps: core::ops::Range<u32>,
}

/// Cells as functions of x.
#[derive(Clone, Copy)]
pub(super) struct Graphs<'a> {
    pub(super) pairs: &'a [Pair],
    pub(super) pieces: &'a [Piece],
    pub(super) cells: &'a [Cell],
    pub(super) y: Extent,
}

impl<'a> Graphs<'a> {
    /// A cell, and the piece it is of.
    pub(super) fn cell(&self, cell: u32) -> (&'a Cell, &'a Piece) {
        let c = &self.cells[cell as usize];
        (c, &self.pieces[c.piece as usize])
    }

    pub(super) fn piece(&self, cell: u32) -> &'a Piece {
        self.cell(cell).1
    }

    pub(super) fn condition(&self, cell: u32) -> &'a Condition {
        &self.pairs[self.piece(cell).pair as usize].condition
    }

    /// Where a cell is along x and along y.
    pub(super) fn cell_box(&self, cell: u32) -> ((f64, f64), (f64, f64)) {
        let (c, p) = self.cell(cell);
        if p.vertical {
            return ((p.start.x, p.start.x), (c.from, c.to));
        }
        let (a, b) = (p.y(self.pairs, c.from), p.y(self.pairs, c.to));
        ((c.from, c.to), (a.min(b), a.max(b)))
    }

    /// y of a cell at an x within it, or just beyond.
    pub(super) fn at(&self, cell: u32, x: f64) -> f64 {
        let c = &self.cells[cell as usize];
        self.piece(cell)
            .y(self.pairs, brought_between(x, c.from, c.to))
    }

    /// From and to of a gap at x of its band; in the band's middle the lower end is in the first turn.
    pub(super) fn interval(&self, gap: &Gap, x: f64) -> (f64, f64) {
        let end = |cell: Option<u32>, turns: i32, limit: f64| {
            cell.map_or(limit, |i| self.at(i, x) + TAU * f64::from(turns))
        };
        let from = end(gap.lower, gap.turns.0, self.y.lo);
        let to = end(gap.upper, gap.turns.1, self.y.hi);
        (from, to.max(from))
    }
}

/// The free gaps of all bands.
#[derive(Clone, Copy)]
pub(super) struct Gaps<'a> {
    pub(super) graphs: Graphs<'a>,
    pub(super) bands: &'a [Band],
    pub(super) gaps: &'a [Gap],
    pub(super) x: Extent,
}

impl Gaps<'_> {
    /// Whether a configuration is in a free gap, or beyond what is computed, where nothing touches.
    pub(super) fn hold(&self, x: f64, y: f64) -> bool {
        self.is_beyond(x, y) || self.region(x, y).is_some()
    }

    fn is_beyond(&self, x: f64, y: f64) -> bool {
        let within = |t: f64, e: &Extent| (e.lo..=e.hi).contains(&t);
        let y_range = &self.graphs.y;
        !(y_range.is_circle() || within(x, &self.x) && within(y, y_range))
    }

    /// The region of the free gap that holds a configuration.
    pub(super) fn region(&self, x: f64, y: f64) -> Option<u32> {
        if self.is_beyond(x, y) {
            return None;
        }
        let band = self.bands.partition_point(|b| b.hi < x);
        self.region_in(self.bands.get(band).or(self.bands.last())?, x, y)
    }

    /// The region of the free gap of a band that holds a configuration.
    pub(super) fn region_in(&self, band: &Band, x: f64, y: f64) -> Option<u32> {
        let gaps = &self.gaps[band.gaps.start as usize..band.gaps.end as usize];
        let held = gaps.iter().find(|gap| {
            let (from, to) = self.graphs.interval(gap, x);
            if self.graphs.y.is_circle() {
                y + TAU * ((from - y) / TAU).ceil() <= to
            } else {
                (from..=to).contains(&y)
            }
        })?;
        Some(held.region)
    }
}
