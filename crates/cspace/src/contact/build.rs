//! Construction of sheets: one for each pair of features that can touch, cut where its ends move to other joints.

use core::f64::consts::{PI, TAU};

use crate::feature::{Feature, FeatureKind, Outline};
use crate::geometry::{Point, Vector, unwrap_near};
use crate::number::Dd;
use crate::part::MeetingLoops;

use super::carrier::{Carrier, SheetKind};
use super::end_names::EndNames;
use super::locus::Locus;
use super::sheet::{EndAt, Seam, Sheet, SheetEnd};
use super::spiral::{Spiral, Swing};
use super::symmetry::{Period, Span};

/// All sheets of a pair in a window of orientations. Stops after about `most` sheets; the result is then incomplete.
pub(super) fn sheets(
    fixed: &Outline,
    moving: &Outline,
    span: Span,
    period: &Period,
    most: usize,
) -> Vec<Sheet> {
    let mut builder = Builder {
        fixed,
        moving,
        span,
        period,
        names: EndNames::new(fixed, moving),
        fixed_vertex: fixed.of_joints(FeatureKind::Vertex),
        moving_vertex: moving.of_joints(FeatureKind::Vertex),
        fixed_line: fixed.of_joints(FeatureKind::Line),
        moving_line: moving.of_joints(FeatureKind::Line),
        sheets: Vec::new(),
    };
    let meeting = MeetingLoops::of(&fixed.heights, &moving.heights);
    for (a, f) in (0..).zip(&fixed.features) {
        for (b, m) in (0..).zip(&moving.features) {
            if meeting.hold(f.name.loop_index, m.name.loop_index) {
                builder.add(a, b);
            }
        }
        if builder.sheets.len() > most {
            break;
        }
    }
    builder.sheets
}

struct Builder<'a> {
    fixed: &'a Outline,
    moving: &'a Outline,
    span: Span,
    period: &'a Period,
    names: EndNames,
    fixed_vertex: Vec<Option<u32>>,
    moving_vertex: Vec<Option<u32>>,
    fixed_line: Vec<Option<u32>>,
    moving_line: Vec<Option<u32>>,
    sheets: Vec<Sheet>,
}

/// A bound of an interval of orientations, and the seam there.
#[derive(Clone, Copy)]
struct Bound {
    theta: Dd,
    seam: Seam,
}

impl Bound {
    fn new(theta: Dd, seam: Seam) -> Self {
        Self { theta, seam }
    }
}

