//! Copies of every patch of one period over all orientations.

use core::f64::consts::{PI, TAU};
use core::ops::Range;

use crate::contact::Steps;
use crate::feature::tolerance::NARROWEST_BAND;
use crate::geometry::unwrap_near;
use crate::parallel;

use crate::general::events::clusters::Clusters;
use crate::general::links::chains::{Chain, ClusterInPeriod};
use crate::space::Window;

/// The copies of one chain: patches with consecutive numbers from `base`, the first of them moved up by `first` periods.
#[derive(Debug, Clone, Copy)]
struct Copies {
    base: u32,
    first: i64,
    count: u32,
    closed: bool,
}

/// Copies of chains shifted by whole periods (figure 4 of Sacks 1999), as far as they overlap the window.
pub(crate) struct Lifts<'a> {
    pub(crate) steps: Steps,
    window: Window,
    /// Whether the chains are those of a period that repeats.
    repeats: bool,
    clusters: &'a Clusters,
    copies: Vec<Copies>,
}

impl<'a> Lifts<'a> {
    /// Copies of the chains in a window. `repeats`: the chains are those of a full turn or a period of it, not those of a window with its
    /// margin.
    pub(crate) fn new(
        chains: &[Chain],
        window: Window,
        steps: Steps,
        repeats: bool,
        clusters: &'a Clusters,
    ) -> Self {
        let mut this = Self {
            steps,
            window,
            repeats,
            clusters,
            copies: Vec::with_capacity(chains.len()),
        };
        let mut base = 0;
        for chain in chains {
            let (first, count) = if window.full_turn || chain.closed {
                (0, steps.slabs)
            } else {
                this.within(chain.lo, chain.hi)
            };
            this.copies.push(Copies {
                base,
                first,
                count,
                closed: chain.closed,
            });
            base = base.saturating_add(count);
        }
        this
    }

    /// Number of patches.
    pub(crate) fn len(&self) -> usize {
        self.copies
            .last()
            .map_or(0, |c| (c.base.saturating_add(c.count)) as usize)
    }

    /// The shifts, in periods, with which an interval has more than the narrowest band, or than half of the window if that is less, in the
    /// window: first and number.
    fn within(&self, lo: f64, hi: f64) -> (i64, u32) {
        let least = NARROWEST_BAND.min(0.5 * (self.window.hi - self.window.lo));
        if !self.repeats {
            let overlap = hi.min(self.window.hi) - lo.max(self.window.lo);
            return (0, u32::from(overlap > least));
        }
        let period = self.steps.period(1);
        let first = ((self.window.lo + least - hi) / period).ceil();
        let last = ((self.window.hi - least - lo) / period).floor();
        (first as i64, (last - first + 1.0).max(0.0) as u32)
    }

    /// The shifts with which an interval of the period must be examined.
    pub(crate) fn shifts(&self, lo: f64, hi: f64) -> Range<i64> {
        let (first, count) = if self.window.full_turn {
            (0, self.steps.slabs)
        } else {
            self.within(lo, hi)
        };
        first..first + i64::from(count)
    }

    /// All shifts, if they are equal for every interval.
    pub(crate) fn all_slabs(&self) -> Option<Range<i64>> {
        (self.window.full_turn).then(|| 0..i64::from(self.steps.slabs))
    }

    /// The shifts of the patches of a chain, with their numbers.
    pub(crate) fn patches(&self, chain: u32) -> impl Iterator<Item = (i64, u32)> + use<> {
        let c = self.copies[chain as usize];
        (c.first..).zip(c.base..c.base + c.count)
    }

    /// The chain of a patch, and the number of periods by which it is shifted.
    pub(crate) fn chain_of(&self, patch: u32) -> (u32, i64) {
        // A chain without patches has the number of the next chain's first patch.
        let chain = self.copies.partition_point(|c| c.base <= patch) - 1;
        let c = self.copies[chain];
        (chain as u32, c.first + i64::from(patch - c.base))
    }

    /// The patch of a chain shifted by some periods, if it is in the window.
    pub(crate) fn patch(&self, chain: u32, slabs: i64) -> Option<u32> {
        let c = self.copies[chain as usize];
        let i = if self.around(c.closed) {
            slabs.rem_euclid(i64::from(self.steps.slabs))
        } else {
            slabs - c.first
        };
        (0..i64::from(c.count))
            .contains(&i)
            .then(|| c.base + i as u32)
    }

    /// Whether two shifts of a chain give the same patch.
    pub(crate) fn is_one_copy(&self, chain: u32, slabs: i64, other: i64) -> bool {
        if self.around(self.copies[chain as usize].closed) {
            (slabs - other) % i64::from(self.steps.slabs) == 0
        } else {
            slabs == other
        }
    }

    /// Whether shifts by a whole turn give the same copy.
    fn around(&self, closed: bool) -> bool {
        self.repeats && (self.window.full_turn || closed)
    }

