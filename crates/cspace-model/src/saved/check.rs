//! Checks of a saved space that the library does not make.

use cspace::pair::Joint;
use cspace::{Axis, AxisMotion, PairSpace};

use super::error::wrong;
use crate::LARGEST_ANGLE;
use crate::{ModelError, shown};

/// Names go to terminals, which obey control characters, and into XML, which has no place for them.
pub(super) fn is_plain(what: &str, text: &str, file: &str) -> Result<(), ModelError> {
    if !text.contains(char::is_control) {
        return Ok(());
    }
    let text = shown::cut(text);
    Err(wrong(
        &format!(
            "the {what} has a control character: \"{}\"",
            shown::text(&text)
        ),
        file,
    ))
}

pub(super) fn check_names(space: &PairSpace, file: &str) -> Result<(), ModelError> {
    is_plain("fixed part's name", space.fixed().name(), file)?;
    is_plain("moving part's name", space.moving().name(), file)
}

/// Orientations and turns are within what a model may have.
pub(super) fn check_angles(space: &PairSpace, file: &str) -> Result<(), ModelError> {
    let turning = |axis: Axis| match axis.motion {
        AxisMotion::Revolute { .. } => axis.range,
        _ => None,
    };
    let ranges = match space {
        PairSpace::Planar(space) => [Some((space.window().lo, space.window().hi)), None],
        PairSpace::FixedAxes(space) => [turning(space.axes().0), turning(space.axes().1)],
        PairSpace::Lower(pair) => match pair.joint() {
            Joint::Revolute { .. } => [pair.limits(), None],
            _ => [None; 2],
        },
    };
    let mut angles = ranges.into_iter().flatten().flat_map(|(lo, hi)| [lo, hi]);
    match angles.find(|a| a.abs() > LARGEST_ANGLE) {
        None => Ok(()),
        Some(a) => Err(wrong(
            &format!(
                "the angle {} rad is more than {LARGEST_ANGLE:e} rad from 0",
                shown::number(a)
            ),
            file,
        )),
    }
}
