//! The surface on which two features touch, before it is cut where other features are in the way.

use crate::feature::tolerance::{LARGEST_CIRCLE, SAME_CARRIER};
use crate::geometry::{Point, Rotation, Vector};

use super::bow::Bow;
use super::bow_events::always_touch;
use super::carrier::Carrier;
use super::curve::{Curve, CurveShape};
use super::function::ContactFunction;
use super::spiral::{Spiral, Swing};
use crate::number::{Dd, Real};

/// The largest distance of two positions in contact, length.
const LONGEST: f64 = 4.0;

/// More than the height of the arc of a large circle over its chord in the pair's frame (length).
///
/// One of the arcs that touch is large, so that it and what touches it turn by no more than [`LONGEST`] / [`LARGEST_CIRCLE`].
pub(crate) const WIDEST_SAGITTA: f64 = 0.125 * LONGEST * LONGEST / LARGEST_CIRCLE;

/// Which features touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SheetKind {
    /// A line of the fixed part and an arc or vertex of the moving part: the normal is constant.
    LineRound,
    /// An arc or vertex of the fixed part and a line of the moving part: the normal turns with θ.
    RoundLine,
    /// Arcs or vertices of both.
    RoundRound,
    /// The same, the fixed arc being so large that the circle is told by a point near it; the normal there is constant.
    FixedBow,
    /// The same, the moving arc alone being so large; the normal turns with θ.
    MovingBow,
}

/// The angle of the contact normal at an end of a circular contact curve: constant, or turning with θ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EndAngle {
    pub(crate) offset: f64,
    pub(crate) turns: bool,
}

impl EndAngle {
    #[inline]
    pub(crate) fn at(&self, theta: f64) -> f64 {
        if self.turns {
            self.offset + theta
        } else {
            self.offset
        }
    }
}

/// What a sheet meets where its orientations end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Seam {
    /// The curve shrinks to a point there.
    Point,
    /// Two lines are parallel there: fixed line, moving line.
    Lines(u32, u32),
    /// A fixed line is tangent at a joint between two moving features, neither of them a line.
    LineJoint(u32, u32),
    /// The same with the roles exchanged.
    JointLine(u32, u32),
    /// The end moves from one joint to another; the sheet goes on: fixed, moving feature, turn, which.
    Same(u32, u32, i32, u8),
    /// The sheet goes on at the other end of the full turn: fixed, moving feature, turn, which.
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

/// The contact of one feature pair over an interval of orientations in which its ends keep their identity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sheet {
    pub(crate) kind: SheetKind,
    pub(crate) fixed: u32,
    pub(crate) moving: u32,
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// The same in double-double.
    pub(crate) from: Dd,
    pub(crate) to: Dd,
    pub(crate) start_at: EndAt,
    pub(crate) end_at: EndAt,
    /// Centre of the fixed round feature, or a point of the fixed line. Of a bow, the point it goes through is this less the
    /// moving one, turned, and the swing.
    pub(crate) fixed_point: Point,
    /// Centre of the moving round feature, or a point of the moving line.
    pub(crate) moving_point: Point,
    /// Only for two large arcs.
    pub(crate) swing: Swing,
    /// Normal on the fixed part: of the fixed line, or minus the normal of the moving line (to be turned). Of a bow, where it
    /// goes through its point.
    pub(crate) normal: Vector,
    /// Sum of the signed radii.
    pub(crate) radius: f64,
    pub(crate) start: Spiral,
    pub(crate) end: Spiral,
    /// Identity of the end: equal for the two sheets that share it.
    pub(crate) start_name: u32,
    pub(crate) end_name: u32,
    /// Only for circles.
    pub(crate) start_angle: EndAngle,
    pub(crate) end_angle: EndAngle,
    pub(crate) bottom: Seam,
    pub(crate) top: Seam,
}

/// The ends that two sheets have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SharedEnds {
    /// The carriers are one, or tangent at every orientation: the curves do not cross.
    pub(crate) tangent: bool,
    /// Ends at which they cross, but only there.
    pub(crate) corners: [Option<Spiral>; 2],
}

impl Sheet {
    /// Whether two sheets have one circle as carrier at every orientation: arcs on one circle, or equal sums of radii
    /// about the same centres. Their curves do not cross, whatever rounding makes of it.
    pub(super) fn same_circle(&self, other: &Self) -> bool {
        let apart = |a: Vector, b: Vector| (a - b).length() > SAME_CARRIER;
        let (c, d) = (self.center(), other.center());
        self.is_circle()
            && other.is_circle()
            && !apart(c.u.to_vector(), d.u.to_vector())
            && !apart(c.w, d.w)
            && (self.radius.abs() - other.radius.abs()).abs() <= SAME_CARRIER
    }

