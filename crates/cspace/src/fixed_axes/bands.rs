//! Bands of x between critical values, the free gaps of y in each, and the free regions they join to.

use super::arrange::Cell;
use super::domain::Extent;
use super::domain::brought_between;
use super::judge::Bodies;
use super::piece::Pair;
use super::piece::Piece;
use core::f64::consts::TAU;

/// Critical values nearer than this are one (radians or length).
const NARROWEST: f64 = crate::feature::tolerance::NARROWEST_BAND;
/// Gaps of neighbouring bands join where they share more than this (radians or length).
const SHORTEST: f64 = crate::feature::tolerance::SHORTEST_OVERLAP;

/// A gap narrower than this between curves that face the same way is none (radians or length): it is what rounding leaves
/// between curves that coincide.
const TOO_NARROW: f64 = 1e-11;

/// A gap at least as wide, in a band at least as wide, is tested for overlap within (radians or length): so far from all
/// curves the test is certain.
const CHECKED: f64 = 1e-5;
/// Where in a gap, as a share of its width, overlap is tested: not in the middle, where a disc may just fill a hole.
const TRIED_AT: f64 = 0.382;

/// A free interval of y over a band.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Gap {
    /// The cell below it, or none at a limit of y, and where nothing touches.
    pub(super) lower: Option<u32>,
    /// The cell above it.
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

/// A connected component of free space.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Region {
    pub(super) sample: (f64, f64),
    pub(super) x: (f64, f64),
    pub(super) y: (f64, f64),
    pub(super) around_x: bool,
    pub(super) around_y: bool,
}

/// The bands, their gaps, and the regions they join to.
#[derive(Debug)]
pub(super) struct Bands {
    pub(super) bands: Vec<Band>,
    pub(super) gaps: Vec<Gap>,
    pub(super) regions: Vec<Region>,
}

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
#[derive(Debug, Default)]
pub(super) struct Swept {
    pub(super) bands: Vec<Band>,
    pub(super) gaps: Vec<Gap>,
    /// Where each gap is at the left end, in the middle and at the right end of its band.
    pub(super) spans: Vec<[(f64, f64); 3]>,
    pub(super) links: Vec<Link>,
    pub(super) conflicts: usize,
    /// Gaps of which a test within tells another thing than the cells beside them.
    pub(super) contradictions: usize,
    pub(super) tests: usize,
}

/// Cells as functions of x.
pub(super) struct Graphs<'a> {
    pub(super) pairs: &'a [Pair],
    pub(super) pieces: &'a [Piece],
    pub(super) cells: &'a [Cell],
    pub(super) y: Extent,
}

pub(super) struct Sweep<'a> {
    pub(super) graphs: Graphs<'a>,
    pub(super) free: &'a [bool],
    pub(super) bodies: &'a Bodies,
    pub(super) x: Extent,
}

impl Graphs<'_> {
    pub(super) fn piece(&self, cell: u32) -> &Piece {
        &self.pieces[self.cells[cell as usize].piece as usize]
    }

    /// y of a cell at an x within it, or just beyond.
    pub(super) fn at(&self, cell: u32, x: f64) -> f64 {
        let c = &self.cells[cell as usize];
        self.piece(cell)
            .y(self.pairs, brought_between(x, c.from, c.to))
    }

    /// From and to of a gap at x of its band; in the band's middle the lower end is in the first turn.
    pub(super) fn interval(&self, gap: &Gap, x: f64) -> (f64, f64) {
        let end = |cell: Option<u32>, turns: i32, limit: f64| {
            cell.map_or(limit, |i| self.at(i, x) + TAU * f64::from(turns))
        };
        let from = end(gap.lower, gap.turns.0, self.y.lo);
        let to = end(gap.upper, gap.turns.1, self.y.hi);
        (from, to.max(from))
    }
}

