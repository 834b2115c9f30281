//! Orientations in double-double, and the spirals on which curves end.

use crate::feature::Outline;
use crate::number::Dd;
use crate::number::plane::{Xy, negative, plus, rounded, times, turned};

use super::super::sheet::{EndAt, Sheet};

/// An orientation in double-double, with its rotation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactTurn {
    pub(crate) theta: Dd,
    pub(super) cos: Dd,
    pub(super) sin: Dd,
}

impl ExactTurn {
    pub(crate) fn by(theta: Dd) -> Self {
        let (sin, cos) = theta.sin_cos();
        Self { theta, cos, sin }
    }

    /// The orientation at another angle: from this one if that is so near that sine and cosine of the difference are a few terms.
    pub(crate) fn turned_to(&self, theta: Dd) -> Self {
        /// The fourth power of what is nearer than this, by 24, is nothing beside one (radians).
        const NEAR: f64 = 1e-8;
        let by = theta - self.theta;
        let d = by.to_f64();
        if d.abs() > NEAR {
            return Self::by(theta);
        }
        let (sine, versine) = (by - d * d * d / 6.0, 0.5 * d * d);
        Self {
            theta,
            cos: self.cos - (self.sin * sine + self.cos * versine),
            sin: self.sin + (self.cos * sine - self.sin * versine),
        }
    }

    /// By cosine and sine, where the angle itself is not asked for.
    pub(crate) fn of(cos: Dd, sin: Dd) -> Self {
        let theta = Dd::from(sin.to_f64().atan2(cos.to_f64()));
        Self { theta, cos, sin }
    }
}

/// A point u + R w.
#[derive(Debug, Clone, Copy)]
pub(super) struct ExactSpiral {
    pub(super) u: Xy<Dd>,
    pub(super) w: Xy<Dd>,
}

impl ExactSpiral {
    pub(super) fn at(&self, turn: &ExactTurn) -> Xy<Dd> {
        plus(self.u, turned(self.w, turn.cos, turn.sin))
    }

    /// The sum of its coordinates, for the rounding of what is computed from it.
    pub(super) fn size(&self) -> f64 {
        let (u, w) = (rounded(self.u), rounded(self.w));
        u.0.abs() + u.1.abs() + w.0.abs() + w.1.abs()
    }
}

/// Where a curve starts or ends.
pub(super) fn end(fixed: &Outline, moving: &Outline, sheet: &Sheet, at: EndAt) -> ExactSpiral {
    let (a, b) = (
        &fixed.exact_features[sheet.fixed as usize],
        &moving.exact_features[sheet.moving as usize],
    );
    match at {
        EndAt::Fixed(j) => {
            let j = &fixed.exact_joints[j as usize];
            ExactSpiral {
                u: plus(j.point, times(j.normal, b.radius)),
                w: negative(b.center),
            }
        }
        EndAt::Moving(j) => {
            let j = &moving.exact_joints[j as usize];
            ExactSpiral {
                u: a.center,
                w: negative(plus(j.point, times(j.normal, a.radius))),
            }
        }
    }
}
