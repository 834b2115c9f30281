//! Checks that patches read from a file lie where contacts of the parts can be.

use crate::feature::PairFrame;
use crate::geometry::Point;
use crate::part::{Corresponding, Part};

use super::data::{SideLink, SpaceData};
use super::patch::Patch;

/// Result of a check: nothing, or the reason for a rejection.
pub(super) type Check = Result<(), &'static str>;

/// Returns `why` as an error if the condition does not hold.
pub(super) fn ensure(holds: bool, why: &'static str) -> Check {
    if holds { Ok(()) } else { Err(why) }
}

/// Upper bound of the error of lengths in the pair's frame.
const SLACK: f64 = 1e-6;

/// Checks that the frame is the one in which a computation of these parts writes patches.
pub(super) fn check_frame(data: &SpaceData) -> Check {
    let (fixed, moving, frame) = (&data.fixed, &data.moving, data.frame);
    let PairFrame {
        fixed_center,
        moving_center,
        scale,
    } = frame;
    let near = |a: Point, b: Point| a.distance(b) * scale <= SLACK.min(frame.rounding());
    let is_center = |part: &Part, center: Point| {
        // In a computation of one period only, everything is relative to the centres of the boxes.
        let by_symmetry = |by| {
            let symmetrized = part.symmetrized(by);
            symmetrized.is_some_and(|s| near(s.center, center))
        };
        near(PairFrame::center(part), center)
            || (data.symmetry.slabs > 1
                && (by_symmetry(Corresponding::Outlines) || by_symmetry(Corresponding::Vertices)))
    };
    ensure(
        is_center(fixed, fixed_center) && is_center(moving, moving_center),
        "a centre is not that of the part",
    )?;
    let computed = PairFrame::scale_of([(fixed, fixed_center), (moving, moving_center)]);
    // If the radius is close to a power of two, its rounding decides which of two scales is taken.
    let radius = |part: &Part, center: Point| {
        let about = PairFrame {
            fixed_center: center,
            moving_center: center,
            scale,
        };
        0.5 * about.reach(part, part)
    };
    let radius = radius(fixed, fixed_center).max(radius(moving, moving_center));
    let is_rounded = (0.5 - SLACK..=0.5 + SLACK).contains(&radius)
        || (1.0 - SLACK..=1.0 + SLACK).contains(&radius);
    let is_scale =
        scale == computed || is_rounded && (scale == 2.0 * computed || 2.0 * scale == computed);
    ensure(is_scale, "the scale is not that of the parts")
}

/// Distance in the pair's frame above which an end is wrong. Ends of patches are known better than 10⁻⁶; an error above this means another
/// patch.
const OFF: f64 = 1e-3;

/// Orientations of an interval at which it is checked. At its very ends carriers may coincide, so that their crossing is not known.
fn inside(lo: f64, hi: f64) -> [f64; 3] {
    [0.25, 0.5, 0.75].map(|share| lo + share * (hi - lo))
}

/// Duration (radians) below which patches and links are not checked: their carriers may almost coincide, and cross anywhere.
const BRIEF: f64 = 1e-8;

/// Checks that a patch begins and ends on its own contact surface, at positions where the parts can touch.
pub(super) fn check_ends(p: &Patch, reach: f64) -> Check {
    if p.hi - p.lo < BRIEF {
        return Ok(());
    }
    for theta in inside(p.lo, p.hi) {
        for boundary in [&p.left, &p.right] {
            let place = p.inner_at(boundary, theta);
            ensure(
                place.to_vector().length() <= reach + OFF,
                "it ends where the parts cannot touch",
            )?;
            ensure(
                p.function.value(place, theta).abs() <= OFF,
                "it does not end on its contact surface",
            )?;
        }
    }
    Ok(())
}

/// Checks that two linked patches meet: the right boundary of `before` coincides with the left boundary of `after`.
pub(super) fn check_link(patches: &[Patch], link: &SideLink) -> Check {
    let [before, after] = [link.before, link.after].map(|i| patches.get(i.index()));
    let (Some(before), Some(after)) = (before, after) else {
        return Err("there is no such patch");
    };
    if link.hi - link.lo < BRIEF {
        return Ok(());
    }
    for theta in inside(link.lo, link.hi) {
        let end = before.inner_at(&before.right, theta);
        let begin = after.inner_at(&after.left, theta);
        ensure(end.distance(begin) <= OFF, "its patches do not meet")?;
    }
    Ok(())
}
