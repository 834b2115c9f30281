//! Orientations in double-double.

use crate::geometry::Rotation;
use crate::number::Dd;

/// An orientation in double-double, with its rotation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactTurn {
    pub(crate) theta: Dd,
    pub(super) turn: Rotation<Dd>,
}

impl ExactTurn {
    pub(crate) fn by(theta: Dd) -> Self {
        Self {
            theta,
            turn: Rotation::by(theta),
        }
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
        let Rotation { cos, sin } = self.turn;
        Self {
            theta,
            turn: Rotation {
                cos: cos - (sin * sine + cos * versine),
                sin: sin + (cos * sine - sin * versine),
            },
        }
    }

    /// By the rotation, where the angle itself is not asked for.
    pub(crate) fn of(turn: Rotation<Dd>) -> Self {
        let theta = Dd::from(turn.sin.to_f64().atan2(turn.cos.to_f64()));
        Self { theta, turn }
    }
}
