//! A motion of constant rates, in the frame of a pair.

use core::f64::consts::TAU;

use crate::feature::PairFrame;
use crate::geometry::{Configuration, LARGEST_ANGLE, Point, Rotation, Vector, time_of_known_angle};
use crate::number::{Ball, Dual, Real};
use crate::space::{ContactSpace, Window};

/// Enclosure over an interval of time, with its derivative by time.
type Jet = Dual<1, Ball>;

/// Reasons for which a motion cannot be followed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// A coordinate, a rate or the duration is not finite, or its square is not; or the duration is negative.
    #[error("the motion is not described by finite numbers, or lasts less than no time")]
    NotFinite,
    /// The parts overlap where the motion begins.
    #[error("the parts overlap where the motion begins")]
    StartsBlocked,
    /// The motion begins at an orientation outside the window of the space.
    #[error("the motion begins outside the orientations of the space")]
    StartsOutside,
    /// A part turns farther from 0 than [`LARGEST_ANGLE`] while contact is still possible, before any contact.
    #[error(
        "the motion turns to more than {LARGEST_ANGLE:e} rad from 0, too far to tell where it is on the circle: take off whole turns, or divide the motion"
    )]
    TurnsTooFar,
}

impl MotionError {
    /// Checks the numbers of a motion and its duration.
    pub(crate) fn check(numbers: impl IntoIterator<Item = f64>, time: f64) -> Result<(), Self> {
        let mut numbers = numbers.into_iter().chain([time]);
        let valid = numbers.all(|n| (n * n).is_finite()) && time >= 0.0;
        valid.then_some(()).ok_or(Self::NotFinite)
    }
}

/// Time at which a motion comes near the region where contact is possible.
pub(super) enum Approach {
    /// The motion begins there, or not far from it.
    Near,
    /// The motion comes near at this time.
    At(f64),
    /// The motion never comes near.
    Never,
}

/// A motion in which a point b of the moving part moves on a straight line: its position q(t) and the orientation θ(t) are linear in time,
/// and the position of the part's origin is q(t) − R(θ(t)) b. With b = 0 the origin moves on a straight line.
///
/// In the pair's frame the position is s (q₀ − c + v t + R(θ₀ + ω t) (d − b)).
#[derive(Debug, Clone, Copy)]
pub(super) struct Path {
    /// q₀: initial position of the point b.
    start: Point,
    /// θ₀, radians.
    theta: f64,
    velocity: Vector,
    /// b, in the moving part's frame.
    about: Vector,
    /// ω: radians per unit of time.
    pub(super) turning: f64,
    frame: PairFrame,
    /// Distance from the origin of the pair's frame within which there may be contact.
    reach: f64,
}

impl Path {
    pub(super) fn new(
        space: &ContactSpace,
        from: Configuration,
        [dx, dy, turning]: [f64; 3],
        about: Vector,
        duration: f64,
    ) -> Result<Self, MotionError> {
        let numbers = [from.x, from.y, from.theta, dx, dy, turning];
        MotionError::check(numbers.into_iter().chain([about.x, about.y]), duration)?;
        Ok(Self {
            start: from.position() + Rotation::by(from.theta) * about,
            theta: from.theta,
            velocity: Vector::new(dx, dy),
            about,
            turning,
            frame: space.data.frame,
            reach: space
                .data
                .frame
                .reach(&space.data.fixed, &space.data.moving),
        })
    }

    /// The orientation at a time, radians.
    pub(super) fn theta(&self, t: f64) -> f64 {
        self.theta + self.turning * t
    }

    /// d − b: vector from the point b to the moving part's centre, in its frame.
    fn arm(&self) -> Vector {
        self.frame.moving_center.to_vector() - self.about
    }

    /// The configuration at a time.
    pub(super) fn outer_at(&self, t: f64) -> Configuration {
        let theta = self.theta(t);
        let p = self.start + self.velocity * t - Rotation::by(theta) * self.about;
        Configuration::new(p.x, p.y, theta)
    }

    /// The position in the pair's frame at a time.
    pub(super) fn inner_at(&self, t: f64) -> Point {
        self.frame.inner_from_outer(self.outer_at(t))
    }

