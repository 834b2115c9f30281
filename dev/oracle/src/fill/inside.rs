//! Depth of one part inside the other, by sample points.

use cspace::{Point, Vector};

use crate::judge::{Body, Oracle};

/// Points of the moving part along each side of the box about it.
const POINTS: usize = 32;

/// Cells along each side of the box about the fixed part, for each least box of the flood fill along an axis.
const CELLS: usize = 4;

/// Points inside the moving part, and how deep inside the fixed part what place is.
///
/// A point d inside the one and e inside the other stays inside both while none of the moving part goes farther than d + e:
/// discs of these radii about it, one of each part, still meet.
#[derive(Debug, Clone)]
pub(super) struct Inside {
    /// Seen from the moving part's middle, and how deep inside it they are: the deepest first.
    points: Vec<(Vector, f64)>,
    low: Vector,
    cell: Vector,
    cells: usize,
    /// Lower bound of the depth inside the fixed part for each cell; negative where a point may be outside.
    depths: Vec<f64>,
}

impl Inside {
    /// For a flood fill of `n` boxes along each axis.
    pub(super) fn new(oracle: &Oracle, n: usize) -> Self {
        let (low, size) = frame(oracle, Body::Moving);
        let step = size * (1.0 / POINTS as f64);
        let mut points: Vec<(Vector, f64)> = middles(low, step, POINTS)
            .map(|p| (p, oracle.depth_inside(Body::Moving, p)))
            .filter(|&(_, depth)| depth > 0.0)
            .collect();
        points.sort_by(|a, b| b.1.total_cmp(&a.1));
        let cells = CELLS * n;
        let (low, size) = frame(oracle, Body::Fixed);
        let cell = size * (1.0 / cells as f64);
        let half = 0.5001 * cell.length();
        let depths = middles(low, cell, cells)
            .map(|p| oracle.depth_inside(Body::Fixed, p) - half)
            .collect();
        Self {
            points,
            low,
            cell,
            cells,
            depths,
        }
    }

    /// Whether the parts certainly overlap at all configurations at which no point of the moving part is farther than
    /// `moves` from its place when that part is turned, and its middle is at `shift` from the fixed part's.
    pub(super) fn overlaps(&self, turn: (f64, f64), shift: Vector, moves: f64) -> bool {
        let (sin, cos) = turn;
        self.points.iter().any(|&(p, depth)| {
            let at = Vector::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y) + shift;
            let there = self.depth(at);
            there > 0.0 && there + depth > moves
        })
    }

    /// Lower bound of the depth of a place inside the fixed part.
    fn depth(&self, at: Vector) -> f64 {
        let from = at - self.low;
        let (i, j) = (from.x / self.cell.x, from.y / self.cell.y);
        let within = |k: f64| k >= 0.0 && k < self.cells as f64;
        if within(i) && within(j) {
            self.depths[i as usize * self.cells + j as usize]
        } else {
            -1.0
        }
    }
}

/// The box about a part as seen from its middle: its lower corner, and its sides.
fn frame(oracle: &Oracle, body: Body) -> (Vector, Vector) {
    let (low, high): (Point, Point) = oracle.frame(body);
    (low.to_vector(), high - low)
}

/// The middles of the cells of a box.
fn middles(low: Vector, cell: Vector, n: usize) -> impl Iterator<Item = Vector> {
    let at = |i: usize| i as f64 + 0.5;
    (0..n * n).map(move |k| {
        let (i, j) = (k / n, k % n);
        low + Vector::new(at(i) * cell.x, at(j) * cell.y)
    })
}