    /// Whether a line and a circle, or two circles, are tangent at every orientation: halves of one disc against a side and
    /// the corner it ends at, or against two arcs that follow each other smoothly. Their curves do not cross, whatever rounding
    /// makes of it.
    fn always_tangent(&self, other: &Self) -> bool {
        if self.is_flat() || other.is_flat() {
            return always_touch(self, other);
        }
        let (line, circle) = match (self.is_circle(), other.is_circle()) {
            (false, false) => return false,
            (false, true) => (self, other),
            (true, false) => (other, self),
            (true, true) => {
                let (c, d) = (self.center(), other.center());
                let (u, w) = (c.u - d.u, c.w - d.w);
                let apart = match (u.length() <= SAME_CARRIER, w.length() <= SAME_CARRIER) {
                    (false, true) => u.length(),
                    (true, false) => w.length(),
                    _ => return false,
                };
                let (r, s) = (self.radius.abs(), other.radius.abs());
                return (apart - (r + s)).abs().min((apart - (r - s).abs()).abs()) <= SAME_CARRIER;
            }
        };
        let (stays, turns) = line.seen(&circle.center());
        let off = line.normal.dot(stays).abs() - circle.radius.abs();
        turns.length() <= SAME_CARRIER && off.abs() <= SAME_CARRIER
    }

    /// A spiral from the start of a line, seen by its normal: what stays, and what turns.
    pub(crate) fn seen(&self, spiral: &Spiral) -> (Vector, Vector) {
        let (u, w) = (spiral.u - self.start.u, spiral.w - self.start.w);
        if self.turns() {
            // R n · (u + R w) = n·w + (R n)·u.
            (w, u)
        } else {
            (u, w)
        }
    }

    /// Whether both curves are lines that are parallel at every orientation, or opposite.
    pub(crate) fn is_parallel(&self, other: &Self) -> bool {
        let lines = self.is_line() && self.kind == other.kind;
        lines && self.normal.cross(other.normal).abs() <= SAME_CARRIER
    }

    /// The ends that two sheets share.
    ///
    /// Where normals agree (every shared end but that of two vertices) the curves are tangent there and have no other
    /// crossing. Where two vertices touch, they cross at the shared end, which is no crossing of interiors.
    pub(crate) fn shared_ends(&self, other: &Self, first_vertex_name: u32) -> SharedEnds {
        let mut shared = SharedEnds {
            tangent: self.same_circle(other)
                || self.same_bow(other)
                || self.always_tangent(other)
                || (self.fixed == other.fixed && self.moving == other.moving),
            corners: self.shared_corners(other, first_vertex_name),
        };
        let smooth = |name: u32, other: u32| name == other && name < first_vertex_name;
        shared.tangent |= smooth(self.end_name, other.start_name);
        shared.tangent |= smooth(self.start_name, other.end_name);
        shared
    }

    /// The ends of two vertices that it shares with another sheet: its own end, and its start.
    pub(crate) fn shared_corners(
        &self,
        other: &Self,
        first_vertex_name: u32,
    ) -> [Option<Spiral>; 2] {
        let corner = |name: u32, other: u32| name == other && name >= first_vertex_name;
        [
            corner(self.end_name, other.start_name).then_some(self.end),
            corner(self.start_name, other.end_name).then_some(self.start),
        ]
    }

    /// Whether its curves are circles about a centre.
    #[inline]
    pub(crate) fn is_circle(&self) -> bool {
        self.kind == SheetKind::RoundRound
    }

    /// Whether its curves are circles so small that doubles do not tell places on them.
    #[inline]
    pub(crate) fn is_small(&self) -> bool {
        /// Of a smaller radius (length).
        const SMALL: f64 = 1e-6;
        self.is_circle() && self.radius.abs() < SMALL
    }

    /// Whether its curves are lines.
    #[inline]
    pub(crate) fn is_line(&self) -> bool {
        matches!(self.kind, SheetKind::LineRound | SheetKind::RoundLine)
    }

    /// Whether its curves are circles told by a point.
    #[inline]
    pub(crate) fn is_bow(&self) -> bool {
        matches!(self.kind, SheetKind::FixedBow | SheetKind::MovingBow)
    }

    /// Whether a large arc is involved.
    #[inline]
    pub(crate) fn is_flat(&self) -> bool {
        self.is_bow() || !self.start.swing.is_none() || !self.end.swing.is_none()
    }

    fn turns(&self) -> bool {
        matches!(self.kind, SheetKind::RoundLine | SheetKind::MovingBow)
    }

    /// How far a bow may be off its chord: half the height of the largest circle over all of the pair, or what an arc may
    /// turn that is part of it. 0 for a line.
    pub(crate) fn height(&self) -> f64 {
        if self.is_bow() {
            let whole = 0.125 * LONGEST * LONGEST / self.radius.abs();
            whole.min(WIDEST_SAGITTA)
        } else {
            0.0
        }
    }

