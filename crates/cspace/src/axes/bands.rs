//! Bands of x between critical values, the free gaps of y in each, and the free regions they join to.

use core::f64::consts::TAU;

use super::arrange::Cell;
use super::body::Bodies;
use super::domain::Extent;
use super::piece::{Pair, Piece};

/// Critical values nearer than this are one (radians or length).
const NARROWEST: f64 = crate::feature::tolerance::NARROWEST_BAND;
/// Gaps of neighbouring bands join where they share more than this (radians or length).
const SHORTEST: f64 = crate::feature::tolerance::SHORTEST_OVERLAP;

/// A gap narrower than this between curves that face the same way is none (radians or length): it is what rounding leaves
/// between curves that coincide.
const TOO_NARROW: f64 = 1e-11;

/// A free interval of y over a band.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
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
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub(super) struct Band {
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// Indices of its gaps, from the lowest.
    pub(super) gaps: core::ops::Range<u32>,
}

/// A connected component of free space.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub(super) struct Region {
    pub(super) sample: (f64, f64),
    pub(super) x: (f64, f64),
    pub(super) y: (f64, f64),
    pub(super) around_x: bool,
    pub(super) around_y: bool,
}

#[derive(Debug)]
pub(super) struct Bands {
    pub(super) bands: Vec<Band>,
    pub(super) gaps: Vec<Gap>,
    pub(super) regions: Vec<Region>,
    pub(super) conflicts: usize,
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
        self.piece(cell).y(self.pairs, x.clamp(c.from, c.to))
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
    pub(super) fn run(&self) -> Bands {
        let mut result = Bands {
            bands: Vec::new(),
            gaps: Vec::new(),
            regions: Vec::new(),
            conflicts: 0,
            tests: 0,
        };
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
            self.gaps(middle, &order, &mut result);
            result.bands.push(Band {
                lo,
                hi,
                gaps: from..result.gaps.len() as u32,
            });
        }
        self.join(&mut result);
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
    fn gaps(&self, middle: f64, order: &[(f64, u32)], result: &mut Bands) {
        let above = |i: u32| self.graphs.piece(i).root == 0;
        let n = order.len();
        let whole = |from: f64, to: f64| ((to - from) / TAU).round() as i32;
        let mut push = |lower: Option<u32>, upper: Option<(f64, u32)>| {
            let turns = if self.graphs.y.is_circle() {
                let of = |y: f64, i: u32| whole(self.graphs.at(i, middle), y);
                let low = lower.map_or(0, |i| {
                    of(self.graphs.y.folded(self.graphs.at(i, middle)), i)
                });
                (low, upper.map_or(0, |(y, i)| of(y, i)))
            } else {
                (0, 0)
            };
            result.gaps.push(Gap {
                lower,
                upper: upper.map(|u| u.1),
                turns,
                region: u32::MAX,
            });
        };
        if n == 0 {
            result.tests += 1;
            if !self
                .bodies
                .overlap(middle, 0.5 * (self.graphs.y.lo + self.graphs.y.hi))
            {
                push(None, None);
            }
            return;
        }
        let circle = self.graphs.y.is_circle();
        if !circle && !above(order[0].1) {
            push(None, Some(order[0]));
        }
        for k in 0..n {
            let (y, i) = order[k];
            let next = if k + 1 < n {
                Some(order[k + 1])
            } else if circle {
                Some((order[0].0 + TAU, order[0].1))
            } else {
                None
            };
            let free_below_next = next.map(|(_, j)| !above(j));
            let free = match free_below_next {
                None => above(i),
                Some(next_says) if next_says == above(i) => next_says,
                // Curves on top of each other, facing the same way.
                Some(_) if next.is_some_and(|n| n.0 - y < TOO_NARROW) => false,
                Some(_) => {
                    result.conflicts += 1;
                    result.tests += 1;
                    let to = next.map_or(self.graphs.y.hi, |n| n.0);
                    !self.bodies.overlap(middle, 0.5 * (y + to))
                }
            };
            if free {
                push(Some(i), next);
            }
        }
    }

