//! The (u, v) plane of pairs with fixed axes, to be drawn: contact curves, and free space as polygons.

use cspace::FixedAxesSpace;
use cspace::fixed_axes::BranchForm;
use js_sys::Array;

use crate::drawn::of_region;

/// An interval is halved at most so often: curves turn around with the square root of a coordinate, as steep as one likes.
const HALVINGS: u32 = 12;

/// The contact curves: an array of `DrawnCurve`.
pub(crate) fn curves(space: &FixedAxesSpace, deviation: f64) -> Array {
    let branches = space.branches().iter().enumerate().map(|(i, branch)| {
        let (from, to) = match branch.form {
            BranchForm::VOfU => (branch.start.0, branch.end.0),
            BranchForm::UOfV => (branch.start.1, branch.end.1),
        };
        let at = |share: f64| {
            let there = space.branch_at(i, from + (to - from) * share);
            [there.map_or(branch.start, |(place, _)| place)]
        };
        let points = followed(at, deviation)
            .into_iter()
            .flat_map(|[(u, v)]| [u, v]);
        let region = space.patches()[branch.patch.index()].region;
        of_region(Some(branch.patch), region, points)
    });
    branches.collect()
}

/// Free space as an array of `FreePolygon`.
pub(crate) fn free(space: &FixedAxesSpace, deviation: f64) -> Array {
    let gaps = space.free_gaps().map(|gap| {
        let sides = followed(|share| gap.ends(share), deviation);
        let there = sides.iter().map(|s| s[0]);
        let back = sides.iter().rev().map(|s| s[1]);
        of_region(
            None,
            Some(gap.region()),
            there.chain(back).flat_map(|(u, v)| [u, v]),
        )
    });
    gaps.collect()
}

/// Places of some curves, from the first to the last, between which all are straight but for a deviation.
fn followed<const N: usize>(
    at: impl Fn(f64) -> [(f64, f64); N],
    deviation: f64,
) -> Vec<[(f64, f64); N]> {
    let mut found = vec![at(0.0)];
    let mut last = 0.0;
    let mut ahead = vec![(1.0, at(1.0), HALVINGS)];
    while let (Some(&from), Some((share, to, halvings))) = (found.last(), ahead.pop()) {
        let middle = 0.5 * (last + share);
        let on = at(middle);
        let bent = (0..N).any(|k| {
            let off = |a: f64, m: f64, b: f64| (m - 0.5 * (a + b)).abs() > deviation;
            off(from[k].0, on[k].0, to[k].0) || off(from[k].1, on[k].1, to[k].1)
        });
        if halvings > 0 && (bent || halvings > HALVINGS - 2) {
            ahead.push((share, to, halvings - 1));
            ahead.push((middle, on, halvings - 1));
        } else {
            found.push(to);
            last = share;
        }
    }
    found
}