    /// By what its carrier is told: a position on it, or its centre.
    pub(crate) fn any(&self) -> Spiral {
        if self.is_line() {
            self.start
        } else {
            self.near()
        }
    }

    /// A position through which a bow goes.
    #[inline]
    fn near(&self) -> Spiral {
        Spiral {
            u: self.fixed_point,
            w: -self.moving_point.to_vector(),
            swing: self.swing,
        }
    }

    /// Whether two bows are one circle at every orientation at which both exist: the same three places are on both at the
    /// first, the middle and the last.
    fn same_bow(&self, other: &Self) -> bool {
        if !(self.is_bow() && other.is_bow()) {
            return false;
        }
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        [lo, 0.5 * (lo + hi), hi].iter().all(|&theta| {
            let turn = Rotation::by(theta);
            let (f, g) = (self.function().bow(turn), other.function().bow(turn));
            f.zip(g).is_some_and(|(f, g)| {
                let on = |u: f64| f.distance(g.point(u)).abs() <= SAME_CARRIER;
                f.normal_at(f.point(0.0)).dot(g.normal_at(f.point(0.0))) > 0.0
                    && [-1.0, 0.0, 1.0].into_iter().all(on)
            })
        })
    }

    /// The outward normal of the fixed line, or of the turning one, at an orientation; of a bow where it goes through its
    /// point. Not for circles.
    #[inline]
    pub(crate) fn normal_at(&self, turn: Rotation) -> Vector {
        if self.turns() {
            turn * self.normal
        } else {
            self.normal
        }
    }

    /// The circle's centre P − R Q, a spiral too.
    #[inline]
    pub(crate) fn center(&self) -> Spiral {
        Spiral::new(self.fixed_point, -self.moving_point.to_vector())
    }

    /// The centre of its circle, if that of another sheet is so near to it that places where the circles cross would be lost in the
    /// rounding of the two centres; and how near.
    ///
    /// Two arcs of a part of 1e-9 sizes touch an arc of the other on circles as near as that. Where they cross is told by the
    /// direction from one centre to the other, and that by the difference of two spirals, in which nothing cancels.
    pub(crate) fn close_to(&self, other: &Self) -> Option<(Spiral, f64)> {
        /// Centres nearer than this are close (length): farther ones are known to 1e-10 of their distance.
        const CLOSE: f64 = 1.0 / (1u64 << 20) as f64;
        if !(self.is_circle() && other.is_circle()) {
            return None;
        }
        let (c, d) = (self.center(), other.center());
        let apart = (d.u - c.u).length() + (d.w - c.w).length();
        (0.0 < apart && apart < CLOSE).then_some((c, apart))
    }

    /// The same circle, seen from a place that moves: in a frame that does not turn and has that place for its origin.
    pub(crate) fn about(&self, place: &Spiral) -> Self {
        Self {
            fixed_point: self.fixed_point - place.u.to_vector(),
            moving_point: self.moving_point + place.w,
            start: self.start.about(place),
            end: self.end.about(place),
            ..*self
        }
    }

    /// Its curve at one orientation.
    pub(crate) fn curve(&self, theta: f64, turn: Rotation) -> Curve {
        let (start, end) = (self.start.at(turn), self.end.at(turn));
        let shape = if self.is_circle() {
            let (from, to) = (self.start_angle.at(theta), self.end_angle.at(theta));
            CurveShape::Circle {
                center: self.center().at(turn),
                radius: self.radius,
                mid_angle: 0.5 * (from + to),
                half: 0.5 * (to - from).abs(),
            }
        } else if self.is_bow() {
            let through = self.near().at(turn);
            CurveShape::Bow(Bow::new(through, self.normal_at(turn), 1.0 / self.radius))
        } else {
            CurveShape::Line {
                normal: self.normal_at(turn),
            }
        };
        Curve { start, end, shape }
    }

    /// Its contact function.
    pub(crate) fn function(&self) -> ContactFunction {
        match self.kind {
            SheetKind::LineRound => ContactFunction::FixedLine {
                normal: self.normal,
                through: self.start,
            },
            SheetKind::RoundLine => ContactFunction::MovingLine {
                normal: self.normal,
                through: self.start,
            },
            SheetKind::RoundRound => ContactFunction::Circle {
                center: self.center(),
                radius: self.radius,
            },
            SheetKind::FixedBow | SheetKind::MovingBow => ContactFunction::FlatCircle {
                through: self.near(),
                normal: self.normal,
                turns: self.turns(),
                radius: self.radius,
            },
        }
    }

    /// Its carrier at the orientation with the given cosine and sine.
    #[inline(always)]
    pub(crate) fn carrier<T: Real>(&self, cos: T, sin: T) -> Carrier<T> {
        self.function().carrier(cos, sin)
    }
}

#[cfg(test)]
pub(super) mod tests;
