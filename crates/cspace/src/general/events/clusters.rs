//! Clusters: events gathered into critical orientations.
//!
//! Every event is known within an error. Events whose intervals overlap make one cluster: one candidate for a critical orientation. From
//! here on orientations are counted in clusters, and structure is determined only half way between two of them, away from every event.

use crate::contact::Exact;
use crate::geometry::Rotation;
use crate::number::Event;
use crate::parallel;

/// An orientation at which something may happen, in double-double, and its error (radians).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Moment {
    pub(crate) theta: Exact,
    pub(crate) error: f64,
}

impl From<Event> for Moment {
    fn from(e: Event) -> Self {
        Self {
            theta: Exact::from(e.theta),
            error: e.error,
        }
    }
}

/// Disjoint intervals of orientation, sorted; between two of them there is no event.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct Clusters {
    lo: Vec<Exact>,
    hi: Vec<Exact>,
    /// The most accurate event of each: the orientation at which curves and places are measured.
    best: Vec<Moment>,
    /// The rotations by these orientations.
    turns: Vec<Rotation>,
}

/// Maximum distance from a cluster of an orientation just beside it, radians: there, carriers that coincide at the cluster are apart by
/// more than rounding, and the quadratic part of their motion is smaller than that.
const BESIDE: f64 = 1.0 / (1u64 << 20) as f64;

/// Distance of clusters (radians) below which they are close: then double-double is used between them.
const CLOSE: f64 = 1e-5;

/// Distance of orientations (radians) below which they are one: above the rounding of double-double, and below the distances in a generic
/// drawing. Events separated by vertices moved by 10⁻¹³ are as near as the square of that.
pub(crate) const SAME: f64 = 1e-28;

/// Added to the errors of events found between clusters, radians, when the most accurate event is chosen.
const BETWEEN: f64 = 1.0;

impl Clusters {
    pub(crate) fn new(events: impl IntoIterator<Item = Moment>) -> Self {
        let events = events.into_iter().collect();
        Self::gather(events, |e: &Moment| {
            (e.theta - e.error, e.theta + e.error, *e)
        })
    }

    /// Gathers clusters from items that have intervals with their most accurate event: items are many, and single events are small.
    fn gather<T: Send>(
        mut all: Vec<T>,
        interval: impl Fn(&T) -> (Exact, Exact, Moment) + Sync,
    ) -> Self {
        parallel::sort_unstable_by(&mut all, |a, b| {
            let (a, b) = (interval(a), interval(b));
            a.0.total_cmp(&b.0)
                .then(a.2.error.total_cmp(&b.2.error))
                .then(a.2.theta.total_cmp(&b.2.theta))
        });
        let mut this = Self::default();
        for (lo, hi, e) in all.iter().map(interval) {
            match (this.hi.last_mut(), this.best.last_mut()) {
                (Some(last), Some(best)) if lo <= *last + SAME => {
                    if hi > *last {
                        *last = hi;
                    }
                    if e.error < best.error {
                        *best = e;
                    }
                }
                _ => {
                    this.lo.push(lo);
                    this.hi.push(hi);
                    this.best.push(e);
                }
            }
        }
        this.turns = (this.best.iter())
            .map(|e| Rotation::by(e.theta.to_f64()))
            .collect();
        this
    }

    /// These clusters with more events that were found between them, and the new number of each old cluster.
    ///
    /// Such an event at the very end of a cluster is a trace of an event within the cluster: an event of the cluster counts as more
    /// accurate, however small the other's error is.
    pub(crate) fn with(&self, more: Vec<Moment>) -> (Self, Vec<u32>) {
        let mut intervals: Vec<_> = more
            .into_iter()
            .map(|e| {
                let between = Moment {
                    error: e.error + BETWEEN,
                    ..e
                };
                (e.theta - e.error, e.theta + e.error, between)
            })
            .collect();
        intervals.extend((0..self.lo.len()).map(|i| (self.lo[i], self.hi[i], self.best[i])));
        let merged = Self::gather(intervals, |i| *i);
        let moved = self.best.iter().map(|e| merged.index(e.theta)).collect();
        (merged, moved)
    }