impl Sweep<'_> {
    pub(super) fn run(&self) -> Swept {
        let mut result = Swept::default();
        let mut graphs: Vec<u32> = (0..self.graphs.cells.len() as u32)
            .filter(|&i| self.free[i as usize] && !self.graphs.piece(i).vertical)
            .collect();
        graphs.sort_by(|&a, &b| {
            let (c, d) = (
                &self.graphs.cells[a as usize],
                &self.graphs.cells[b as usize],
            );
            c.from.total_cmp(&d.from).then(a.cmp(&b))
        });
        let mut active: Vec<u32> = Vec::new();
        let mut next = 0;
        let mut order: Vec<(f64, u32)> = Vec::new();
        for (lo, hi) in self.critical().windows(2).map(|w| (w[0].1, w[1].0)) {
            let middle = 0.5 * (lo + hi);
            active.retain(|&i| self.graphs.cells[i as usize].to > middle);
            while let Some(&i) = graphs.get(next) {
                if self.graphs.cells[i as usize].from >= middle {
                    break;
                }
                next += 1;
                if self.graphs.cells[i as usize].to > middle {
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
            let from = result.gaps.len() as u32;
            self.gaps((lo, hi), &order, &mut result);
            result.bands.push(Band {
                lo,
                hi,
                gaps: from..result.gaps.len() as u32,
            });
        }
        self.spans(&mut result);
        self.links(&mut result);
        result
    }

    /// Clusters of critical values: first and last of each.
    fn critical(&self) -> Vec<(f64, f64)> {
        let mut all = vec![self.x.lo, self.x.hi];
        for i in (0..self.graphs.cells.len() as u32).filter(|&i| self.free[i as usize]) {
            let (c, p) = (&self.graphs.cells[i as usize], self.graphs.piece(i));
            if p.vertical {
                all.push(p.start.x);
            } else {
                all.extend([c.from, c.to]);
            }
        }
        all.sort_by(f64::total_cmp);
        let mut clusters: Vec<(f64, f64)> = Vec::new();
        for x in all {
            match clusters.last_mut() {
                Some(last) if x - last.1 < NARROWEST => last.1 = x,
                _ => clusters.push((x, x)),
            }
        }
        clusters
    }

    /// The free gaps at the middle of a band, between cells in order of y.
    fn gaps(&self, (lo, hi): (f64, f64), order: &[(f64, u32)], result: &mut Swept) {
        let middle = 0.5 * (lo + hi);
        let y = self.graphs.y;
        let at = |o: Option<(f64, u32)>, limit: f64| o.map_or(limit, |o| o.0);
        let ends = match (order.first(), order.last()) {
            (Some(&first), Some(&last)) if y.is_circle() => {
                vec![(Some(last), Some((first.0 + TAU, first.1)))]
            }
            (first, last) => {
                let mut ends = vec![(None, first.copied())];
                ends.extend(last.map(|&last| (Some(last), None)));
                ends
            }
        };
        // Of a circle the gap across the cut comes last, of an interval the gap at its lower end first.
        let (before, after) = ends.split_at(usize::from(!y.is_circle() || order.is_empty()));
        let between = order.windows(2).map(|w| (Some(w[0]), Some(w[1])));
        let all = before
            .iter()
            .copied()
            .chain(between)
            .chain(after.iter().copied());
        for (lower, upper) in all {
            let (from, to) = (at(lower, y.lo), at(upper, y.hi));
            let certain = to - from >= CHECKED && hi - lo >= CHECKED;
            let said = self.said(lower, upper);
            let free = match said {
                Some(free) if !certain => free,
                // Curves on top of each other, facing the same way.
                None if lower.is_some() && to - from < TOO_NARROW => false,
                _ => {
                    result.tests += 1;
                    let free = !self.bodies.overlap(middle, from + TRIED_AT * (to - from));
                    let agreed = said == Some(free) || order.is_empty();
                    result.conflicts += usize::from(!agreed);
                    result.contradictions += usize::from(!agreed && certain);
                    free
                }
            };
            if free {
                result.gaps.push(self.gap(middle, lower, upper));
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
    fn links(&self, result: &mut Swept) {
        let mut links = Vec::new();
        let n = result.bands.len();
        let mut walls: Vec<(f64, (f64, f64))> = (0..self.graphs.cells.len() as u32)
            .filter(|&i| self.free[i as usize] && self.graphs.piece(i).vertical)
            .map(|i| {
                let c = &self.graphs.cells[i as usize];
                (self.graphs.piece(i).start.x, (c.from, c.to))
            })
            .collect();
        walls.sort_by(|a, b| a.0.total_cmp(&b.0));
        for k in 0..n {
            let last = k + 1 == n;
            if last && !self.x.is_circle() {
                break;
            }
            let (left, right) = (&result.bands[k], &result.bands[(k + 1) % n]);
            let from = walls.partition_point(|w| w.0 < left.hi);
            let to = walls.partition_point(|w| w.0 <= right.lo);
            let between = if last {
                [&walls[from..], &walls[..to]]
            } else {
                [&walls[from..to], &[]]
            };
            for a in left.gaps.clone() {
                let (p, q) = result.spans[a as usize][2];
                for b in right.gaps.clone() {
                    let (r, s) = result.spans[b as usize][0];
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
        result.links = links;
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
    fn spans(&self, result: &mut Swept) {
        for band in &result.bands {
            let middle = 0.5 * (band.lo + band.hi);
            for g in band.gaps.clone() {
                let gap = &result.gaps[g as usize];
                result
                    .spans
                    .push([band.lo, middle, band.hi].map(|x| self.graphs.interval(gap, x)));
            }
        }
    }
}

// The connected components of free space: gaps that hang together.

/// Walks through linked gaps, keeping count of turns.
pub(super) fn regions(swept: Swept, y: &Extent) -> Bands {
    let Swept {
        bands,
        mut gaps,
        spans,
        links,
        ..
    } = swept;
    let n = gaps.len();
    let mut regions: Vec<Region> = Vec::new();
    // The links of each gap, side by side.
    let mut beside: Vec<(u32, u32, i32, i32)> = Vec::with_capacity(2 * links.len());
    for l in &links {
        beside.push((l.from, l.to, l.x_turns, l.y_turns));
        beside.push((l.to, l.from, -l.x_turns, -l.y_turns));
    }
    beside.sort_unstable();
    let mut starts = vec![0usize; n + 1];
    for b in &beside {
        starts[b.0 as usize + 1] += 1;
    }
    for i in 0..n {
        starts[i + 1] += starts[i];
    }
    let mut band_of = vec![0u32; n];
    for (k, band) in (0u32..).zip(&bands) {
        for g in band.gaps.clone() {
            band_of[g as usize] = k;
        }
    }
    let mut turns = vec![(0, 0); n];
    for seed in 0..n as u32 {
        if gaps[seed as usize].region != u32::MAX {
            continue;
        }
        let index = regions.len() as u32;
        let mut region = Region {
            sample: (0.0, 0.0),
            x: (f64::INFINITY, f64::NEG_INFINITY),
            y: (f64::INFINITY, f64::NEG_INFINITY),
            around_x: false,
            around_y: false,
        };
        let mut largest = -1.0;
        let mut stack = vec![seed];
        gaps[seed as usize].region = index;
        while let Some(g) = stack.pop() {
            let (tx, ty) = turns[g as usize];
            let gap = gaps[g as usize];
            let band = &bands[band_of[g as usize] as usize];
            if gap.lower == gap.upper && y.is_circle() && gap.lower.is_none() {
                region.around_y = true;
            }
            let middle = 0.5 * (band.lo + band.hi);
            let size = |(p, q): (f64, f64)| q - p;
            let (dx, dy) = (TAU * f64::from(tx), TAU * f64::from(ty));
            let at = spans[g as usize][1];
            let measure = size(at).min(band.hi - band.lo);
            if measure > largest {
                largest = measure;
                // In the turn in which the walk came to it, as the region's ranges are.
                region.sample = (middle + dx, 0.5 * (at.0 + at.1) + dy);
            }
            region.x.0 = region.x.0.min(band.lo + dx);
            region.x.1 = region.x.1.max(band.hi + dx);
            for (p, q) in spans[g as usize] {
                region.y.0 = region.y.0.min(p + dy);
                region.y.1 = region.y.1.max(q + dy);
            }
            for &(_, other, dx, dy) in &beside[starts[g as usize]..starts[g as usize + 1]] {
                // The neighbour, seen from here, is dx turns of x and dy turns of y farther than where it is drawn.
                let there = (tx + dx, ty + dy);
                if gaps[other as usize].region == u32::MAX {
                    gaps[other as usize].region = index;
                    turns[other as usize] = there;
                    stack.push(other);
                } else {
                    let known = turns[other as usize];
                    region.around_x |= known.0 != there.0;
                    region.around_y |= known.1 != there.1;
                }
            }
        }
        regions.push(region);
    }
    Bands {
        bands,
        gaps,
        regions,
    }
}
