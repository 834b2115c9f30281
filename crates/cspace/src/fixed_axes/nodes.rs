//! Where contact curves end because one feature gives way to its neighbour: configurations with names.
//!
//! A node belongs to a joint of one part and a feature of the other (or to two vertices, or two lines), not to a pair
//! of features. All pairs that meet there compute it from the same numbers, so it is the same to the last bit, and its
//! name tells that it is one.

use super::cycle::Cycle;
use super::equation::Equation;
use super::equation::apexes;
use super::equation::coincidences;
use super::motion::Motion;
use super::motion::Motions;
use super::motion::Placement;
use super::piece::Name;
use super::piece::Node;
use super::repeats::Image;
use super::scene::Scene;
use super::tolerance::INDEPENDENT;
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
            if b.near.is_some() {
                let arc = Cycle::of(&self.second, b);
                let (tip, of_arc) = (Tip::of_joint(point, normal, arc.weight), Tip::of_arc(&arc));
                meetings((first, &tip), (second, &of_arc), meets);
            } else {
                let at = point + normal * b.radius();
                coincidences(first, at, second, b.center(), plausible, meets);
            }
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
            if a.near.is_some() {
                let arc = Cycle::of(&self.first, a);
                let (of_arc, tip) = (Tip::of_arc(&arc), Tip::of_joint(point, normal, arc.weight));
                meetings((first, &of_arc), (second, &tip), meets);
            } else {
                let at = point + normal * a.radius();
                coincidences(first, a.center(), second, at, plausible, meets);
            }
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

// Configurations at which a joint touches a large arc of the other part, their normals opposite.
//
// The centre of the arc is at X + r n then, for the joint X with the normal n: two points that coincide, as in
// [`coincidences`](super::equation::coincidences), but far away. All lengths are taken κ = 1/r times, so that both points
// are seen from the pivots at about one, and what their squares differ by is known without the difference.

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
