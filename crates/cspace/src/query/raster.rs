//! Which cells of a slot a patch may pass.

use crate::geometry::{Point, Vector};
use crate::slice::CurveGeometry;
use crate::space::Patch;

use super::grid::Grid;
use super::swept::Swept;

/// How far curves may move while they are taken for one, in cells, and by how much they may be too long.
const LOOSE: f64 = 0.5;
const LOOSE_ENDS: f64 = 1.0;
/// Slots are halved at most so often.
const HALVINGS: u32 = 6;

/// Calls `pass` with every cell, as row · side + column, that the curves of a patch may come to between two orientations
/// of the patch. A cell may be told several times.
pub(super) fn cells_of(
    grid: &Grid,
    patch: &Patch,
    (lo, hi): (f64, f64),
    pass: &mut impl FnMut(usize),
) {
    halve(grid, patch, lo, hi, HALVINGS, pass);
}

fn halve(grid: &Grid, patch: &Patch, lo: f64, hi: f64, left: u32, pass: &mut impl FnMut(usize)) {
    let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let swept = Swept::new(patch, mid, half);
    let loose = swept.spread > LOOSE * grid.cell || swept.slack > LOOSE_ENDS * grid.cell;
    if left > 0 && loose {
        halve(grid, patch, lo, mid, left - 1, pass);
        halve(grid, patch, mid, hi, left - 1, pass);
        return;
    }
    let spread = swept.spread + grid.margin;
    match swept.shape {
        CurveGeometry::Segment { start, end } => near_segment(grid, start, end, spread, pass),
        CurveGeometry::FlatArc { start, end, bulge } => {
            let height = 0.5 * bulge.abs() * start.distance(end);
            near_segment(grid, start, end, spread + height, pass);
        }
        CurveGeometry::Arc {
            center,
            radius,
            start_angle,
            sweep,
        } => {
            // Chords that leave the arc by an eighth of a cell: 1 − cos(a / 2) ≤ a² / 8.
            let step = (grid.cell / radius).sqrt();
            let pieces = (sweep.abs() / step).ceil().clamp(1.0, 4096.0);
            let angle = sweep / pieces;
            let sagitta = radius * angle * angle / 8.0;
            let at = |i: f64| center + Vector::from_angle(start_angle + angle * i) * radius;
            let mut from = at(0.0);
            for i in 1..=pieces as u32 {
                let to = at(f64::from(i));
                near_segment(grid, from, to, spread + sagitta, pass);
                from = to;
            }
        }
    }
}

/// The cells within a distance of a segment, and maybe a few more.
fn near_segment(grid: &Grid, a: Point, b: Point, distance: f64, pass: &mut impl FnMut(usize)) {
    let clamp = |x: f64| (x.clamp(0.0, grid.side as f64 - 1.0)) as usize;
    let outside =
        |lo: f64, hi: f64| grid.in_cells(hi) < 0.0 || grid.in_cells(lo) >= grid.side as f64;
    let (low, high) = (a.y.min(b.y) - distance, a.y.max(b.y) + distance);
    if outside(low, high) {
        return;
    }
    let (first, last) = (clamp(grid.in_cells(low)), clamp(grid.in_cells(high)));
    let rise = b.y - a.y;
    for row in first..=last {
        // The share of the segment that is near the row.
        let (mut s, mut t) = (0.0, 1.0);
        if rise != 0.0 {
            let p = (grid.line(row) - distance - a.y) / rise;
            let q = (grid.line(row + 1) + distance - a.y) / rise;
            s = f64::max(s, p.min(q));
            t = f64::min(t, p.max(q));
        }
        if s > t {
            continue;
        }
        let (x, y) = (a.x + (b.x - a.x) * s, a.x + (b.x - a.x) * t);
        let (x, y) = (x.min(y) - distance, x.max(y) + distance);
        if outside(x, y) {
            continue;
        }
        for column in clamp(grid.in_cells(x))..=clamp(grid.in_cells(y)) {
            pass(row * grid.side + column);
        }
    }
}
