//! Where contact curves end because one feature gives way to its neighbour: configurations with names.
//!
//! A node belongs to a joint of one part and a feature of the other (or to two vertices, or two lines), not to a pair
//! of features. All pairs that meet there compute it from the same numbers, so it is the same to the last bit, and its
//! name tells that it is one.

use core::f64::consts::PI;

use crate::feature::{Feature, Outline};
use crate::geometry::{Point, Rotation, Vector};

use super::condition::INDEPENDENT;
use super::domain::{Extent, wrapped};
use super::equation::{Equation, coincidences};
use super::motion::{Motion, Motions};
use super::repeats::{Image, Repeats};

/// What a node is, so that ends of curves find each other.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize,
)]
pub(super) enum Name {
    /// A joint of the first part touches a round feature of the second.
    FirstJoint(u32, u32),
    /// A round feature of the first part touches a joint of the second.
    SecondJoint(u32, u32),
    /// Two vertices touch.
    Vertices(u32, u32),
    /// Two lines touch along a stretch.
    Lines(u32, u32),
    /// A line of the first part has the normal of a joint of the second, between round features.
    LineJoint(u32, u32),
    /// A joint of the first part, between round features, has the normal of a line of the second.
    JointLine(u32, u32),
    /// Two smooth joints between arcs touch, their normals opposite.
    Joints(u32, u32),
    /// The two roots of a pair become one: pair, which of them.
    Turning(u32, u32),
    /// A curve goes on with the same pair: at the cut of a circle, or where it is cut to be monotone.
    Same(u32, u32),
    /// A curve goes on in the next copy of the window.
    Seam(u32, u32),
    /// A limit of a motion, or the window's end.
    Limit,
}

/// A name, which of several such configurations, and in which turn.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize,
)]
pub(super) struct Key {
    pub(super) name: Name,
    pub(super) root: u8,
    pub(super) x_turn: i32,
    pub(super) y_turn: i32,
}

impl Key {
    /// The key when pairs have other numbers.
    pub(super) fn renumbered(mut self, number: impl Fn(u32) -> u32) -> Self {
        if let Name::Turning(pair, _) | Name::Same(pair, _) = &mut self.name {
            *pair = number(*pair);
        }
        self
    }
}

/// A node on the curve of a pair; coordinates in the first turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spot {
    pub(super) name: Name,
    pub(super) root: u8,
    pub(super) x: f64,
    pub(super) y: f64,
    /// Where it is in the window, and in which copy of it x is.
    pub(super) in_window: f64,
    pub(super) copy: u32,
}

/// Normals nearer than this to an end of an interval of normals are told by that end alone (radians).
const NEAR: f64 = 1e-3;

/// Normals that oppose each other to within this do so exactly (radians): the rounding of the configurations at which that is
/// asked, with room.
const TIE: f64 = 1e-12;

/// One part with what its joints belong to.
#[derive(Debug)]
pub(super) struct Side {
    pub(super) outline: Outline,
    vertex: Vec<Option<u32>>,
    line: Vec<Option<u32>>,
    cones: Vec<Cone>,
}

/// The normals of a feature: about a middle one.
#[derive(Debug, Clone, Copy)]
struct Cone {
    middle: Vector,
    /// Cosine of half its width and a little more.
    least: f64,
}

impl Cone {
    fn new(f: &Feature) -> Self {
        Self {
            middle: Vector::from_angle(0.5 * (f.lo + f.hi)),
            least: (0.5 * (f.hi - f.lo) + NEAR).min(PI).cos(),
        }
    }

    /// Whether a direction is among the normals, or near to them: a quick look before the decision.
    fn may_hold(&self, direction: Vector) -> bool {
        self.middle.dot(direction) >= self.least
    }
}

impl Side {
    pub(super) fn new(outline: Outline) -> Self {
        Self {
            vertex: outline.vertex_of_joint(),
            line: outline.line_of_joint(),
            cones: outline.features.iter().map(Cone::new).collect(),
            outline,
        }
    }

    fn point(&self, joint: u32) -> Point {
        self.outline.joints[joint as usize].point
    }

