//! Where a part is along a leg.

use cspace::{AxisMotion, Point, Rotation, Vector};

/// Coordinates as numbers: x, y and θ, or u, v and 0.
pub type Coords = [f64; 3];

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

/// The point of a part that is the origin of its placed frame: what it turns about on an axis.
pub(super) fn origin(motion: AxisMotion) -> Vector {
    match motion {
        AxisMotion::Revolute { center } => center.to_vector(),
        _ => Vector::ZERO,
    }
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
    /// The pose of a part that does not move, whose frame is that of the assembly.
    pub(super) const STILL: Self = Self {
        from: Point::ORIGIN,
        velocity: Vector::ZERO,
        angle: 0.0,
        turning: 0.0,
    };

    /// A part in the plane, at x, y and θ.
    pub(super) fn planar(from: Coords, to: Coords) -> Self {
        Self {
            from: Point::new(from[0], from[1]),
            velocity: Vector::new(to[0] - from[0], to[1] - from[1]),
            angle: from[2],
            turning: to[2] - from[2],
        }
    }

    /// A part on an axis. What turns does so about the origin of its placed frame, see [`origin`].
    pub(super) fn on_axis(motion: AxisMotion, from: f64, to: f64) -> Self {
        match motion {
            AxisMotion::Fixed => Self::STILL,
            AxisMotion::Revolute { center } => Self {
                from: center,
                angle: from,
                turning: to - from,
                ..Self::STILL
            },
            AxisMotion::Prismatic { direction } => {
                let d = direction.unit();
                Self {
                    from: Point::ORIGIN + d * from,
                    velocity: d * (to - from),
                    ..Self::STILL
                }
            }
        }
    }

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
