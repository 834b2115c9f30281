//! Which patches may exist at an orientation, without a look at each of them.

use core::f64::consts::{PI, TAU};

use crate::grouped::Grouped;

use super::options::Window;
use super::patch::Patch;

/// Patches are listed where they begin and end by so much more (radians): more than what rounding does to orientations, and to
/// turns of them.
const SLACK: f64 = 1e-9;

/// Orientations farther from zero than this (radians, some hundred turns) are rounded by more than what [`SLACK`] is for.
const FARTHEST_ORIENTATION: f64 = 1024.0;

/// Equal intervals of orientation, as long as patches are in the mean, with the patches that come to each: those that exist at
/// an orientation are about half of them.
#[derive(Debug, Clone)]
pub(crate) struct Alive {
    lo: f64,
    full_turn: bool,
    /// Intervals per radian, and their number.
    density: f64,
    count: usize,
    patches: Grouped,
}

impl Alive {
    pub(crate) fn new(window: Window, patches: &[Patch]) -> Self {
        let (lo, hi) = if window.full_turn {
            (-PI, PI)
        } else {
            (window.lo, window.hi)
        };
        let lengths: f64 = patches.iter().map(|p| p.hi - p.lo).sum();
        let most = patches.len().max(1) as f64;
        let count = (most * (hi - lo) / lengths).clamp(1.0, most);
        let mut this = Self {
            lo,
            full_turn: window.full_turn,
            density: count.floor() / (hi - lo),
            count: count as usize,
            patches: Grouped::default(),
        };
        let places = (0u32..)
            .zip(patches)
            .flat_map(|(i, patch)| this.intervals(patch).map(move |place| (place, i)));
        this.patches = Grouped::new(this.count, places);
        this
    }

    /// The intervals that a patch comes to, each once.
    fn intervals(&self, patch: &Patch) -> impl Iterator<Item = u32> + Clone + use<> {
        let place = |theta: f64| ((theta - self.lo) * self.density).floor() as i64;
        let (first, last) = (place(patch.lo - SLACK), place(patch.hi + SLACK));
        let (count, full_turn) = (self.count as i64, self.full_turn);
        let places = if full_turn {
            first..=last.min(first + count - 1)
        } else {
            first.max(0)..=last.min(count - 1)
        };
        places.map(move |place| place.rem_euclid(count) as u32)
    }

    /// Patches among which are all that exist at an orientation, in ascending order; `None` if that is not known.
    pub(crate) fn at(&self, theta: f64) -> Option<&[u32]> {
        if !(theta.abs() <= FARTHEST_ORIENTATION) {
            return None;
        }
        let mut from_lo = theta - self.lo;
        if self.full_turn {
            from_lo -= TAU * (from_lo / TAU).floor();
        }
        let place = (from_lo * self.density) as usize;
        Some(self.patches.of(place.min(self.count - 1) as u32))
    }
}
