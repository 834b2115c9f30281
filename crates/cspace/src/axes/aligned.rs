//! Configurations at which a joint of one part is on a line of the other, their normals opposite.

use core::f64::consts::PI;

use crate::geometry::{Point, Rotation, Vector};

use super::condition::INDEPENDENT;
use super::equation::Equation;
use super::motion::Motion;

/// Where the line's part sees the joint's part: its point q at turn q + shift.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    turn: Rotation,
    shift: Vector,
}

impl Seen {
    pub(super) fn point(&self, q: Point) -> Point {
        self.turn * q + self.shift
    }
}

/// Coordinates (of the line's part, of the joint's part) at which a joint is on a line and their normals oppose, if that is
/// to be accepted as the parts then see each other.
pub(super) fn aligned(
    line_motion: Motion,
    (normal, through, alpha): (Vector, Point, f64),
    joint_motion: Motion,
    (point, beta): (Point, f64),
    accepts: impl Fn(Seen) -> bool,
    mut found: impl FnMut(u8, f64, f64),
) {
    let theta = alpha + PI - beta;
    match (line_motion, joint_motion) {
        (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
            // n(t)·(d + R_t R_θ w − c) = n·(l − c).
            let turn = Rotation::by(theta);
            let between = d - c;
            let w = turn * (point - d);
            let equation = Equation::Trig {
                alpha: normal.dot(between),
                beta: normal.left().dot(between),
                gamma: normal.dot(w - (through - c)),
            };
            for (root, t) in (0u8..).zip(equation.directions()) {
                let Some(t) = t else { continue };
                // The other pivot, turned back about the line's.
                let there = Rotation {
                    cos: t.x,
                    sin: -t.y,
                } * between;
                let shift = (c.to_vector() + there) - turn * d.to_vector();
                if accepts(Seen { turn, shift }) {
                    let t = t.angle();
                    found(root, t, t + theta);
                }
            }
        }
        (Motion::Turn { center: c }, Motion::Slide { direction }) => {
            let t = -theta;
            let n = line_motion.vector(t, normal);
            let rate = n.dot(direction);
            if rate.abs() >= INDEPENDENT {
                let s = n.dot(line_motion.point(t, through) - point) / rate;
                let turn = Rotation::by(theta);
                let shift = c.to_vector() + turn * (direction * s - c.to_vector());
                if accepts(Seen { turn, shift }) {
                    found(0, t, s);
                }
            }
        }
        (Motion::Slide { direction }, Motion::Turn { center: d }) => {
            let rate = normal.dot(direction);
            if rate.abs() >= INDEPENDENT {
                let at = joint_motion.point(theta, point);
                let s = normal.dot(at - through) / rate;
                let turn = Rotation::by(theta);
                let shift = d.to_vector() - turn * d.to_vector() - direction * s;
                if accepts(Seen { turn, shift }) {
                    found(0, s, theta);
                }
            }
        }
        _ => {}
    }
}
