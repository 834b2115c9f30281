//! A motion of constant rates, in the frame of a pair.

use core::f64::consts::TAU;

use crate::feature::PairFrame;
use crate::geometry::{Configuration, Point, Rotation, Vector, time_of_known_angle};
use crate::number::{Ball, Dual, Real};
use crate::space::{ContactSpace, Window};

/// An enclosure over times, with its derivative by time.
type Jet = Dual<1, Ball>;

/// x(t), y(t) and θ(t), linear in time.
///
/// In the pair's frame the position is s (p₀ − c + v t + R(θ₀ + ω t) d).
#[derive(Debug, Clone, Copy)]
pub(super) struct Path {
    from: Configuration,
    velocity: Vector,
    /// Radians per unit of time.
    pub(super) turning: f64,
    frame: PairFrame,
    /// How far from the origin of the frame there may be contact.
    reach: f64,
}

impl Path {
    pub(super) fn new(
        space: &ContactSpace,
        from: Configuration,
        velocity: Vector,
        turning: f64,
    ) -> Self {
        Self {
            from,
            velocity,
            turning,
            frame: space.data.frame,
            reach: space
                .data
                .frame
                .reach(&space.data.fixed, &space.data.moving),
        }
    }

    /// The orientation at a time, radians.
    pub(super) fn theta(&self, t: f64) -> f64 {
        self.from.theta + self.turning * t
    }

    /// The configuration at a time.
    pub(super) fn outer_at(&self, t: f64) -> Configuration {
        let p = self.from.position() + self.velocity * t;
        Configuration::new(p.x, p.y, self.theta(t))
    }

    /// The position in the pair's frame at a time.
    pub(super) fn inner_at(&self, t: f64) -> Point {
        self.frame.inner_from_outer(self.outer_at(t))
    }

    /// The rotation by the orientation, and the position, enclosed over times with their derivatives by time.
    pub(super) fn enclosed(&self, t: Ball) -> (Rotation<Jet>, Point<Jet>) {
        let t = Jet::variable(t, 0);
        let linear = |from: f64, rate: f64| Jet::constant(from) + Jet::constant(rate) * t;
        let turn = Rotation::by(linear(self.from.theta, self.turning));
        let start = self.from.position() - self.frame.fixed_center;
        let center = self.frame.moving_center.to_vector().map(Jet::constant);
        let at = Point::new(
            linear(start.x, self.velocity.x),
            linear(start.y, self.velocity.y),
        );
        let from_center = (at + turn * center).to_vector() * Jet::constant(self.frame.scale);
        (turn, Point::new(from_center.x, from_center.y))
    }

    /// How fast a position of the pair's frame moves at most (length per unit of time).
    pub(super) fn speed(&self) -> f64 {
        let drawn = self.frame.moving_center.to_vector().length();
        (self.velocity.length() + drawn * self.turning.abs()) * self.frame.scale
    }

    /// When it leaves the window of orientations, if it does.
    pub(super) fn time_in_window(&self, window: Window) -> Option<f64> {
        if window.full_turn || self.turning == 0.0 {
            return None;
        }
        let edge = if self.turning > 0.0 {
            window.hi
        } else {
            window.lo
        };
        Some(((edge - self.from.theta) / self.turning).max(0.0))
    }

    /// The times up to `end` at which contact is possible: the position without its turning share is within the reach,
    /// and the length of that share, of the centre of the fixed part. Of a motion that turns in place, only the first turn matters.
    pub(super) fn times_in_reach(&self, end: f64) -> Option<(f64, f64)> {
        let start = self.from.position() - self.frame.fixed_center;
        let drawn = self.frame.moving_center.to_vector().length();
        // A little more, for rounding.
        let radius = (self.frame.outer_length(self.reach) + drawn) * (1.0 + 1e-9);
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

    /// When its orientation is no longer known.
    pub(super) fn time_known(&self) -> f64 {
        time_of_known_angle(self.from.theta, self.turning)
    }

    /// Whether contact is possible up to `end` when its orientation is no longer known.
    pub(super) fn turns_too_far(&self, end: f64) -> bool {
        self.times_in_reach(end)
            .is_some_and(|(_, hi)| self.time_known() < hi)
    }

    /// Pieces of the times from `lo` to `hi` in which it turns by a radian at most.
    pub(super) fn pieces(self, lo: f64, hi: f64) -> impl Iterator<Item = (f64, f64)> {
        /// So much of a turn is searched at once, radians.
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
