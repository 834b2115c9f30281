//! Motion of a part on its axis, in the frame of the pair.

use crate::contact::Cycle;
use crate::geometry::{Point, Rotation, Vector, wrap};
use crate::number::Real;
use core::f64::consts::{PI, TAU};

/// A motion of at most one degree of freedom, with coordinate t.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Motion {
    /// No motion.
    Still,
    /// q → c + `R_t` (q − c).
    Turn { center: Point },
    /// q → q + t d, with d of length one.
    Slide { direction: Vector },
}

impl Motion {
    /// Position of a point of the part.
    #[inline]
    pub(super) fn point(&self, t: f64, p: Point) -> Point {
        match *self {
            Self::Still => p,
            Self::Turn { center } => center + Rotation::by(t) * (p - center),
            Self::Slide { direction } => p + direction * t,
        }
    }

    /// Image of a direction of the part.
    #[inline]
    pub(super) fn vector(&self, t: f64, v: Vector) -> Vector {
        match self {
            Self::Turn { .. } => Rotation::by(t) * v,
            _ => v,
        }
    }

    /// Image of a cycle of the part.
    #[inline]
    pub(super) fn moved<T: Real>(&self, t: T, cycle: &Cycle) -> Cycle<T> {
        let cycle = cycle.lift();
        match *self {
            Self::Still => cycle,
            Self::Turn { center } => {
                let (turn, center) = (Rotation::by(t), center.map(T::constant));
                Cycle {
                    through: center + turn * (cycle.through - center),
                    normal: turn * cycle.normal,
                    ..cycle
                }
            }
            Self::Slide { direction } => Cycle {
                through: cycle.through + direction.map(T::constant) * t,
                ..cycle
            },
        }
    }

    /// Angle by which the part has turned, radians.
    #[inline]
    pub(super) fn angle(&self, t: f64) -> f64 {
        if self.turns() { t } else { 0.0 }
    }

    /// The velocity by t of the point of the part that is now at `p`.
    #[inline]
    pub(super) fn velocity(&self, p: Point) -> Vector {
        match *self {
            Self::Still => Vector::ZERO,
            Self::Turn { center } => (p - center).left(),
            Self::Slide { direction } => direction,
        }
    }

    pub(super) fn turns(&self) -> bool {
        matches!(self, Self::Turn { .. })
    }
}

/// Placement of a part, or its inverse: its point q is at turn q + shift.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placement {
    pub(super) turn: Rotation,
    pub(super) shift: Vector,
}

impl Placement {
    pub(super) fn point(&self, q: Point) -> Point {
        self.turn * q + self.shift
    }
}

/// The motions of both parts.
///
/// The first has the coordinate x along which the plane is swept, the second the coordinate y.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Motions {
    pub(super) first: Motion,
    pub(super) second: Motion,
}

impl Motions {
    pub(super) fn swapped(&self) -> Self {
        Self {
            first: self.second,
            second: self.first,
        }
    }

    /// Whether both parts turn about one point.
    pub(super) fn share_a_pivot(&self) -> bool {
        self.between_pivots()
            .is_some_and(|apart| apart < super::tolerance::INDEPENDENT)
    }

    /// The distance of the pivots, if both parts turn.
    fn between_pivots(&self) -> Option<f64> {
        match (self.first, self.second) {
            (Motion::Turn { center: c }, Motion::Turn { center: d }) => Some(c.distance(d)),
            _ => None,
        }
    }

    /// The directions, if both parts slide.
    pub(super) fn slides(&self) -> Option<(Vector, Vector)> {
        match (self.first, self.second) {
            (Motion::Slide { direction: d }, Motion::Slide { direction: e }) => Some((d, e)),
            _ => None,
        }
    }

    /// Unites pivots that are nearer to each other than `near`. Returns the largest resulting displacement of a place of the second part:
    /// its turns about both pivots differ by (1 − R)(c − d).
    ///
    /// A corner at both pivots would touch the other part's sides there, or not, wherever the parts are.
    pub(super) fn join_pivots(&mut self, near: f64) -> f64 {
        let Some(apart) = self.between_pivots().filter(|&apart| apart < near) else {
            return 0.0;
        };
        self.second = self.first;
        2.0 * apart
    }

    /// Makes slides parallel if their angle is below `near`. Returns the angle by which the second's direction is turned (radians).
    pub(super) fn join_slides(&mut self, near: f64) -> f64 {
        let Some((d, e)) = self.slides().filter(|(d, e)| d.cross(*e).abs() < near) else {
            return 0.0;
        };
        let direction = d * d.dot(e).signum();
        self.second = Motion::Slide { direction };
        d.cross(e).abs()
    }

