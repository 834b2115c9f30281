//! Construction of sheets: one for each pair of features that can touch, cut where its ends move to other joints.

use core::f64::consts::{PI, TAU};

use crate::feature::{Feature, Outline};
use crate::geometry::{Point, Vector, unwrap_near};
use crate::number::Dd;
use crate::part::MeetingLoops;

use super::carrier::SheetKind;
use super::end_names::EndNames;
use super::locus::Locus;
use super::sheet::{EndAngle, EndAt, Seam, Sheet};
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
        fixed_vertex: fixed.vertex_of_joint(),
        moving_vertex: moving.vertex_of_joint(),
        fixed_line: fixed.line_of_joint(),
        moving_line: moving.line_of_joint(),
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

/// End of a curve.
struct SheetEnd {
    spiral: Spiral,
    name: u32,
    angle: EndAngle,
    at: EndAt,
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
            (true, false) if b.radius() >= 0.0 => self.add_line_round(ia, ib, &a, &b),
            (false, true) if a.radius() >= 0.0 => self.add_round_line(ia, ib, &a, &b),
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

    fn line_seam(&self, line: u32, moving_joint: u32) -> Seam {
        match self.moving_line[moving_joint as usize] {
            Some(other) => Seam::Lines(line, other),
            None => Seam::LineJoint(line, moving_joint),
        }
    }

    fn joint_seam(&self, fixed_joint: u32, line: u32) -> Seam {
        match self.fixed_line[fixed_joint as usize] {
            Some(other) => Seam::Lines(other, line),
            None => Seam::JointLine(fixed_joint, line),
        }
    }

    fn add_line_round(&mut self, ia: u32, ib: u32, a: &Feature, b: &Feature) {
        let (b_lo, b_hi) = b.joints_by_angle();
        let (theta_lo, theta_hi) = (first_orientation(a, b), a.lo - b.lo - PI);
        let (lo_seam, hi_seam) = (self.line_seam(ia, b_hi), self.line_seam(ia, b_lo));
        let ends = [a.start, a.end].map(|joint| SheetEnd {
            spiral: self.fixed_joint_spiral(joint, b),
            name: self.fixed_joint_name(joint, ib, b),
            angle: EndAngle::NONE,
            at: EndAt::Fixed(joint),
        });
        let locus = Locus {
            kind: SheetKind::LineRound,
            through: ends[0].spiral,
            normal: self.fixed.start(a).normal,
            radius: b.radius(),
            start: ends[0].spiral,
            end: ends[1].spiral,
        };
        let bounds = [
            (theta_lo, (a.start, b_hi), lo_seam),
            (theta_hi, (a.start, b_lo), hi_seam),
        ];
        self.add_line((ia, ib), &locus, &ends, bounds);
    }

    fn add_round_line(&mut self, ia: u32, ib: u32, a: &Feature, b: &Feature) {
        let (a_lo, a_hi) = a.joints_by_angle();
        let (theta_lo, theta_hi) = (first_orientation(a, b), a.hi - b.lo - PI);
        let (lo_seam, hi_seam) = (self.joint_seam(a_lo, ib), self.joint_seam(a_hi, ib));
        let ends = [b.start, b.end].map(|joint| SheetEnd {
            spiral: self.moving_joint_spiral(a, joint),
            name: self.moving_joint_name(ia, a, joint),
            angle: EndAngle::NONE,
            at: EndAt::Moving(joint),
        });
        let locus = Locus {
            kind: SheetKind::RoundLine,
            through: ends[0].spiral,
            normal: -self.moving.start(b).normal,
            radius: a.radius(),
            start: ends[0].spiral,
            end: ends[1].spiral,
        };
        let bounds = [
            (theta_lo, (a_lo, b.start), lo_seam),
            (theta_hi, (a_hi, b.start), hi_seam),
        ];
        self.add_line((ia, ib), &locus, &ends, bounds);
    }

    /// Adds the sheet of a line: its smallest and its largest orientation, the joints whose normals oppose each other there, and the seams.
    fn add_line(
        &mut self,
        features: (u32, u32),
        locus: &Locus,
        ends: &[SheetEnd; 2],
        bounds: [(f64, (u32, u32), Seam); 2],
    ) {
        self.instances(bounds[0].0, bounds[1].0, |this, shift, k| {
            let [lo, hi] = bounds.map(|(theta, (fixed, moving), seam)| {
                Bound::new(this.alignment(fixed, moving, theta + shift), seam)
            });
            this.push(features, locus, ends, [lo, hi], (k, 0));
        });
    }

