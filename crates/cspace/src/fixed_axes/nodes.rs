//! Where contact curves end because one feature gives way to its neighbour: configurations with names.
//!
//! A node belongs to a joint of one part and a feature of the other (or to two vertices, or two lines), not to a pair
//! of features. All pairs that meet there compute it from the same numbers, so it is the same to the last bit, and its
//! name tells that it is one.

use super::equation::Equation;
use super::meeting::meetings;
use super::motion::Motion;
use super::motion::Motions;
use super::motion::Placement;
use super::piece::Name;
use super::piece::Node;
use super::repeats::Image;
use super::scene::{Scene, Side};
use super::tolerance::INDEPENDENT;
use crate::contact::Cycle;
use crate::feature::Feature;
use crate::geometry::Point;
use crate::geometry::Rotation;
use crate::geometry::Vector;
use core::f64::consts::PI;

impl Scene {
    /// Calls `found` with every node on the curve of a pair of which one is round at least. The first feature stands for
    /// its orbit.
    ///
    /// What belongs to another joint or line of the first part is computed from the one that stands for its orbit, and
    /// moved: so all pairs that meet there have the same numbers, in whatever copy of the window they meet.
    pub(super) fn nodes(&self, ia: u32, ib: u32, mut found: impl FnMut(Node)) {
        let (a, b) = (self.first_feature(ia), self.second_feature(ib));
        let fold = self.repeats.fold;
        let mut found = |name, root, steps: u32, x: f64, y: f64| {
            let (in_window, copy) = self.repeats.split(&self.x, x);
            let copy = (copy + fold - steps) % fold;
            found(Node {
                name,
                root,
                x: if fold == 1 {
                    in_window
                } else {
                    in_window + self.repeats.period() * f64::from(copy)
                },
                y: self.y.reduced(y),
                in_window,
                copy,
            });
        };
        if !b.is_line() {
            self.first_joints(a, ib, b, &mut found);
        }
        if !a.is_line() {
            self.second_joints(ia, a, b, &mut found);
        }
        if a.is_line() {
            self.aligned_with_first(ia, ib, &mut found);
        }
        if b.is_line() {
            self.aligned_with_second(ia, ib, &mut found);
        }
    }

    /// Ends of a feature of the first part touch a round feature: the centre is at X + ρ n.
    fn first_joints(
        &self,
        a: &Feature,
        ib: u32,
        b: &Feature,
        found: &mut impl FnMut(Name, u8, u32, f64, f64),
    ) {
        let Motions { first, second } = self.motions;
        for joint in [a.start, a.end] {
            let Image { of: joint, steps } = self.repeats.joint(joint);
            let (point, normal) = (self.first.point(joint), self.first.normal(joint));
            let name = match self.first.vertex[joint as usize] {
                Some(vertex) if b.is_vertex() => Name::Vertices(vertex, ib),
                _ => Name::FirstJoint(joint, ib),
            };
            let cone = self.second.cones[ib as usize];
            let plausible = |theta: Rotation| cone.may_hold(-(theta.inverse() * normal));
            let meets = |root, x: f64, y: f64| {
                let theta = self.motions.theta(x, y);
                let tied = |k: &u32| self.tied(joint, *k, theta);
                if let Some(k) = [b.start, b.end].into_iter().find(tied) {
                    found(Name::Joints(joint, k), root, steps, x, y);
                } else if self.second_has(b, joint, theta) {
                    found(name, root, steps, x, y);
                }
            };
            let (arc, at) = touching(&self.second, b, point, normal);
            meetings((first, &at), (second, &arc), plausible, meets);
        }
    }

    fn second_joints(
        &self,
        ia: u32,
        a: &Feature,
        b: &Feature,
        found: &mut impl FnMut(Name, u8, u32, f64, f64),
    ) {
        let Motions { first, second } = self.motions;
        for joint in [b.start, b.end] {
            let (point, normal) = (self.second.point(joint), self.second.normal(joint));
            let name = match self.second.vertex[joint as usize] {
                Some(vertex) if a.is_vertex() => Name::Vertices(ia, vertex),
                _ => Name::SecondJoint(ia, joint),
            };
            let cone = self.first.cones[ia as usize];
            let plausible = |theta: Rotation| cone.may_hold(-(theta * normal));
            let meets = |root, x: f64, y: f64| {
                let theta = self.motions.theta(x, y);
                let tied = |k: &u32| self.tied(*k, joint, theta);
                if let Some(k) = [a.start, a.end].into_iter().find(tied) {
                    let Image { of, steps } = self.repeats.joint(k);
                    // The orbit's joint is there when x is larger by the steps between them.
                    let x = x + self.repeats.period() * f64::from(steps);
                    found(Name::Joints(of, joint), root, steps, x, y);
                } else if self.first_has(a, joint, theta) {
                    found(name, root, 0, x, y);
                }
            };
            let (arc, at) = touching(&self.first, a, point, normal);
            meetings((first, &arc), (second, &at), plausible, meets);
        }
    }

