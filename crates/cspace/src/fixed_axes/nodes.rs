//! Nodes: named configurations at which contact curves end because one feature ends and its neighbour begins.
//!
//! A node belongs to a joint of one part and a feature of the other (or to two vertices, or two lines), not to a pair of features. All
//! pairs that meet there compute it from the same numbers, so it is the same to the last bit, and its name identifies it.

use super::equation::Equation;
use super::meeting::meetings;
use super::motion::{Motion, Motions, Placement};
use super::piece::{Name, Node};
use super::repeats::Image;
use super::scene::{Scene, Side};
use super::tolerance::INDEPENDENT;
use crate::contact::Cycle;
use crate::feature::Feature;
use crate::geometry::{Point, Rotation, Vector};
use core::f64::consts::PI;

impl Scene {
    /// Calls `found` with every node on the curve of a pair with at least one round feature. The first feature represents its orbit.
    ///
    /// Nodes that belong to another joint or line of the first part are computed from the representative of its orbit, and moved: so all
    /// pairs that meet there have the same numbers, in whatever copy of the window they meet.
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
        for swap in [false, true] {
            let [(_, f), (_, other)] = swapped(swap, [(ia, a), (ib, b)]);
            if !other.is_line() {
                self.joints(swap, [(ia, a), (ib, b)], &mut found);
            }
            if f.is_line() {
                self.alignments(swap, [(ia, a), (ib, b)], &mut found);
            }
        }
    }

    /// Nodes at which an end of a feature of the first part, or with `swap` of the second, touches a round feature of the other: its centre
    /// is at X + ρ n.
    fn joints(
        &self,
        swap: bool,
        features: [(u32, &Feature); 2],
        found: &mut impl FnMut(Name, u8, u32, f64, f64),
    ) {
        let [own, other] = swapped(swap, [&self.first, &self.second]);
        let [(_, f), (i, round)] = swapped(swap, features);
        for joint in [f.start, f.end] {
            let Image { of: joint, steps } = self.image(swap, joint);
            let (point, normal) = (own.point(joint), own.normal(joint));
            let name = match own.vertex[joint as usize] {
                Some(vertex) if round.is_vertex() => {
                    let [v, w] = swapped(swap, [vertex, i]);
                    Name::Vertices(v, w)
                }
                _ if swap => Name::SecondJoint(i, joint),
                _ => Name::FirstJoint(joint, i),
            };
            let cone = other.cones[i as usize];
            let plausible = |theta: Rotation| {
                let [seen, _] = swapped(swap, [theta.inverse(), theta]);
                cone.may_hold(-(seen * normal))
            };
            let meets = |root, x: f64, y: f64| {
                let theta = self.motions.theta(x, y);
                let ends = [round.start, round.end].map(|k| swapped(swap, [joint, k]));
                if let Some([j, k]) = ends.into_iter().find(|&[j, k]| self.tied(j, k, theta)) {
                    let Image { of, steps: on } = self.repeats.joint(j);
                    // The joint of the orbit is there when x is larger by the steps between them.
                    let x = x + self.repeats.period() * f64::from(on);
                    found(Name::Joints(of, k), root, steps, x, y);
                } else if self.has(!swap, round, joint, theta) {
                    found(name, root, steps, x, y);
                }
            };
            let (arc, at) = touching(other, round, point, normal);
            let [p, q] = swapped(swap, [&at, &arc]);
            let Motions { first, second } = self.motions;
            meetings((first, p), (second, q), plausible, meets);
        }
    }

    /// Nodes at which a round feature of the second part, or with `swap` of the first, ends where its normal is that of a line of the
    /// other.
    fn alignments(
        &self,
        swap: bool,
        features: [(u32, &Feature); 2],
        found: &mut impl FnMut(Name, u8, u32, f64, f64),
    ) {
        let [own, other] = swapped(swap, [&self.first, &self.second]);
        let [(i, line), (_, round)] = swapped(swap, features);
        let motions = if swap {
            self.motions.swapped()
        } else {
            self.motions
        };
        for (joint, at_start) in [(round.start, true), (round.end, false)] {
            if let Some(beside) = other.line[joint as usize] {
                let Image { of, steps } = if swap {
                    self.repeats.feature(beside)
                } else {
                    Image::itself(beside)
                };
                // Travel continues: where the feature starts, the line ends.
                let before = &other.outline.features[of as usize];
                let joint = if at_start { before.end } else { before.start };
                let [ia, ib] = swapped(swap, [i, of]);
                self.lines((ia, steps), ib, found, |from_first, at| {
                    from_first == swap && at == joint
                });
                continue;
            }
            let Image { of: joint, steps } = self.image(!swap, joint);
            let end = (other.point(joint), other.angle(joint));
            let name = if swap {
                Name::JointLine(joint, i)
            } else {
                Name::LineJoint(i, joint)
            };
            aligned(
                motions,
                own.line(line),
                end,
                own.beside(line, end.0),
                |root, s, t| {
                    let [x, y] = swapped(swap, [s, t]);
                    found(name, root, steps, x, y);
                },
            );
        }
    }

    /// A joint of the first part as the image of the representative of its orbit; with `swap` a joint of the second part, which is its own.
    fn image(&self, swap: bool, joint: u32) -> Image {
        if swap {
            Image::itself(joint)
        } else {
            self.repeats.joint(joint)
        }
    }

    /// Nodes of two lines that touch along a stretch: its two ends, each a joint of one part, selected by `ends_at`.
    fn lines(
        &self,
        (ia, steps): (u32, u32),
        ib: u32,
        found: &mut impl FnMut(Name, u8, u32, f64, f64),
        ends_at: impl Fn(bool, u32) -> bool,
    ) {
        let (a, b) = (self.first_feature(ia), self.second_feature(ib));
        let (start, along, length) = self.first.segment(a);
        let side = self.first.line(a);
        let joint = (self.second.point(b.start), self.second.angle(b.start));
        let accepts = |seen: Placement| {
            let place = |joint| along.dot(seen.point(self.second.point(joint)) - start);
            // Opposite normals: the direction of travel is opposite on the second part.
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
        aligned(self.motions, side, joint, accepts, |root, x, y| {
            found(Name::Lines(ia, ib), root, steps, x, y);
        });
    }
}

