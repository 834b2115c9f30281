//! Configurations at which a joint touches a large arc of the other part, their normals opposite.
//!
//! The centre of the arc is at X + r n then, for the joint X with the normal n: two points that coincide, as in
//! [`coincidences`](super::equation::coincidences), but far away. All lengths are taken κ = 1/r times, so that both points
//! are seen from the pivots at about one, and what their squares differ by is known without the difference.

use super::cycle::Cycle;
use super::equation::{Equation, apexes};
use super::motion::{Motion, Placement};
use super::tolerance::INDEPENDENT;
use crate::geometry::{Point, Rotation, Vector};
use core::f64::consts::PI;

/// κ times the way from where it is seen to the centre of the arc, and what its square is more than one.
#[derive(Debug, Clone, Copy)]
struct Arm {
    vector: Vector,
    excess: f64,
}

/// A point of one part at which the centre of the arc is to be: a joint with its normal, or a point of the arc with the
/// opposite of its own.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tip {
    point: Point,
    normal: Vector,
    curvature: f64,
}

impl Tip {
    pub(super) fn of_joint(point: Point, normal: Vector, curvature: f64) -> Self {
        Self {
            point,
            normal,
            curvature,
        }
    }

    pub(super) fn of_arc(arc: &Cycle) -> Self {
        Self::of_joint(arc.through, -arc.normal, arc.weight)
    }

    fn arm(&self, from: Point) -> Arm {
        let d = (self.point - from) * self.curvature;
        Arm {
            vector: d + self.normal,
            excess: d.dot(d + self.normal * 2.0),
        }
    }
}

/// Coordinates (s, t) at which both tell the same centre.
pub(super) fn meetings(
    (first, p): (Motion, &Tip),
    (second, q): (Motion, &Tip),
    mut found: impl FnMut(u8, f64, f64),
) {
    match (first, second) {
        (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
            let (v, w, between) = (p.arm(c), q.arm(d), (d - c) * p.curvature);
            if c.distance(d) < INDEPENDENT {
                return;
            }
            let apart = between.length();
            let (e, f) = (v.vector.length(), w.vector.length());
            let differ = v.excess - w.excess;
            let (less, sum) = (differ / (e + f), e + f);
            let square = (apart - less) * (apart + less) * (sum - apart) * (sum + apart);
            if square < 0.0 {
                return;
            }
            for (root, [from_first, from_second]) in apexes(between, differ, square) {
                found(
                    root,
                    turn(v.vector, from_first),
                    turn(w.vector, from_second),
                );
            }
        }
        (Motion::Turn { center }, Motion::Slide { direction }) => {
            slid(p, q, center, direction, found);
        }
        (Motion::Slide { direction }, Motion::Turn { center }) => {
            slid(q, p, center, direction, |root, t, s| found(root, s, t));
        }
        (Motion::Slide { direction: d }, Motion::Slide { direction: e }) => {
            // p + s d + r n = q + t e + r m.
            let area = d.cross(e);
            if area.abs() >= INDEPENDENT {
                let v = (q.point - p.point) + (q.normal - p.normal) * (1.0 / p.curvature);
                found(0, v.cross(e) / area, v.cross(d) / area);
            }
        }
        (Motion::Still, _) | (_, Motion::Still) => {}
    }
}

/// The angle from one direction to another.
fn turn(from: Vector, to: Vector) -> f64 {
    from.cross(to).atan2(from.dot(to))
}

/// Root, angle and way at which what turns about a centre is where what slides is.
fn slid(
    turning: &Tip,
    sliding: &Tip,
    center: Point,
    d: Vector,
    mut found: impl FnMut(u8, f64, f64),
) {
    let (v, w) = (turning.arm(center), sliding.arm(center));
    let (aside, along) = (d.cross(w.vector), d.dot(w.vector));
    let differ = v.excess - w.excess;
    let square = along * along + differ;
    if square < 0.0 {
        return;
    }
    for (root, half) in [(0, square.sqrt()), (1, -square.sqrt())] {
        // half − along, without the cancelling.
        let way = if (half < 0.0) == (along < 0.0) {
            differ / (half + along)
        } else {
            half - along
        };
        let at = d * half + d.left() * aside;
        found(root, turn(v.vector, at), way / turning.curvature);
    }
}

// Configurations at which a joint of one part is on a line of the other, their normals opposite.

/// Coordinates (of the line's part, of the joint's part) at which a joint is on a line and their normals oppose, if that is
/// to be accepted as the line's part then sees the joint's.
pub(super) fn aligned(
    line_motion: Motion,
    (normal, through, alpha): (Vector, Point, f64),
    joint_motion: Motion,
    (point, beta): (Point, f64),
    accepts: impl Fn(Placement) -> bool,
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
                if accepts(Placement { turn, shift }) {
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
                if accepts(Placement { turn, shift }) {
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
                if accepts(Placement { turn, shift }) {
                    found(0, s, theta);
                }
            }
        }
        _ => {}
    }
}
