//! The configuration of a patch that is nearest to a given one.

use super::space::ByClass;
use super::{Coordinates, PairSpace, QueryError};
use crate::ids::PatchId;

/// Metric on configurations.
///
/// | class | distance² |
/// |---|---|
/// | general, symmetric | Δx² + Δy² + (ρ Δθ)² |
/// | fixed axes | (aᵤ Δu)² + (aᵥ Δv)², with a = ρ for a part that turns and a = 1 for one that slides |
///
/// Angles are in radians; ρ is a length, for example the distance of the moving part's outline from its centre of rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Metric {
    /// ρ: the length that a radian counts, in the model's unit. Positive.
    pub length_per_radian: f64,
}

/// The nearest configuration of a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Projection {
    /// The configuration in contact.
    pub at: Coordinates,
    /// Its distance by the metric, in the model's unit of length.
    pub distance: f64,
}

pub(super) fn nearest_patch(
    space: &PairSpace,
    at: Coordinates,
    metric: Metric,
) -> Result<Option<(PatchId, Projection)>, QueryError> {
    check(space, at, metric)?;
    if let ByClass::Planar(space, c) = space.by_class(at)? {
        let found = space.nearest_patch(c, metric.length_per_radian);
        return Ok(found.map(|(patch, c, distance)| {
            let at = Coordinates::Planar(c);
            (patch, Projection { at, distance })
        }));
    }
    let mut nearest: Option<(PatchId, Projection)> = None;
    for patch in (0..space.patch_count() as u32).map(PatchId) {
        let known = nearest.map_or(f64::INFINITY, |(_, found)| found.distance);
        if let Some(found) = project_below(space, at, patch, metric, known) {
            nearest = Some((patch, found));
        }
    }
    Ok(nearest)
}

/// Checks that a configuration can be projected with a metric.
pub(super) fn check(space: &PairSpace, at: Coordinates, metric: Metric) -> Result<(), QueryError> {
    let rho = metric.length_per_radian;
    if !(rho > 0.0 && (rho * rho).is_normal()) {
        return Err(QueryError::Metric);
    }
    space.refuse_lower()?;
    let numbers = match space.by_class(at)? {
        ByClass::Axes(_, u, v) => [u, v, 0.0],
        ByClass::Planar(_, c) | ByClass::Lower(_, c) => [c.x, c.y, c.theta],
    };
    let has_square = |n: f64| (n * n).is_finite();
    match numbers.into_iter().all(has_square) {
        true => Ok(()),
        false => Err(QueryError::Outside),
    }
}

/// The nearest configuration of a patch, if there is one nearer than `known`.
pub(super) fn project_below(
    space: &PairSpace,
    at: Coordinates,
    patch: PatchId,
    metric: Metric,
    known: f64,
) -> Option<Projection> {
    let rho = metric.length_per_radian;
    let (at, distance) = match space.by_class(at).ok()? {
        ByClass::Lower(..) => return None,
        ByClass::Axes(space, u, v) => {
            let (at, distance) = space.project((u, v), patch, rho, known)?;
            (Coordinates::of_axes(at), distance)
        }
        ByClass::Planar(space, c) => {
            let (c, distance) =
                space.project(c, space.patches().get(patch.index())?, rho, known)?;
            (Coordinates::Planar(c), distance)
        }
    };
    Some(Projection { at, distance })
}
