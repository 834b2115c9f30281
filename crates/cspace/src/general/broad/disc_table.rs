//! Table of discs inside a part: which of them overlaps most with what is at a place, approximately.
//!
//! A disc inside one part and a disc inside the other block the positions at which they overlap. Parts with many edges have too many
//! pairs of discs to try them all. The table has, for every square of a grid over a part, the disc that overlaps most with a small thing
//! there. So each disc of the other part, wherever it is placed, is compared with one disc only: the right one but for the width of a
//! square.

use crate::boxes::Boxes;
use crate::geometry::{Point, Vector};
use crate::part::Bounds;

/// A disc inside a part, in the pair's frame: centre and radius.
pub(crate) type PartDisc = (Point, f64);

/// Discs inside a part: those that are looked up in the other part's table, and the table for those of the other part.
#[derive(Debug)]
pub(crate) struct DiscTable {
    probes: Vec<PartDisc>,
    boxes: Boxes,
    discs: Vec<PartDisc>,
    corner: Point,
    /// Width of a square.
    step: f64,
    rows: usize,
    columns: usize,
    /// The discs of the squares, row by row.
    squares: Vec<Option<u32>>,
}

/// Number of squares per disc, and maximum. At the maximum a table takes half a megabyte.
const SQUARES_PER_DISC: usize = 128;
const MOST_SQUARES: usize = 1 << 16;

/// Minimum width and height of a table (length): thin parts would have long rows of tiny squares.
const NARROWEST: f64 = 1.0 / 256.0;

/// The square around a disc.
fn around(&(center, radius): &PartDisc) -> Bounds {
    let corner = Vector::new(radius, radius);
    Bounds::of(center + -corner, center + corner)
}

impl DiscTable {
    /// The table of some discs, of which some may have radius 0; `None` if there are none. `probes`: those that are looked up in the
    /// table of the other part.
    pub(crate) fn new(probes: Vec<PartDisc>, discs: Vec<PartDisc>) -> Option<Self> {
        if discs.is_empty() {
            return None;
        }
        let bounds = discs.iter().map(around).fold(Bounds::EMPTY, Bounds::union);
        let (width, height) = (bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y);
        let squares = (SQUARES_PER_DISC * discs.len()).min(MOST_SQUARES);
        let [width, height] = [width, height].map(|length| length.max(NARROWEST));
        let step = (width * height / squares as f64).sqrt();
        let along = |length: f64| ((length / step).ceil() as usize).max(1);
        let mut this = Self {
            boxes: Boxes::new(probes.iter().map(around)),
            probes,
            discs,
            corner: bounds.min,
            step,
            rows: along(height),
            columns: along(width),
            squares: Vec::new(),
        };
        this.squares = this.filled();
        this.spread();
        Some(this)
    }

    /// For every square whose middle is in a disc, that in which its power is largest; otherwise a disc with its centre in the square.
    ///
    /// The power r² − d² of a place is the square of half the chord through it, which is how far the place may move along the boundary and
    /// stay in the disc. Of two discs in which a place is equally deep, the larger has the larger power.
    fn filled(&self) -> Vec<Option<u32>> {
        let mut best = vec![(f64::NEG_INFINITY, None); self.rows * self.columns];
        for (i, disc) in (0u32..).zip(&self.discs) {
            let (square, own) = (around(disc), self.at(disc.0));
            let ((top, left), (bottom, right)) = (self.at(square.min), self.at(square.max));
            for (row, column) in (top..=bottom).flat_map(|y| (left..=right).map(move |x| (y, x))) {
                let off = (self.middle(row, column) - disc.0).length_squared();
                let power = disc.1 * disc.1 - off;
                let best = &mut best[row * self.columns + column];
                if (power > 0.0 || (row, column) == own) && power > best.0 {
                    *best = (power, Some(i));
                }
            }
        }
        best.into_iter().map(|b| b.1).collect()
    }

    /// Gives each square without a disc the one, of those of its neighbours, in which its middle is deepest: from row to row, forth and
    /// back, so that every square has the nearest one or another nearly as near.
    fn spread(&mut self) {
        let empty: Vec<usize> = (0..self.squares.len())
            .filter(|&at| self.squares[at].is_none())
            .collect();
        for &at in empty.iter().chain(empty.iter().rev()) {
            let (row, column) = (at / self.columns, at % self.columns);
            let middle = self.middle(row, column);
            let rows = row.saturating_sub(1)..(row + 2).min(self.rows);
            let columns = column.saturating_sub(1)..(column + 2).min(self.columns);
            self.squares[at] = rows
                .flat_map(|y| columns.clone().map(move |x| (y, x)))
                .filter_map(|(y, x)| self.squares[y * self.columns + x])
                .max_by(|&a, &b| self.depth(a, middle).total_cmp(&self.depth(b, middle)));
        }
    }

