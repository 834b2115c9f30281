//! A grid over the plane of positions that finds which of many discs may come near a place.

use crate::geometry::Point;
use crate::grouped::Grouped;

/// The number of squares along each side.
const SIDE: usize = 24;

/// Discs by the squares that they may reach into.
#[derive(Debug)]
pub(crate) struct Grid {
    squares: Squares,
    discs: Grouped,
}

impl Grid {
    /// Grid of discs given by centres and radii, for queries of the discs within `reach` of a place.
    pub(crate) fn new(discs: impl Iterator<Item = (Point, f64)> + Clone, reach: f64) -> Self {
        let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
        for (c, r) in discs.clone() {
            lo = lo.min(c.x.min(c.y) - r);
            hi = hi.max(c.x.max(c.y) + r);
        }
        let squares = Squares {
            lo,
            scale: SIDE as f64 / (hi - lo).max(f64::MIN_POSITIVE),
        };
        let pairs = (0u32..).zip(discs).flat_map(move |(i, (c, r))| {
            let reached = squares.reached(c, r + reach);
            reached.map(move |k| (k as u32, i))
        });
        Self {
            squares,
            discs: Grouped::new(SIDE * SIDE, pairs),
        }
    }

    /// The discs that may come within the reach of a place.
    pub(crate) fn near(&self, p: Point) -> &[u32] {
        let (i, j) = (self.squares.index(p.x), self.squares.index(p.y));
        self.discs.of((i * SIDE + j) as u32)
    }
}

/// A square grid of squares; places beyond it belong to the squares at its edges.
#[derive(Debug, Clone, Copy)]
struct Squares {
    /// Smallest coordinate (length).
    lo: f64,
    /// Squares per unit of length.
    scale: f64,
}

impl Squares {
    /// The row or column of a coordinate.
    fn index(&self, v: f64) -> usize {
        (((v - self.lo) * self.scale) as usize).min(SIDE - 1)
    }

    /// The squares that a disc may reach into.
    fn reached(&self, c: Point, r: f64) -> impl Iterator<Item = usize> + Clone + use<> {
        let columns = self.index(c.x - r)..=self.index(c.x + r);
        let (from, to) = (self.index(c.y - r), self.index(c.y + r));
        columns.flat_map(move |i| (from..=to).map(move |j| i * SIDE + j))
    }
}
