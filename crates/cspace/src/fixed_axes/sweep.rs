//! Sweep of the plane along x: bands between critical values, the free gaps of y in each, and links between gaps.

use super::arrange::Cell;
use super::condition::Condition;
use super::motion::{Extent, brought_between, clusters};
use super::piece::{Pair, Piece};
use super::setup::Bodies;
use super::tolerance::COINCIDENT;
use core::f64::consts::TAU;

/// Distance of critical values below which they are one (radians or length).
const NARROWEST: f64 = crate::feature::tolerance::NARROWEST_BAND;
/// Length of the shared interval above which gaps of adjacent bands are joined (radians or length).
const SHORTEST: f64 = crate::feature::tolerance::SHORTEST_OVERLAP;

/// Minimum width of a gap and of its band for an overlap test within the gap (radians or length): at that distance from all curves the test
/// is certain.
const CHECKED: f64 = 1e-5;
/// Place of the overlap test in a gap, as a share of its width: not in the middle, where a disc may just fill a hole.
const TRIED_AT: f64 = 0.382;

/// Two gaps of adjacent bands that share an interval: `to`, moved by a number of turns, or widths of the window, is right of `from`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub(super) from: u32,
    pub(super) to: u32,
    pub(super) x_turns: i32,
    pub(super) y_turns: i32,
}

/// Result of the sweep.
#[derive(Debug, Default)]
pub(super) struct Swept {
    pub(super) bands: Vec<Band>,
    pub(super) gaps: Vec<Gap>,
    /// Ends of each gap at the left end, in the middle and at the right end of its band.
    pub(super) spans: Vec<[(f64, f64); 3]>,
    pub(super) links: Vec<Link>,
}

/// Counts of tests of overlap within gaps.
#[derive(Debug, Default)]
pub(super) struct Tally {
    pub(super) tests: usize,
    /// Tests whose result differs from the class that the cells beside the gap give.
    pub(super) conflicts: usize,
    /// Conflicts in which the test is certain.
    pub(super) contradictions: usize,
}

pub(super) struct Sweep<'a> {
    pub(super) graphs: Graphs<'a>,
    pub(super) free: &'a [bool],
    pub(super) bodies: &'a Bodies,
    pub(super) x: Extent,
}

