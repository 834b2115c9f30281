//! Computes the contents of the cells of each interval of orientations.

use core::f64::consts::TAU;

use crate::geometry::{Point, Rotation};
use crate::query::swept::Orientations;
use crate::space::ContactSpace;

use super::board::Board;
use super::cells::CellStore;
use super::grid::{Grid, MARGIN};
use super::raster::cells_of;
use super::ray::AxisDirection;
use super::walk;

/// A patch and the orientations, by its own count of turns, at which it may exist in an interval.
#[derive(Debug, Clone, Copy)]
pub(super) struct Presence {
    patch: u32,
    lo: f64,
    hi: f64,
    /// Whether these are all orientations of the interval.
    all: bool,
}

/// For every interval, the patches that exist in it, extended by the margin.
pub(super) fn presences(space: &ContactSpace, grid: &Grid) -> Vec<Vec<Presence>> {
    let mut all = vec![Vec::new(); grid.slots];
    let turns: &[f64] = if space.window().full_turn {
        &[-TAU, 0.0, TAU]
    } else {
        &[0.0]
    };
    for (i, patch) in (0u32..).zip(space.patches()) {
        for &turn in turns {
            for slot in grid.slots_between(patch.lo + turn - MARGIN, patch.hi + turn + MARGIN) {
                let (lo, hi) = grid.wider(slot);
                let (lo, hi) = (lo - turn, hi - turn);
                let presence = Presence {
                    patch: i,
                    lo: patch.lo.max(lo),
                    hi: patch.hi.min(hi),
                    all: patch.lo <= lo && hi <= patch.hi,
                };
                if presence.lo <= presence.hi {
                    all[slot].push(presence);
                }
            }
        }
    }
    all
}

/// Computes the contents of the cells of consecutive intervals, given the number of the first.
pub(super) fn cells(
    space: &ContactSpace,
    grid: &Grid,
    first: usize,
    slots: &[Vec<Presence>],
) -> CellStore {
    let mut board = Board::new(grid.side);
    let mut store = CellStore::default();
    for (slot, presences) in (first..).zip(slots) {
        let (lo, hi) = grid.wider(slot);
        let whole = Orientations::between(lo, hi);
        for p in presences {
            let patch = &space.patches()[p.patch as usize];
            let part = if p.all {
                whole
            } else {
                Orientations::between(p.lo, p.hi)
            };
            cells_of(grid, patch, &part, &mut |cell, number| {
                (cell..cell + number).for_each(|cell| board.mark(cell, p.patch));
            });
        }
        board.list(store.lists());
        board.fill(|board, column, row| is_free(space, grid, slot, (column, row), (board, &store)));
        board.pack(&mut store);
    }
    store
}

/// Whether a cell without patches is free, when all cells to the right of it are known.
fn is_free(
    space: &ContactSpace,
    grid: &Grid,
    slot: usize,
    (column, row): (usize, usize),
    (board, store): (&Board, &CellStore),
) -> bool {
    let (lo, hi) = grid.orientations(slot);
    let content = |column, row| board.content(store, column, row);
    // The cell's own content is not known yet: the ray begins at its right edge. Any height and orientation can be used.
    const SHARES: [(f64, f64); 4] = [(0.53, 0.51), (0.27, 0.73), (0.81, 0.34), (0.13, 0.17)];
    let mut place = (Point::ORIGIN, Rotation::by(lo), lo);
    for (height, share) in SHARES {
        let theta = lo + (hi - lo) * share;
        let p = Point::new(grid.line(column + 1), grid.line(row) + height * grid.cell);
        let turn = Rotation::by(theta);
        place = (p, turn, theta);
        let start = (column + 1, row);
        let place = (p, theta, turn);
        let found = walk::from_cell(space, grid, start, place, AxisDirection::Right, content);
        if let Some(free) = found {
            return free;
        }
    }
    let (p, turn, theta) = place;
    let frame = &space.data().frame;
    let turned = turn * frame.moving_center.to_vector();
    let at = frame.fixed_center + (p.to_vector() * (1.0 / frame.scale) - turned);
    space.slice(theta).is_free(at)
}