    /// These clusters with each of some runs, from a first to a last, merged; and the new number of each old cluster.
    pub(crate) fn contracted(&self, runs: &[(u32, u32)]) -> (Self, Vec<u32>) {
        let mut this = Self::default();
        let mut moved = Vec::with_capacity(self.len());
        let mut runs = runs.iter().peekable();
        let mut i = 0;
        while i < self.len() {
            let last = match runs.next_if(|run| run.0 as usize == i) {
                Some(run) => run.1 as usize,
                None => i,
            };
            let middle = i.midpoint(last);
            this.lo.push(self.lo[i]);
            this.hi.push(self.hi[last]);
            this.best.push(self.best[middle]);
            this.turns.push(self.turns[middle]);
            moved.resize(last + 1, this.len() as u32 - 1);
            i = last + 1;
        }
        (this, moved)
    }

    pub(crate) fn len(&self) -> usize {
        self.lo.len()
    }

    /// The cluster an orientation belongs to: the last that does not begin after it.
    pub(crate) fn index(&self, theta: Exact) -> u32 {
        self.lo.partition_point(|&lo| lo <= theta).max(1) as u32 - 1
    }

    /// The orientation in the cluster whose event is known best.
    pub(crate) fn at(&self, i: u32) -> f64 {
        self.exact_at(i).to_f64()
    }

    /// The orientation [`at`](Self::at) in double-double.
    pub(crate) fn exact_at(&self, i: u32) -> Exact {
        self.best[i as usize].theta
    }

    /// The rotation by [`at`](Self::at).
    pub(crate) fn turn(&self, i: u32) -> Rotation {
        self.turns[i as usize]
    }

    /// Beginning of the cluster.
    pub(crate) fn lo(&self, i: u32) -> f64 {
        self.lo[i as usize].to_f64()
    }

    /// End of the cluster.
    pub(crate) fn hi(&self, i: u32) -> f64 {
        self.hi[i as usize].to_f64()
    }

    /// End of a cluster, and beginning of another, in double-double.
    pub(crate) fn exactly_between(&self, i: u32, j: u32) -> (Exact, Exact) {
        (self.hi[i as usize], self.lo[j as usize])
    }

    /// Distance from the end of one cluster to the beginning of another, radians.
    pub(crate) fn duration(&self, i: u32, j: u32) -> f64 {
        (self.lo[j as usize] - self.hi[i as usize]).to_f64()
    }

    /// Whether two clusters are close.
    pub(crate) fn are_close(&self, i: u32, j: u32) -> bool {
        self.duration(i, j) < CLOSE
    }

    /// Middle between one cluster and another.
    pub(crate) fn between(&self, i: u32, j: u32) -> f64 {
        self.exact_between(i, j).to_f64()
    }

    /// The middle [`between`](Self::between) two clusters in double-double.
    pub(crate) fn exact_between(&self, i: u32, j: u32) -> Exact {
        (self.hi[i as usize] + self.lo[j as usize]).scaled(0.5)
    }

    /// Width of the cluster, radians.
    pub(crate) fn width(&self, i: u32) -> f64 {
        (self.hi[i as usize] - self.lo[i as usize]).to_f64()
    }

    /// Orientations just below and above a cluster, where places have hardly moved: at most [`BESIDE`] from its ends.
    pub(crate) fn exactly_beside(&self, i: u32) -> (Exact, Exact) {
        let (below, above) = (self.exact_below(i), self.exact_above(i));
        let near = (self.lo[i as usize] - BESIDE, self.hi[i as usize] + BESIDE);
        (
            if below > near.0 { below } else { near.0 },
            if above < near.1 { above } else { near.1 },
        )
    }

    /// Middle between the cluster and the one before, or at the cluster if there is none.
    pub(crate) fn exact_below(&self, i: u32) -> Exact {
        self.exact_between(i.max(1) - 1, i)
    }

    /// Middle between the cluster and the one after, or at the cluster if there is none.
    pub(crate) fn exact_above(&self, i: u32) -> Exact {
        self.exact_between(i, (i + 1).min(self.len() as u32 - 1))
    }

    /// The ends of a cluster in double-double.
    pub(crate) fn exact_ends(&self, i: u32) -> (Exact, Exact) {
        (self.lo[i as usize], self.hi[i as usize])
    }
}
