//! Places on the surface, by the contact functions of the patches that are followed.

use cspace::{PatchId, QueryError};

use super::ground::Ground;
use super::tolerance::{FARTHEST_LANDING, ON_SURFACE};
use super::vector::{Vec3, minus, size, weighted, weights_of};

/// Newton's method doubles digits with each step: where so many do not do, there is no such place.
const NEWTON_STEPS: usize = 12;

/// A place on the surface, and the patches that it is on.
#[derive(Debug, Clone)]
pub(super) struct Landing {
    pub(super) goal: Vec3,
    pub(super) followed: Vec<PatchId>,
}

/// The place on some patches nearest to where a step of a length ends; `None` if there is none near.
pub(super) fn land_on(
    ground: &impl Ground,
    end: Vec3,
    length: f64,
    followed: Vec<PatchId>,
) -> Result<Option<Landing>, QueryError> {
    let goal = on_surface(ground, end, &followed)?;
    let goal = goal.filter(|g| size(minus(*g, end)) <= FARTHEST_LANDING * length);
    Ok(goal.map(|goal| Landing { goal, followed }))
}

/// How far a position is above a patch, to first order.
pub(super) fn value_off(ground: &impl Ground, patch: PatchId, at: Vec3) -> Result<f64, QueryError> {
    let f = ground.constraint(patch, at)?;
    Ok(f.value / size(f.gradient))
}

/// The nearest place at which the contact functions of some patches vanish, by Newton's method; `None` if it does not come to one.
pub(super) fn on_surface(
    ground: &impl Ground,
    from: Vec3,
    patches: &[PatchId],
) -> Result<Option<Vec3>, QueryError> {
    let mut at = from;
    for _ in 0..NEWTON_STEPS {
        let (mut rows, mut values) = (Vec::new(), Vec::new());
        let mut weights = [0.0; 3];
        let mut is_on = true;
        // Of contacts that depend on each other the first do.
        for &patch in patches {
            let f = ground.constraint(patch, at)?;
            is_on &= f.value.abs() <= ON_SURFACE * ground.contact();
            if rows.len() == at.len() {
                continue;
            }
            rows.push(f.gradient);
            values.push(-f.value);
            match weights_of(&rows, &values) {
                Some(more) => weights = more,
                None => {
                    rows.pop();
                    values.pop();
                }
            }
        }
        if is_on {
            return Ok(Some(at));
        }
        at = weighted(&rows, weights, at);
        if !at.iter().all(|x| x.is_finite()) {
            return Ok(None);
        }
    }
    Ok(None)
}