    fn normal(&self, joint: u32) -> Vector {
        self.outline.joints[joint as usize].normal
    }

    fn angle(&self, joint: u32) -> f64 {
        self.outline.joints[joint as usize].angle
    }

    /// Start of a line's, its unit direction of travel, and its length.
    pub(super) fn segment(&self, line: &Feature) -> (Point, Vector, f64) {
        let (start, end) = (self.point(line.start), self.point(line.end));
        let along = self.normal(line.start).left();
        (start, along, along.dot(end - start))
    }
}

/// Both parts, and how they move.
#[derive(Debug)]
pub(super) struct Scene {
    pub(super) first: Side,
    pub(super) second: Side,
    pub(super) motions: Motions,
    pub(super) x: Extent,
    pub(super) y: Extent,
    /// How the first part repeats itself.
    pub(super) repeats: Repeats,
}

impl Scene {
    /// How far a normal of the second part is, counter-clockwise, from opposing one of the first.
    ///
    /// Where both oppose each other, for good or just there, the second is taken to be turned by a little more. Every
    /// pair asks this of the same two joints, so all agree.
    fn beyond(&self, first_angle: f64, second_angle: f64, theta: f64) -> f64 {
        let angle = wrapped(second_angle + theta + PI - first_angle);
        if angle.abs() < TIE { 0.0 } else { angle }
    }

    /// Whether two smooth joints between arcs oppose each other in passing. In what order the contact passes them is not
    /// known then; so all four pairs of arcs are cut there, and where each is in contact is told away from it.
    fn tied(&self, first_joint: u32, second_joint: u32, theta: f64) -> bool {
        let turning = self.motions.first.turns() || self.motions.second.turns();
        let smooth = |side: &Side, joint: u32| {
            side.line[joint as usize].is_none() && side.vertex[joint as usize].is_none()
        };
        let (a, b) = (
            self.first.angle(first_joint),
            self.second.angle(second_joint),
        );
        turning
            && self.beyond(a, b, theta) == 0.0
            && smooth(&self.first, first_joint)
            && smooth(&self.second, second_joint)
    }

    /// Whether a round feature of the second part has the normal opposite to that of a joint of the first.
    fn second_has(&self, b: &Feature, first_joint: u32, theta: f64) -> bool {
        let angle = self.first.angle(first_joint);
        let (lo, hi) = b.joints_by_angle();
        let to_lo = self.beyond(angle, self.second.angle(lo), theta);
        let to_hi = self.beyond(angle, self.second.angle(hi), theta);
        within(b, to_lo < 0.0, to_lo, to_hi >= 0.0, to_hi, -1.0)
    }

    /// Whether a round feature of the first part has the normal opposite to that of a joint of the second.
    fn first_has(&self, a: &Feature, second_joint: u32, theta: f64) -> bool {
        let angle = self.second.angle(second_joint);
        let (lo, hi) = a.joints_by_angle();
        let from_lo = self.beyond(self.first.angle(lo), angle, theta);
        let from_hi = self.beyond(self.first.angle(hi), angle, theta);
        within(a, from_lo >= 0.0, from_lo, from_hi < 0.0, from_hi, 1.0)
    }

    /// Whether the normals of the pair can oppose each other while nothing turns.
    pub(super) fn normals_meet(&self, ia: u32, ib: u32) -> bool {
        let (a, b) = (self.first_feature(ia), self.second_feature(ib));
        match (a.is_line(), b.is_line()) {
            (true, _) => self.second_has(b, a.start, 0.0),
            (_, true) => self.first_has(a, b.start, 0.0),
            _ => true,
        }
    }

    pub(super) fn first_feature(&self, i: u32) -> &Feature {
        &self.first.outline.features[i as usize]
    }

    pub(super) fn second_feature(&self, i: u32) -> &Feature {
        &self.second.outline.features[i as usize]
    }

