//! Places on patches, and ways across them.

use core::f64::consts::TAU;

use cspace::{CurveGeometry, PatchId, Point};

/// A place on a patch: its orientation, in the numbering of the patch, and the share of its contact curve, 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Station {
    pub(super) theta: f64,
    pub(super) share: f64,
}

/// A way across a patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Across {
    pub(super) patch: PatchId,
    /// Whole turns that are added to the patch's orientations along the path.
    pub(super) turn: f64,
    pub(super) entry: Station,
    pub(super) exit: Station,
}

/// The share of a curve at which it is nearest to a point of it.
pub(super) fn share_of(curve: &CurveGeometry, at: Point) -> f64 {
    let on_chord = |start: Point, end: Point| {
        let way = end - start;
        let share = (at - start).dot(way) / way.length_squared();
        if share.is_finite() {
            share.clamp(0.0, 1.0)
        } else {
            0.0
        }
    };
    match *curve {
        CurveGeometry::Arc {
            center,
            start_angle,
            sweep,
            ..
        } => {
            let turned = ((at - center).angle() - start_angle) * sweep.signum();
            let turned = turned - TAU * (turned / TAU).floor();
            let whole = sweep.abs();
            if turned <= whole {
                turned / whole
            } else if turned - whole < TAU - turned {
                1.0
            } else {
                0.0
            }
        }
        CurveGeometry::Segment { start, end } | CurveGeometry::FlatArc { start, end, .. } => {
            on_chord(start, end)
        }
    }
}
