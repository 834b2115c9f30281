//! Reasons why there is no path: the enclosure between start and goal, and overlaps at an end.

use std::collections::BTreeSet;

use cspace::{Coordinates, FeatureName, Metric, PairSpace, QueryError, RegionId};

use crate::answer::{Blocked, Enclosed};
use crate::legs::Scene;

/// Finds which of two regions is enclosed, and by what.
pub(crate) fn enclosed(
    space: &PairSpace,
    a: RegionId,
    b: RegionId,
) -> Result<Enclosed, QueryError> {
    let regions = space.regions();
    let unbounded = |r: RegionId| regions.get(r.index()).is_some_and(|r| r.unbounded);
    let patches_of = |r: RegionId| {
        (space.patches())
            .filter(|p| p.region().is_ok_and(|of| of == Some(r)))
            .collect::<Vec<_>>()
    };
    let (of_a, of_b) = (patches_of(a), patches_of(b));
    let first = (unbounded(a), of_a.len()) <= (unbounded(b), of_b.len());
    let (region, patches) = if first { (a, of_a) } else { (b, of_b) };
    let mut features: BTreeSet<(FeatureName, FeatureName)> = BTreeSet::new();
    for patch in &patches {
        let (fixed, moving) = patch.features()?;
        features.insert((fixed.name, moving.name));
    }
    Ok(Enclosed {
        region,
        patches: patches.len(),
        features: features.into_iter().collect(),
    })
}

/// Finds the overlap at a blocked configuration, and the nearest free configuration.
pub(crate) fn blocked(
    space: &PairSpace,
    scene: &Scene,
    at: Coordinates,
) -> Result<Blocked, QueryError> {
    let levers = scene.levers();
    let turning = match space {
        PairSpace::Planar(_) => levers[2],
        _ => levers[0].max(levers[1]),
    };
    let metric = Metric {
        length_per_radian: if turning > 0.0 { turning } else { 1.0 },
    };
    Ok(match space.nearest_patch(at, metric)? {
        None => Blocked {
            depth: f64::INFINITY,
            nearest: None,
            features: None,
        },
        Some((patch, found)) => {
            let (fixed, moving) = space.patch(patch)?.features()?;
            Blocked {
                depth: found.distance,
                nearest: Some(found.at),
                features: Some((fixed.name, moving.name)),
            }
        }
    })
}
