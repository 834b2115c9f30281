//! The cells of one interval of orientations while they are computed.
//!
//! First the patches that reach a cell are marked in it; then the cells without patches are classified as free or blocked; then the result
//! is packed, and the board is cleared for the next interval.

use super::cells::{CellStore, Entry};
use super::grid::TILE;
use super::walk::Content;

/// No patch.
const NONE: u32 = u32::MAX;

/// A square grid of cells.
#[derive(Debug)]
pub(super) struct Board {
    side: usize,
    /// For every cell, the index of its last mark.
    last: Vec<u32>,
    /// Marks: a patch, and the index of the previous mark in the same cell.
    marks: Vec<(u32, u32)>,
    /// Bit set of the cells that have patches: by rows, eight columns per byte.
    mixed: Vec<u8>,
    /// Bit set of the cells without patches that are free.
    free: Vec<u8>,
    /// Contents of the cells that have patches.
    entries: Vec<Entry>,
}

impl Board {
    pub(super) fn new(side: usize) -> Self {
        Self {
            side,
            last: vec![NONE; side * side],
            marks: Vec::new(),
            mixed: vec![0; side * side / 8],
            free: vec![0; side * side / 8],
            entries: vec![Entry::UNKNOWN; side * side],
        }
    }

    /// Marks that a patch reaches a cell; all marks of one patch must come in a row.
    #[inline]
    pub(super) fn mark(&mut self, cell: usize, patch: u32) {
        let last = self.last[cell];
        if last != NONE && self.marks[last as usize].0 == patch {
            return;
        }
        self.last[cell] = self.marks.len() as u32;
        self.marks.push((patch, last));
        self.mixed[cell / 8] |= 1 << (cell % 8);
    }

    /// Makes lists of patches from the marks. Consecutive cells share a list if they have the same patches.
    pub(super) fn list(&mut self, lists: &mut Vec<u32>) {
        let (mut before, mut here) = (Vec::new(), Vec::new());
        let mut entry = Entry::UNKNOWN;
        for (byte, &bits) in self.mixed.iter().enumerate() {
            for bit in ones(u64::from(bits)) {
                let cell = 8 * byte + bit;
                here.clear();
                let mut at = core::mem::replace(&mut self.last[cell], NONE);
                while at != NONE {
                    let (patch, next) = self.marks[at as usize];
                    here.push(patch);
                    at = next;
                }
                if here != before {
                    entry = Entry::listed(&here, lists);
                    core::mem::swap(&mut here, &mut before);
                }
                self.entries[cell] = entry;
            }
        }
        self.marks.clear();
    }

    /// Classifies the cells without patches as free or blocked.
    ///
    /// Everything right of the square is free. Adjacent cells without patches have the same class, so a run of them takes the class of a
    /// cell without patches above it; if there is none, `is_free` classifies the last cell of the run from its right neighbour.
    pub(super) fn fill(&mut self, is_free: impl Fn(&Self, usize, usize) -> bool) {
        for row in 0..self.side {
            let mut end = self.side;
            while let Some(last) = self.last_in(row, end, false) {
                let first = self.last_in(row, last, true).map_or(0, |c| c + 1);
                let free = if last + 1 == self.side {
                    true
                } else if let Some(above) = self.last_above(row, first, last) {
                    bit(&self.free, (row - 1) * self.side + above)
                } else {
                    is_free(self, last, row)
                };
                if free {
                    set(
                        &mut self.free,
                        row * self.side + first,
                        row * self.side + last,
                    );
                }
                end = first;
            }
        }
    }

    /// The last cell of a row, before column `end`, that has patches, or has none.
    fn last_in(&self, row: usize, end: usize, mixed: bool) -> Option<usize> {
        let bytes = &self.mixed[row * self.side / 8..][..self.side / 8];
        let wanted = |byte: usize| if mixed { bytes[byte] } else { !bytes[byte] };
        let mut byte = end / 8;
        let mut bits = if byte < bytes.len() {
            wanted(byte) & !(u8::MAX << (end % 8))
        } else {
            0
        };
        while bits == 0 {
            byte = byte.checked_sub(1)?;
            bits = wanted(byte);
        }
        Some(8 * byte + 7 - bits.leading_zeros() as usize)
    }

    /// A cell without patches in the row above, over the given cells of a row.
    fn last_above(&self, row: usize, first: usize, last: usize) -> Option<usize> {
        let above = self.last_in(row.checked_sub(1)?, last + 1, false)?;
        (above >= first).then_some(above)
    }