    /// The sine of the angle between the directions, if both parts slide.
    pub(super) fn between_slides(&self) -> Option<f64> {
        self.slides().map(|(d, e)| d.cross(e).abs())
    }

    /// The orientation of the second part relative to the first.
    #[inline]
    pub(super) fn theta(&self, x: f64, y: f64) -> f64 {
        self.second.angle(y) - self.first.angle(x)
    }

    /// Position of the second part's origin in the first part's frame, and its orientation.
    pub(super) fn relative(&self, x: f64, y: f64) -> (Point, f64) {
        let world = self.second.point(y, Point::ORIGIN);
        (self.first.point(-x, world), self.theta(x, y))
    }
}

// Ranges of the coordinates.

/// The values of one coordinate, in the frame of the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Extent {
    pub(super) lo: f64,
    pub(super) hi: f64,
    pub(super) kind: ExtentKind,
}

/// Kind of the two ends of an extent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum ExtentKind {
    /// Both ends are one place: a full turn.
    Circle,
    /// Limits of a motion by an angle, which may be more than a turn.
    TurnLimits,
    /// Limits of a motion along a direction.
    SlideLimits,
    /// Places beyond which nothing touches, or beyond which the space repeats.
    Open,
}

impl Extent {
    /// A full turn, cut at an angle at which an event is unlikely.
    pub(super) fn circle() -> Self {
        /// Angle of the cut, radians: no multiple of a simple fraction of a turn.
        const CUT: f64 = -PI + 0.012_345_678_9;
        Self {
            lo: CUT,
            hi: CUT + TAU,
            kind: ExtentKind::Circle,
        }
    }

    pub(super) fn is_circle(&self) -> bool {
        self.kind == ExtentKind::Circle
    }

    /// Whether values a turn apart are the same position of the part.
    pub(super) fn repeats(&self) -> bool {
        matches!(self.kind, ExtentKind::Circle | ExtentKind::TurnLimits)
    }

    /// The value reduced to the first turn, if values repeat.
    pub(super) fn reduced(&self, t: f64) -> f64 {
        if !self.repeats() {
            return t;
        }
        let r = t - TAU * ((t - self.lo) / TAU).floor();
        if r >= self.lo + TAU { self.lo } else { r }
    }

    /// a − b, modulo whole turns if values repeat.
    pub(super) fn difference(&self, a: f64, b: f64) -> f64 {
        if self.repeats() { wrap(a - b) } else { a - b }
    }

    /// a − b; if both ends are the same place, the shorter way around.
    pub(super) fn apart(&self, a: f64, b: f64) -> f64 {
        if self.is_circle() { wrap(a - b) } else { a - b }
    }

    /// The value reduced to the circle; unchanged if the ends are not the same place.
    pub(super) fn folded(&self, t: f64) -> f64 {
        if self.is_circle() { self.reduced(t) } else { t }
    }

    /// A value moved by whole turns into a range extended by `reach`, if possible; without turns if the ends of the extent are not the same
    /// place.
    pub(super) fn brought(&self, t: f64, (lo, hi): (f64, f64), reach: f64) -> Option<f64> {
        let t = if self.is_circle() {
            t + TAU * ((lo - reach - t) / TAU).ceil()
        } else {
            t
        };
        (lo - reach <= t && t <= hi + reach).then_some(t)
    }

    /// Bounds of the first turn; of the whole extent, if values do not repeat.
    pub(super) fn first_turn(&self) -> (f64, f64) {
        let to = if self.repeats() {
            self.lo + TAU
        } else {
            self.hi
        };
        (self.lo, to)
    }

    /// Number of turns, including a partial last one.
    pub(super) fn turns(&self) -> i32 {
        match self.kind {
            ExtentKind::TurnLimits => ((self.hi - self.lo) / TAU).floor() as i32 + 1,
            _ => 1,
        }
    }
}

/// A value limited to an interval, whose ends rounding may have exchanged.
pub(super) fn brought_between(t: f64, lo: f64, hi: f64) -> f64 {
    t.max(lo).min(hi)
}

/// Groups values whose distance from the previous one is below `near`: the first and the last value of each cluster.
pub(super) fn clusters(mut values: Vec<f64>, near: f64) -> Vec<(f64, f64)> {
    values.sort_by(f64::total_cmp);
    let mut clusters: Vec<(f64, f64)> = Vec::new();
    for x in values {
        match clusters.last_mut() {
            Some(last) if x - last.1 < near => last.1 = x,
            _ => clusters.push((x, x)),
        }
    }
    clusters
}
