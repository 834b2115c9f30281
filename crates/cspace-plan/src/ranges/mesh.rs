//! Parts that turn only together: by how much, and with which play.

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::{AxesError, Axis, AxisMotion, FixedAxesSpace};

use core::f64::consts::TAU;

use super::answer::Backlash;
use super::backlash::backlash;
use super::region::{loops, regions, turns_together};

/// Turns of v and of u after which parts that turn only together are back, and the play between them.
pub(super) struct Mesh {
    pub(super) ratio: (i64, i64),
    pub(super) backlash: Option<Backlash>,
}

/// How two parts that turn without limits turn together, if they do: in a space of theirs with no ranges; the play for values of u in a range.
pub(super) fn mesh(
    space: &FixedAxesSpace,
    place: [f64; 2],
    range: Option<(f64, f64)>,
) -> Result<Option<Mesh>, AxesError> {
    let [one] = regions(space, place)[..] else {
        return Ok(None);
    };
    let Some((u, v)) = turns_together(&loops(space, one)) else {
        return Ok(None);
    };
    Ok(Some(Mesh {
        ratio: (v, u),
        backlash: backlash(space, place, range)?,
    }))
}

/// Whether both parts turn, and contact keeps each from going through its range, or a turn, while the other is held at a place.
pub(super) fn turn_not_alone(space: &FixedAxesSpace, place: [f64; 2]) -> bool {
    let (fixed, moving) = space.axes();
    let turns = |axis: Axis| matches!(axis.motion, AxisMotion::Revolute { .. });
    let is_held = |k: usize| {
        let at = place[k];
        let (lo, hi) = [fixed, moving][k].range.unwrap_or((at - TAU, at + TAU));
        [(hi - at, 1.0), (at - lo, -1.0)]
            .into_iter()
            .any(|(far, way)| {
                let mut rates = [0.0; 2];
                rates[k] = way;
                let met = space.first_contact((place[0], place[1]), (rates[0], rates[1]), far);
                far > 0.0 && matches!(met, Ok(AxesMotionOutcome::Contact(_)))
            })
    };
    turns(fixed) && turns(moving) && is_held(0) && is_held(1)
}