    fn add_round_round(&mut self, ia: u32, ib: u32, a: &Feature, b: &Feature) {
        let exact = self.fixed.exact_features[ia as usize].radius
            + self.moving.exact_features[ib as usize].radius;
        let radius = exact.to_f64();
        let convex = a.radius() >= 0.0 && b.radius() >= 0.0;
        let concave = a.radius() < 0.0 && b.radius() < 0.0;
        // An arc does not touch within a smaller fillet; a vertex touches a vertex only at the ends of adjacent contacts.
        let touch = if convex { radius > 0.0 } else { radius < 0.0 };
        if concave || !touch {
            return;
        }
        let (a_lo, a_hi) = a.joints_by_angle();
        let (b_lo, b_hi) = b.joints_by_angle();
        let (kind, through, normal) = carrier(a, b);
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
                    this.fixed_end(ib, a, b, a_lo, radius, a.lo)
                } else {
                    this.moving_end(ia, a, b, b_lo, radius, b.lo + PI - shift)
                };
                let high = if middle < switch_high {
                    this.moving_end(ia, a, b, b_hi, radius, b.hi + PI - shift)
                } else {
                    this.fixed_end(ib, a, b, a_hi, radius, a.hi)
                };
                // Travel goes with the normal's angle on convex circles, against it on concave ones.
                let ends = if radius > 0.0 {
                    [low, high]
                } else {
                    [high, low]
                };
                let locus = Locus {
                    kind,
                    through,
                    normal,
                    radius,
                    start: ends[0].spiral,
                    end: ends[1].spiral,
                };
                this.push((ia, ib), &locus, &ends, [from, to], (k, piece));
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
        locus: &Locus,
        [start, end]: &[SheetEnd; 2],
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
            start_at: start.at,
            end_at: end.at,
            locus: *locus,
            start_name: start.name,
            end_name: end.name,
            start_angle: start.angle,
            end_angle: end.angle,
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

    /// X + ρ n − R Q: contact of a moving round feature at a joint of the fixed part.
    fn fixed_joint_spiral(&self, joint: u32, b: &Feature) -> Spiral {
        let j = self.fixed.joints[joint as usize];
        match b.near {
            Some(near) => Spiral {
                u: j.point,
                w: -near.point.to_vector(),
                swing: swing(j.normal, near.normal, b.radius()),
            },
            None => Spiral::new(j.point + j.normal * b.radius(), -b.center().to_vector()),
        }
    }

    /// P − R (Y + ρ n): contact of a fixed round feature at a joint of the moving part.
    fn moving_joint_spiral(&self, a: &Feature, joint: u32) -> Spiral {
        let j = self.moving.joints[joint as usize];
        match a.near {
            Some(near) => Spiral {
                u: near.point,
                w: -j.point.to_vector(),
                swing: swing(near.normal, j.normal, -a.radius()),
            },
            None => Spiral::new(a.center(), -(j.point + j.normal * a.radius()).to_vector()),
        }
    }

    fn fixed_end(
        &self,
        ib: u32,
        a: &Feature,
        b: &Feature,
        joint: u32,
        radius: f64,
        near: f64,
    ) -> SheetEnd {
        let spiral = self.fixed_joint_spiral(joint, b);
        // Only circles given by a centre need the angle.
        let v = (spiral.u - a.center()) * radius.signum();
        let offset = unwrap_near(v.angle(), near);
        SheetEnd {
            spiral,
            name: self.fixed_joint_name(joint, ib, b),
            angle: EndAngle {
                offset,
                turns: false,
            },
            at: EndAt::Fixed(joint),
        }
    }

    fn moving_end(
        &self,
        ia: u32,
        a: &Feature,
        b: &Feature,
        joint: u32,
        radius: f64,
        near: f64,
    ) -> SheetEnd {
        let spiral = self.moving_joint_spiral(a, joint);
        let v = (spiral.w + b.center().to_vector()) * radius.signum();
        let offset = unwrap_near(v.angle(), near);
        SheetEnd {
            spiral,
            name: self.moving_joint_name(ia, a, joint),
            angle: EndAngle {
                offset,
                turns: true,
            },
            at: EndAt::Moving(joint),
        }
    }

    fn fixed_joint_name(&self, joint: u32, ib: u32, b: &Feature) -> u32 {
        match self.fixed_vertex[joint as usize] {
            Some(vertex) if b.is_vertex() => self.names.vertices(vertex, ib),
            _ => self.names.fixed_joint(joint, ib),
        }
    }

    fn moving_joint_name(&self, ia: u32, a: &Feature, joint: u32) -> u32 {
        match self.moving_vertex[joint as usize] {
            Some(vertex) if a.is_vertex() => self.names.vertices(ia, vertex),
            _ => self.names.moving_joint(ia, joint),
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

/// Data that define the circle of two round features: the spiral of its centre; or, if a centre is far away, the spiral of a point of the
/// circle near the parts, and the normal there, in the frame of the arc it belongs to.
fn carrier(a: &Feature, b: &Feature) -> (SheetKind, Spiral, Vector) {
    let spiral = |fixed: Point, moving: Point| Spiral::new(fixed, -moving.to_vector());
    match (a.near, b.near) {
        (None, None) => (
            SheetKind::RoundRound,
            spiral(a.center(), b.center()),
            Vector::ZERO,
        ),
        (Some(n), None) => (
            SheetKind::FixedFlatArc,
            spiral(n.point + n.normal * b.radius(), b.center()),
            n.normal,
        ),
        (None, Some(m)) => (
            SheetKind::MovingFlatArc,
            spiral(a.center(), m.point + m.normal * a.radius()),
            -m.normal,
        ),
        (Some(n), Some(m)) => (
            SheetKind::FixedFlatArc,
            Spiral {
                swing: swing(n.normal, m.normal, b.radius()),
                ..spiral(n.point, m.point)
            },
            n.normal,
        ),
    }
}
