//! Index of the patches that come near a configuration, which avoids examining all of them.
//!
//! The interval of a patch is halved until its curves move little in each part. A box contains all its curves there: they are enclosed, not
//! sampled (`swept.rs`), except for the rounding of their ends. A tree of the boxes finds those that contain the orientation and are near
//! the position; their patches are evaluated as in a slice. So the answers are those found by examining all patches. The first queries do
//! examine all patches, until building the tree pays off.

use core::f64::consts::{PI, TAU};

use crate::boxes::{Boxes, Swath};
use crate::contact::ContactFunction;
use crate::feature::tolerance::WIDEST_SAGITTA;
use crate::geometry::{Configuration, Point, Rotation, Vector};
use crate::ids::PatchId;
use crate::parallel::prelude::*;
use crate::part::Bounds;
use crate::space::{ContactSpace, Patch};

use super::classify::END_ERROR;
use super::swept::{Orientations, Swept};

/// Maximum displacement of curves from the middle of an interval, and maximum excess length (length of the pair's frame).
const LOOSE: f64 = 4.0 * WIDEST_SAGITTA;
/// Maximum number of times that the interval of a patch is halved.
const HALVINGS: u32 = 6;
/// Bound of the error of critical orientations (radians): farther than this from the beginning and the end of a patch, the ends of its
/// curve do not pass each other.
const SEAM: f64 = 1.0 / (1u32 << 16) as f64;
/// Number of queries answered by examining every patch: these take about as long as building the tree.
const SCANS: u32 = 512;
/// A distance above all that are computed (length of the pair's frame).
const EVERYWHERE: f64 = 1e100;
/// Bound of the relative rounding error of a distance.
const RELATIVE: f64 = 1e-12;
/// Bound of the rounding error of a turned orientation, in units of the largest summand.
const TURNED: f64 = 8.0 * f64::EPSILON;

impl ContactSpace {
    /// Calls `visit` with every patch that exists at a configuration's orientation and whose curve there comes within a distance of its
    /// position: the patch, the nearest point and its distance. A visit may lower the distance by its result. Some patches farther away are
    /// visited too, and some twice; the first queries visit all.
    pub(super) fn visit_near(
        &self,
        c: Configuration,
        within: f64,
        mut visit: impl FnMut(PatchId, Point, f64) -> f64,
    ) {
        let surface = self.surface();
        let settled = surface.settled(c.theta);
        let home = home(settled);
        let slack = TURNED * settled.abs();
        let p = self.data.frame.inner_from_outer(c);
        let margin = END_ERROR + 2.0 * self.data.frame.rounding();
        let distance = |swath: &Swath| {
            let holds = |t: f64| swath.lo - slack <= t && t <= swath.hi + slack;
            if ![home - TAU, home, home + TAU].into_iter().any(holds) {
                return None;
            }
            let inner = swath.bounds.distance(p) * (1.0 - RELATIVE) - margin;
            Some(self.data.frame.outer_length(inner.max(0.0)))
        };
        let mut limit = within;
        let mut look = |i: u32| {
            let patch = &self.data.patches[i as usize];
            if let Some(t) = surface.alive(patch, settled) {
                let curve = surface.curve_as_at(patch, t, c.theta);
                let q = curve.nearest(c.position());
                limit = visit(PatchId(i), q, q.distance(c.position()));
            }
            limit
        };
        match self.places.after(SCANS, || boxes(self)) {
            Some(boxes) => boxes.visit_near(distance, within, look),
            None => (0..self.data.patches.len() as u32).for_each(|i| {
                look(i);
            }),
        }
    }
}

impl ContactSpace {
    /// A list, in ascending order, that includes all patches that come within a distance `reach` of a position (lengths of the pair's
    /// frame) at orientations no farther than `wide` from `theta`; `None` for the first queries.
    pub(super) fn around(&self, p: Point, theta: f64, reach: f64, wide: f64) -> Option<Vec<u32>> {
        let boxes = self.places.after(SCANS, || boxes(self))?;
        let home = home(theta);
        let (slack, margin) = (TURNED * theta.abs() + wide, reach + END_ERROR);
        let reaches = |swath: &Swath| {
            let holds = |t: f64| swath.lo - slack <= t && t <= swath.hi + slack;
            [home - TAU, home, home + TAU].into_iter().any(holds)
                && swath.bounds.distance(p) * (1.0 - RELATIVE) <= margin
        };
        let mut found = Vec::new();
        boxes.any(reaches, |i| {
            found.push(i);
            false
        });
        found.sort_unstable();
        found.dedup();
        Some(found)
    }
}

/// An orientation reduced to [−π, π) by whole turns.
fn home(theta: f64) -> f64 {
    theta - TAU * ((theta + PI) / TAU).floor()
}

fn boxes(space: &ContactSpace) -> Boxes<Swath> {
    let of_each: Vec<Vec<Swath>> = (space.data.patches.par_iter()).map(swaths).collect();
    let numbered = (0u32..).zip(of_each).flat_map(|(i, swaths)| {
        let numbered = move |swath| (i, swath);
        swaths.into_iter().map(numbered)
    });
    Boxes::numbered(numbered.collect())
}

/// The boxes of a patch. Next to the orientations at which it begins and ends they contain the whole carriers.
fn swaths(patch: &Patch) -> Vec<Swath> {
    let (lo, hi) = (patch.lo, patch.hi);
    if hi - lo <= 2.0 * SEAM {
        return vec![of_carrier(patch, lo, hi)];
    }
    let (first, last) = (lo + SEAM, hi - SEAM);
    let mut swaths = vec![of_carrier(patch, lo, first), of_carrier(patch, last, hi)];
    halve(patch, first, last, HALVINGS, &mut swaths);
    swaths
}

/// Adds the boxes of a patch between two of its orientations.
fn halve(patch: &Patch, lo: f64, hi: f64, left: u32, swaths: &mut Vec<Swath>) {
    let mid = 0.5 * (lo + hi);
    let swept = Swept::new(patch, &Orientations::between(lo, hi));
    if left > 0 && swept.spread.max(swept.slack) > LOOSE {
        halve(patch, lo, mid, left - 1, swaths);
        halve(patch, mid, hi, left - 1, swaths);
    } else {
        swaths.push(swath(swept.shape.bounds(), swept.spread, lo, hi));
    }
}

/// The box of a whole circle; for any other carrier it contains all positions.
fn of_carrier(patch: &Patch, lo: f64, hi: f64) -> Swath {
    let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let (center, reach) = match patch.function {
        ContactFunction::Circle { center, radius } => {
            let reach = radius.abs() + center.w.length() * half;
            (center.at(Rotation::by(mid)), reach)
        }
        _ => (Point::ORIGIN, EVERYWHERE),
    };
    swath(Bounds::of(center, center), reach, lo, hi)
}

/// A box extended by a distance, over orientations reduced to a turn.
fn swath(bounds: Bounds, by: f64, lo: f64, hi: f64) -> Swath {
    let (by, from) = (Vector::new(by, by), home(lo));
    let slack = TURNED * (lo.abs() + TAU);
    Swath {
        bounds: Bounds {
            min: bounds.min - by,
            max: bounds.max + by,
        },
        lo: from - slack,
        hi: from + (hi - lo) + slack,
    }
}
