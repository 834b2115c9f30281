//! The free regions in which two parts are drawn, and the closed curves around them.

use core::f64::consts::TAU;

use cspace::fixed_axes::AxesBranch;
use cspace::{AxisMotion, FixedAxesSpace, PatchId, RegionId};

/// Share of the parts' size within which contacts of parts that touch as drawn are looked for.
const TOUCHING: f64 = 1e-9;

/// The free region of a configuration, or those beside it where the parts touch; none where they overlap.
pub(super) fn regions(space: &FixedAxesSpace, [u, v]: [f64; 2]) -> Vec<RegionId> {
    if let Some(region) = space.locate(u, v).region() {
        return vec![region];
    }
    let size = space.fixed().size().max(space.moving().size());
    let mut found: Vec<RegionId> = (space.contacts(u, v, TOUCHING * size).iter())
        .filter_map(|&(patch, _)| space.patches()[patch.index()].region)
        .collect();
    found.sort_unstable();
    found.dedup();
    found
}

/// The branches of the curves that bound some regions.
pub(super) fn bounding<'a>(
    space: &'a FixedAxesSpace,
    regions: &'a [RegionId],
) -> impl Iterator<Item = &'a AxesBranch> + Clone {
    space.branches().iter().filter(|b| {
        let region = space.patches()[b.patch.index()].region;
        region.is_some_and(|r| regions.contains(&r))
    })
}

/// Whether any contact bounds some regions.
pub(super) fn is_bounded(space: &FixedAxesSpace, regions: &[RegionId]) -> bool {
    bounding(space, regions).next().is_some()
}

/// A closed curve of contacts around which both parts come back to where they were, after whole turns.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Loop {
    /// Its patches.
    pub(super) patches: Vec<PatchId>,
    /// Turns of u and of v along it.
    pub(super) turns: (i64, i64),
}

/// The closed curves on the boundary of a region; curves that end at limits of the motions are left out.
///
/// Travel along a curve has free space on its right, and both coordinates are continuous along each branch; so the turns are the sum of what
/// the branches go through, to rounding.
pub(super) fn loops(space: &FixedAxesSpace, region: RegionId) -> Vec<Loop> {
    let patches = space.patches();
    let mut is_seen = vec![false; patches.len()];
    let mut found = Vec::new();
    for first in 0..patches.len() {
        if is_seen[first] || patches[first].region != Some(region) {
            continue;
        }
        let mut members = Vec::new();
        let mut at = Some(first);
        while let Some(patch) = at.filter(|&p| !is_seen[p]) {
            is_seen[patch] = true;
            members.push(PatchId(patch as u32));
            at = patches[patch].next.map(PatchId::index);
        }
        if at == Some(first) {
            found.push(Loop {
                turns: turns(space, &members),
                patches: members,
            });
        }
    }
    found
}

fn turns(space: &FixedAxesSpace, members: &[PatchId]) -> (i64, i64) {
    let (mut u, mut v) = (0.0, 0.0);
    for &patch in members {
        let branches = space.patches()[patch.index()].branches.clone();
        for branch in &space.branches()[branches.start as usize..branches.end as usize] {
            u += branch.end.0 - branch.start.0;
            v += branch.end.1 - branch.start.1;
        }
    }
    let whole = |sum: f64, motion| match motion {
        AxisMotion::Revolute { .. } => (sum / TAU).round() as i64,
        _ => 0,
    };
    let (fixed, moving) = space.axes();
    (whole(u, fixed.motion), whole(v, moving.motion))
}

/// Turns (of u, of v) after which the parts are back, if a region lets neither turn without the other; the first is positive.
pub(super) fn turns_together(loops: &[Loop]) -> Option<(i64, i64)> {
    let (u, v) = (loops.iter().map(|l| l.turns)).find(|&(u, v)| u != 0 || v != 0)?;
    let common = gcd(u.unsigned_abs(), v.unsigned_abs());
    let common = i64::try_from(common).ok()?;
    (u != 0 && v != 0).then(|| (u / common * u.signum(), v / common * u.signum()))
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}
