//! Contact conditions of two features: what must vanish where they touch.

use crate::geometry::{Point, Vector};

use super::cycle::Bearing;
use super::cycle::{self, Cycle};
use super::motion::{Motion, Motions};
use super::tolerance::INDEPENDENT;

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

/// A condition prepared to be solved for y.
///
/// Root 0 is where the contact function grows with y (free space above), root 1 where it falls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Condition {
    pub(super) carriers: Carriers,
    pub(super) motions: Motions,
    /// Second turning: direction to the carried point, and the angle and the arm of the turning feature. Of cycles, the first
    /// one's arm, and the angle, the arm and for `offset` the moment of the second, all seen from the second part's pivot.
    pub(super) bearing: Bearing,
    pub(super) angle: f64,
    pub(super) arm: f64,
    /// What the turning line's distance from its own pivot and the radius add up to.
    pub(super) offset: f64,
}

impl Condition {
    pub(super) fn new(carriers: Carriers, motions: Motions) -> Self {
        let pivot = match motions.second {
            Motion::Turn { center } => center,
            _ => Point::ORIGIN,
        };
        let (carried, angle, arm, offset) = match carriers {
            Carriers::FirstLine { normal, point, .. } => {
                let w = point - pivot;
                (point, normal.angle() - w.angle(), w.length(), 0.0)
            }
            Carriers::SecondLine {
                normal,
                through,
                point,
                radius,
            } => (
                point,
                -normal.angle(),
                0.0,
                radius + normal.dot(through - pivot),
            ),
            Carriers::Circles { first, second, .. } => {
                let w = second - pivot;
                (first, -w.angle(), w.length(), 0.0)
            }
            Carriers::Cycles { first, second } => {
                let arm = second.arm(pivot);
                let moment = second.moment(pivot);
                (first.through, -arm.angle(), arm.length(), moment)
            }
        };
        let bearing = match carriers {
            Carriers::Cycles { first, .. } => Bearing::of_arm(motions.first, &first, pivot),
            _ => Bearing::new(motions.first, carried, pivot),
        };
        Self {
            carriers,
            motions,
            bearing,
            angle,
            arm,
            offset,
        }
    }

    /// The same condition, to be solved for x.
    pub(super) fn swapped(&self) -> Self {
        Self::new(self.carriers.swapped(), self.motions.swapped())
    }

    /// The contact function: the distance of the carriers along the normal, positive where the parts are apart.
    pub(super) fn value(&self, x: f64, y: f64) -> f64 {
        let Motions { first, second } = self.motions;
        match self.carriers {
            Carriers::FirstLine {
                normal,
                through,
                point,
                radius,
            } => {
                let n = first.vector(x, normal);
                n.dot(second.point(y, point) - first.point(x, through)) - radius
            }
            Carriers::SecondLine {
                normal,
                through,
                point,
                radius,
            } => {
                let n = second.vector(y, normal);
                n.dot(first.point(x, point) - second.point(y, through)) - radius
            }
            Carriers::Circles {
                first: p,
                second: q,
                radius,
            } => {
                let apart = second.point(y, q).distance(first.point(x, p));
                (apart - radius.abs()) * radius.signum()
            }
            Carriers::Cycles {
                first: a,
                second: b,
            } => cycle::distance(&a.moved(first, x), &b.moved(second, y)),
        }
    }

    /// Its derivatives by x and y.
    pub(super) fn gradient(&self, x: f64, y: f64) -> (f64, f64) {
        let Motions { first, second } = self.motions;
        match self.carriers {
            Carriers::FirstLine { normal, point, .. } => {
                let (n, q) = (first.vector(x, normal), second.point(y, point));
                (-n.dot(first.velocity(q)), n.dot(second.velocity(q)))
            }
            Carriers::SecondLine { normal, point, .. } => {
                let (n, p) = (second.vector(y, normal), first.point(x, point));
                (n.dot(first.velocity(p)), -n.dot(second.velocity(p)))
            }
            Carriers::Circles {
                first: p,
                second: q,
                radius,
            } => {
                let (p, q) = (first.point(x, p), second.point(y, q));
                let n = (q - p).unit() * radius.signum();
                (-n.dot(first.velocity(p)), n.dot(second.velocity(q)))
            }
            Carriers::Cycles {
                first: a,
                second: b,
            } => {
                let (a, b) = (a.moved(first, x), b.moved(second, y));
                let slopes = cycle::slopes(&a, first, &b, second);
                // F is K d + λ₁ λ₂ d²/2 for the distance d.
                let rate = cycle::centres(&a, &b).length();
                (slopes.0 / rate, slopes.1 / rate)
            }
        }
    }

    /// Whether the condition does not depend on y: its curves are x = constant.
    pub(super) fn is_vertical(&self) -> bool {
        let carried_by_pivot = |p: Point| match (self.motions.first, self.motions.second) {
            (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
                p.distance(c) < INDEPENDENT && c.distance(d) < INDEPENDENT
            }
            (Motion::Still, Motion::Turn { center: d }) => p.distance(d) < INDEPENDENT,
            _ => false,
        };
        match (self.carriers, self.motions.second) {
            (_, Motion::Still) => true,
            (Carriers::FirstLine { .. }, Motion::Turn { .. }) => self.arm < INDEPENDENT,
            (Carriers::SecondLine { point, .. }, Motion::Turn { .. }) => carried_by_pivot(point),
            (Carriers::Circles { first, .. }, Motion::Turn { .. }) => {
                self.arm < INDEPENDENT || carried_by_pivot(first)
            }
            (Carriers::FirstLine { normal, .. }, Motion::Slide { direction }) => {
                !self.motions.first.turns() && normal.dot(direction).abs() < INDEPENDENT
            }
            (Carriers::SecondLine { normal, .. }, Motion::Slide { direction }) => {
                normal.dot(direction).abs() < INDEPENDENT
            }
            (Carriers::Circles { .. }, Motion::Slide { .. }) => false,
            // The arm of an arc whose centre is far away is about one; that of a line is.
            (Carriers::Cycles { first, second }, Motion::Turn { .. }) => {
                second.is_centred() && self.arm < INDEPENDENT
                    || first.is_centred() && carried_by_pivot(first.through)
            }
            (Carriers::Cycles { first, second }, Motion::Slide { direction }) => {
                let along = |line: &Cycle| {
                    line.weight == 0.0 && line.normal.dot(direction).abs() < INDEPENDENT
                };
                !self.motions.first.turns() && along(&first) || along(&second)
            }
        }
    }
}
