//! Whether a step of the motion may be taken as it is.

use crate::contact::{Bound, Path, Watch, limit_tolerance, limits};

use super::flow::{Arrived, Flow};
use super::friction::agrees;

/// A contact's push below this share of the speed, and negative, is a pull.
const PULL: f64 = 1e-10;

/// Whether closed contacts push all the way and agree with friction, no other part is met, and no range is left.
pub(crate) fn goes_on(watch: &mut Watch<'_>, flow: &Flow<'_>, h: f64, to: &Arrived) -> bool {
    let pull = -PULL * to.velocity.speed;
    let mut pushes = to.velocity.pushes.iter().zip(&flow.held);
    if pushes.any(|(&p, bound)| p < pull && !bound.is_brake()) {
        return false;
    }
    if !agrees(flow.system, flow.pairs, &flow.held, &to.q, &to.velocity) {
        return false;
    }
    let leaves = |(bound, room): &(Bound, f64)| match bound {
        Bound::Limit { part, .. } => {
            *room < -limit_tolerance(flow.system, *part) && !flow.held.contains(bound)
        }
        Bound::Contact(_) | Bound::Brake { .. } => false,
    };
    if limits(flow.system, &to.q).iter().any(leaves) {
        return false;
    }
    watch.check(&flow.held, &step(flow, h, to)).is_none()
}

/// The path of a step.
pub(crate) fn step<'a>(flow: &'a Flow<'_>, h: f64, to: &'a Arrived) -> Path<'a> {
    Path::new(
        (&flow.q, &flow.velocity.rates),
        (&to.q, &to.velocity.rates),
        h,
    )
}
