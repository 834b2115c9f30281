//! Orientations with their rotations, in numbers of any kind.

use crate::geometry::Rotation;
use crate::number::{Dd, Real};

/// An orientation in radians, with its rotation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Orientation<T = f64> {
    pub(crate) theta: T,
    pub(crate) turn: Rotation<T>,
}

impl<T: Real> Orientation<T> {
    pub(crate) fn by(theta: T) -> Self {
        Self {
            theta,
            turn: Rotation::by(theta),
        }
    }
}

impl Orientation<Dd> {
    /// The orientation at another angle: computed from this one if it is so near that a few terms of sine and cosine of the difference are
    /// enough.
    pub(crate) fn turned_to(&self, theta: Dd) -> Self {
        /// Difference (radians) whose fourth power, divided by 24, is negligible beside one.
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
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A turn from a nearby orientation equals that by the angle.
    #[test]
    fn turns_to_what_is_near() {
        let base = Orientation::by(Dd::from(0.7) + 1e-19);
        for by in [
            0.0, 1e-30, -3e-20, 2e-14, -7e-11, 9.9e-9, -1e-8, 1.1e-8, 0.3,
        ] {
            let theta = base.theta + by;
            let (turn, expected) = (base.turned_to(theta), Orientation::by(theta));
            for off in [
                turn.turn.cos - expected.turn.cos,
                turn.turn.sin - expected.turn.sin,
            ] {
                assert!(off.to_f64().abs() < 4e-32, "{by}: {off:?}");
            }
        }
    }
}