/// A pair of elements of the first and of the second part, exchanged if `swap`.
fn swapped<T>(swap: bool, [first, second]: [T; 2]) -> [T; 2] {
    if swap {
        [second, first]
    } else {
        [first, second]
    }
}

/// The cycle of a round feature, and that cycle placed so that it touches a joint of the other part. If the centre is near, both are
/// points: the centres.
fn touching(side: &Side, f: &Feature, joint: Point, normal: Vector) -> (Cycle, Cycle) {
    if f.near.is_some() {
        let arc = Cycle::of(&side.outline, f);
        return (arc, Cycle::flat(joint, -normal, arc.weight));
    }
    let at = joint + normal * f.radius;
    (Cycle::round(f.center, 0.0), Cycle::round(at, 0.0))
}

// Configurations at which a joint of one part is on a line of the other, with opposite normals.

/// Coordinates (of the line's part, of the joint's part) at which a joint is on a line with opposite normals, if `accepts` admits the
/// joint's position as seen from the line's part.
fn aligned(
    motions: Motions,
    (normal, through, alpha): (Vector, Point, f64),
    (point, beta): (Point, f64),
    accepts: impl Fn(Placement) -> bool,
    mut found: impl FnMut(u8, f64, f64),
) {
    let theta = alpha + PI - beta;
    let turn = Rotation::by(theta);
    let mut meets = |root: u8, s: f64, t: f64| {
        let shift = motions.relative(s, t).0.to_vector();
        if accepts(Placement { turn, shift }) {
            found(root, s, t);
        }
    };
    let (line, joint) = (motions.first, motions.second);
    match (line, joint) {
        (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
            // n(t)·(d + R_t R_θ w − c) = n·(l − c).
            let between = d - c;
            let w = turn * (point - d);
            let equation = Equation::Trig {
                alpha: normal.dot(between),
                beta: normal.left().dot(between),
                gamma: normal.dot(w - (through - c)),
            };
            let mut roots = 0..;
            equation.roots(&mut |t| meets(roots.next().unwrap_or(0), t, t + theta));
        }
        (Motion::Turn { .. }, Motion::Slide { direction }) => {
            let n = line.vector(-theta, normal);
            let rate = n.dot(direction);
            if rate.abs() >= INDEPENDENT {
                let s = n.dot(line.point(-theta, through) - point) / rate;
                meets(0, -theta, s);
            }
        }
        (Motion::Slide { direction }, Motion::Turn { .. }) => {
            let rate = normal.dot(direction);
            if rate.abs() >= INDEPENDENT {
                let s = normal.dot(joint.point(theta, point) - through) / rate;
                meets(0, s, theta);
            }
        }
        _ => {}
    }
}