    /// How far a place is inside a disc; negative outside.
    fn depth(&self, disc: u32, p: Point) -> f64 {
        let (center, radius) = self.discs[disc as usize];
        radius - p.distance(center)
    }

    /// The middle of a square.
    fn middle(&self, row: usize, column: usize) -> Point {
        self.corner + Vector::new(column as f64 + 0.5, row as f64 + 0.5) * self.step
    }

    /// Row and column of the square at a place; beyond the table, of the nearest square.
    fn at(&self, p: Point) -> (usize, usize) {
        let v = (p - self.corner) * (1.0 / self.step);
        // Negative coordinates become 0.
        let (row, column) = (v.y as usize, v.x as usize);
        (row.min(self.rows - 1), column.min(self.columns - 1))
    }

    /// The disc that overlaps most with what is at a place, approximately, and how far the place is inside it.
    fn near(&self, p: Point) -> Option<(u32, f64)> {
        let (row, column) = self.at(p);
        let disc = self.squares[row * self.columns + column]?;
        Some((disc, self.depth(disc, p)))
    }

    /// The disc of the table that a disc of the other part overlaps there, if it does.
    fn overlapped(&self, center: Point, radius: f64) -> Option<PartDisc> {
        let (disc, depth) = self.near(center)?;
        (depth + radius > 0.0).then(|| self.discs[disc as usize])
    }

    /// Number of discs in the table.
    pub(crate) fn size(&self) -> usize {
        self.discs.len()
    }

    /// Each of the first `count` probes with the disc of another part that it overlaps, if it does. `place` maps places of this part to those
    /// of the other at one configuration.
    pub(crate) fn overlaps(
        &self,
        count: usize,
        other: &Self,
        place: impl Fn(Point) -> Point,
    ) -> impl Iterator<Item = (PartDisc, PartDisc)> {
        let probes = self.probes.iter().take(count);
        probes.filter_map(move |&probe| {
            let disc = other.overlapped(place(probe.0), probe.1)?;
            Some((probe, disc))
        })
    }

    /// Calls `take` with a probe and the disc of another part that it overlaps, until it returns true, which is then returned. `place` maps
    /// places of this part to those of the other at one configuration. Some that overlap may be missed.
    pub(crate) fn any_overlap(
        &self,
        other: &Self,
        place: impl Fn(Point) -> Point,
        mut take: impl FnMut(PartDisc, PartDisc) -> bool,
    ) -> bool {
        let reaches = |b: &Bounds| {
            let depth = other.near(place(b.center())).map(|n| n.1);
            depth.is_some_and(|depth| depth + 0.5 * b.diagonal() + 2.0 * other.step > 0.0)
        };
        self.boxes.any(reaches, |i| {
            let probe = self.probes[i as usize];
            let disc = other.overlapped(place(probe.0), probe.1);
            disc.is_some_and(|disc| take(probe, disc))
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    /// The disc that is looked up is about as deep as the deepest; and it contains what another contains, but for the width of a square.
    #[test]
    fn finds_what_overlaps_most() {
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        let mut place = |size: f64| {
            let mut at = || rng.random_range(-size..size);
            Point::new(at(), at())
        };
        let radii = [0.3, 0.1, 0.05, 0.02, 0.0];
        let discs: Vec<PartDisc> = (0..100).map(|i| (place(0.7), radii[i / 20])).collect();
        let table = DiscTable::new(discs.clone(), discs.clone()).unwrap();
        let mut contained = 0;
        for _ in 0..10_000 {
            let p = place(0.7);
            let found = table.near(p).unwrap().1;
            let deepest =
                (discs.iter().map(|d| d.1 - d.0.distance(p))).fold(f64::NEG_INFINITY, f64::max);
            if deepest > 0.0 {
                contained += 1;
                assert!(found > -table.step, "{p:?}: {found} instead of {deepest}");
            } else {
                assert!(
                    found > deepest - 2.0 * table.step,
                    "{p:?}: {found} instead of {deepest}"
                );
            }
        }
        assert!(contained > 1000);
    }

    /// Discs in one line, and at one place, make no table larger than others.
    #[test]
    fn thin_tables_are_small() {
        let line = (0..500).map(|i| (Point::new(f64::from(i) / 500.0, 0.0), 0.0));
        for discs in [line.collect(), vec![(Point::ORIGIN, 0.0); 3]] {
            let table = DiscTable::new(discs.clone(), discs).unwrap();
            assert!(table.squares.len() < 2 * MOST_SQUARES);
            assert_eq!(
                table.near(Point::new(7.0, -9.0)).unwrap().0 > 0,
                table.columns > 400
            );
        }
        assert!(DiscTable::new(Vec::new(), Vec::new()).is_none());
    }
}
