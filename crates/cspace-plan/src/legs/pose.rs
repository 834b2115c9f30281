//! Where a part is along a leg.

use cspace::{Point, Rotation, Vector};

/// A motion of constant rates for times from 0 to 1: the part's point q is at from + velocity t + R(angle + turning t) q.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    pub(super) from: Point,
    pub(super) velocity: Vector,
    /// Radians.
    pub(super) angle: f64,
    /// Radians for the whole leg.
    pub(super) turning: f64,
}

/// The pose at one time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed {
    pub(super) at: Point,
    pub(super) turn: Rotation,
    pub(super) angle: f64,
    pub(super) velocity: Vector,
    pub(super) turning: f64,
}

impl Pose {
    pub(super) fn at(&self, t: f64) -> Placed {
        let angle = self.angle + self.turning * t;
        Placed {
            at: self.from + self.velocity * t,
            turn: Rotation::by(angle),
            angle,
            velocity: self.velocity,
            turning: self.turning,
        }
    }
}

/// A point that moves: where it is and how fast, and how fast that changes at most.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mover {
    pub(super) at: Point,
    pub(super) velocity: Vector,
    pub(super) bend: f64,
}

impl Placed {
    /// A point of the part.
    pub(super) fn point(&self, q: Point) -> Mover {
        let arm = self.turn * q.to_vector();
        Mover {
            at: self.at + arm,
            velocity: self.velocity + arm.left() * self.turning,
            bend: self.turning * self.turning * arm.length(),
        }
    }

    /// The point of the part, in its own frame, that is at a place.
    pub(super) fn back(&self, p: Point) -> Point {
        Point::ORIGIN + self.turn.inverse() * (p - self.at)
    }

    /// The part's frame seen from a point that moves: the point in that frame, with its velocity there and a bound on how
    /// fast that changes, over times up to `half` away.
    pub(super) fn seen(&self, p: Mover, half: f64) -> Mover {
        let back = self.turn.inverse();
        let way = p.at - self.at;
        let relative = p.velocity - self.velocity;
        let omega = self.turning;
        let slip = relative - way.left() * omega;
        let farthest = way.length() + (relative.length() + p.bend * half) * half;
        let fastest = relative.length() + p.bend * half;
        Mover {
            at: Point::ORIGIN + back * way,
            velocity: back * slip,
            bend: p.bend + 2.0 * omega.abs() * fastest + omega * omega * farthest,
        }
    }
}
