//! The surface on which two features touch, before it is cut where other features interfere.

use crate::feature::tolerance::{LONGEST, SMALL_CIRCLE, WIDEST_SAGITTA};
use crate::feature::{Feature, Joint, Outline};
use crate::geometry::Rotation;
use crate::number::{Dd, Ordered, Real};

use super::carrier::{Carrier, SheetKind};
use super::curve::Curve;
use super::cycle::Cycle;
use super::function::ContactFunction;
use super::locus::Locus;
use super::orientation::Orientation;
use super::spiral::Spiral;
use super::symmetry::Span;

/// Event at which a sheet's interval of orientations begins or ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Seam {
    /// The curve shrinks to a point.
    Point,
    /// Two lines are parallel: fixed line, moving line.
    Lines(u32, u32),
    /// A fixed line is tangent at a joint between two moving features, neither of them a line.
    LineJoint(u32, u32),
    /// A joint between two fixed features, neither of them a line, at which a moving line is tangent.
    JointLine(u32, u32),
    /// The end moves from one joint to another; the sheet continues: fixed feature, moving feature, turn, number.
    Same(u32, u32, i32, u8),
    /// The sheet continues at the other end of the full turn: fixed feature, moving feature, turn, number.
    Wrap(u32, u32, i32, u8),
    /// The window ends.
    Window,
}

/// The joint at which a curve ends, of the fixed or of the moving part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EndAt {
    Fixed(u32),
    Moving(u32),
}

impl EndAt {
    /// How the end moves, given the features that touch and the joints of both parts: contact of the other part's round feature at the joint.
    pub(super) fn spiral<T: Real>(
        self,
        (a, fixed): (&Feature<T>, &[Joint<T>]),
        (b, moving): (&Feature<T>, &[Joint<T>]),
    ) -> Spiral<T> {
        match self {
            // X + ρ n − R Q
            Self::Fixed(j) => {
                let j = &fixed[j as usize];
                Spiral::new(j.point + j.normal * b.radius, -b.center.to_vector())
            }
            // P − R (Y + ρ n)
            Self::Moving(j) => {
                let j = &moving[j as usize];
                Spiral::new(a.center, -(j.point + j.normal * a.radius).to_vector())
            }
        }
    }
}

/// An end of a sheet's curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SheetEnd {
    pub(crate) at: EndAt,
    /// Its identity: equal for the two sheets that share it.
    pub(crate) name: u32,
    /// The angle of the contact normal there, at θ = 0; only for circles.
    pub(super) angle: f64,
}

impl SheetEnd {
    /// The angle of the contact normal there: constant, or turning with θ; only for circles.
    #[inline]
    pub(crate) fn angle_at(&self, theta: f64) -> f64 {
        match self.at {
            EndAt::Fixed(_) => self.angle,
            EndAt::Moving(_) => self.angle + theta,
        }
    }
}

/// The contact of one feature pair over an interval of orientations in which its ends keep their identity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sheet {
    pub(crate) fixed: u32,
    pub(crate) moving: u32,
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Ends of the interval in double-double.
    pub(crate) from: Dd,
    pub(crate) to: Dd,
    pub(crate) locus: Locus,
    pub(crate) start: SheetEnd,
    pub(crate) end: SheetEnd,
    pub(crate) bottom: Seam,
    pub(crate) top: Seam,
}

/// Duration up to which a sheet is an artefact of rounding (radians).
const SHORTEST: f64 = 1e-26;

impl Sheet {
    /// The part of the sheet within a window, with the seams where the window cuts it; `None` if nothing is left.
    pub(super) fn cut(
        mut self,
        span: Span,
        bottom: impl FnOnce() -> Seam,
        top: impl FnOnce() -> Seam,
    ) -> Option<Self> {
        if self.from < span.from() {
            (self.from, self.bottom) = (span.from(), bottom());
        }
        if self.to > span.to() {
            (self.to, self.top) = (span.to(), top());
        }
        (self.lo, self.hi) = (self.from.to_f64(), self.to.to_f64());
        ((self.to - self.from).to_f64() > SHORTEST).then_some(self)
    }