    /// The orientation of a place shifted by some periods: in [−π, π) for a full turn. One orientation always gives the same number,
    /// whichever period it is counted from.
    pub(crate) fn orientation(&self, place: ClusterInPeriod, slabs: i64) -> f64 {
        if !self.repeats {
            return self.clusters.at(place.cluster);
        }
        let mut slabs = slabs + i64::from(place.slabs);
        let mut cluster = place.cluster;
        // The end of a period is the beginning of the next.
        if cluster as usize + 1 == self.clusters.len() {
            (cluster, slabs) = (0, slabs + 1);
        }
        let phase = self.clusters.at(cluster);
        if self.window.full_turn {
            let slabs = slabs.rem_euclid(i64::from(self.steps.slabs));
            normalized(phase + self.steps.period(slabs))
        } else {
            phase + self.steps.period(slabs)
        }
    }

    /// The orientations of a chain shifted by some periods, limited to the window.
    pub(crate) fn interval(&self, chain: &Chain, slabs: i64) -> (f64, f64) {
        if self.around(false) {
            let lo = self.orientation(chain.from, slabs);
            if chain.closed {
                return (lo, lo + TAU);
            }
            let hi = self.orientation(chain.to, slabs);
            return (lo, unwrap_near(hi, lo + (chain.hi - chain.lo)));
        }
        if chain.closed {
            return (self.window.lo, self.window.hi);
        }
        let (lo, hi) = (chain.from, chain.to);
        self.clipped(self.orientation(lo, slabs), self.orientation(hi, slabs))
    }

    /// The part of an interval that is in the window, if the window is not the full turn; an interval that ends within the narrowest band
    /// of the window's end ends there.
    pub(crate) fn clipped(&self, lo: f64, hi: f64) -> (f64, f64) {
        if self.window.full_turn {
            return (lo, hi);
        }
        let Window {
            lo: first,
            hi: last,
            ..
        } = self.window;
        (
            if lo > first + NARROWEST_BAND {
                lo
            } else {
                first
            },
            if hi < last - NARROWEST_BAND { hi } else { last },
        )
    }

    /// Whether an orientation of an event is inside the window, not at its end.
    pub(crate) fn is_inside(&self, theta: f64) -> bool {
        let Window { lo, hi, full_turn } = self.window;
        full_turn || (lo + NARROWEST_BAND < theta && theta < hi - NARROWEST_BAND)
    }

    /// Whether the window contains a chain as a whole.
    pub(crate) fn is_whole(&self, chain: &Chain, slabs: i64) -> bool {
        let inside = |place| self.is_inside(self.orientation(place, slabs));
        self.window.full_turn || (!chain.closed && inside(chain.from) && inside(chain.to))
    }

    /// An orientation moved by whole turns near an expected one.
    pub(crate) fn near(&self, theta: f64, expected: f64) -> f64 {
        if self.around(false) {
            unwrap_near(theta, expected)
        } else {
            theta
        }
    }

    /// Orientations, other than the window's own ends, at which a patch begins or ends.
    pub(crate) fn critical_orientations(&self, chains: &[Chain]) -> Vec<f64> {
        // Places, each once: for a full turn they are the same in all periods.
        let mut places: Vec<(u32, i64)> = Vec::new();
        for (i, chain) in (0u32..).zip(chains).filter(|(_, c)| !c.closed) {
            let ends = [chain.from, chain.to];
            if self.around(false) {
                places.extend(ends.map(|p| (p.cluster, 0)));
            } else {
                let shifts = self.patches(i).map(|(slabs, _)| slabs);
                places
                    .extend(shifts.flat_map(|s| ends.map(|p| (p.cluster, s + i64::from(p.slabs)))));
            }
        }
        parallel::sort_unstable_by(&mut places, Ord::cmp);
        places.dedup();
        let shifts = if self.around(false) {
            self.steps.slabs
        } else {
            1
        };
        let mut all: Vec<f64> = (places.into_iter())
            .flat_map(|(cluster, slabs)| {
                let place = ClusterInPeriod { cluster, slabs: 0 };
                (0..i64::from(shifts)).map(move |s| self.orientation(place, slabs + s))
            })
            .collect();
        all.retain(|&t| self.is_inside(t));
        parallel::sort_unstable_by(&mut all, f64::total_cmp);
        all.dedup_by(|b, a| *b - *a <= SAME_ORIENTATION);
        all
    }

    /// Number of bands computed: those of one period, if the space repeats.
    pub(crate) fn computed_bands(&self, chains: &[Chain], bands: usize) -> usize {
        if !self.repeats {
            return bands;
        }
        let cut = self.clusters.len() as u32 - 1;
        let mut ends: Vec<u32> = (chains.iter().filter(|c| !c.closed))
            .flat_map(|c| [c.from.cluster % cut, c.to.cluster % cut])
            .collect();
        ends.sort_unstable();
        ends.dedup();
        ends.len().max(1)
    }
}

/// Distance of orientations, radians, below which they are one that was split by rounding.
const SAME_ORIENTATION: f64 = 8.0 * f64::EPSILON;

/// Reduces an orientation to [−π, π); half a turn gives −π, on whichever side of it rounding or the perturbation of the parts has put it.
pub(crate) fn normalized(theta: f64) -> f64 {
    let t = theta - TAU * ((theta + PI) / TAU).floor();
    if (t - PI).abs() <= NARROWEST_BAND || (t + PI).abs() <= NARROWEST_BAND {
        -PI
    } else if t >= PI {
        t - TAU
    } else {
        t
    }
}

#[cfg(test)]
mod tests;
