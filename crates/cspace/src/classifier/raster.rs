//! Cells that a patch may reach over an interval of orientations.

use crate::geometry::{Point, Rotation, Vector};
use crate::part::Edge;
use crate::query::swept::{Orientations, Swept};
use crate::slice::CurveGeometry;
use crate::space::Patch;

use super::grid::Grid;

/// Displacement up to which moving curves are represented by one, in cells.
const LOOSE: f64 = 0.5;
/// Admissible excess length of that one at its ends, in cells.
const LOOSE_ENDS: f64 = 1.0;
/// Maximum number of pieces into which an interval is divided at a time: the bounds of its speeds are too wide for more.
const MOST_PIECES: f64 = 8.0;
/// Maximum number of times that an interval is halved.
const HALVINGS: u32 = 6;

/// Calls `pass` with rows of cells, as first cell and number, that the curves of a patch may reach in an interval of its orientations. A
/// cell is row · side + column, and may be passed several times.
pub(super) fn cells_of(
    grid: &Grid,
    patch: &Patch,
    over: &Orientations,
    pass: &mut impl FnMut(usize, usize),
) {
    halve(grid, patch, over, HALVINGS, pass);
}

fn halve(
    grid: &Grid,
    patch: &Patch,
    over: &Orientations,
    left: u32,
    pass: &mut impl FnMut(usize, usize),
) {
    let swept = Swept::new(patch, over);
    let (distance, longer) = (LOOSE * grid.cell, LOOSE_ENDS * grid.cell);
    if left == 0 || (swept.spread <= distance && swept.slack <= longer) {
        stamp(grid, &swept, pass);
        return;
    }
    let pieces = swept.pieces(over, distance, longer);
    if pieces <= MOST_PIECES {
        let pieces = pieces.ceil().max(1.0) as u32;
        for i in 0..pieces {
            stamp(grid, &swept.within(patch, &over.piece(i, pieces)), pass);
        }
    } else {
        for i in 0..2 {
            halve(grid, patch, &over.piece(i, 2), left - 1, pass);
        }
    }
}

/// Passes the cells near a shape.
fn stamp(grid: &Grid, swept: &Swept, pass: &mut impl FnMut(usize, usize)) {
    let spread = swept.spread + grid.margin;
    match swept.shape {
        CurveGeometry::Segment { start, end } => near_segment(grid, start, end, spread, pass),
        CurveGeometry::FlatArc { start, end, bulge } => {
            let height = Edge::between(start, end, bulge).height();
            near_segment(grid, start, end, spread + height, pass);
        }
        CurveGeometry::Arc {
            center,
            radius,
            start_angle,
            sweep,
        } => {
            // Length of chords that deviate from the arc by an eighth of a cell: 1 − cos(a / 2) ≤ a² / 8.
            let step = (grid.cell / radius).sqrt();
            let pieces = (sweep.abs() / step).ceil().clamp(1.0, 4096.0);
            let angle = sweep / pieces;
            let sagitta = radius * angle * angle / 8.0;
            let turn = Rotation::by(angle);
            let mut arm = Vector::from_angle(start_angle) * radius;
            for _ in 0..pieces as u32 {
                let next = turn * arm;
                near_segment(grid, center + arm, center + next, spread + sagitta, pass);
                arm = next;
            }
        }
    }
}

/// Rise, in cells, below which a segment counts as level.
const FLAT: f64 = 1e-3;
/// Bound of the rounding error of the place where a segment crosses the edge of a row, in cells: numbers of cells are below 2048, and their
/// rounding is multiplied by the slope.
const CROSSING: f64 = 1e-5;

/// Passes the cells within a distance of a segment, and maybe a few more.
fn near_segment(
    grid: &Grid,
    a: Point,
    b: Point,
    distance: f64,
    pass: &mut impl FnMut(usize, usize),
) {
    // Coordinates in cells from the edge of the square, with the segment pointing upwards.
    let [a, b] = if a.y <= b.y { [a, b] } else { [b, a] };
    let [(ax, ay), (bx, by)] = [a, b].map(|p| (grid.in_cells(p.x), grid.in_cells(p.y)));
    let distance = distance / grid.cell + CROSSING;
    let side = grid.side as f64;
    let cell = |x: f64| x.clamp(0.0, side - 1.0) as usize;
    let (low, high) = (ay - distance, by + distance);
    let (left, right) = (ax.min(bx), ax.max(bx));
    if !(high >= 0.0 && low < side && right + distance >= 0.0 && left - distance < side) {
        return;
    }
    // If it is level enough, the whole segment counts as near every row.
    let slope = if by - ay > FLAT {
        (bx - ax) / (by - ay)
    } else {
        0.0
    };
    for row in cell(low)..=cell(high) {
        // Range in which the segment is near the row.
        let (mut from, mut to) = (left, right);
        if slope != 0.0 {
            let y = row as f64;
            let p = ax + slope * (y - distance - ay);
            let q = ax + slope * (y + 1.0 + distance - ay);
            from = from.max(p.min(q));
            to = to.min(p.max(q));
        }
        let (from, to) = (from - distance, to + distance);
        if from <= to && to >= 0.0 && from < side {
            let first = cell(from);
            pass(row * grid.side + first, cell(to) + 1 - first);
        }
    }
}
