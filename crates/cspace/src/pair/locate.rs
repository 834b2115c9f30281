//! Location of a configuration: its free region, blocked, or outside the computed range; the clearance of the parts, and their contacts.

use crate::contact::ContactFunction;
use crate::geometry::Configuration;
use crate::part::distance_of;
use crate::query::Classification;

use super::space::ByClass;
use super::{Coordinates, PairNearest, PairSpace, PatchId, QueryError, RegionId};

/// Location of a configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Location {
    /// The parts are apart, in this free region.
    Free(RegionId),
    /// The parts touch, within the resolution.
    Contact,
    /// The parts overlap.
    Blocked,
    /// The configuration is not finite, or outside the window of orientations or the ranges of motion: nothing was computed there.
    Outside,
}

pub(super) fn locate(space: &PairSpace, at: Coordinates) -> Result<Location, QueryError> {
    let class = match space.classify(at) {
        Err(QueryError::Outside) => return Ok(Location::Outside),
        class => class?,
    };
    let region = match space.by_class(at)? {
        ByClass::Lower(..) => None,
        ByClass::Axes(space, u, v) => space.region_at(u, v),
        ByClass::Planar(space, c) => space.region_at(c),
    };
    Ok(match (class, region) {
        (Classification::Contact, _) => Location::Contact,
        (Classification::Free, Some(region)) => Location::Free(RegionId(region)),
        _ => Location::Blocked,
    })
}

pub(super) fn clearance(space: &PairSpace, at: Coordinates) -> Result<f64, QueryError> {
    match space.classify(at)? {
        Classification::Contact => Ok(0.0),
        Classification::Blocked => Err(QueryError::Blocked),
        Classification::Free => {
            let at = placed(space, at)?;
            Ok(distance_of(space.fixed(), space.moving(), at))
        }
    }
}

/// Placement of the moving part in the fixed part's frame.
pub(super) fn placed(space: &PairSpace, at: Coordinates) -> Result<Configuration, QueryError> {
    Ok(match space.by_class(at)? {
        ByClass::Axes(space, u, v) => space.configuration(u, v),
        ByClass::Planar(_, c) | ByClass::Lower(_, c) => c,
    })
}

/// Returns an error for a configuration for which nothing was computed.
fn check(space: &PairSpace, at: Coordinates) -> Result<(), QueryError> {
    match space.by_class(at)? {
        ByClass::Planar(space, c) if space.covers(c) => Ok(()),
        _ => space.classify(at).map(|_| ()),
    }
}

pub(super) fn contacts(
    space: &PairSpace,
    at: Coordinates,
    tolerance: f64,
) -> Result<Vec<(PatchId, f64)>, QueryError> {
    check(space, at)?;
    let found: Vec<(u32, f64)> = match space.by_class(at)? {
        ByClass::Lower(pair, c) => {
            let off = |f: &ContactFunction| f.value(c.position(), c.theta).abs();
            let all = (0..).zip(pair.contacts());
            let all = all.map(|(i, contact)| (i, off(&contact.function)));
            all.filter(|&(_, off)| off <= tolerance).collect()
        }
        ByClass::Axes(space, u, v) => space.contacts(u, v, tolerance),
        ByClass::Planar(space, c) => space.contacts(c, tolerance),
    };
    let named = |(patch, distance)| (PatchId(patch), distance);
    Ok(found.into_iter().map(named).collect())
}

pub(super) fn nearest_contact(
    space: &PairSpace,
    at: Coordinates,
) -> Result<Option<PairNearest>, QueryError> {
    check(space, at)?;
    let nearest = |patch, at, distance| PairNearest {
        patch: PatchId(patch),
        at,
        distance,
    };
    Ok(match space.by_class(at)? {
        ByClass::Lower(..) => return Err(QueryError::Permanent),
        ByClass::Axes(space, u, v) => (space.nearest_contact(u, v))
            .map(|n| nearest(n.patch, Coordinates::of_axes(n.at), n.distance)),
        ByClass::Planar(space, c) => (space.nearest_contact(c))
            .map(|n| nearest(n.patch, Coordinates::Planar(n.configuration), n.distance)),
    })
}
