//! How far parts go in the regions in which they are drawn, and what stops them there.

use core::f64::consts::TAU;

use cspace::{Axis, AxisMotion, FeatureName, FixedAxesSpace, RegionId};

use super::answer::{End, Limits, Stop};
use super::region::bounding;

/// Difference of coordinates (radians, or shares of the parts' size) below which two are one: more than the ends of curves are rounded, and
/// than the growth of parts takes.
const SAME: f64 = 1e-9;

/// Least and greatest values of both coordinates in some regions; infinite where a part goes on without end.
pub(super) fn reach(space: &FixedAxesSpace, regions: &[RegionId], place: [f64; 2]) -> [Limits; 2] {
    let all = space.regions();
    let (fixed, moving) = space.axes();
    [0, 1].map(|k| {
        let axis = [fixed, moving][k];
        if axis.motion == AxisMotion::Fixed {
            return Limits { lo: 0.0, hi: 0.0 };
        }
        (regions.iter())
            .filter_map(|&r| all.get(r.index()))
            .map(|r| {
                let (range, open, is_around) = match k {
                    0 => (r.u, r.open_u, r.around_u),
                    _ => (r.v, r.open_v, r.around_v),
                };
                if is_around {
                    return Limits::NONE;
                }
                let (lo, hi) = unrolled(range, &axis, place[k]);
                Limits {
                    lo: if open.0 { f64::NEG_INFINITY } else { lo },
                    hi: if open.1 { f64::INFINITY } else { hi },
                }
            })
            .reduce(Limits::and)
            .unwrap_or(Limits {
                lo: place[k],
                hi: place[k],
            })
    })
}

impl Limits {
    /// No limits.
    const NONE: Self = Self {
        lo: f64::NEG_INFINITY,
        hi: f64::INFINITY,
    };

    fn and(self, other: Self) -> Self {
        Self {
            lo: self.lo.min(other.lo),
            hi: self.hi.max(other.hi),
        }
    }
}

/// Whether values of a coordinate a turn apart are one place.
fn is_circle(axis: &Axis) -> bool {
    axis.range.is_none() && matches!(axis.motion, AxisMotion::Revolute { .. })
}

/// A range of a region, in the turn in which it holds a place.
fn unrolled((lo, hi): (f64, f64), axis: &Axis, place: f64) -> (f64, f64) {
    if !is_circle(axis) || (lo - SAME..=hi + SAME).contains(&place) {
        return (lo, hi);
    }
    let turns = ((0.5 * (lo + hi) - place) / TAU).round() * TAU;
    (lo - turns, hi - turns)
}

/// Contacts that keep parts from the ends of their ranges, or from a whole turn.
pub(super) fn stops(
    space: &FixedAxesSpace,
    regions: &[RegionId],
    reach: [Limits; 2],
    place: [f64; 2],
) -> Vec<Stop> {
    let (fixed, moving) = space.axes();
    let size = space.fixed().size().max(space.moving().size());
    let mut found = Vec::new();
    for part in [0, 1] {
        let axis = [fixed, moving][part];
        let same = match axis.motion {
            AxisMotion::Fixed => continue,
            AxisMotion::Revolute { .. } => SAME,
            AxisMotion::Prismatic { .. } => SAME * size,
        };
        let Limits { lo, hi } = reach[part];
        for (end, value) in [(End::Lo, lo), (End::Hi, hi)] {
            let is_reached = axis.range.is_some_and(|(from, to)| match end {
                End::Lo => value <= from + same,
                End::Hi => value >= to - same,
            });
            if is_reached || value.is_infinite() {
                continue;
            }
            let Some(at) = farthest(space, regions, part, value, place) else {
                continue;
            };
            found.push(Stop {
                part,
                end,
                is_declared: axis.range.is_some(),
                at,
                features: touching(space, at, regions),
            });
        }
    }
    found
}

/// The end of a curve around some regions at which a coordinate has a value, its least or greatest there; of several that where the other
/// coordinate is nearest to a place.
///
/// A coordinate is monotone along each branch: it is least and greatest at ends of branches.
fn farthest(
    space: &FixedAxesSpace,
    regions: &[RegionId],
    part: usize,
    value: f64,
    place: [f64; 2],
) -> Option<(f64, f64)> {
    let (fixed, moving) = space.axes();
    let axes = [fixed, moving];
    let apart = |k: usize, from: f64, to: f64| match is_circle(&axes[k]) {
        true => {
            let by = to - from;
            by - (by / TAU).round() * TAU
        }
        false => to - from,
    };
    let ends = bounding(space, regions)
        .flat_map(|b| [b.start, b.end])
        .map(|(u, v)| {
            let at = [u, v];
            let off = apart(part, value, at[part]).abs();
            let other = apart(1 - part, place[1 - part], at[1 - part]);
            let mut there = [0.0; 2];
            there[part] = value;
            there[1 - part] = match axes[1 - part].motion {
                AxisMotion::Fixed => 0.0,
                _ => place[1 - part] + other,
            };
            (off, other.abs(), (there[0], there[1]))
        });
    let nearest = |limit: f64| {
        let ends = ends.clone().filter(move |e| e.0 <= limit);
        ends.min_by(|a, b| a.1.total_cmp(&b.1))
    };
    let least = ends.clone().map(|e| e.0).min_by(f64::total_cmp)?;
    nearest(least + SAME).map(|e| e.2)
}

/// The features that touch at a configuration on the boundary of some regions.
pub(super) fn touching(
    space: &FixedAxesSpace,
    (u, v): (f64, f64),
    regions: &[RegionId],
) -> Vec<[FeatureName; 2]> {
    let size = space.fixed().size().max(space.moving().size());
    let mut found = Vec::new();
    for (patch, _) in space.contacts(u, v, SAME * size) {
        let patch = &space.patches()[patch.index()];
        let features = [patch.fixed, patch.moving];
        let is_there = patch.region.is_none_or(|r| regions.contains(&r));
        if is_there && !found.contains(&features) {
            found.push(features);
        }
    }
    found
}
