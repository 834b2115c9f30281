//! A goal in which a symmetric part looks the same, and to which there is a way.

use core::f64::consts::{PI, TAU};

use cspace::{Configuration, Coordinates, Location, PairSpace, RegionId, Rotation};
use schemars::JsonSchema;
use serde::Serialize;

/// So many turns are looked at: a part with finer symmetry is all but round.
const MOST: usize = 64;

/// A configuration in which the moving part covers what it covers at the goal.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Twin {
    /// The turn of the part by which it looks the same, radians.
    pub turn: f64,
    /// The configuration.
    pub at: Coordinates,
}

impl Twin {
    /// The twin of a goal with the least turn that is in a region; none if the moving part is not planar or has no symmetry.
    pub(crate) fn in_region(
        space: &PairSpace,
        region: RegionId,
        goal: Coordinates,
    ) -> Option<Self> {
        let (PairSpace::Planar(_), Coordinates::Planar(goal)) = (space, goal) else {
            return None;
        };
        let symmetry = space.moving().symmetry();
        let fold = symmetry.fold();
        let center = symmetry.center();
        let middle = goal.fixed_from_moving(center);
        let at = |turn: f64| {
            let theta = goal.theta + turn;
            let origin = middle - Rotation::by(theta) * center.to_vector();
            Coordinates::Planar(Configuration::new(origin.x, origin.y, theta))
        };
        let mut turns: Vec<f64> = (1..fold)
            .map(|k| TAU * f64::from(k) / f64::from(fold))
            .map(|turn| if turn > PI { turn - TAU } else { turn })
            .collect();
        turns.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        let is_there = |&at: &Coordinates| space.locate(at) == Ok(Location::Free(region));
        (turns.into_iter().take(MOST))
            .map(|turn| Self { turn, at: at(turn) })
            .find(|twin| is_there(&twin.at))
    }
}
