//! Contact conditions as stored in saved spaces: one form for each kind of features.

use super::condition::Condition;
use crate::contact::Cycle;
use crate::geometry::{Point, Vector};

/// Contact condition of two features: the equation that holds where they touch, at zero coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Carriers {
    /// A line of the first part and an arc or vertex of the second: n(x)·(q(y) − l(x)) = ρ.
    FirstLine {
        normal: Vector,
        through: Point,
        point: Point,
        radius: f64,
    },
    /// An arc or vertex of the first part and a line of the second: n(y)·(p(x) − l(y)) = ρ.
    SecondLine {
        normal: Vector,
        through: Point,
        point: Point,
        radius: f64,
    },
    /// Two round features: |q(y) − p(x)| = |r|.
    Circles {
        first: Point,
        second: Point,
        radius: f64,
    },
    /// Any two features, at least one of them an arc whose centre is far away.
    Cycles { first: Cycle, second: Cycle },
}

impl Carriers {
    pub(super) fn of(condition: &Condition) -> Self {
        let Condition { first, second, .. } = *condition;
        match (first.is_centred(), second.is_centred()) {
            (true, true) => Self::Circles {
                first: first.through,
                second: second.through,
                radius: first.weight * first.size + second.weight * second.size,
            },
            (false, true) if first.weight == 0.0 => Self::FirstLine {
                normal: first.normal,
                through: first.through,
                point: second.through,
                radius: second.size,
            },
            (true, false) if second.weight == 0.0 => Self::SecondLine {
                normal: second.normal,
                through: second.through,
                point: first.through,
                radius: first.size,
            },
            _ => Self::Cycles { first, second },
        }
    }
}