impl Sweep<'_> {
    pub(super) fn run(&self) -> (Swept, Tally) {
        let (mut bands, mut gaps) = (Vec::new(), Vec::new());
        let mut tally = Tally::default();
        let cell = |i: u32| &self.graphs.cells[i as usize];
        let mut graphs: Vec<u32> = (self.free_cells())
            .filter(|&i| !self.graphs.piece(i).vertical)
            .collect();
        graphs.sort_by(|&a, &b| cell(a).from.total_cmp(&cell(b).from).then(a.cmp(&b)));
        let mut active: Vec<u32> = Vec::new();
        let mut next = 0;
        let mut order: Vec<(f64, u32)> = Vec::new();
        for (lo, hi) in self.critical().windows(2).map(|w| (w[0].1, w[1].0)) {
            let middle = 0.5 * (lo + hi);
            active.retain(|&i| cell(i).to > middle);
            while let Some(&i) = graphs.get(next) {
                if cell(i).from >= middle {
                    break;
                }
                next += 1;
                if cell(i).to > middle {
                    active.push(i);
                }
            }
            order.clear();
            order.extend(
                active
                    .iter()
                    .map(|&i| (self.graphs.y.folded(self.graphs.at(i, middle)), i)),
            );
            order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let from = gaps.len() as u32;
            self.add_gaps((lo, hi), &order, &mut gaps, &mut tally);
            bands.push(Band {
                lo,
                hi,
                gaps: from..gaps.len() as u32,
            });
        }
        let spans = self.spans(&bands, &gaps);
        let links = self.links(&bands, &spans);
        let swept = Swept {
            bands,
            gaps,
            spans,
            links,
        };
        (swept, tally)
    }

    fn free_cells(&self) -> impl Iterator<Item = u32> + '_ {
        (0u32..).zip(self.free).filter(|c| *c.1).map(|c| c.0)
    }

    /// Clusters of critical values: first and last of each.
    fn critical(&self) -> Vec<(f64, f64)> {
        let mut all = vec![self.x.lo, self.x.hi];
        for (c, p) in self.free_cells().map(|i| self.graphs.cell(i)) {
            if p.vertical {
                all.push(p.start.x);
            } else {
                all.extend([c.from, c.to]);
            }
        }
        clusters(all, NARROWEST)
    }

    /// Adds the free gaps at the middle of a band, between cells in order of y.
    fn add_gaps(
        &self,
        (lo, hi): (f64, f64),
        order: &[(f64, u32)],
        gaps: &mut Vec<Gap>,
        tally: &mut Tally,
    ) {
        let middle = 0.5 * (lo + hi);
        let y = self.graphs.y;
        let at = |o: Option<(f64, u32)>, limit: f64| o.map_or(limit, |o| o.0);
        // The ends of the gaps, from the lowest: on a circle the first cell is repeated, a turn further.
        let cells = order.iter().copied().map(Some);
        let ends: Vec<Option<(f64, u32)>> = match order.first() {
            Some(&(at, first)) if y.is_circle() => cells.chain([Some((at + TAU, first))]).collect(),
            _ => [None].into_iter().chain(cells).chain([None]).collect(),
        };
        for (lower, upper) in ends.windows(2).map(|w| (w[0], w[1])) {
            let (from, to) = (at(lower, y.lo), at(upper, y.hi));
            let certain = to - from >= CHECKED && hi - lo >= CHECKED;
            let said = self.said(lower, upper);
            let free = match said {
                Some(free) if !certain => free,
                // Curves that coincide and face the same way.
                None if lower.is_some() && to - from < COINCIDENT => false,
                _ => {
                    tally.tests += 1;
                    let free = !self.bodies.overlap(middle, from + TRIED_AT * (to - from));
                    let agreed = said == Some(free) || order.is_empty();
                    tally.conflicts += usize::from(!agreed);
                    tally.contradictions += usize::from(!agreed && certain);
                    free
                }
            };
            if free {
                gaps.push(self.gap(middle, lower, upper));
            }
        }
    }

    /// Whether a gap is free according to the cells below and above it; `None` if they contradict each other, or there are none.
    fn said(&self, lower: Option<(f64, u32)>, upper: Option<(f64, u32)>) -> Option<bool> {
        let above = |(_, i): (f64, u32)| self.graphs.piece(i).root == 0;
        match (lower.map(above), upper.map(|u| !above(u))) {
            (Some(a), Some(b)) => (a == b).then_some(a),
            (a, b) => a.or(b),
        }
    }

    fn gap(&self, middle: f64, lower: Option<(f64, u32)>, upper: Option<(f64, u32)>) -> Gap {
        // Number of turns by which a cell must be moved to its place here.
        let turns = |o: Option<(f64, u32)>| match o {
            Some((y, i)) if self.graphs.y.is_circle() => {
                ((y - self.graphs.at(i, middle)) / TAU).round() as i32
            }
            _ => 0,
        };
        Gap {
            lower: lower.map(|o| o.1),
            upper: upper.map(|o| o.1),
            turns: (turns(lower), turns(upper)),
            region: u32::MAX,
        }
    }

    /// Links of gaps of adjacent bands that share an interval, part of which is not covered by vertical cells between them.
    fn links(&self, bands: &[Band], spans: &[[(f64, f64); 3]]) -> Vec<Link> {
        let mut links = Vec::new();
        let n = bands.len();
        let mut walls: Vec<(f64, (f64, f64))> = (self.free_cells())
            .map(|i| self.graphs.cell(i))
            .filter(|(_, p)| p.vertical)
            .map(|(c, p)| (p.start.x, (c.from, c.to)))
            .collect();
        walls.sort_by(|a, b| a.0.total_cmp(&b.0));
        for k in 0..n {
            let last = k + 1 == n;
            if last && !self.x.is_circle() {
                break;
            }
            let (left, right) = (&bands[k], &bands[(k + 1) % n]);
            let from = walls.partition_point(|w| w.0 < left.hi);
            let to = walls.partition_point(|w| w.0 <= right.lo);
            let between = if last {
                [&walls[from..], &walls[..to]]
            } else {
                [&walls[from..to], &[]]
            };
            for a in left.gaps.clone() {
                let (p, q) = spans[a as usize][2];
                for b in right.gaps.clone() {
                    let (r, s) = spans[b as usize][0];
                    let shifts = if self.graphs.y.is_circle() {
                        ((p - s) / TAU).ceil() as i32..=((q - r) / TAU).floor() as i32
                    } else {
                        0..=0
                    };
                    for turns in shifts {
                        let by = TAU * f64::from(turns);
                        if self.is_open((p.max(r + by), q.min(s + by)), between) {
                            links.push(Link {
                                from: a,
                                to: b,
                                x_turns: i32::from(last),
                                y_turns: turns,
                            });
                        }
                    }
                }
            }
        }
        links
    }

    /// Whether vertical cells leave an interval of y open: a motion across one is blocked, if only on the cell itself.
    fn is_open(&self, (lo, hi): (f64, f64), walls: [&[(f64, (f64, f64))]; 2]) -> bool {
        if hi - lo <= SHORTEST {
            return false;
        }
        let mut closed: Vec<(f64, f64)> = Vec::new();
        for &(_, (from, to)) in walls.into_iter().flatten() {
            let mut turns = 0.0;
            if self.graphs.y.is_circle() {
                turns = TAU * ((lo - to) / TAU).ceil();
            }
            while from + turns < hi {
                closed.push((from + turns, to + turns));
                if !self.graphs.y.is_circle() {
                    break;
                }
                turns += TAU;
            }
        }
        closed.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut at = lo;
        for (from, to) in closed {
            if from - at > SHORTEST {
                return true;
            }
            at = at.max(to);
        }
        hi - at > SHORTEST
    }

    /// Ends of every gap at the ends and in the middle of its band.
    fn spans(&self, bands: &[Band], gaps: &[Gap]) -> Vec<[(f64, f64); 3]> {
        let mut spans = Vec::with_capacity(gaps.len());
        for band in bands {
            let places = [band.lo, 0.5 * (band.lo + band.hi), band.hi];
            let inside = &gaps[band.gaps.start as usize..band.gaps.end as usize];
            spans.extend((inside.iter()).map(|gap| places.map(|x| self.graphs.interval(gap, x))));
        }
        spans
    }
}

