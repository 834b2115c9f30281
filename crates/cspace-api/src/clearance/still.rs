//! Parts that have no motion beside parts on axes: most likely they stand still, and the model does not say so.

use cspace_model::{Mechanism, shown};

use crate::host::Host;

/// Notes that an axis has no effect against a part that has no motion: the pair is planar, and looked at as drawn.
///
/// A part that is carried by a joint, or is subject to masses, springs or loads, moves in the plane by intention.
pub(super) fn tell(model: &Mechanism, host: &dyn Host) {
    let dynamics = &model.dynamics;
    let is_free = |i: usize| {
        let is_carried = (model.joints.iter()).any(|j| j.parts.0 == i || j.parts.1 == i);
        let of_part = dynamics.parts.get(i);
        let moves =
            of_part.is_some_and(|p| p.mass.is_some() || p.start.is_some() || p.rate.is_some());
        let is_loaded = dynamics.loads.iter().any(|l| l.part == i)
            || (dynamics.springs.iter()).any(|s| s.part == i || s.other == Some(i));
        model.parts[i].axis.is_none() && !is_carried && !moves && !is_loaded
    };
    let turns = |i: usize| {
        let axis = model.parts[i].axis;
        axis.is_some_and(|a| a.motion != cspace::AxisMotion::Fixed)
    };
    let free: Vec<usize> = (0..model.parts.len()).filter(|&i| is_free(i)).collect();
    let Some(moving) = (0..model.parts.len()).find(|&i| turns(i)) else {
        return;
    };
    for &part in free.iter().take(MOST) {
        let [free, moving] = [part, moving].map(|i| shown::quoted(model.parts[i].part.name()));
        host.note(&format_args!(
            "part {free} has no motion, so it is free in the plane, and the axis of {moving} is not used against it: if it stands still, add `motion = {{ type = \"fixed\" }}` to part {free}"
        ));
    }
    if let Some(more @ 1..) = free.len().checked_sub(MOST) {
        host.note(&format_args!("{more} more parts without a motion"));
    }
}

/// So many parts are named.
const MOST: usize = 4;
