//! Doubtful and critical orientations near each interval of orientation.

use core::ops::Range;

use crate::space::ContactSpace;

use super::grid::{Grid, MARGIN};
use super::slab::{ASIDE, Home, Slab};

/// For every interval, the doubtful intervals and the critical orientations near it, by number: the first, and one past the last.
#[derive(Debug, Clone)]
pub(super) struct Nearby {
    slots: Vec<Near>,
    /// Distance from the beginning of the period above which orientations are next to the end of a turn (radians).
    seam: f64,
}

#[derive(Debug, Clone, Copy, Default)]
struct Near {
    doubts: (u32, u32),
    critical: (u32, u32),
}

impl Nearby {
    pub(super) fn new(space: &ContactSpace, grid: &Grid, slab: &Slab) -> Self {
        let critical = space.critical_orientations();
        let count = |within: Range<usize>| (within.start as u32, within.end as u32);
        let mut slots: Vec<Near> = (0..grid.slots)
            .map(|slot| {
                let (lo, hi) = grid.wider(slot);
                let before = |theta: f64| critical.partition_point(|&c| c < theta);
                Near {
                    // The intervals of a whole turn begin where the doubtful intervals do.
                    doubts: if slab.count == 1 {
                        count(between(space.doubtful_orientations(), lo, hi))
                    } else {
                        (0, 0)
                    },
                    critical: count(before(lo)..before(hi)),
                }
            })
            .collect();
        if slab.count > 1 {
            let doubts = space.doubtful_orientations();
            for &(lo, hi) in doubts {
                for slot in slots_between(grid, slab, lo - MARGIN, hi + MARGIN) {
                    slots[slot].doubts = (0, doubts.len() as u32);
                }
            }
        }
        Self {
            slots,
            seam: slab.hi - slab.lo - ASIDE,
        }
    }

    /// Whether patches alone do not decide at an orientation, which has been reduced to an interval.
    #[inline]
    pub(super) fn is_doubtful(&self, space: &ContactSpace, slot: usize, theta: f64) -> bool {
        let (first, end) = self.slots[slot].doubts;
        first < end
            && space
                .surface()
                .doubts()
                .hold_among(theta, first as usize..end as usize)
    }

    /// Whether an orientation may be critical, up to rounding.
    #[inline]
    pub(super) fn is_critical(
        &self,
        space: &ContactSpace,
        slot: usize,
        home: Home,
        lo: f64,
    ) -> bool {
        let (first, end) = self.slots[slot].critical;
        let near = &space.critical_orientations()[first as usize..end as usize];
        let theta = lo + home.from_lo;
        home.from_lo >= self.seam || near.iter().any(|c| (c - theta).abs() <= ASIDE)
    }

    /// Number of bytes in memory, without itself.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.slots.as_slice())
    }
}

/// Numbers of the doubtful intervals that overlap `lo` to `hi`, which are not reduced by turns.
fn between(doubts: &[(f64, f64)], lo: f64, hi: f64) -> Range<usize> {
    let first = doubts.partition_point(|d| d.1 < lo);
    let end = doubts.partition_point(|d| d.0 <= hi);
    first..end.max(first)
}

/// The intervals that overlap the orientations from `lo` to `hi`, in any period.
fn slots_between(grid: &Grid, slab: &Slab, lo: f64, hi: f64) -> impl Iterator<Item = usize> {
    let period = slab.hi - slab.lo;
    let place = |theta: f64| ((theta - slab.lo) / period).floor();
    let (first, last) = (place(lo), place(hi));
    // A range longer than a period reaches all intervals of the second.
    let second = (last > first).then(|| {
        let by = period * (first + 1.0);
        grid.slots_between(slab.lo, hi - by)
    });
    let by = period * first;
    let first = grid.slots_between(lo - by, hi - by);
    first.chain(second.into_iter().flatten())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn doubts_are_found_by_number() {
        let doubts = [(-3.2, -2.98), (0.5, 0.8), (3.0, 3.2)];
        assert_eq!(between(&doubts, 0.0, 1.0), 1..2);
        assert_eq!(between(&doubts, 0.9, 2.0), 2..2);
        assert_eq!(between(&doubts, -4.0, 4.0), 0..3);
    }
}
