//! Check of a step of the motion.

use crate::contact::{Bound, Path, Watch, goes_past, limit_tolerance, limits};

use super::flow::{Arrived, Flow};
use super::friction::agrees;

/// A contact's push below this share of the speed, and negative, is a pull.
pub(super) const PULL: f64 = 1e-10;

/// Why a step may not be taken as it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Obstacle {
    /// A bound pulls.
    Pull,
    /// Friction would be other.
    Friction,
    /// A part left its range.
    Limit,
    /// The parts of a pair met, do not touch as they did, or went past the end of a feature.
    Pair(usize),
    /// The step's error is too large.
    Error,
}

/// Whether the motion goes on during the step: closed contacts push and agree with friction, no other part is met, and
/// no range is left.
pub(crate) fn goes_on(watch: &mut Watch<'_>, flow: &Flow<'_>, h: f64, to: &Arrived) -> bool {
    obstacle(watch, flow, h, to).is_none()
}

/// Obstacle that keeps a step from being taken as it is, if there is one.
pub(super) fn obstacle(
    watch: &mut Watch<'_>,
    flow: &Flow<'_>,
    h: f64,
    to: &Arrived,
) -> Option<Obstacle> {
    own_obstacle(flow, to).or_else(|| {
        watch.check(&flow.held, &step(flow, h, to))?;
        watch.met().map(Obstacle::Pair)
    })
}

/// As `obstacle`, for the step that was checked last: the result for its pairs is known.
pub(super) fn last_obstacle(watch: &Watch<'_>, flow: &Flow<'_>, to: &Arrived) -> Option<Obstacle> {
    own_obstacle(flow, to).or_else(|| watch.met().map(Obstacle::Pair))
}

/// Obstacle to a step other than meetings of pairs.
fn own_obstacle(flow: &Flow<'_>, to: &Arrived) -> Option<Obstacle> {
    let pull = -PULL * to.velocity.speed;
    let mut pushes = to.velocity.pushes.iter().zip(&flow.held);
    if pushes.any(|(&p, bound)| p < pull && !bound.is_brake()) {
        return Some(Obstacle::Pull);
    }
    if !agrees(flow.system, flow.pairs, &flow.held, &to.q, &to.velocity) {
        return Some(Obstacle::Friction);
    }
    let leaves = |(bound, room): &(Bound, f64)| match bound {
        Bound::Limit { part, .. } => {
            *room < -limit_tolerance(flow.system, *part) && !flow.held.contains(bound)
        }
        Bound::Contact(_) | Bound::Brake { .. } => false,
    };
    if limits(flow.system, &to.q).iter().any(leaves) {
        return Some(Obstacle::Limit);
    }
    flow.held.iter().find_map(|bound| match bound {
        Bound::Contact(touch) => {
            let pair = &flow.pairs.list()[touch.pair];
            goes_past(pair, touch, flow.system, [&flow.q, &to.q])
                .then_some(Obstacle::Pair(touch.pair))
        }
        Bound::Limit { .. } | Bound::Brake { .. } => None,
    })
}

/// The path of a step.
pub(crate) fn step<'a>(flow: &'a Flow<'_>, h: f64, to: &'a Arrived) -> Path<'a> {
    Path::new(
        (&flow.q, &flow.velocity.rates),
        (&to.q, &to.velocity.rates),
        h,
    )
}