    /// Joins gaps to regions.
    fn join(&self, result: &mut Bands) {
        // (gap, gap, turns of x, turns of y between them)
        let mut links: Vec<(u32, u32, i32, i32)> = Vec::new();
        let n = result.bands.len();
        for k in 0..n {
            let last = k + 1 == n;
            if last && !self.x.is_circle() {
                break;
            }
            let (left, right) = (&result.bands[k], &result.bands[(k + 1) % n]);
            for a in left.gaps.clone() {
                let (p, q) = self.graphs.interval(&result.gaps[a as usize], left.hi);
                for b in right.gaps.clone() {
                    let (r, s) = self.graphs.interval(&result.gaps[b as usize], right.lo);
                    let shifts = if self.graphs.y.is_circle() {
                        ((p - s) / TAU).ceil() as i32..=((q - r) / TAU).floor() as i32
                    } else {
                        0..=0
                    };
                    for turns in shifts {
                        let by = TAU * f64::from(turns);
                        if q.min(s + by) - p.max(r + by) > SHORTEST {
                            links.push((a, b, i32::from(last), turns));
                        }
                    }
                }
            }
        }
        self.collect(&links, result);
    }

    /// Walks through linked gaps, keeping count of turns.
    fn collect(&self, links: &[(u32, u32, i32, i32)], result: &mut Bands) {
        let n = result.gaps.len();
        let mut beside: Vec<Vec<(u32, i32, i32)>> = vec![Vec::new(); n];
        for &(a, b, dx, dy) in links {
            beside[a as usize].push((b, dx, dy));
            beside[b as usize].push((a, -dx, -dy));
        }
        let mut band_of = vec![0u32; n];
        for (k, band) in (0u32..).zip(&result.bands) {
            for g in band.gaps.clone() {
                band_of[g as usize] = k;
            }
        }
        let mut turns = vec![(0, 0); n];
        for seed in 0..n as u32 {
            if result.gaps[seed as usize].region != u32::MAX {
                continue;
            }
            let index = result.regions.len() as u32;
            let mut region = Region {
                sample: (0.0, 0.0),
                x: (f64::INFINITY, f64::NEG_INFINITY),
                y: (f64::INFINITY, f64::NEG_INFINITY),
                around_x: false,
                around_y: false,
            };
            let mut largest = -1.0;
            let mut stack = vec![seed];
            result.gaps[seed as usize].region = index;
            while let Some(g) = stack.pop() {
                let (tx, ty) = turns[g as usize];
                let gap = result.gaps[g as usize];
                let band = &result.bands[band_of[g as usize] as usize];
                if gap.lower == gap.upper && self.graphs.y.is_circle() && gap.lower.is_none() {
                    region.around_y = true;
                }
                let middle = 0.5 * (band.lo + band.hi);
                let size = |(p, q): (f64, f64)| q - p;
                let at = self.graphs.interval(&gap, middle);
                let measure = size(at).min(band.hi - band.lo);
                if measure > largest {
                    largest = measure;
                    region.sample = (middle, 0.5 * (at.0 + at.1));
                }
                let (dx, dy) = (TAU * f64::from(tx), TAU * f64::from(ty));
                region.x.0 = region.x.0.min(band.lo + dx);
                region.x.1 = region.x.1.max(band.hi + dx);
                for x in [band.lo, middle, band.hi] {
                    let (p, q) = self.graphs.interval(&gap, x);
                    region.y.0 = region.y.0.min(p + dy);
                    region.y.1 = region.y.1.max(q + dy);
                }
                for &(other, dx, dy) in &beside[g as usize] {
                    // The neighbour, seen from here, is dx turns of x and dy turns of y farther than where it is drawn.
                    let there = (tx + dx, ty + dy);
                    if result.gaps[other as usize].region == u32::MAX {
                        result.gaps[other as usize].region = index;
                        turns[other as usize] = there;
                        stack.push(other);
                    } else {
                        let known = turns[other as usize];
                        region.around_x |= known.0 != there.0;
                        region.around_y |= known.1 != there.1;
                    }
                }
            }
            result.regions.push(region);
        }
    }
}
