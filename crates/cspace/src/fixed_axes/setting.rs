//! The frame of the sweep: from the motions u and v to its coordinates x and y, where these run, and the parts in it.

use crate::contact::{Body, overlap};
use crate::feature::tolerance::CONTACT;
use crate::feature::{FeatureName, PairFrame};

use super::domain::{Extent, ExtentKind};
use super::motion::{Motion, Motions};
use super::tolerance::INDEPENDENT;

/// From u and v to x and y and back.
///
/// x is the coordinate along which the plane is swept: one of a part that turns, if there is one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Map {
    pub(super) frame: PairFrame,
    pub(super) swapped: bool,
    /// Model units per unit of x and y.
    pub(super) x_unit: f64,
    pub(super) y_unit: f64,
}

impl Map {
    pub(super) fn inner(&self, u: f64, v: f64) -> (f64, f64) {
        let (x, y) = self.exchanged(u, v);
        (x / self.x_unit, y / self.y_unit)
    }

    pub(super) fn outer(&self, x: f64, y: f64) -> (f64, f64) {
        let (x, y) = (x * self.x_unit, y * self.y_unit);
        self.exchanged(x, y)
    }

    /// Something of x and of y as that of u and of v.
    pub(super) fn exchanged<T>(&self, of_x: T, of_y: T) -> (T, T) {
        if self.swapped {
            (of_y, of_x)
        } else {
            (of_x, of_y)
        }
    }

    /// Model units per unit of u and of v.
    pub(super) fn units(&self) -> (f64, f64) {
        self.outer(1.0, 1.0)
    }
}

/// Both parts, ready to be placed.
#[derive(Debug)]
pub(super) struct Bodies {
    pub(super) first: Body,
    pub(super) second: Body,
    pub(super) motions: Motions,
}

impl Bodies {
    /// Whether the parts overlap at (x, y). Certain away from contact.
    pub(super) fn overlap(&self, x: f64, y: f64) -> bool {
        let (p, theta) = self.motions.relative(x, y);
        overlap(&self.first, &self.second, p, theta)
    }
}

/// What follows from the parts and their axes alone and is needed for questions.
#[derive(Debug)]
pub(super) struct Setting {
    pub(super) map: Map,
    pub(super) motions: Motions,
    pub(super) x: Extent,
    pub(super) y: Extent,
    pub(super) bodies: Bodies,
    /// What the features of the first and of the second part are called.
    pub(super) names: (Vec<FeatureName>, Vec<FeatureName>),
    /// How far the parts as computed are from the parts as drawn, in the model's unit of length.
    pub(super) deviation: f64,
    /// How far off its place a contact may be because sharp corners are grown by more than sides, in the model's unit.
    pub(super) grown: f64,
}

impl Setting {
    /// Configurations at which a contact function is less than this are in contact (model length): the resolution, but for
    /// what corners are grown by.
    pub(super) fn contact_distance(&self) -> f64 {
        self.map.frame.outer_length(CONTACT) + self.deviation
    }

    /// The same in the frame of the pair.
    pub(super) fn inner_contact_distance(&self) -> f64 {
        self.contact_distance() * self.map.frame.scale
    }

    /// u and v of a point on a curve: 0 of a part that does not move, of which the arrangement has a strip.
    pub(super) fn outer(&self, x: f64, y: f64) -> (f64, f64) {
        let at = |t: f64, m: Motion| if m == Motion::Still { 0.0 } else { t };
        self.map
            .outer(at(x, self.motions.first), at(y, self.motions.second))
    }

    /// Coordinates within the extents; none outside the ranges.
    pub(super) fn placed(&self, u: f64, v: f64) -> Option<(f64, f64)> {
        let (mut x, mut y) = self.map.inner(u, v);
        if !(x.is_finite() && y.is_finite()) {
            return None;
        }
        for (t, extent) in [(&mut x, &self.x), (&mut y, &self.y)] {
            match extent.kind {
                ExtentKind::Circle => *t = extent.reduced(*t),
                ExtentKind::TurnLimits | ExtentKind::SlideLimits => {
                    if !(extent.lo..=extent.hi).contains(t) {
                        return None;
                    }
                }
                ExtentKind::Open => {}
            }
        }
        // A part that does not move is at 0 and nowhere else.
        let moved = |t: f64, m: Motion| m == Motion::Still && t != 0.0;
        if moved(x, self.motions.first) || moved(y, self.motions.second) {
            return None;
        }
        if let Some(share) = self.on_one_line() {
            y -= x * share;
            x = 0.0;
        }
        Some((x, y))
    }

    /// Of parts that slide along one line without limits only the difference of y and so many x matters.
    pub(super) fn on_one_line(&self) -> Option<f64> {
        let (Motion::Slide { direction: d }, Motion::Slide { direction: e }) =
            (self.motions.first, self.motions.second)
        else {
            return None;
        };
        let open = self.x.kind == ExtentKind::Open && self.y.kind == ExtentKind::Open;
        (open && d.cross(e).abs() < INDEPENDENT).then(|| d.dot(e))
    }
}
