//! Ranges of a coordinate, found by place.

use super::motion::Extent;
use super::tolerance::NEAR;
use crate::grouped::Grouped;
use core::f64::consts::TAU;

/// An extent divided into slots of one width, and for each the ranges that reach into it, by number.
#[derive(Debug)]
pub(super) struct Slots {
    extent: Extent,
    count: i64,
    ranges: Grouped,
}

impl Slots {
    pub(super) fn new(
        extent: Extent,
        count: i64,
        ranges: impl Iterator<Item = (f64, f64)>,
    ) -> Self {
        let ranges: Vec<(f64, f64)> = ranges.collect();
        let reached = (0u32..).zip(&ranges).flat_map(|(i, &(lo, hi))| {
            let slots = reached(&extent, count, lo, hi);
            slots.map(move |slot| (slot as u32, i))
        });
        Self {
            ranges: Grouped::new(count as usize, reached),
            extent,
            count,
        }
    }

    /// All ranges no farther from a value than `reach`, some perhaps several times, and some that are farther.
    pub(super) fn near(&self, t: f64, reach: f64) -> impl Iterator<Item = u32> + '_ {
        self.between(t - reach, t + reach)
    }

    /// The same of those that reach between two values.
    pub(super) fn between(&self, lo: f64, hi: f64) -> impl Iterator<Item = u32> + '_ {
        let slots = reached(&self.extent, self.count, lo, hi);
        slots.flat_map(|slot| self.ranges.of(slot as u32).iter().copied())
    }

    /// All no farther than `reach`, each once and in order.
    pub(super) fn near_in_order(&self, t: f64, reach: f64) -> Vec<u32> {
        let mut found: Vec<u32> = self.near(t, reach).collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// The slots into which an interval reaches, give or take what rounding may move it. Those beyond an end of the extent are
/// the one at that end, or on a circle those at the other.
fn reached(
    extent: &Extent,
    count: i64,
    lo: f64,
    hi: f64,
) -> impl Iterator<Item = usize> + Clone + use<> {
    let (first, last, circle) = (extent.lo, extent.hi, extent.is_circle());
    let slot = |t: f64| ((t - first) / (last - first) * count as f64).floor() as i64;
    let (from, to) = (slot(lo - NEAR), slot(hi + NEAR));
    let (from, to) = match circle {
        true if hi - lo >= TAU || to.saturating_sub(from) >= count => (0, count - 1),
        true => (from, to),
        false => (from.clamp(0, count - 1), to.clamp(0, count - 1)),
    };
    (from..=to).map(move |slot| slot.rem_euclid(count) as usize)
}
