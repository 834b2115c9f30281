//! The cells of one slot of orientations, found and packed.

use core::f64::consts::TAU;

use crate::geometry::{Point, Rotation};
use crate::space::ContactSpace;

use super::cells::{CellStore, Entry, PURE_BLOCKED, PURE_FREE};
use super::grid::{Grid, MARGIN};
use super::raster::cells_of;
use super::ray::Direction;
use super::walk::{self, Content};

/// A patch and the orientations, by its own count of turns, at which it may be met in a slot.
#[derive(Debug, Clone, Copy)]
pub(super) struct Presence {
    pub(super) patch: u32,
    lo: f64,
    hi: f64,
}

/// For every slot the patches that exist in it, or nearly.
pub(super) fn presences(space: &ContactSpace, grid: &Grid) -> Vec<Vec<Presence>> {
    let mut all = vec![Vec::new(); grid.slots];
    let turns: &[f64] = if space.data.window.full_turn {
        &[-TAU, 0.0, TAU]
    } else {
        &[0.0]
    };
    for (i, patch) in (0u32..).zip(&space.data.patches) {
        for &turn in turns {
            for slot in grid.slots_between(patch.lo + turn - MARGIN, patch.hi + turn + MARGIN) {
                let (lo, hi) = grid.orientations(slot);
                all[slot].push(Presence {
                    patch: i,
                    lo: patch.lo.max(lo - turn - MARGIN),
                    hi: patch.hi.min(hi - turn + MARGIN),
                });
            }
        }
    }
    all
}

/// Finds what is in the cells of a slot.
pub(super) fn cells(
    space: &ContactSpace,
    grid: &Grid,
    slot: usize,
    presences: &[Presence],
) -> CellStore {
    let mut passed: Vec<(u32, u32)> = Vec::new();
    for p in presences.iter().filter(|p| p.lo <= p.hi) {
        let patch = &space.data.patches[p.patch as usize];
        cells_of(grid, patch, (p.lo, p.hi), &mut |cell| {
            passed.push((cell as u32, p.patch));
        });
    }
    passed.sort_unstable();
    passed.dedup();
    let mut lists = Vec::new();
    let mut cells = vec![PURE_FREE; grid.side * grid.side];
    let mut last: Option<(Entry, &[(u32, u32)])> = None;
    for chunk in passed.chunk_by(|a, b| a.0 == b.0) {
        let same = |other: &[(u32, u32)]| other.iter().map(|c| c.1).eq(chunk.iter().map(|c| c.1));
        let entry = match last {
            Some((entry, other)) if same(other) => entry,
            _ => Entry::listed(chunk.iter().map(|c| c.1), &mut lists),
        };
        last = Some((entry, chunk));
        cells[chunk[0].0 as usize] = entry;
    }
    sort_pure(space, grid, slot, &mut cells, &lists, &passed);
    CellStore::packed(grid.side, &cells, lists)
}

/// Tells the pure cells that are blocked from those that are free, from right to left: what is right of the square is
/// free, and beyond mixed cells one position tells.
fn sort_pure(
    space: &ContactSpace,
    grid: &Grid,
    slot: usize,
    cells: &mut [Entry],
    lists: &[u32],
    passed: &[(u32, u32)],
) {
    let side = grid.side;
    let rows = passed.iter().map(|c| c.0 as usize / side);
    let mut done = usize::MAX;
    for row in rows {
        if row == done {
            continue;
        }
        done = row;
        for column in (0..side - 1).rev() {
            let at = row * side + column;
            if !cells[at].is_pure() {
                continue;
            }
            let right = cells[at + 1];
            cells[at] = if right.is_pure() {
                right
            } else if is_free(space, grid, slot, (column, row), cells, lists) {
                PURE_FREE
            } else {
                PURE_BLOCKED
            };
        }
    }
}

/// Whether a pure cell is free, when all to the right of it is known.
fn is_free(
    space: &ContactSpace,
    grid: &Grid,
    slot: usize,
    (column, row): (usize, usize),
    cells: &[Entry],
    lists: &[u32],
) -> bool {
    let (lo, hi) = grid.orientations(slot);
    let content = |column: usize, row: usize| {
        let entry = &cells[row * grid.side + column];
        match *entry {
            PURE_FREE => Content::Pure { free: true },
            PURE_BLOCKED => Content::Pure { free: false },
            _ => Content::Mixed(entry.patches(lists)),
        }
    };
    // The cell's own content is not known yet: the way begins at its right edge. Any height and orientation does.
    const SHARES: [(f64, f64); 4] = [(0.53, 0.51), (0.27, 0.73), (0.81, 0.34), (0.13, 0.17)];
    let mut place = (Point::ORIGIN, lo);
    for (height, share) in SHARES {
        let theta = lo + (hi - lo) * share;
        let p = Point::new(grid.line(column + 1), grid.line(row) + height * grid.cell);
        place = (p, theta);
        let turn = Rotation::by(theta);
        let start = (column + 1, row);
        let found = walk::from_cell(
            space,
            grid,
            start,
            (p, theta, turn),
            Direction::Right,
            content,
        );
        if let Some(free) = found {
            return free;
        }
    }
    let at = space
        .data
        .frame
        .outer_from_inner(place.0, place.1)
        .position();
    space.slice(place.1).is_free(at)
}
