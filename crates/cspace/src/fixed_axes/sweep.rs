//! The plane swept along x: bands between critical values, the free gaps of y in each, and which gaps join.

use core::f64::consts::TAU;

use super::domain::{Extent, clusters};
use super::gaps::{Band, Gap, Graphs};
use super::setting::Bodies;
use super::tolerance::COINCIDENT;

/// Critical values nearer than this are one (radians or length).
const NARROWEST: f64 = crate::feature::tolerance::NARROWEST_BAND;
/// Gaps of neighbouring bands join where they share more than this (radians or length).
const SHORTEST: f64 = crate::feature::tolerance::SHORTEST_OVERLAP;

/// A gap at least as wide, in a band at least as wide, is tested for overlap within (radians or length): so far from all
/// curves the test is certain.
const CHECKED: f64 = 1e-5;
/// Where in a gap, as a share of its width, overlap is tested: not in the middle, where a disc may just fill a hole.
const TRIED_AT: f64 = 0.382;

/// Two gaps of neighbouring bands that share a stretch: `to`, moved by so many turns, or widths of the window, is right of
/// `from`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub(super) from: u32,
    pub(super) to: u32,
    pub(super) x_turns: i32,
    pub(super) y_turns: i32,
}

/// What the sweep finds.
#[derive(Debug)]
pub(super) struct Swept {
    pub(super) bands: Vec<Band>,
    pub(super) gaps: Vec<Gap>,
    /// Where each gap is at the left end, in the middle and at the right end of its band.
    pub(super) spans: Vec<[(f64, f64); 3]>,
    pub(super) links: Vec<Link>,
}

/// Counts of tests of overlap within gaps.
#[derive(Debug, Default)]
pub(super) struct Tally {
    pub(super) tests: usize,
    /// Those that tell another thing than the cells beside the gap.
    pub(super) conflicts: usize,
    /// Of these the tests that are certain.
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
        // What is at the ends of the gaps, from the lowest: of a circle the first cell comes once more, a turn on.
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
                // Curves on top of each other, facing the same way.
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

    /// Whether a gap is free as the cells below and above it say; none if they say different things, or there are none.
    fn said(&self, lower: Option<(f64, u32)>, upper: Option<(f64, u32)>) -> Option<bool> {
        let above = |(_, i): (f64, u32)| self.graphs.piece(i).root == 0;
        match (lower.map(above), upper.map(|u| !above(u))) {
            (Some(a), Some(b)) => (a == b).then_some(a),
            (a, b) => a.or(b),
        }
    }

    fn gap(&self, middle: f64, lower: Option<(f64, u32)>, upper: Option<(f64, u32)>) -> Gap {
        // By how many turns a cell has to be moved to be where it is met.
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

    /// Gaps of neighbouring bands that share a stretch, of which no vertical cell between them takes all.
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

    /// Whether walls leave a stretch of y open: what crosses one is blocked, if only on the wall itself.
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

    /// Where every gap is at the ends and in the middle of its band.
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
