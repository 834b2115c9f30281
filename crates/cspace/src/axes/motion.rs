//! How a part moves on its axis, in the frame of the pair.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::geometry::{Point, Rotation, Vector};

use super::cycle::Cycle;

/// A motion of one degree of freedom at most, with coordinate t.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Motion {
    /// No motion.
    Still,
    /// q → c + `R_t` (q − c).
    Turn { center: Point },
    /// q → q + t d, with d of length one.
    Slide { direction: Vector },
}

impl Motion {
    /// Where a point of the part is.
    #[inline]
    pub(super) fn point(&self, t: f64, p: Point) -> Point {
        match *self {
            Self::Still => p,
            Self::Turn { center } => center + Rotation::by(t) * (p - center),
            Self::Slide { direction } => p + direction * t,
        }
    }

    /// Where a direction of the part points.
    #[inline]
    pub(super) fn vector(&self, t: f64, v: Vector) -> Vector {
        match self {
            Self::Turn { .. } => Rotation::by(t) * v,
            _ => v,
        }
    }

    /// By how much the part has turned, radians.
    #[inline]
    pub(super) fn angle(&self, t: f64) -> f64 {
        if self.turns() { t } else { 0.0 }
    }

    /// The velocity by t of the point of the part that is now at `p`.
    #[inline]
    pub(super) fn velocity(&self, p: Point) -> Vector {
        match *self {
            Self::Still => Vector::ZERO,
            Self::Turn { center } => (p - center).left(),
            Self::Slide { direction } => direction,
        }
    }

    pub(super) fn turns(&self) -> bool {
        matches!(self, Self::Turn { .. })
    }
}

/// The motions of both parts.
///
/// The first has the coordinate x along which the plane is swept, the second the coordinate y.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Motions {
    pub(super) first: Motion,
    pub(super) second: Motion,
}

impl Motions {
    pub(super) fn swapped(&self) -> Self {
        Self {
            first: self.second,
            second: self.first,
        }
    }

    /// Whether both parts turn about one point.
    pub(super) fn share_a_pivot(&self) -> bool {
        match (self.first, self.second) {
            (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
                c.distance(d) < super::condition::INDEPENDENT
            }
            _ => false,
        }
    }

    /// Makes pivots one that are nearer to each other than `near`, and tells how far that takes any place of the second
    /// part: its turns about both differ by (1 − R)(c − d).
    ///
    /// A corner at both pivots would touch the other part's sides there, or not, wherever the parts are.
    pub(super) fn join_pivots(&mut self, near: f64) -> f64 {
        let (Motion::Turn { center: c }, Motion::Turn { center: d }) = (self.first, self.second)
        else {
            return 0.0;
        };
        let apart = c.distance(d);
        if apart >= near {
            return 0.0;
        }
        self.second = self.first;
        2.0 * apart
    }

    /// Makes slides parallel that are so but for less than `near`, and tells the angle by which the second's direction is
    /// turned (radians).
    pub(super) fn join_slides(&mut self, near: f64) -> f64 {
        let (Motion::Slide { direction: d }, Motion::Slide { direction: e }) =
            (self.first, self.second)
        else {
            return 0.0;
        };
        let angle = d.cross(e).abs();
        if angle >= near {
            return 0.0;
        }
        let direction = d * d.dot(e).signum();
        self.second = Motion::Slide { direction };
        angle
    }

    /// The sine of the angle between the directions, if both parts slide.
    pub(super) fn between_slides(&self) -> Option<f64> {
        match (self.first, self.second) {
            (Motion::Slide { direction: d }, Motion::Slide { direction: e }) => {
                Some(d.cross(e).abs())
            }
            _ => None,
        }
    }

    /// The orientation of the second part seen from the first.
    #[inline]
    pub(super) fn theta(&self, x: f64, y: f64) -> f64 {
        self.second.angle(y) - self.first.angle(x)
    }

    /// Where the first part's frame sees the origin of the second's, and its orientation.
    pub(super) fn relative(&self, x: f64, y: f64) -> (Point, f64) {
        let world = self.second.point(y, Point::ORIGIN);
        let seen = match self.first {
            Motion::Slide { direction } => world + direction * -x,
            turn => turn.point(-x, world),
        };
        (seen, self.theta(x, y))
    }
}

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