    /// Content of a cell. For a cell without patches it is valid only as far as [`fill`](Self::fill) has got.
    pub(super) fn content<'a>(
        &'a self,
        lists: &'a CellStore,
        column: usize,
        row: usize,
    ) -> Content<'a> {
        let cell = row * self.side + column;
        if bit(&self.mixed, cell) {
            Content::Mixed(lists.patches(&self.entries[cell]))
        } else {
            Content::Pure {
                free: bit(&self.free, cell),
            }
        }
    }

    /// Appends all cells to the packed ones, and clears the grid.
    pub(super) fn pack(&mut self, store: &mut CellStore) {
        let width = self.side / TILE;
        for ty in 0..width {
            for tx in 0..width {
                let gather = |bytes: &[u8]| {
                    let rows = bytes[ty * TILE * width + tx..].iter().step_by(width);
                    let shifted = rows.zip(0..TILE).map(|(&b, row)| u64::from(b) << (8 * row));
                    shifted.sum::<u64>()
                };
                let mixed = gather(&self.mixed);
                let cell =
                    |bit: usize| (ty * TILE + bit / TILE) * self.side + tx * TILE + bit % TILE;
                let entries = ones(mixed).map(|bit| self.entries[cell(bit)]);
                store.add(mixed, gather(&self.free), entries);
            }
        }
        self.mixed.fill(0);
        self.free.fill(0);
    }
}

/// Positions of the set bits of a number, from the lowest.
fn ones(mut bits: u64) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let bit = (bits != 0).then_some(bits.trailing_zeros() as usize);
        bits &= bits.wrapping_sub(1);
        bit
    })
}

fn bit(bytes: &[u8], place: usize) -> bool {
    bytes[place / 8] >> (place % 8) & 1 == 1
}

/// Sets the bits from `first` to `last`, both included.
fn set(bytes: &mut [u8], first: usize, last: usize) {
    let (from, to) = (u8::MAX << (first % 8), u8::MAX >> (7 - last % 8));
    let bytes = &mut bytes[first / 8..=last / 8];
    if let [one] = bytes {
        *one |= from & to;
    } else if let [begin, middle @ .., end] = bytes {
        *begin |= from;
        middle.fill(u8::MAX);
        *end |= to;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: usize = 24;

    /// A ring of patches: cells inside are blocked, cells outside are free, and one ray decides for all cells inside.
    #[test]
    fn what_a_ring_separates() {
        let mut board = Board::new(SIDE);
        let ring = |column: usize, row: usize| {
            let (x, y) = (column.abs_diff(11), row.abs_diff(12));
            x.max(y) == 6
        };
        let mut store = CellStore::default();
        for slot in 0..2 {
            for row in 0..SIDE {
                for column in 0..SIDE {
                    if ring(column, row) {
                        for patch in [7, 7, 3 + slot] {
                            board.mark(row * SIDE + column, patch);
                        }
                    }
                }
            }
            board.list(store.lists());
            let asked = core::cell::Cell::new(0);
            board.fill(|_, column, row| {
                asked.set(asked.get() + 1);
                column.abs_diff(11).max(row.abs_diff(12)) > 6
            });
            // One query inside the ring; left of it, the row above decides.
            assert_eq!(asked.get(), 1);
            board.pack(&mut store);
        }
        store.finish(SIDE);
        for slot in 0..2 {
            for row in 0..SIDE {
                for column in 0..SIDE {
                    let inside = column.abs_diff(11).max(row.abs_diff(12)) < 6;
                    match store.content(SIDE, slot, column, row) {
                        Content::Mixed(patches) => {
                            assert!(ring(column, row));
                            assert_eq!(patches, [3 + slot as u32, 7]);
                        }
                        Content::Pure { free } => {
                            assert!(!ring(column, row));
                            assert_eq!(free, !inside, "{column} {row}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn bits_between_two() {
        for (first, last) in [(0, 0), (3, 5), (7, 8), (0, 23), (5, 20), (16, 23)] {
            let mut bytes = [0; 3];
            set(&mut bytes, first, last);
            for place in 0..24 {
                assert_eq!(bit(&bytes, place), (first..=last).contains(&place));
            }
        }
        assert!(ones(0b1010_0001).eq([0, 5, 7]));
    }
}