    /// Calls `found` with every node on the curve of a pair of which one is round at least. The first feature stands for
    /// its orbit.
    ///
    /// What belongs to another joint or line of the first part is computed from the one that stands for its orbit, and
    /// moved: so all pairs that meet there have the same numbers, in whatever copy of the window they meet.
    pub(super) fn spots(&self, ia: u32, ib: u32, mut found: impl FnMut(Spot)) {
        let (a, b) = (self.first_feature(ia), self.second_feature(ib));
        let fold = self.repeats.fold;
        let mut found = |name, root, steps: u32, x: f64, y: f64| {
            let (in_window, copy) = self.repeats.split(&self.x, x);
            let copy = (copy + fold - steps) % fold;
            found(Spot {
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
            let at = self.first.point(joint) + self.first.normal(joint) * b.radius();
            let name = match self.first.vertex[joint as usize] {
                Some(vertex) if b.is_vertex() => Name::Vertices(vertex, ib),
                _ => Name::FirstJoint(joint, ib),
            };
            let normal = self.first.normal(joint);
            let cone = self.second.cones[ib as usize];
            let plausible = |theta: Rotation| cone.may_hold(-(theta.inverse() * normal));
            coincidences(first, at, second, b.center(), plausible, |root, x, y| {
                let theta = self.motions.theta(x, y);
                let tied = |k: &u32| self.tied(joint, *k, theta);
                if let Some(k) = [b.start, b.end].into_iter().find(tied) {
                    found(Name::Joints(joint, k), root, steps, x, y);
                } else if self.second_has(b, joint, theta) {
                    found(name, root, steps, x, y);
                }
            });
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
            let at = self.second.point(joint) + self.second.normal(joint) * a.radius();
            let name = match self.second.vertex[joint as usize] {
                Some(vertex) if a.is_vertex() => Name::Vertices(ia, vertex),
                _ => Name::SecondJoint(ia, joint),
            };
            let normal = self.second.normal(joint);
            let cone = self.first.cones[ia as usize];
            let plausible = |theta: Rotation| cone.may_hold(-(theta * normal));
            coincidences(first, a.center(), second, at, plausible, |root, x, y| {
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
            });
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
            let (start, along, length) = self.first.segment(a);
            let Motions { first, second } = self.motions;
            let side = (self.first.normal(a.start), start, self.first.angle(a.start));
            let (point, beta) = (self.second.point(joint), self.second.angle(joint));
            let accepts = |seen: Seen| {
                let at = along.dot(seen.point(point) - start);
                0.0 < at && at < length
            };
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
            let (start, along, length) = self.second.segment(b);
            let Motions { first, second } = self.motions;
            let side = (
                self.second.normal(b.start),
                start,
                self.second.angle(b.start),
            );
            let (point, alpha) = (self.first.point(joint), self.first.angle(joint));
            let accepts = |seen: Seen| {
                let at = along.dot(seen.point(point) - start);
                0.0 < at && at < length
            };
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
        let side = (self.first.normal(a.start), start, self.first.angle(a.start));
        let joint = (self.second.point(b.start), self.second.angle(b.start));
        let accepts = |seen: Seen| {
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

/// Inside an interval of normals, given the decisions and distances at its two ends.
fn within(f: &Feature, above_lo: bool, to_lo: f64, below_hi: bool, to_hi: f64, sign: f64) -> bool {
    let width = f.hi - f.lo;
    if width < PI - NEAR {
        return above_lo && below_hi;
    }
    if to_lo.abs() < NEAR {
        return above_lo;
    }
    if to_hi.abs() < NEAR {
        return below_hi;
    }
    // Away from both ends: by the distance from the middle.
    let from_lo = sign * to_lo;
    wrapped(from_lo - 0.5 * width).abs() < 0.5 * width
}

/// Where the line's part sees the joint's part: its point q at turn q + shift.
#[derive(Debug, Clone, Copy)]
struct Seen {
    turn: Rotation,
    shift: Vector,
}

impl Seen {
    fn point(&self, q: Point) -> Point {
        self.turn * q + self.shift
    }
}

/// Coordinates (of the line's part, of the joint's part) at which a joint is on a line and their normals oppose, if that is
/// to be accepted as the parts then see each other.
fn aligned(
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
