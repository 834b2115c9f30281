//! Events gathered into critical orientations.
//!
//! Every event is known within an error. Events whose intervals overlap, or that are nearer than the narrowest band,
//! make one cluster: one candidate for a critical orientation. From here on orientations are counted in clusters, and
//! structure is only ever looked at half way between two of them, away from every event.

use rayon::prelude::*;

use crate::feature::tolerance::NARROWEST_BAND;
use crate::number::Event;

/// Disjoint intervals of orientation, sorted; between two of them nothing happens.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Clusters {
    lo: Vec<f64>,
    hi: Vec<f64>,
}

impl Clusters {
    pub(super) fn new(mut events: Vec<Event>) -> Self {
        events.par_sort_unstable_by(|a, b| (a.theta - a.error).total_cmp(&(b.theta - b.error)));
        let mut this = Self::default();
        for e in events {
            let (lo, hi) = (e.theta - e.error, e.theta + e.error);
            match this.hi.last_mut() {
                Some(last) if lo <= *last + NARROWEST_BAND => *last = last.max(hi),
                _ => {
                    this.lo.push(lo);
                    this.hi.push(hi);
                }
            }
        }
        this
    }

    /// These clusters with more events, and where each of the old ones went.
    pub(super) fn with(&self, more: Vec<Event>) -> (Self, Vec<u32>) {
        let mut events = more;
        events.extend((0..self.lo.len()).map(|i| Event {
            theta: 0.5 * (self.lo[i] + self.hi[i]),
            error: 0.5 * (self.hi[i] - self.lo[i]),
        }));
        let merged = Self::new(events);
        let moved = (0..self.lo.len())
            .map(|i| merged.index(0.5 * (self.lo[i] + self.hi[i])))
            .collect();
        (merged, moved)
    }

    pub(super) fn len(&self) -> usize {
        self.lo.len()
    }

    /// The cluster an orientation belongs to: the last that does not begin after it.
    pub(super) fn index(&self, theta: f64) -> u32 {
        self.lo.partition_point(|&lo| lo <= theta).max(1) as u32 - 1
    }

    /// An orientation in the cluster.
    pub(super) fn at(&self, i: u32) -> f64 {
        0.5 * (self.lo[i as usize] + self.hi[i as usize])
    }

    /// Where the cluster begins.
    pub(super) fn lo(&self, i: u32) -> f64 {
        self.lo[i as usize]
    }

    /// Where it ends.
    pub(super) fn hi(&self, i: u32) -> f64 {
        self.hi[i as usize]
    }

    /// Half way from one cluster to another.
    pub(super) fn between(&self, i: u32, j: u32) -> f64 {
        0.5 * (self.hi[i as usize] + self.lo[j as usize])
    }
}
