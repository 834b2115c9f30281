//! Location of a configuration: its free region, blocked, or outside the computed range; the clearance of the parts, and their contacts.

use crate::contact::ContactFunction;
use crate::geometry::Configuration;
use crate::ids::PatchId;
use crate::part::distance_of;
use crate::query::Location;

use super::space::ByClass;
use super::{Coordinates, PairNearest, PairSpace, QueryError};

pub(super) fn locate(space: &PairSpace, at: Coordinates) -> Result<Location, QueryError> {
    Ok(match space.by_class(at)? {
        ByClass::Lower(pair, c) => pair.locate(c),
        ByClass::Axes(space, u, v) => space.locate(u, v),
        ByClass::Planar(space, c) => space.locate(c),
    })
}

pub(super) fn clearance(space: &PairSpace, at: Coordinates) -> Result<f64, QueryError> {
    match locate(space, at)? {
        Location::Contact => Ok(0.0),
        Location::Blocked => Err(QueryError::Blocked),
        Location::Outside => Err(QueryError::Outside),
        Location::Free(_) => distance(space, at),
    }
}

/// Distance of the parts' boundaries: their clearance, where they are known not to overlap.
pub(super) fn distance(space: &PairSpace, at: Coordinates) -> Result<f64, QueryError> {
    let at = placed(space, at)?;
    Ok(distance_of(space.fixed(), space.moving(), at))
}

/// Placement of the moving part in the fixed part's frame.
pub(super) fn placed(space: &PairSpace, at: Coordinates) -> Result<Configuration, QueryError> {
    Ok(match space.by_class(at)? {
        ByClass::Axes(space, u, v) => space.configuration(u, v),
        ByClass::Planar(_, c) | ByClass::Lower(_, c) => c,
    })
}

/// Returns an error for a configuration for which nothing was computed.
pub(super) fn covered(space: &PairSpace, at: Coordinates) -> Result<(), QueryError> {
    let covered = match space.by_class(at)? {
        ByClass::Planar(space, c) => space.covers(c),
        ByClass::Axes(space, u, v) => space.covers(u, v),
        ByClass::Lower(_, c) => c.position().is_finite() && c.theta.is_finite(),
    };
    covered.then_some(()).ok_or(QueryError::Outside)
}

pub(super) fn contacts(
    space: &PairSpace,
    at: Coordinates,
    tolerance: f64,
) -> Result<Vec<(PatchId, f64)>, QueryError> {
    covered(space, at)?;
    Ok(match space.by_class(at)? {
        ByClass::Lower(pair, c) => {
            let off = |f: &ContactFunction| f.value(c.position(), c.theta).abs();
            let all = (0..).map(PatchId).zip(pair.contacts());
            let all = all.map(|(i, contact)| (i, off(&contact.function)));
            all.filter(|&(_, off)| off <= tolerance).collect()
        }
        ByClass::Axes(space, u, v) => space.contacts(u, v, tolerance),
        ByClass::Planar(space, c) => space.contacts(c, tolerance),
    })
}

pub(super) fn nearest_contact(
    space: &PairSpace,
    at: Coordinates,
) -> Result<Option<PairNearest>, QueryError> {
    covered(space, at)?;
    let nearest = |patch, at, distance| PairNearest {
        patch,
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
