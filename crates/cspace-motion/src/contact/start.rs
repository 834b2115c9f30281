//! Check of the start configuration.

use cspace::{Classification, PairSpace, QueryError};

use crate::error::SimulateError;
use crate::pairs::{MovingPair, Pairs};
use crate::system::System;

use super::pinch::pinching;

/// Checks that no parts overlap.
///
/// # Errors
/// If parts overlap, or a pair's space was not computed at this configuration.
pub(crate) fn check_start(system: &System, pairs: &Pairs, q: &[f64]) -> Result<(), SimulateError> {
    (pairs.list().iter()).try_for_each(|pair| match overlap(pair, system, q)? {
        None => Ok(()),
        Some(depth) => Err(overlap_error(system, pair, depth)),
    })
}

/// The distance to the nearest contact of a pair that overlaps by more than contacts are known to; `None` of others. It includes parts
/// that fit exactly, which have no contact nearby.
///
/// # Errors
/// If the pair's space was not computed at this configuration.
pub(crate) fn overlap(
    pair: &MovingPair,
    system: &System,
    q: &[f64],
) -> Result<Option<f64>, SimulateError> {
    let Some(depth) = depth(pair, system, q)?.filter(|depth| *depth > pair.touch) else {
        return Ok(None);
    };
    match is_held(pair, system, q) {
        Ok(is_held) => Ok((!is_held).then_some(depth)),
        Err(error) => {
            let [fixed, moving] = names(pair, system);
            Err(SimulateError::Query {
                fixed,
                moving,
                error,
            })
        }
    }
}

/// The error of a pair that overlaps.
pub(crate) fn overlap_error(system: &System, pair: &MovingPair, depth: f64) -> SimulateError {
    let [fixed, moving] = names(pair, system);
    SimulateError::Overlap {
        fixed,
        moving,
        depth,
    }
}

/// Names of the fixed and of the moving part of a pair.
pub(crate) fn names(pair: &MovingPair, system: &System) -> [String; 2] {
    let parts = &system.mechanism().parts;
    [pair.fixed, pair.moving].map(|i| parts[i].part.name().to_owned())
}

/// Penetration depth of overlapping parts: along or about their axes if both are on axes, otherwise by translation.
/// `None` if they do not overlap.
///
/// # Errors
/// If the pair's space was not computed at this configuration.
fn depth(pair: &MovingPair, system: &System, q: &[f64]) -> Result<Option<f64>, SimulateError> {
    let at = pair.coordinates(system, q);
    let found = match pair.space.classify(at) {
        Ok(Classification::Blocked) => pair.space.nearest_contact(at).map(Some),
        Ok(_) => Ok(None),
        Err(error) => Err(error),
    };
    let [fixed, moving] = names(pair, system);
    match found {
        Ok(blocked) => Ok(blocked.map(|n| n.map_or(f64::INFINITY, |n| n.distance))),
        Err(QueryError::Outside) => Err(SimulateError::Outside { fixed, moving }),
        Err(error) => Err(SimulateError::Query {
            fixed,
            moving,
            error,
        }),
    }
}

/// Whether parts that are classified as blocked only touch. A wedged part is at the last orientation at which it fits,
/// or beyond it by rounding, where nothing is free and no contact is near.
fn is_held(pair: &MovingPair, system: &System, q: &[f64]) -> Result<bool, QueryError> {
    if !matches!(pair.space, PairSpace::Planar(_)) {
        return Ok(false);
    }
    let touches = pair.touches(0, system, q, pair.touch)?;
    Ok(!touches.is_empty() || !pinching(system, (0, pair), q).is_empty())
}