    /// The rotation by the orientation, and the position, enclosed over an interval of time, with their derivatives by time.
    pub(super) fn enclosed(&self, t: Ball) -> (Rotation<Jet>, Point<Jet>) {
        let t = Jet::variable(t, 0);
        let linear = |from: f64, rate: f64| Jet::constant(from) + Jet::constant(rate) * t;
        let turn = Rotation::by(linear(self.theta, self.turning));
        let start = self.start - self.frame.fixed_center;
        let arm = self.arm().map(Jet::constant);
        let at = Point::new(
            linear(start.x, self.velocity.x),
            linear(start.y, self.velocity.y),
        );
        let from_center = (at + turn * arm).to_vector() * Jet::constant(self.frame.scale);
        (turn, Point::new(from_center.x, from_center.y))
    }

    /// Time at which a motion that begins far from all contact comes near it. Contact functions along a motion are polynomials about its
    /// beginning, whose rounding, at a thousand sizes from there, is larger than a contact.
    pub(super) fn approach(&self) -> Approach {
        /// Distance of the beginning, in units of that beyond which all is free, that is near enough.
        const NEAR: f64 = 64.0;
        let reach = self.frame.outer_length(2.0 * self.reach) + 2.0 * self.arm().length();
        let away = self.start - self.frame.fixed_center;
        if away.length() <= NEAR * reach {
            return Approach::Near;
        }
        let speed = self.velocity.length();
        // Distance of the line of the motion from the centre, and remaining distance to its nearest point.
        let (past, along) = (
            away.cross(self.velocity) / speed,
            -away.dot(self.velocity) / speed,
        );
        let half = 4.0 * reach * reach - past * past;
        if !(half >= 0.0 && along > 0.0) {
            return Approach::Never;
        }
        Approach::At((along - half.sqrt()) / speed)
    }

    /// Largest speed of a position in the pair's frame (length per unit of time).
    pub(super) fn speed(&self) -> f64 {
        (self.velocity.length() + self.arm().length() * self.turning.abs()) * self.frame.scale
    }

    /// Time at which the motion leaves the window of orientations, if it does.
    pub(super) fn time_in_window(&self, window: Window) -> Option<f64> {
        if window.full_turn || self.turning == 0.0 {
            return None;
        }
        let edge = if self.turning > 0.0 {
            window.hi
        } else {
            window.lo
        };
        Some(((edge - self.theta) / self.turning).max(0.0))
    }

    /// The times up to `end` at which contact is possible: those at which the position of the point b is within the reach plus the length
    /// of the arm d − b from the centre of the fixed part. For a motion that turns in place, only the first turn matters.
    pub(super) fn times_in_reach(&self, end: f64) -> Option<(f64, f64)> {
        let start = self.start - self.frame.fixed_center;
        // Slightly enlarged, for rounding.
        let radius = (self.frame.outer_length(self.reach) + self.arm().length()) * (1.0 + 1e-9);
        let speed = self.velocity.length();
        if speed == 0.0 {
            let turn = if self.turning == 0.0 {
                f64::INFINITY
            } else {
                1.01 * TAU / self.turning.abs()
            };
            return (start.length() <= radius).then_some((0.0, end.min(turn)));
        }
        let along = self.velocity * (1.0 / speed);
        let (at, aside) = (start.dot(along), start.cross(along));
        if aside.abs() > radius {
            return None;
        }
        let half = ((radius - aside) * (radius + aside)).sqrt();
        let slack = 1e-9 * radius;
        let lo = ((-at - half - slack) / speed).max(0.0);
        let hi = ((-at + half + slack) / speed).min(end);
        (lo <= hi).then_some((lo, hi))
    }

    /// Time from which its orientation is no longer known.
    pub(super) fn time_known(&self) -> f64 {
        time_of_known_angle(self.theta, self.turning)
    }

    /// Whether contact is possible, up to `end`, after the orientation is no longer known.
    pub(super) fn turns_too_far(&self, end: f64) -> bool {
        self.times_in_reach(end)
            .is_some_and(|(_, hi)| self.time_known() < hi)
    }

    /// Pieces of the time from `lo` to `hi` in which the motion turns by at most a radian.
    pub(super) fn pieces(self, lo: f64, hi: f64) -> impl Iterator<Item = (f64, f64)> {
        /// Largest turn that is searched at once, radians.
        const PIECE: f64 = 1.0;
        let count = ((hi - lo) * self.turning.abs() / PIECE).ceil().max(1.0);
        let at = move |i: f64| {
            if i < count {
                lo + (hi - lo) * (i / count)
            } else {
                hi
            }
        };
        (0..count as u64).map(move |i| (at(i as f64), at(i as f64 + 1.0)))
    }
}
