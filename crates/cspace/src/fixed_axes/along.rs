//! Contact conditions along a motion of constant rates.

use crate::geometry::Point;

use super::condition::{Carriers, Condition};
use super::cycle::{self, Cycle};
use super::motion::Motion;

/// A straight way in the (x, y) plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) dx: f64,
    pub(super) dy: f64,
}

/// A condition along a way.
pub(super) struct Along<'a> {
    pub(super) condition: &'a Condition,
    pub(super) way: &'a Way,
}

impl Along<'_> {
    /// The contact function and its derivative by time.
    pub(super) fn distance(&self, t: f64) -> (f64, f64) {
        let (x, y) = (self.way.x + self.way.dx * t, self.way.y + self.way.dy * t);
        let (by_x, by_y) = self.condition.gradient(x, y);
        (
            self.condition.value(x, y),
            by_x * self.way.dx + by_y * self.way.dy,
        )
    }

    /// The smooth condition, its derivative, and a bound on its second derivative over times from `lo` to `hi`.
    ///
    /// With w the vector between what touches, w′ its velocity and w″ its acceleration: (|w|² − r²)″ / 2 = |w′|² + w·w″,
    /// and (n·w)″ = n″·w + 2 n′·w′ + n·w″. A part that turns at a rate ω has |w′| ≤ ω R and |w″| ≤ ω² R, with R how far
    /// the point is from the pivot; one that slides has no acceleration.
    fn smooth(&self, lo: f64, hi: f64) -> (f64, f64, f64) {
        let mid = 0.5 * (lo + hi);
        let Way { x, y, dx, dy } = *self.way;
        let (x, y) = (x + dx * mid, y + dy * mid);
        let motions = self.condition.motions;
        let (first, second) = (motions.first, motions.second);
        let rate = |m: Motion, d: f64| if m.turns() { d.abs() } else { 0.0 };
        let (spin, turn) = (rate(first, dx), rate(second, dy));
        let half = 0.5 * (hi - lo);
        // Bounds on speed and acceleration of a point of the first part and one of the second, and on how far apart they are.
        let bounds = |p: Point, q: Point| {
            let rates = (
                first.velocity(p).length() * dx.abs(),
                second.velocity(q).length() * dy.abs(),
            );
            let speed = rates.0 + rates.1;
            let acceleration = rates.0 * spin + rates.1 * turn;
            (speed, acceleration, (q - p).length() + speed * half)
        };
        // A bound on what bends a product with a normal that turns at a rate.
        let across = |rate: f64, (speed, acceleration, reach): (f64, f64, f64)| {
            rate * (rate * reach + 2.0 * speed) + acceleration
        };
        match self.condition.carriers {
            Carriers::Circles {
                first: p,
                second: q,
                radius,
            } => {
                let (p, q) = (first.point(x, p), second.point(y, q));
                let w = q - p;
                let velocity = second.velocity(q) * dy - first.velocity(p) * dx;
                let (speed, acceleration, reach) = bounds(p, q);
                let sign = radius.signum();
                let bend = 2.0 * (speed * speed + reach * acceleration);
                let value = (w.length() - radius.abs()) * (w.length() + radius.abs());
                (sign * value, sign * 2.0 * w.dot(velocity), bend)
            }
            Carriers::Cycles {
                first: a,
                second: b,
            } => {
                // F, which is K d + λ₁ λ₂ d²/2 for the distance d: of its terms that move each by itself, in the way from one to
                // the other and in two normals.
                let (a, b) = (a.moved(first, x), b.moved(second, y));
                let slopes = cycle::slopes(&a, first, &b, second);
                let bounds = bounds(a.through, b.through);
                let (speed, acceleration, reach) = bounds;
                let normal = |c: &Cycle| if c.is_centred() { 0.0 } else { 1.0 };
                let bend = (a.weight * b.weight).abs() * (speed * speed + reach * acceleration)
                    + b.weight.abs() * normal(&a) * across(spin, bounds)
                    + a.weight.abs() * normal(&b) * across(turn, bounds)
                    + normal(&a) * normal(&b) * (spin + turn) * (spin + turn);
                let slope = slopes.0 * dx + slopes.1 * dy;
                (cycle::between(&a, &b), slope, bend)
            }
            Carriers::FirstLine { through, point, .. } => {
                let (value, slope) = self.distance(mid);
                let bounds = bounds(first.point(x, through), second.point(y, point));
                (value, slope, across(spin, bounds))
            }
            Carriers::SecondLine { through, point, .. } => {
                let (value, slope) = self.distance(mid);
                let bounds = bounds(first.point(x, point), second.point(y, through));
                (value, slope, across(turn, bounds))
            }
        }
    }

    /// Calls `take` with every time at which the condition falls through zero, in order, until it returns true. Returns
    /// whether it did.
    pub(super) fn falls(&self, lo: f64, hi: f64, take: &mut impl FnMut(f64) -> bool) -> bool {
        /// Intervals are not halved below this share of their ends: two roots within one are a touch that goes no deeper
        /// than rounding.
        const NARROWEST: f64 = 1e-11;
        let half = 0.5 * (hi - lo);
        let (value, slope, bend) = self.smooth(lo, hi);
        if value.abs() > slope.abs() * half + 0.5 * bend * half * half {
            return false;
        }
        let narrow = half <= NARROWEST * (1.0 + hi.abs());
        if slope.abs() > bend * half || narrow {
            let (a, b) = (self.smooth(lo, lo).0, self.smooth(hi, hi).0);
            return a >= 0.0 && b < 0.0 && take(self.root(lo, hi));
        }
        let mid = 0.5 * (lo + hi);
        self.falls(lo, mid, take) || self.falls(mid, hi, take)
    }

    /// Where the condition changes from positive to negative, by halving.
    fn root(&self, mut lo: f64, mut hi: f64) -> f64 {
        for _ in 0..200 {
            let mid = 0.5 * (lo + hi);
            if mid <= lo || mid >= hi {
                break;
            }
            if self.smooth(mid, mid).0 >= 0.0 {
                lo = mid;
            } else {
                hi = mid;
            }
        }
        lo
    }
}
