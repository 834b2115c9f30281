//! A grid over orientations and positions.

use core::ops::Range;

use crate::ids::PatchId;
use crate::space::ContactSpace;

use super::slab::Slab;

/// Side of a tile of cells.
pub(super) const TILE: usize = 8;

/// Approximate number of mixed cells per patch, of some ten bytes each.
const CELLS_PER_PATCH: f64 = 32.0;
/// Minimum number of mixed cells of a space, or of one period of a symmetric one, so that small spaces are fast as well.
const LEAST_CELLS: f64 = 16384.0;
/// Upper bound of all cells, as a multiple of the mixed ones: each takes one bit of a tile's masks, so they are bounded as well.
const ALL_CELLS: f64 = 32.0;
/// Maximum number of intervals of orientation: each costs some time and memory of its own.
const MOST_SLOTS: f64 = 4096.0;
/// Maximum number of columns, and of rows, of an interval, for the same reason.
const MOST_COLUMNS: f64 = 2048.0;

/// A patch is entered in all cells that it comes within this distance of (length of the pair's frame, about 1e-9): above the contact
/// resolution, and above all rounding, unless parts are drawn very far from their origins. Intervals of orientation are longer by as much
/// (radians), because orientations are rounded when they are reduced by whole turns.
pub(super) const MARGIN: f64 = 1.0 / (1u64 << 30) as f64;

/// Intervals of orientation, each with the same square of square cells about the origin of the pair's frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Grid {
    /// First orientation, radians.
    lo: f64,
    pub(super) slots: usize,
    /// Intervals per radian.
    slot_density: f64,
    /// Number of cells in a row, and in a column; a multiple of [`TILE`].
    pub(super) side: usize,
    /// Half the side of the square (length).
    reach: f64,
    /// Side of a cell (length).
    pub(super) cell: f64,
    cell_density: f64,
    /// Distance from a patch within which cells list it (length).
    pub(super) margin: f64,
}

impl Grid {
    /// A grid for one period; `reach` is the distance from the origin within which there may be contact.
    ///
    /// In a slice, curves of length A pass about 2 A / h cells of side h; a radian moves them by about one unit of length, so intervals of
    /// orientation are h radians long. So there are M mixed cells if h = √(2 ∫ A dθ / M). Each orbit of patches passes the period once.
    pub(super) fn new(space: &ContactSpace, slab: &Slab, reach: f64) -> Self {
        let (lo, span) = (slab.lo, slab.hi - slab.lo);
        let scale = space.data().frame.scale;
        let area: f64 = (slab.representatives(space))
            .filter_map(|(i, p)| {
                let curve = space.curve_at(PatchId(i), 0.5 * (p.lo + p.hi))?;
                Some(curve.length() * scale * (p.hi - p.lo))
            })
            .sum();
        let patches = space.patches().len() as f64 / f64::from(slab.count);
        let wanted = (CELLS_PER_PATCH * patches).max(LEAST_CELLS);
        let by_contact = (2.0 * area / wanted).sqrt();
        let by_volume = (span * 4.0 * reach * reach / (ALL_CELLS * wanted)).cbrt();
        let cell = by_contact.max(by_volume);
        let count = |length: f64, most: f64| (length / cell).ceil().clamp(1.0, most);
        let slots = count(span, MOST_SLOTS);
        let side = count(2.0 * reach, MOST_COLUMNS) as usize;
        let side = side.next_multiple_of(TILE);
        let cell = 2.0 * reach / side as f64;
        Self {
            lo,
            slots: slots as usize,
            slot_density: slots / span,
            side,
            reach,
            cell,
            cell_density: 1.0 / cell,
            margin: MARGIN.max(2.0 * space.data.frame.rounding()),
        }
    }

    /// The interval of an orientation, which is given relative to the beginning of the period.
    #[inline]
    pub(super) fn slot(&self, from_lo: f64) -> usize {
        ((from_lo * self.slot_density) as usize).min(self.slots - 1)
    }

    /// The intervals that overlap the orientations from `lo` to `hi`.
    pub(super) fn slots_between(&self, lo: f64, hi: f64) -> Range<usize> {
        let at = |t: f64| (t - self.lo) * self.slot_density;
        let first = at(lo).floor().max(0.0) as usize;
        let last = at(hi).floor();
        if last < 0.0 {
            0..0
        } else {
            first..(last as usize + 1).min(self.slots)
        }
    }

    /// The orientations of an interval.
    pub(super) fn orientations(&self, slot: usize) -> (f64, f64) {
        let at = |i: usize| self.lo + i as f64 / self.slot_density;
        (at(slot), at(slot + 1))
    }

    /// The orientations of an interval, extended by the margin.
    pub(super) fn wider(&self, slot: usize) -> (f64, f64) {
        let (lo, hi) = self.orientations(slot);
        (lo - MARGIN, hi + MARGIN)
    }

    /// The middle of an interval, relative to the beginning of the period, radians.
    #[inline]
    pub(super) fn middle(&self, slot: usize) -> f64 {
        (slot as f64 + 0.5) / self.slot_density
    }

    /// A coordinate in units of cells, from the edge of the square.
    #[inline]
    pub(super) fn in_cells(&self, coordinate: f64) -> f64 {
        (coordinate + self.reach) * self.cell_density
    }

    /// Coordinate of a line between cells.
    #[inline]
    pub(super) fn line(&self, index: usize) -> f64 {
        index as f64 * self.cell - self.reach
    }

    /// Column or row of a coordinate, if it is in the square.
    #[inline]
    pub(super) fn index(&self, coordinate: f64) -> Option<usize> {
        let at = self.in_cells(coordinate);
        (at >= 0.0 && at < self.side as f64).then_some(at as usize)
    }
}
