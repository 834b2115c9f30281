//! A mode: what of each coordinate it reaches, and around which it closes.

use core::cmp::Ordering;
use core::f64::consts::{PI, TAU};

use crate::modes::extent::Extent;
use crate::modes::shape::Shape;

/// An operating mode: a connected component of the free space of three parts. Two free configurations can be joined by a motion
/// of the three parts if and only if they are in one mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// A configuration (u, v, w) within it.
    pub sample: [f64; 3],
    /// Minimum and maximum u, v and w, in radians or the model's unit of length. A coordinate that goes on past a turn
    /// is unrolled; the range of one around which the mode closes is a full turn.
    pub ranges: [(f64, f64); 3],
    /// Whether each coordinate is unbounded below its minimum and above its maximum.
    pub open: [(bool, bool); 3],
    /// The turns (of u, v and w) by which motions within the mode come back to where they began: all of them are sums of whole
    /// multiples of these, three at most.
    pub turns: Vec<[i64; 3]>,
}

impl Mode {
    /// Whether the mode closes on itself around a coordinate: the part can turn without end, with the others or alone.
    pub fn around(&self, coordinate: usize) -> bool {
        self.turns
            .iter()
            .any(|t| t.get(coordinate).is_some_and(|&t| t != 0))
    }
}

/// The ranges of a mode's coordinates, and a sample.
type Reached<'a> = (&'a [(f64, f64)], &'a [f64]);

/// Modes by the minimum of each coordinate, then by the maximum, then by the sample, which `of` gives; `mode_of` has their numbers and gets
/// the new ones.
pub(crate) fn in_order<M>(
    modes: impl IntoIterator<Item = M>,
    of: fn(&M) -> Reached<'_>,
    mode_of: &mut [u32],
) -> Vec<M> {
    let key = |m: &M| -> Vec<f64> {
        let (ranges, sample) = of(m);
        let (lo, hi) = (ranges.iter().map(|r| r.0), ranges.iter().map(|r| r.1));
        lo.chain(hi).chain(sample.iter().copied()).collect()
    };
    // Ends that differ only by rounding are equal.
    let compare = |(x, y): (&f64, &f64)| match (x - y).abs() < 1e-9 * (1.0 + x.abs()) {
        true => Ordering::Equal,
        false => x.total_cmp(y),
    };
    let order =
        |a: &[f64], b: &[f64]| (a.iter().zip(b).map(compare)).fold(Ordering::Equal, Ordering::then);
    let mut modes: Vec<(usize, Vec<f64>, M)> = (modes.into_iter().enumerate())
        .map(|(old, mode)| (old, key(&mode), mode))
        .collect();
    modes.sort_by(|(_, a, _), (_, b, _)| order(a, b));
    let mut place = vec![0; modes.len()];
    for (new, (old, _, _)) in modes.iter().enumerate() {
        place[*old] = new as u32;
    }
    for mode in mode_of {
        *mode = place[*mode as usize];
    }
    modes.into_iter().map(|(_, _, mode)| mode).collect()
}

/// State of a mode while its cells are collected; coordinates are s, p and q.
pub(crate) struct Gathered {
    turns: Vec<[i64; 3]>,
    extents: [Extent; 3],
    ranges: [(f64, f64); 3],
    sample: [f64; 3],
    /// Size of the cell that holds the sample, as a share of the extents.
    largest: f64,
}

impl Gathered {
    pub(crate) fn new(turns: Vec<[i64; 3]>, extents: [Extent; 3]) -> Self {
        Self {
            turns,
            extents,
            ranges: [(f64::INFINITY, f64::NEG_INFINITY); 3],
            sample: [0.0; 3],
            largest: -1.0,
        }
    }

    /// Adds a cell, displaced by `by` from the origin of the mode's turns.
    pub(crate) fn add(&mut self, shape: &Shape<'_>, by: [f64; 3]) {
        let hulls = shape.hulls();
        let (lo, hi) = shape.s;
        let s = &mut self.ranges[0];
        *s = (s.0.min(lo + by[0]), s.1.max(hi + by[0]));
        let is_wider = |known: (f64, f64), hull: (f64, f64), by: f64| {
            hull.0 + by < known.0 || hull.1 + by > known.1
        };
        if is_wider(self.ranges[1], hulls[0], by[1]) {
            let (lo, hi) = shape.p_range();
            let p = &mut self.ranges[1];
            *p = (p.0.min(lo + by[1]), p.1.max(hi + by[1]));
        }
        if is_wider(self.ranges[2], hulls[1], by[2]) {
            let (lo, hi) = shape.q_range();
            let q = &mut self.ranges[2];
            *q = (q.0.min(lo + by[2]), q.1.max(hi + by[2]));
        }
        let share =
            |(lo, hi): (f64, f64), k: usize| (hi - lo) / (self.extents[k].hi - self.extents[k].lo);
        if share((lo, hi), 0) <= self.largest || share(hulls[0], 1) <= self.largest {
            return;
        }
        let s = 0.5 * (lo + hi);
        let p = shape.p(s);
        let at = 0.5 * (p.0 + p.1);
        let q = shape.q_at(s, at);
        let size = share((lo, hi), 0).min(share(p, 1)).min(share(q, 2));
        if size > self.largest {
            self.largest = size;
            self.sample = [s + by[0], at + by[1], 0.5 * (q.0 + q.1) + by[2]];
        }
    }

    /// Mode with s, p and q assigned to u, v and w by `order`.
    pub(crate) fn mode(self, order: [usize; 3], open: [bool; 3]) -> Mode {
        let mut mode = Mode {
            sample: [0.0; 3],
            ranges: [(0.0, 0.0); 3],
            open: [(false, false); 3],
            turns: Vec::new(),
        };
        for (k, &to) in order.iter().enumerate() {
            let (mut range, mut sample) = (self.ranges[k], self.sample[k]);
            let extent = &self.extents[k];
            if extent.circle {
                if self.turns.iter().any(|t| t[k] != 0) {
                    range = (-PI, PI);
                    sample -= TAU * ((sample + PI) / TAU).floor();
                } else {
                    let turns = TAU * ((range.0 + PI) / TAU).floor();
                    range = (range.0 - turns, range.1 - turns);
                    sample -= turns;
                }
            }
            let near = |a: f64, b: f64| (a - b).abs() <= extent.opening;
            mode.ranges[to] = range;
            mode.sample[to] = sample;
            mode.open[to] = (
                open[to] && near(range.0, extent.lo),
                open[to] && near(range.1, extent.hi),
            );
        }
        let turned = |row: &[i64; 3]| {
            let mut turns = [0; 3];
            for (k, &to) in order.iter().enumerate() {
                turns[to] = row[k];
            }
            turns
        };
        mode.turns = crate::modes::turns::reduced(self.turns.iter().map(turned));
        mode
    }
}