    /// The locus computed from the outlines in double-double.
    ///
    /// A flat arc is written by the point at which it has the normal used in f64.
    pub(crate) fn exact(&self, fixed: &Outline, moving: &Outline) -> Locus<Dd> {
        let (a, b) = (
            &fixed.exact_features[self.fixed as usize],
            &moving.exact_features[self.moving as usize],
        );
        let joints = (&fixed.exact_joints[..], &moving.exact_joints[..]);
        let [start, end] =
            [self.start, self.end].map(|e| e.at.spiral((a, joints.0), (b, joints.1)));
        let kind = self.locus.carrier.kind;
        let radius = a.radius + b.radius;
        let center = Spiral::new(a.center, -b.center.to_vector());
        let rough = self.locus.carrier.normal.map(Dd::from);
        let (through, normal) = match kind {
            SheetKind::LineRound => (start, joints.0[a.start as usize].normal),
            SheetKind::RoundLine => (start, -joints.1[b.start as usize].normal),
            SheetKind::RoundRound => (center, rough),
            SheetKind::FixedFlatArc => {
                let normal = rough.unit();
                (Spiral::new(center.u + normal * radius, center.w), normal)
            }
            SheetKind::MovingFlatArc => {
                let normal = rough.unit();
                (Spiral::new(center.u, center.w + normal * radius), normal)
            }
        };
        Locus {
            carrier: Carrier {
                kind,
                through,
                normal,
                radius,
            },
            start,
            end,
        }
    }

    /// Whether its curves are circles given by a centre.
    #[inline]
    pub(crate) fn is_circle(&self) -> bool {
        self.locus.carrier.kind == SheetKind::RoundRound
    }

    /// Whether its curves are circles so small that f64 does not resolve places on them.
    #[inline]
    pub(crate) fn is_small(&self) -> bool {
        self.is_circle() && self.locus.carrier.radius.abs() < SMALL_CIRCLE
    }

    /// Whether its curves are lines.
    #[inline]
    pub(crate) fn is_line(&self) -> bool {
        matches!(
            self.locus.carrier.kind,
            SheetKind::LineRound | SheetKind::RoundLine
        )
    }

    /// Whether its curves are flat arcs.
    #[inline]
    pub(crate) fn is_flat_arc(&self) -> bool {
        matches!(
            self.locus.carrier.kind,
            SheetKind::FixedFlatArc | SheetKind::MovingFlatArc
        )
    }

    /// Whether a flat arc is involved: its curve is one, or its ends move with one.
    #[inline]
    pub(crate) fn is_flat(&self) -> bool {
        self.is_flat_arc() || !self.locus.start.swing.is_none() || !self.locus.end.swing.is_none()
    }

    /// Upper bound of the distance of a flat arc from its chord: the height of its circle over a chord of [`LONGEST`], at most
    /// [`WIDEST_SAGITTA`]. 0 for other curves.
    pub(crate) fn height(&self) -> f64 {
        if self.is_flat_arc() {
            let whole = 0.125 * LONGEST * LONGEST / self.locus.carrier.radius.abs();
            whole.min(WIDEST_SAGITTA)
        } else {
            0.0
        }
    }

    /// Its curve at one orientation.
    pub(crate) fn curve(&self, theta: f64, turn: Rotation) -> Curve {
        self.curve_on(&self.locus, &Orientation { theta, turn })
    }

    /// Its curve at one orientation, on the locus in numbers of any kind.
    pub(crate) fn curve_on<T: Ordered>(&self, locus: &Locus<T>, at: &Orientation<T>) -> Curve<T> {
        let theta = at.theta.value();
        let angles = [self.start, self.end].map(|e| e.angle_at(theta));
        Curve::new(locus.carrier.cycle(at.turn), locus.ends(at.turn), angles)
    }

    /// The whole line or circle of its curve at an orientation.
    #[inline(always)]
    pub(crate) fn cycle<T: Real>(&self, turn: Rotation<T>) -> Cycle<T> {
        self.locus.carrier.lift().cycle(turn)
    }

    /// Its contact function.
    #[inline(always)]
    pub(crate) fn function(&self) -> ContactFunction {
        self.locus.carrier.function()
    }
}

#[cfg(test)]
pub(super) mod tests;
