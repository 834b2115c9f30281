//! Doubtful orientations, at which the patches alone do not decide.
//!
//! Structure is determined between events, and events have errors; where many events occur at nearly one orientation, links may be wrong.
//! Such orientations show by what contradicts itself or ends without a reason. They are reported, so that a query of one configuration can
//! be answered by a test of the parts themselves.

use core::f64::consts::TAU;

use crate::feature::tolerance::NARROWEST_BAND;
use crate::ids::PatchId;

use crate::general::cells::cell::Cell;
use crate::general::events::clusters::Clusters;
use crate::general::links::copies::Lifts;
use crate::general::verdict::shells::Shells;
use crate::space::{Patch, SideLink, Window, in_window, union};

/// Width (radians) below which bands are doubtful: f64 does not resolve places on curves that cross there at as small an angle.
const NARROW: f64 = 2.0 * NARROWEST_BAND;

/// Orientations at which cells are doubtful: where shells were in conflict.
pub(crate) fn doubtful(clusters: &Clusters, cells: &[Cell], shells: &Shells) -> Vec<(f64, f64)> {
    let in_conflict = (cells.iter().zip(&shells.in_conflict))
        .filter(|(_, conflict)| **conflict)
        .map(|(c, _)| (clusters.lo(c.from), clusters.hi(c.to)));
    union(in_conflict.collect())
}

/// Orientations at which the patches of a computation are doubtful: where shells were in conflict, in narrow bands, and where a patch has
/// no successor.
pub(crate) fn doubts(
    doubtful: &[(f64, f64)],
    lifts: &Lifts<'_>,
    (patches, side_links): (&[Patch], &[SideLink]),
    critical_orientations: &[f64],
    window: Window,
) -> Vec<(f64, f64)> {
    let copies = doubtful.iter().flat_map(|&(lo, hi)| {
        lifts.shifts(lo, hi).map(move |slabs| {
            let by = lifts.steps.period(slabs);
            (lo + by, hi + by)
        })
    });
    let around = (critical_orientations.last())
        .filter(|_| window.full_turn)
        .map(|&last| last - TAU);
    let criticals: Vec<f64> = around
        .into_iter()
        .chain(critical_orientations.iter().copied())
        .collect();
    let narrow = (criticals.windows(2))
        .filter(|w| w[1] - w[0] < NARROW)
        .map(|w| (w[0], w[1]));
    let open = unlinked(patches, side_links);
    in_window(copies.chain(narrow).chain(open), window)
}

/// The orientations at which a patch has no successor. Side links are in order of the patch before and of orientation.
fn unlinked(patches: &[Patch], side_links: &[SideLink]) -> Vec<(f64, f64)> {
    let mut links = side_links.iter().peekable();
    let mut open = Vec::new();
    for (i, patch) in (0u32..).zip(patches) {
        let mut known = patch.lo;
        let mut until = |to: f64, known: f64| {
            if to - known > NARROWEST_BAND {
                open.push((known, to));
            }
        };
        while let Some(link) = links.next_if(|l| l.before == PatchId(i)) {
            until(link.lo, known);
            known = known.max(link.hi);
        }
        until(patch.hi, known);
    }
    open
}
