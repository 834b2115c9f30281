//! Parts that turn only together: by how much, and with which play.

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::{AxesError, Axis, AxisMotion, FixedAxesSpace};

use core::f64::consts::TAU;

use super::answer::Backlash;
use super::backlash::backlash;
use super::kept::Kept;
use super::region::{loops, regions, turns_together};

/// Two parts of which neither can turn without the other.
#[derive(Debug)]
pub struct Mesh<'a> {
    /// Their space without ranges.
    endless: Kept<'a>,
    place: [f64; 2],
    /// Values of u over which the play is asked for.
    range: Option<(f64, f64)>,
    turns: (i64, i64),
}

impl Mesh<'_> {
    /// Turns of v and of u after which the parts are back where they were.
    pub fn ratio(&self) -> (i64, i64) {
        self.turns
    }

    /// The play of the moving part while the other is held, over a turn of that or its range; none if something in the region is passed on
    /// two sides.
    ///
    /// # Errors
    /// If the plane of their motions cannot be computed.
    pub fn backlash(&self) -> Result<Option<Backlash>, AxesError> {
        backlash(&self.endless, self.place, self.range)
    }
}

/// How two parts that turn without limits turn together, if they do: in a space of theirs with no ranges; the play for values of u in a range.
pub(super) fn mesh(
    endless: Kept<'_>,
    place: [f64; 2],
    range: Option<(f64, f64)>,
) -> Option<Mesh<'_>> {
    let [one] = regions(&endless, place)[..] else {
        return None;
    };
    let (u, v) = turns_together(&loops(&endless, one))?;
    Some(Mesh {
        endless,
        place,
        range,
        turns: (v, u),
    })
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
