//! Items of the kernel that the crate `cspace-classifier` needs beyond the interface. They are for that crate alone and carry no promise:
//! every version may change or remove them.

use core::ops::Range;

pub use crate::contact::{SlabMotion, Steps};
pub use crate::query::swept::{Orientations, Swept};

use crate::contact::{ContactFunction, Spiral};
use crate::feature::tolerance;
use crate::geometry::{Point, Rotation};
use crate::query::classify;
use crate::slice::CurveGeometry;
use crate::space::{self, Boundary, ContactSpace, Patch};

/// Width of the narrowest band (radians).
pub const NARROWEST_BAND: f64 = tolerance::NARROWEST_BAND;

/// Accuracy to which ends of curves are known (length of the pair's frame).
pub const END_ERROR: f64 = classify::END_ERROR;

/// Distance of the ends of an arc, as a share of the radius, below which ends in the wrong order count as one point.
pub const PASSED_ENDS: f64 = space::PASSED_ENDS;

/// Largest distance from the origin of the pair's frame at which the parts can be in contact.
pub fn reach(space: &ContactSpace) -> f64 {
    let data = &space.data;
    data.frame.reach(&data.fixed, &data.moving)
}

/// Bound of the rounding error of positions within reach (length of the pair's frame).
pub fn rounding(space: &ContactSpace) -> f64 {
    space.data.frame.rounding()
}

/// The orientation; or if it is critical up to rounding, the smallest one above that is certain to be in the next band.
pub fn settled(space: &ContactSpace, theta: f64) -> f64 {
    space.settled(theta)
}

/// Whether an orientation is in one of the doubtful intervals whose indices are in `near`.
#[inline]
pub fn is_doubtful(space: &ContactSpace, theta: f64, near: Range<usize>) -> bool {
    space.doubts().hold_among(theta, near)
}

/// The settled orientation reduced to the interval of a patch, if the patch is part of the slice there.
#[inline]
pub fn alive(space: &ContactSpace, patch: &Patch, settled: f64) -> Option<f64> {
    space.alive(patch, settled)
}

/// The curve of a patch in the slice at an orientation, if the patch is part of it.
pub fn curve(space: &ContactSpace, patch: &Patch, theta: f64) -> Option<CurveGeometry> {
    let alive = space.alive(patch, space.settled(theta))?;
    Some(space.curve_as_at(patch, alive, theta))
}

/// The position of one of a patch's boundaries in the pair's frame, and its rounding error.
#[inline]
pub fn end(boundary: &Boundary, own: &ContactFunction, turn: Rotation) -> (Point, f64) {
    boundary.inner_and_error(own, turn)
}

/// The position of a spiral at an orientation.
#[inline]
pub fn position(spiral: &Spiral, turn: Rotation) -> Point {
    spiral.at(turn)
}

/// The value of a contact function at a position of the pair's frame, given the rotation by the orientation.
#[inline]
pub fn value(function: &ContactFunction, p: Point, turn: Rotation) -> f64 {
    function.cycle(turn).distance(p)
}
