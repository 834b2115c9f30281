//! Whether a given path is free, by the distances of the parts alone.

use core::f64::consts::TAU;

use cspace::{Coordinates, FeatureName, QueryError};
use serde::Serialize;

use crate::answer::Narrow;
use crate::ends::is_far;
use crate::legs::{Coords, Scene};
use crate::path::Legs;
use crate::planner::PlanError;
use crate::route::along;

/// Share of the size, or of a longer leg, from which on a path that begins or ends in contact is judged.
const END: f64 = 1e-3;
/// Parts this near, as a share of their size, touch.
const TOUCHING: f64 = 1e-10;
/// The time of a first contact is found by so many halvings.
const HALVINGS: usize = 60;

/// Result of checking a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Checked {
    /// The parts never overlap.
    Free(Narrow),
    /// They overlap at the first configuration.
    FromBlocked,
    /// They overlap at the last configuration.
    ToBlocked,
    /// They meet on the way.
    Meets(Meeting),
}

/// Where a path meets a contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Meeting {
    /// The leg, counted from 0.
    pub leg: usize,
    /// The share of the leg that is free.
    pub fraction: f64,
    /// The configuration.
    pub at: Coordinates,
    /// The features of the fixed and of the moving part that meet.
    pub features: Option<(FeatureName, FeatureName)>,
}

/// Judges a path of motions of constant rates between configurations, without a contact space.
///
/// It may begin and end in contact, and touch nowhere else.
///
/// # Errors
/// If there is no configuration, or one is in the coordinates of another class, not finite, outside the window or the ranges of
/// motion, or so far away that it is not known where the parts are to each other.
///
/// ```
/// use cspace::{Configuration, Coordinates, Part};
/// use cspace_plan::{Checked, check, legs::Scene};
/// let post = Part::circle("post", (0.0, 0.0), 1.0)?;
/// let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0)?;
/// let scene = Scene::new(&post, &block, None);
/// let at = |x, y| Coordinates::Planar(Configuration::new(x, y, 0.0));
/// let Checked::Free(past) = check(&scene, &[at(-4.0, 2.5), at(4.0, 2.5)])? else {
///     return Err("the block goes past the post".into());
/// };
/// assert!((past.clearance - 0.5).abs() < 1e-5);
/// let Checked::Meets(hit) = check(&scene, &[at(-4.0, 0.0), at(4.0, 0.0)])? else {
///     return Err("the block hits the post".into());
/// };
/// assert!((hit.fraction - 0.25).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check(scene: &Scene, path: &[Coordinates]) -> Result<Checked, PlanError> {
    let outside = Err(PlanError::Pair(QueryError::Outside));
    let places = (path.iter())
        .map(|&at| scene.numbers(at).map_err(PlanError::Pair))
        .collect::<Result<Vec<_>, _>>()?;
    if places.iter().flatten().any(|c| !c.is_finite()) {
        return outside;
    }
    if (0..3).any(|k| is_outside(scene, &places, k)) {
        return outside;
    }
    if places.iter().any(|&at| is_far(scene, at)) {
        let place = "a configuration of the path";
        return Err(PlanError::TooFar { place });
    }
    let (Some(&first), Some(&last)) = (places.first(), places.last()) else {
        return outside;
    };
    let rounding = scene.rounding(first, last);
    let touches = |at: Coords| touches_up_to(scene, at, rounding);
    let is_blocked = |at: Coords| !touches(at) && scene.overlaps(at);
    if is_blocked(first) {
        return Ok(Checked::FromBlocked);
    }
    if is_blocked(last) {
        return Ok(Checked::ToBlocked);
    }
    let (leaves, arrives) = (touches(first), touches(last));
    let count = places.len().saturating_sub(1);
    for (leg, ends) in places.windows(2).enumerate() {
        // What begins or ends in contact is looked at from a little beside it.
        let share = |touches: bool| {
            let long = (0..3)
                .map(|k| ((ends[1][k] - ends[0][k]) * scene.levers()[k]).abs())
                .fold(scene.size(), f64::max);
            if touches {
                END * scene.size() / long
            } else {
                0.0
            }
        };
        let from = along(ends[0], ends[1], share(leg == 0 && leaves));
        let to = along(ends[1], ends[0], share(leg + 1 == count && arrives));
        // Distances have no sign: what is judged is free where it is free at its beginning.
        if leg == 0 && scene.overlaps(from) {
            return Ok(Checked::FromBlocked);
        }
        if !scene.is_apart(from, to, scene.rounding(from, to)) {
            return Ok(Checked::Meets(meeting(
                scene,
                leg,
                (ends[0], ends[1]),
                (from, to),
            )));
        }
    }
    let legs = Legs::new(scene, places);
    Ok(match legs.narrowest() {
        Some((at, found)) => Checked::Free(Narrow {
            clearance: found.distance,
            at: scene.coordinates(at),
            features: found.features,
        }),
        None => Checked::FromBlocked,
    })
}

/// Whether the parts touch where a free path is.
pub fn touches(scene: &Scene, at: Coords) -> bool {
    touches_up_to(scene, at, scene.rounding(at, at))
}

fn touches_up_to(scene: &Scene, at: Coords, rounding: f64) -> bool {
    scene.clearance(at) <= TOUCHING * scene.size() + rounding
}

/// Whether a coordinate leaves its limits; of a window of orientations, by whichever turn.
fn is_outside(scene: &Scene, places: &[Coords], k: usize) -> bool {
    /// Angles that were taken modulo a turn are rounded so far, radians.
    const ROUNDING: f64 = 1e-12;
    let (lo, hi) = scene.limits()[k];
    let first = places.first().map_or(lo, |p| p[k]);
    let turns = if k == 2 && lo.is_finite() {
        TAU * ((lo - ROUNDING - first) / TAU).ceil()
    } else {
        0.0
    };
    (places.iter()).any(|p| p[k] + turns < lo - ROUNDING || p[k] + turns > hi + ROUNDING)
}

/// Where a leg first meets a contact, between two places of it.
fn meeting(
    scene: &Scene,
    leg: usize,
    whole: (Coords, Coords),
    (from, to): (Coords, Coords),
) -> Meeting {
    let (mut free, mut met) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (free + met);
        if scene.is_apart(from, along(from, to, middle), scene.rounding(from, to)) {
            free = middle;
        } else {
            met = middle;
        }
    }
    let at = along(from, to, free);
    let length: f64 = (0..3).map(|k| (whole.1[k] - whole.0[k]).powi(2)).sum();
    let done: f64 = (0..3)
        .map(|k| (at[k] - whole.0[k]) * (whole.1[k] - whole.0[k]))
        .sum();
    Meeting {
        leg,
        fraction: if length > 0.0 { done / length } else { 0.0 },
        at: scene.coordinates(at),
        features: scene.nearest(at).features,
    }
}
