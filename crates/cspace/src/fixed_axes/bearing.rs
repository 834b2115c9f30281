//! A cycle carried by one part, as seen from a fixed point: its arm, and the direction of the arm without jumps by whole turns.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::equation::Equation;
use super::motion::Motion;
use crate::contact::Cycle;
use crate::geometry::{Point, Rotation, Vector};

/// A carried cycle. Directions are those of its arm, or of the opposite vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bearing {
    /// Whether the part turns, rather than slides.
    turns: bool,
    /// The vector from the point to the part's pivot, or the direction of sliding.
    offset: Vector,
    weight: f64,
    /// The arm as seen from the pivot, or at x = 0.
    arm: Vector,
    moment: f64,
    /// 1, or −1 if directions are those of the opposite vector.
    pub(super) side: f64,
    /// A direction and its angle; it is less than a quarter turn from the direction that is measured.
    about: Vector,
    angle: f64,
    /// Whether `about` turns with the part: then it is the direction of the arm as seen from the pivot.
    turning: bool,
}

/// A carried cycle at a given x.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    pub(super) arm: Vector,
    pub(super) moment: f64,
    side: f64,
    about: Vector,
    angle: f64,
}

impl Bearing {
    pub(super) fn new(motion: Motion, cycle: &Cycle, from: Point, side: f64) -> Self {
        let (offset, arm, moment) = match motion {
            Motion::Turn { center } => {
                let offset = center - from;
                let moment = cycle.level(center) + 0.5 * cycle.weight * offset.length_squared();
                (offset, cycle.arm(center), moment)
            }
            Motion::Slide { direction } => (direction, cycle.arm(from), cycle.level(from)),
            Motion::Still => (Vector::ZERO, cycle.arm(from), cycle.level(from)),
        };
        let between = offset * (cycle.weight * side);
        let (about, turning) = match motion {
            // λ w + R a: the longer of the two is always less than a quarter turn from their sum.
            Motion::Turn { .. } if arm.length_squared() < between.length_squared() => {
                (between, false)
            }
            Motion::Turn { .. } => (arm * side, true),
            Motion::Slide { direction } if cycle.is_centred() => {
                let left = direction.left();
                let beyond = left.dot(arm * side) < 0.0;
                (if beyond { -left } else { left }, false)
            }
            // The direction of the arm of a sliding cycle whose centre is far away turns little: it turns by a quarter turn only at the
            // distance of the centre.
            Motion::Slide { .. } | Motion::Still => (arm * side, false),
        };
        Self {
            turns: motion.turns(),
            offset,
            weight: cycle.weight,
            arm,
            moment,
            side,
            about,
            angle: about.angle(),
            turning,
        }
    }

    #[inline]
    pub(super) fn seen(&self, x: f64) -> Seen {
        let (arm, moment, about, angle) = if self.turns {
            let arm = Rotation::by(x) * self.arm;
            let (about, angle) = if self.turning {
                (arm * self.side, self.angle + x)
            } else {
                (self.about, self.angle)
            };
            let moment = self.moment + self.offset.dot(arm);
            (self.offset * self.weight + arm, moment, about, angle)
        } else {
            let half = self.offset * (0.5 * self.weight * x);
            let moment = self.moment + x * self.offset.dot(self.arm + half);
            (self.arm + half + half, moment, self.about, self.angle)
        };
        Seen {
            arm,
            moment,
            side: self.side,
            about,
            angle,
        }
    }

    /// The moment as a function of x, minus a constant, with the sign of the side.
    pub(super) fn moment_less(&self, constant: f64) -> Equation {
        let (arm, c) = (self.arm * self.side, self.side * (self.moment - constant));
        if self.turns {
            Equation::Trig {
                alpha: arm.dot(self.offset),
                beta: arm.left().dot(self.offset),
                gamma: c,
            }
        } else if self.offset == Vector::ZERO {
            Equation::constant(c)
        } else {
            Equation::Quadratic {
                a: 0.5 * self.side * self.weight,
                b: arm.dot(self.offset),
                c,
            }
        }
    }

    /// Whether the length of the cycle's arm is below `near` at every x.
    pub(super) fn is_nothing(&self, near: f64) -> bool {
        self.arm.length() < near && (self.offset * self.weight).length() < near
    }
}

impl Seen {
    /// The angle of the arm, or of the opposite vector, plus the angle of (c, s) if `sign` is 1, minus it if `sign` is −1; s is not
    /// negative.
    ///
    /// The first angle is less than a quarter turn from the reference direction, the second is at most half a turn: so the angle of their
    /// product, which is computed, is their sum up to a turn that its quadrant decides.
    #[inline]
    pub(super) fn turned(&self, (c, s): (f64, f64), sign: f64) -> f64 {
        let arm = self.arm * self.side;
        let (along, aside) = (self.about.dot(arm), self.about.cross(arm));
        let s = sign * s;
        let sum = (aside * c + along * s).atan2(along * c - aside * s);
        let sum = if sign * sum < -FRAC_PI_2 {
            sum + sign * TAU
        } else {
            sum
        };
        self.angle + sum
    }
}
