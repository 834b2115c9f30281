//! The carriers of two features that can touch.

use crate::feature::Feature;
use crate::feature::tolerance::SMALLEST_CIRCLE;
use crate::geometry::{Point, Vector};

use super::cycle::Cycle;
use super::scene::Scene;

/// When two features touch: their carriers, at zero coordinates.
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
    /// Any two features of which one is an arc whose centre is far away.
    Cycles { first: Cycle, second: Cycle },
}

impl Carriers {
    /// With the parts exchanged.
    pub(super) fn swapped(&self) -> Self {
        match *self {
            Self::FirstLine {
                normal,
                through,
                point,
                radius,
            } => Self::SecondLine {
                normal,
                through,
                point,
                radius,
            },
            Self::SecondLine {
                normal,
                through,
                point,
                radius,
            } => Self::FirstLine {
                normal,
                through,
                point,
                radius,
            },
            Self::Circles {
                first,
                second,
                radius,
            } => Self::Circles {
                first: second,
                second: first,
                radius,
            },
            Self::Cycles { first, second } => Self::Cycles {
                first: second,
                second: first,
            },
        }
    }
}

/// The condition of a pair of features, if they can touch.
pub(super) fn carriers(scene: &Scene, ia: u32, ib: u32) -> Option<Carriers> {
    let (a, b) = (scene.first_feature(ia), scene.second_feature(ib));
    let found = by_centres(scene, a, b)?;
    if a.near.is_none() && b.near.is_none() {
        return Some(found);
    }
    Some(Carriers::Cycles {
        first: Cycle::of(&scene.first, a),
        second: Cycle::of(&scene.second, b),
    })
}

/// The condition of two features by the centres of those that are round.
fn by_centres(scene: &Scene, a: &Feature, b: &Feature) -> Option<Carriers> {
    match (a.is_line(), b.is_line()) {
        (true, false) if b.radius() >= 0.0 => {
            let joint = scene.first.outline.start(a);
            Some(Carriers::FirstLine {
                normal: joint.normal,
                through: joint.point,
                point: b.center(),
                radius: b.radius(),
            })
        }
        (false, true) if a.radius() >= 0.0 => {
            let joint = scene.second.outline.start(b);
            Some(Carriers::SecondLine {
                normal: joint.normal,
                through: joint.point,
                point: a.center(),
                radius: a.radius(),
            })
        }
        (false, false) => {
            let radius = a.radius() + b.radius();
            let convex = a.radius() >= 0.0 && b.radius() >= 0.0;
            let concave = a.radius() < 0.0 && b.radius() < 0.0;
            let touch = !concave
                && if convex {
                    radius >= SMALLEST_CIRCLE
                } else {
                    radius <= -SMALLEST_CIRCLE
                };
            touch.then_some(Carriers::Circles {
                first: a.center(),
                second: b.center(),
                radius,
            })
        }
        _ => None,
    }
}