impl Builder<'_> {
    fn add(&mut self, ia: u32, ib: u32) {
        let (a, b) = (
            self.fixed.features[ia as usize],
            self.moving.features[ib as usize],
        );
        match (a.is_line(), b.is_line()) {
            (true, true) => {}
            (true, false) if b.radius >= 0.0 => self.add_line(ia, ib, &a, &b),
            (false, true) if a.radius >= 0.0 => self.add_line(ia, ib, &a, &b),
            (false, false) => self.add_round_round(ia, ib, &a, &b),
            _ => {}
        }
    }

    /// The orientation nearest to `near` at which the normal of a joint of the fixed part opposes that of a joint of the moving part.
    ///
    /// The angle is reduced to the window first, so that one pair of normals always gives the same number.
    fn alignment(&self, fixed_joint: u32, moving_joint: u32, near: f64) -> Dd {
        let t = self.fixed.exact_joints[fixed_joint as usize].angle
            - self.moving.exact_joints[moving_joint as usize].angle
            - Dd::PI;
        let t = t - Dd::TAU * ((t.to_f64() - self.span.lo) / TAU).floor();
        t + Dd::TAU * ((near - t.to_f64()) / TAU).round()
    }

    /// Adds the sheets of a line and a convex round feature.
    fn add_line(&mut self, ia: u32, ib: u32, a: &Feature, b: &Feature) {
        let ([a_lo, a_hi], [b_lo, b_hi]) = (a.joints_by_angle(), b.joints_by_angle());
        // The joints whose normals oppose each other at the smallest and at the largest orientation, and the seams there.
        let (kind, normal, at, bounds) = if a.is_line() {
            (
                SheetKind::LineRound,
                self.fixed.start(a).normal,
                [a.start, a.end].map(EndAt::Fixed),
                [b_hi, b_lo].map(|j| {
                    let parallel = |other| Seam::Lines(ia, other);
                    let seam = self.moving_line[j as usize].map(parallel);
                    ((a.start, j), seam.unwrap_or(Seam::LineJoint(ia, j)))
                }),
            )
        } else {
            (
                SheetKind::RoundLine,
                -self.moving.start(b).normal,
                [b.start, b.end].map(EndAt::Moving),
                [a_lo, a_hi].map(|j| {
                    let parallel = |other| Seam::Lines(other, ib);
                    let seam = self.fixed_line[j as usize].map(parallel);
                    ((j, b.start), seam.unwrap_or(Seam::JointLine(j, ib)))
                }),
            )
        };
        let [start, end] = at.map(|at| self.spiral(at, a, b));
        let carrier = Carrier {
            kind,
            through: start,
            normal,
            radius: a.radius + b.radius,
        };
        let locus = Locus {
            carrier,
            start,
            end,
        };
        let ends = at.map(|at| SheetEnd {
            at,
            name: self.name(at, (ia, ib), a, b),
            angle: 0.0,
        });
        let (lo, hi) = (first_orientation(a, b), a.hi - b.lo - PI);
        self.instances(lo, hi, |this, shift, k| {
            let bound = |theta: f64, ((fixed, moving), seam)| Bound {
                theta: this.alignment(fixed, moving, theta + shift),
                seam,
            };
            let bounds = [bound(lo, bounds[0]), bound(hi, bounds[1])];
            this.push((ia, ib), locus, ends, bounds, (k, 0));
        });
    }

    fn add_round_round(&mut self, ia: u32, ib: u32, a: &Feature, b: &Feature) {
        let exact = self.fixed.exact_features[ia as usize].radius
            + self.moving.exact_features[ib as usize].radius;
        let radius = exact.to_f64();
        let convex = a.radius >= 0.0 && b.radius >= 0.0;
        let concave = a.radius < 0.0 && b.radius < 0.0;
        // An arc does not touch within a smaller fillet; a vertex touches a vertex only at the ends of adjacent contacts.
        let touch = if convex { radius > 0.0 } else { radius < 0.0 };
        if concave || !touch {
            return;
        }
        let ([a_lo, a_hi], [b_lo, b_hi]) = (a.joints_by_angle(), b.joints_by_angle());
        let carrier = carrier(a, b, radius);
        let (theta_lo, theta_hi) = (first_orientation(a, b), a.hi - b.lo - PI);
        // Below the first, normals start with those of the fixed feature; below the second, they end with those of the moving one.
        let (low_switch, high_switch) = (a.lo - b.lo - PI, a.hi - b.hi - PI);
        self.instances(theta_lo, theta_hi, |this, shift, k| {
            let switch_low = this.alignment(a_lo, b_lo, low_switch + shift);
            let switch_high = this.alignment(a_hi, b_hi, high_switch + shift);
            let point = |theta| Bound::new(theta, Seam::Point);
            let first = point(this.alignment(a_lo, b_hi, theta_lo + shift));
            let last = point(this.alignment(a_hi, b_lo, theta_hi + shift));
            let (m1, m2) = if switch_low < switch_high {
                (switch_low, switch_high)
            } else {
                (switch_high, switch_low)
            };
            let inner = |theta, which| Bound::new(theta, Seam::Same(ia, ib, k, which));
            let bounds = [first, inner(m1, 0), inner(m2, 1), last];
            for piece in 0..3u8 {
                let (from, to) = (bounds[usize::from(piece)], bounds[usize::from(piece) + 1]);
                if to.theta < this.span.from() || this.span.to() < from.theta {
                    continue;
                }
                let middle = (from.theta + to.theta).scaled(0.5);
                let low = if middle < switch_low {
                    (EndAt::Fixed(a_lo), a.lo)
                } else {
                    (EndAt::Moving(b_lo), b.lo + PI - shift)
                };
                let high = if middle < switch_high {
                    (EndAt::Moving(b_hi), b.hi + PI - shift)
                } else {
                    (EndAt::Fixed(a_hi), a.hi)
                };
                // Travel goes with the normal's angle on convex circles, against it on concave ones.
                let ends = if radius > 0.0 {
                    [low, high]
                } else {
                    [high, low]
                };
                let [start, end] = ends.map(|(at, _)| this.spiral(at, a, b));
                let locus = Locus {
                    carrier,
                    start,
                    end,
                };
                let ends = [(start, ends[0]), (end, ends[1])].map(|(spiral, (at, near))| {
                    // Only circles given by a centre need the angle.
                    let arm = match at {
                        EndAt::Fixed(_) => spiral.u - a.center,
                        EndAt::Moving(_) => spiral.w + b.center.to_vector(),
                    };
                    SheetEnd {
                        at,
                        name: this.name(at, (ia, ib), a, b),
                        angle: unwrap_near((arm * radius.signum()).angle(), near),
                    }
                });
                this.push((ia, ib), locus, ends, [from, to], (k, piece));
            }
        });
    }

    /// Calls `add` with every shift by whole turns that moves the interval into the window.
    fn instances(&mut self, lo: f64, hi: f64, mut add: impl FnMut(&mut Self, f64, i32)) {
        let first = ((self.span.lo - hi) / TAU).floor() as i32;
        let last = ((self.span.hi - lo) / TAU).ceil() as i32;
        for k in first..=last {
            let shift = f64::from(k) * TAU;
            if hi + shift > self.span.lo && lo + shift < self.span.hi {
                add(self, shift, k);
            }
        }
    }

    /// Cuts a sheet to the window and keeps it if anything is left. `piece` identifies the sheet among those of its features: the turn, and
    /// its number.
    fn push(
        &mut self,
        (fixed, moving): (u32, u32),
        locus: Locus,
        [start, end]: [SheetEnd; 2],
        [from, to]: [Bound; 2],
        (k, piece): (i32, u8),
    ) {
        let sheet = Sheet {
            fixed,
            moving,
            lo: from.theta.to_f64(),
            hi: to.theta.to_f64(),
            from: from.theta,
            to: to.theta,
            locus,
            start,
            end,
            bottom: from.seam,
            top: to.seam,
        };
        let span = self.span;
        let at_end = |goes_on: Seam| if span.full { goes_on } else { Seam::Window };
        let (bottom, top) = (
            || at_end(Seam::Wrap(fixed, moving, k, piece)),
            || at_end(self.seam_below(fixed, moving, k, piece)),
        );
        if let Some(sheet) = sheet.cut(span, bottom, top) {
            self.sheets.push(sheet);
        }
    }

    /// The seam through which a sheet that passes the upper end of the period continues at the lower end: that of the features that are
    /// there, and of their turn.
    fn seam_below(&self, fixed: u32, moving: u32, k: i32, piece: u8) -> Seam {
        let (a, b) = (
            self.period.fixed_back.features[fixed as usize],
            self.period.moving_back.features[moving as usize],
        );
        let first = |a: u32, b: u32| {
            first_orientation(
                &self.fixed.features[a as usize],
                &self.moving.features[b as usize],
            )
        };
        let lower = first(fixed, moving) + f64::from(k) * TAU - (self.span.hi - self.span.lo);
        let turn = ((lower - first(a, b)) / TAU).round() as i32;
        Seam::Wrap(a, b, turn, piece)
    }

    /// How an end of a curve moves; if it lies on a large arc, with that arc's swing.
    fn spiral(&self, at: EndAt, a: &Feature, b: &Feature) -> Spiral {
        match (at, a.near, b.near) {
            (EndAt::Fixed(j), _, Some(near)) => {
                let j = self.fixed.joints[j as usize];
                Spiral {
                    u: j.point,
                    w: -near.point.to_vector(),
                    swing: swing(j.normal, near.normal, b.radius),
                }
            }
            (EndAt::Moving(j), Some(near), _) => {
                let j = self.moving.joints[j as usize];
                Spiral {
                    u: near.point,
                    w: -j.point.to_vector(),
                    swing: swing(near.normal, j.normal, -a.radius),
                }
            }
            _ => at.spiral((a, &self.fixed.joints), (b, &self.moving.joints)),
        }
    }

    /// The name of an end of the curves of two features.
    fn name(&self, at: EndAt, (ia, ib): (u32, u32), a: &Feature, b: &Feature) -> u32 {
        match at {
            EndAt::Fixed(joint) => match self.fixed_vertex[joint as usize] {
                Some(vertex) if b.is_vertex() => self.names.vertices(vertex, ib),
                _ => self.names.fixed_joint(joint, ib),
            },
            EndAt::Moving(joint) => match self.moving_vertex[joint as usize] {
                Some(vertex) if a.is_vertex() => self.names.vertices(ia, vertex),
                _ => self.names.moving_joint(ia, joint),
            },
        }
    }
}

