//! Critical orientations: how long the general algorithm searches them, and what makes the product's.

use core::f64::consts::{PI, TAU};
use std::time::Duration;

use cpu_time::ProcessTime;
use cspace::{ContactSpace, Part};
use cspace_baseline::critical::{Known, search};
use cspace_baseline::kinds;
use serde::Serialize;

use crate::timing::{median, timed};

/// How many critical orientations have events of each kind, in one of the slabs that symmetry makes.
#[derive(Serialize, Default)]
pub(crate) struct Kinds {
    /// All of them; several kinds may be at one.
    pub(crate) orientations: usize,
    pub(crate) aligned: usize,
    pub(crate) end: usize,
    pub(crate) tangent: usize,
    pub(crate) triple: usize,
}

impl Kinds {
    /// Counts the critical orientations in one of the `slabs` that are images of each other; the space covers the whole turn.
    pub(crate) fn new(space: &ContactSpace, slabs: u32) -> Self {
        let all = kinds::of(space);
        // From one critical orientation on, so that rounding puts none of a slab's two ends in it twice.
        let first = all.first().map_or(-PI, |k| k.0);
        let end = first + TAU / f64::from(slabs) - 1e-9;
        let mut counts = Self::default();
        for (_, kinds) in all.into_iter().take_while(|k| k.0 < end) {
            counts.orientations += 1;
            counts.aligned += usize::from(kinds.aligned);
            counts.end += usize::from(kinds.end);
            counts.tangent += usize::from(kinds.tangent);
            counts.triple += usize::from(kinds.triple);
        }
        counts
    }
}

/// The work of one search of critical orientations by the general algorithm, and its time.
#[derive(Serialize, Clone, Copy)]
pub(crate) struct Searched {
    /// The median of so many runs, or of as many as fit in the limit.
    pub(crate) seconds: f64,
    /// Solutions of the equations of all combinations of features.
    pub(crate) solutions: u64,
    /// Solutions that were examined one by one; the others lie at an orientation that was known.
    pub(crate) examined: u64,
    /// Configurations at which the parts were tested for overlap.
    pub(crate) overlap_tests: u64,
    /// Critical orientations that are left.
    pub(crate) orientations: usize,
}

/// Searches so often, or as often as fits in the limit; `None` if that is not once.
pub(crate) fn searched(
    fixed: &Part,
    moving: &Part,
    known: Known,
    (limit, repeat): (f64, u16),
) -> Option<Searched> {
    let (begin, limit) = (ProcessTime::now(), Duration::from_secs_f64(limit));
    let (mut runs, mut last) = (Vec::new(), None);
    for _ in 0..repeat {
        let (seconds, found) = timed(|| search(fixed, moving, known, &|| begin.elapsed() < limit));
        let Some(found) = found else {
            break;
        };
        runs.push(seconds);
        last = Some(found);
    }
    last.map(|found| Searched {
        seconds: median(runs),
        solutions: found.candidates,
        examined: found.candidates - found.skipped,
        overlap_tests: found.overlap_tests,
        orientations: found.orientations.len(),
    })
}
