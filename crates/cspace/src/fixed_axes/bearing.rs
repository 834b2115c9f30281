//! The direction of what one part carries, seen from the other part's pivot, without jumps by whole turns.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::geometry::{Point, Rotation, Vector};

use super::cycle::Cycle;
use super::motion::Motion;

/// The direction of a point that the first part carries, seen from a centre that stays: continuous in x, without
/// jumps by whole turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bearing {
    motion: Motion,
    point: Point,
    center: Point,
    /// The direction whose angle `angle` is.
    about: Vector,
    angle: f64,
    /// Whether `about` turns with the first part.
    turning: bool,
}

impl Bearing {
    pub(super) fn new(motion: Motion, point: Point, center: Point) -> Self {
        let (about, turning) = match motion {
            Motion::Still => (point - center, false),
            // c₁ − c₂ + R p: the longer of the two never lies a quarter turn or more from their sum.
            Motion::Turn { center: own } => {
                let (between, arm) = (own - center, point - own);
                if arm.length_squared() < between.length_squared() {
                    (between, false)
                } else {
                    (arm, true)
                }
            }
            Motion::Slide { direction } => {
                let side = direction.left();
                let side = if side.dot(point - center) < 0.0 {
                    -side
                } else {
                    side
                };
                (side, false)
            }
        };
        Self {
            motion,
            point,
            center,
            about,
            angle: about.angle(),
            turning,
        }
    }

    /// The direction of the arm of a cycle that the first part carries.
    pub(super) fn of_arm(motion: Motion, cycle: &Cycle, center: Point) -> Self {
        if cycle.is_centred() {
            return Self::new(motion, cycle.through, center);
        }
        // Arms are as many times smaller than what they stand for as the weight says, and so are ways.
        match motion {
            Motion::Turn { center: own } => {
                let own_arm = Point::ORIGIN + (own - center) * cycle.weight;
                let turning = Motion::Turn { center: own_arm };
                Self::new(turning, own_arm + cycle.arm(own), Point::ORIGIN)
            }
            Motion::Slide { .. } | Motion::Still => {
                let arm = cycle.arm(center);
                let motion = match motion {
                    Motion::Slide { direction } => Motion::Slide {
                        direction: direction * cycle.weight,
                    },
                    other => other,
                };
                // It turns by little: to a quarter turn it is as far as to the centre.
                Self {
                    motion,
                    point: Point::ORIGIN + arm,
                    center: Point::ORIGIN,
                    about: arm,
                    angle: arm.angle(),
                    turning: false,
                }
            }
        }
    }

    /// The vector from the centre to the point.
    #[inline]
    pub(super) fn vector(&self, x: f64) -> Vector {
        self.motion.point(x, self.point) - self.center
    }

    /// The angle of the vector, plus the angle of (c, s) where `sign` is 1, less it where it is −1; s is not negative.
    ///
    /// The first is less than a quarter turn from the direction it is measured by, the second at most half a turn: so the
    /// angle of their product, which is computed, is their sum but for a turn that its quadrant tells.
    #[inline]
    pub(super) fn turned(&self, x: f64, v: Vector, (c, s): (f64, f64), sign: f64) -> f64 {
        let (about, angle) = if self.turning {
            (Rotation::by(x) * self.about, self.angle + x)
        } else {
            (self.about, self.angle)
        };
        let (along, aside) = (about.dot(v), about.cross(v));
        let s = sign * s;
        let sum = (aside * c + along * s).atan2(along * c - aside * s);
        let sum = if sign * sum < -FRAC_PI_2 {
            sum + sign * TAU
        } else {
            sum
        };
        angle + sum
    }
}