// The free gaps of y at every x, between cells of the free boundary, and the search for the gap of a configuration.

/// A free interval of y over a band.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Gap {
    /// The cell below it; `None` at a limit of y, and where nothing touches.
    pub(super) lower: Option<u32>,
    /// The cell above it; `None` likewise.
    pub(super) upper: Option<u32>,
    /// Turns to add to y of the lower and of the upper cell: the lower end is in the first turn at the band's middle.
    pub(super) turns: (i32, i32),
    pub(super) region: u32,
}

/// An interval of x in which the order of the free boundary's cells does not change.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Band {
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// Indices of its gaps, from the lowest.
    pub(super) gaps: core::ops::Range<u32>,
}

/// Cells as functions of x.
#[derive(Clone, Copy)]
pub(super) struct Graphs<'a> {
    pub(super) pairs: &'a [Pair],
    pub(super) pieces: &'a [Piece],
    pub(super) cells: &'a [Cell],
    pub(super) y: Extent,
}

impl<'a> Graphs<'a> {
    /// A cell, and its piece.
    pub(super) fn cell(&self, cell: u32) -> (&'a Cell, &'a Piece) {
        let c = &self.cells[cell as usize];
        (c, &self.pieces[c.piece as usize])
    }

    pub(super) fn piece(&self, cell: u32) -> &'a Piece {
        self.cell(cell).1
    }

    pub(super) fn condition(&self, cell: u32) -> &'a Condition {
        &self.pairs[self.piece(cell).pair as usize].condition
    }

    /// Ranges of a cell along x and along y.
    pub(super) fn cell_box(&self, cell: u32) -> ((f64, f64), (f64, f64)) {
        let (c, p) = self.cell(cell);
        if p.vertical {
            return ((p.start.x, p.start.x), (c.from, c.to));
        }
        let (a, b) = (p.y(self.pairs, c.from), p.y(self.pairs, c.to));
        ((c.from, c.to), (a.min(b), a.max(b)))
    }

    /// y of a cell at an x within it, or just beyond.
    pub(super) fn at(&self, cell: u32, x: f64) -> f64 {
        let c = &self.cells[cell as usize];
        self.piece(cell)
            .y(self.pairs, brought_between(x, c.from, c.to))
    }

    /// Ends of a gap at an x of its band; in the band's middle the lower end is in the first turn.
    pub(super) fn interval(&self, gap: &Gap, x: f64) -> (f64, f64) {
        let end = |cell: Option<u32>, turns: i32, limit: f64| {
            cell.map_or(limit, |i| self.at(i, x) + TAU * f64::from(turns))
        };
        let from = end(gap.lower, gap.turns.0, self.y.lo);
        let to = end(gap.upper, gap.turns.1, self.y.hi);
        (from, to.max(from))
    }
}