    /// The round feature of the second part ends where its normal is a line's of the first.
    fn aligned_with_first(
        &self,
        ia: u32,
        ib: u32,
        found: &mut impl FnMut(Name, u8, u32, f64, f64),
    ) {
        let (a, b) = (self.first_feature(ia), self.second_feature(ib));
        for joint in [b.start, b.end] {
            if let Some(line) = self.second.line[joint as usize] {
                self.lines((ia, 0), line, found, |from_first, at| {
                    !from_first && at == joint
                });
                continue;
            }
            let Motions { first, second } = self.motions;
            let side = self.first.line(a);
            let (point, beta) = (self.second.point(joint), self.second.angle(joint));
            let accepts = self.first.beside(a, point);
            aligned(first, side, second, (point, beta), accepts, |root, x, y| {
                found(Name::LineJoint(ia, joint), root, 0, x, y);
            });
        }
    }

    fn aligned_with_second(
        &self,
        ia: u32,
        ib: u32,
        found: &mut impl FnMut(Name, u8, u32, f64, f64),
    ) {
        let (a, b) = (self.first_feature(ia), self.second_feature(ib));
        for (joint, at_start) in [(a.start, true), (a.end, false)] {
            if let Some(line) = self.first.line[joint as usize] {
                let Image { of, steps } = self.repeats.feature(line);
                // Travel goes on: where the feature starts the line ends.
                let line = self.first_feature(of);
                let joint = if at_start { line.end } else { line.start };
                self.lines((of, steps), ib, found, |from_first, at| {
                    from_first && at == joint
                });
                continue;
            }
            let Image { of: joint, steps } = self.repeats.joint(joint);
            let Motions { first, second } = self.motions;
            let side = self.second.line(b);
            let (point, alpha) = (self.first.point(joint), self.first.angle(joint));
            let accepts = self.second.beside(b, point);
            aligned(
                second,
                side,
                first,
                (point, alpha),
                accepts,
                |root, y, x| {
                    found(Name::JointLine(joint, ib), root, steps, x, y);
                },
            );
        }
    }

    /// Two lines touch along a stretch; it has two ends, each a joint of one part, at which `ends_at` is asked.
    fn lines(
        &self,
        (ia, steps): (u32, u32),
        ib: u32,
        found: &mut impl FnMut(Name, u8, u32, f64, f64),
        ends_at: impl Fn(bool, u32) -> bool,
    ) {
        let Motions { first, second } = self.motions;
        let (a, b) = (self.first_feature(ia), self.second_feature(ib));
        let (start, along, length) = self.first.segment(a);
        let side = self.first.line(a);
        let joint = (self.second.point(b.start), self.second.angle(b.start));
        let accepts = |seen: Placement| {
            let place = |joint| along.dot(seen.point(self.second.point(joint)) - start);
            // Opposite normals: travel goes the other way on the second part.
            let (lo, hi) = (place(b.end), place(b.start));
            if lo.max(0.0) >= hi.min(length) {
                return false;
            }
            let lower = if lo <= 0.0 {
                (true, a.start)
            } else {
                (false, b.end)
            };
            let upper = if hi >= length {
                (true, a.end)
            } else {
                (false, b.start)
            };
            ends_at(lower.0, lower.1) || ends_at(upper.0, upper.1)
        };
        aligned(first, side, second, joint, accepts, |root, x, y| {
            found(Name::Lines(ia, ib), root, steps, x, y);
        });
    }
}

/// A round feature, and where it is when it touches a joint of the other part. Of circles whose centres are near these are
/// enough.
fn touching(side: &Side, f: &Feature, joint: Point, normal: Vector) -> (Cycle, Cycle) {
    if f.near.is_some() {
        let arc = Cycle::of(&side.outline, f);
        return (arc, Cycle::flat(joint, -normal, arc.weight));
    }
    let at = joint + normal * f.radius();
    (Cycle::round(f.center(), 0.0), Cycle::round(at, 0.0))
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