/// The lowest orientation, up to whole turns, at which a normal of one feature opposes one of the other.
fn first_orientation(a: &Feature, b: &Feature) -> f64 {
    a.lo - b.hi - PI
}

/// The displacement r (n + R m) as a swing: n and R m cancel at the orientation at which the normals oppose each other.
fn swing(n: Vector, m: Vector, radius: f64) -> Swing {
    Swing {
        arm: n * radius,
        rest: n.angle() - m.angle() - PI,
    }
}

/// The circle of two round features, by the spiral of its centre; or, if a centre is far away, by the spiral of a point of the circle near
/// the parts, and the normal there, in the frame of the arc it belongs to.
fn carrier(a: &Feature, b: &Feature, radius: f64) -> Carrier {
    let spiral = |fixed: Point, moving: Point| Spiral::new(fixed, -moving.to_vector());
    let (kind, through, normal) = match (a.near, b.near) {
        (None, None) => (
            SheetKind::RoundRound,
            spiral(a.center, b.center),
            Vector::ZERO,
        ),
        (Some(n), None) => (
            SheetKind::FixedFlatArc,
            spiral(n.point + n.normal * b.radius, b.center),
            n.normal,
        ),
        (None, Some(m)) => (
            SheetKind::MovingFlatArc,
            spiral(a.center, m.point + m.normal * a.radius),
            -m.normal,
        ),
        (Some(n), Some(m)) => (
            SheetKind::FixedFlatArc,
            Spiral {
                swing: swing(n.normal, m.normal, b.radius),
                ..spiral(n.point, m.point)
            },
            n.normal,
        ),
    };
    Carrier {
        kind,
        through,
        normal,
        radius,
    }
}