/// The free gaps of all bands.
#[derive(Clone, Copy)]
pub(super) struct Gaps<'a> {
    pub(super) graphs: Graphs<'a>,
    pub(super) bands: &'a [Band],
    pub(super) gaps: &'a [Gap],
    pub(super) x: Extent,
}

impl Gaps<'_> {
    /// Whether a configuration is in a free gap, or outside the window, where nothing touches.
    pub(super) fn hold(&self, x: f64, y: f64) -> bool {
        self.is_beyond(x, y) || self.region(x, y).is_some()
    }

    /// Whether a configuration is outside the window, where nothing touches.
    pub(super) fn is_beyond(&self, x: f64, y: f64) -> bool {
        let within = |t: f64, e: &Extent| (e.lo..=e.hi).contains(&t);
        let y_range = &self.graphs.y;
        !(y_range.is_circle() || within(x, &self.x) && within(y, y_range))
    }

    /// The region of the free gap that contains a configuration.
    pub(super) fn region(&self, x: f64, y: f64) -> Option<u32> {
        if self.is_beyond(x, y) {
            return None;
        }
        let band = self.bands.partition_point(|b| b.hi < x);
        self.region_in(self.bands.get(band).or(self.bands.last())?, x, y)
    }

    /// The region of the free gap that contains a configuration, or is nearest to it: where the space has conflicts, a free configuration may
    /// be in none. `None` if there is no gap.
    pub(super) fn region_nearest(&self, x: f64, y: f64) -> Option<u32> {
        let held = self.region(x, y);
        held.or_else(|| {
            let gaps = self.bands.iter().flat_map(|band| {
                let gaps = &self.gaps[band.gaps.start as usize..band.gaps.end as usize];
                gaps.iter().map(move |gap| {
                    let beside = x.clamp(band.lo, band.hi);
                    let (from, to) = self.graphs.interval(gap, beside);
                    let middle = 0.5 * (from + to);
                    let y = middle - self.graphs.y.apart(middle, y);
                    ((x - beside).hypot(y - y.clamp(from, to)), gap.region)
                })
            });
            gaps.min_by(|a, b| a.0.total_cmp(&b.0))
                .map(|(_, region)| region)
        })
    }

    /// The region of the free gap of a band that contains a configuration.
    pub(super) fn region_in(&self, band: &Band, x: f64, y: f64) -> Option<u32> {
        let gaps = &self.gaps[band.gaps.start as usize..band.gaps.end as usize];
        let held = gaps.iter().find(|gap| {
            let (from, to) = self.graphs.interval(gap, x);
            if self.graphs.y.is_circle() {
                y + TAU * ((from - y) / TAU).ceil() <= to
            } else {
                (from..=to).contains(&y)
            }
        })?;
        Some(held.region)
    }
}
