//! A grid over the plane of positions that tells which of many discs may come near a place.

use crate::geometry::Point;

/// The number of squares along each side.
const SIDE: usize = 24;

/// Squares, each with the discs that may reach into it.
#[derive(Debug)]
pub(crate) struct Grid {
    lo: f64,
    /// Squares per unit of length.
    scale: f64,
    /// The discs of square k are `list[first[k]..first[k + 1]]`.
    first: Vec<u32>,
    list: Vec<u32>,
}

impl Grid {
    /// Of discs given by centres and radii, to be asked for those within `reach`.
    pub(crate) fn new(discs: impl Iterator<Item = (Point, f64)> + Clone, reach: f64) -> Self {
        let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
        for (c, r) in discs.clone() {
            lo = lo.min(c.x.min(c.y) - r);
            hi = hi.max(c.x.max(c.y) + r);
        }
        let mut grid = Self {
            lo,
            scale: SIDE as f64 / (hi - lo).max(f64::MIN_POSITIVE),
            first: vec![0; SIDE * SIDE + 1],
            list: Vec::new(),
        };
        for (c, r) in discs.clone() {
            for k in grid.squares(c, r + reach) {
                grid.first[k + 1] += 1;
            }
        }
        for k in 0..SIDE * SIDE {
            grid.first[k + 1] += grid.first[k];
        }
        let mut at = grid.first.clone();
        grid.list = vec![0; grid.first[SIDE * SIDE] as usize];
        for (i, (c, r)) in (0..).zip(discs) {
            for k in grid.squares(c, r + reach) {
                grid.list[at[k] as usize] = i;
                at[k] += 1;
            }
        }
        grid
    }

    /// The discs that may come within the reach of a place.
    pub(crate) fn near(&self, p: Point) -> &[u32] {
        let k = self.index(p.x) * SIDE + self.index(p.y);
        &self.list[self.first[k] as usize..self.first[k + 1] as usize]
    }

    /// The row or column of a coordinate; those beyond the grid count to its ends.
    fn index(&self, v: f64) -> usize {
        (((v - self.lo) * self.scale) as usize).min(SIDE - 1)
    }

    /// The squares that a disc may reach into.
    fn squares(&self, c: Point, r: f64) -> impl Iterator<Item = usize> + use<> {
        let columns = self.index(c.x - r)..=self.index(c.x + r);
        let (from, to) = (self.index(c.y - r), self.index(c.y + r));
        columns.flat_map(move |i| (from..=to).map(move |j| i * SIDE + j))
    }
}
