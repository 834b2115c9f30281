//! The first contact along a motion of constant rates.

use crate::pair::{Coordinates, PairContact, PairMotion};
use crate::query::{Classification, MotionError};

use super::carriers::Carriers;
use super::condition::Condition;
use super::domain::ExtentKind;
use super::motion::Motion;
use super::space::FixedAxesSpace;

/// How far a contact may lie outside a cell's box: rounding of a root, and of crossings (radians or length of the frame).
const NEAR: f64 = 1e-9;

impl FixedAxesSpace {
    /// The first contact when the parts move from `from` at constant rates (du/dt, dv/dt) for times from 0 to `duration`.
    ///
    /// Along the motion the contact condition of each curve is a smooth function of time (for two arcs the square of the
    /// centres' distance). A bound on its second derivative tells for any interval of time that it holds no root, or one
    /// at most; other intervals are halved. A root counts if the parts come closer there and the configuration is on the
    /// curve. Nothing is found by sampling. Motions that touch without going deeper go on. A motion that asks a part to move that does not leaves its range at once.
    ///
    /// # Errors
    /// If numbers are not finite, or the motion begins in blocked space or outside the ranges.
    ///
    /// ```
    /// use cspace::pair::PairMotion;
    /// use cspace::{Axis, FixedAxesSpace, Part, Vector, Vertex};
    /// let square = |name: &str, x: f64| {
    ///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slide = Axis::prismatic(Vector::new(-1.0, 0.0));
    /// let space = FixedAxesSpace::compute(&square("wall", 0.0)?, Axis::FIXED, &square("slider", 5.0)?, slide)?;
    /// let PairMotion::Contact(contact) = space.first_contact((0.0, 0.0), (0.0, 2.0), 10.0)? else {
    ///     panic!("it should touch");
    /// };
    /// assert!((contact.time - 1.5).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn first_contact(
        &self,
        from: (f64, f64),
        rates: (f64, f64),
        duration: f64,
    ) -> Result<PairMotion, MotionError> {
        let numbers = [from.0, from.1, rates.0, rates.1, duration];
        if !numbers.iter().all(|n| (n * n).is_finite()) || duration < 0.0 {
            return Err(MotionError::NotFinite);
        }
        let touches = match self.classify(from.0, from.1) {
            None => return Err(MotionError::StartsOutside),
            Some(Classification::Blocked) => return Err(MotionError::StartsBlocked),
            Some(class) => class == Classification::Contact,
        };
        let way = self.way(from, rates);
        let leaves = self.time_in_ranges(&way).filter(|&t| t < duration);
        let end = leaves.unwrap_or(duration);
        let mut first: Option<(f64, u32)> = None;
        for b in &self.branches {
            let until = first.map_or(end, |f| f.0);
            if let Some(time) = self.meets(&way, b.cell(), until, touches) {
                let earlier = first.is_none_or(|f| (time, b.patch) < f);
                if earlier {
                    first = Some((time, b.patch));
                }
            }
        }
        Ok(match (first, leaves) {
            (Some((time, patch)), _) => PairMotion::Contact(PairContact {
                time,
                at: Coordinates::Axes {
                    u: from.0 + rates.0 * time,
                    v: from.1 + rates.1 * time,
                },
                patch,
            }),
            (None, Some(time)) => PairMotion::Leaves { time },
            (None, None) => PairMotion::Free,
        })
    }

    /// The motion in the coordinates of the sweep.
    fn way(&self, from: (f64, f64), rates: (f64, f64)) -> Way {
        let (x, y) = self.map.inner(from.0, from.1);
        let (dx, dy) = self.map.inner(rates.0, rates.1);
        Way { x, y, dx, dy }
    }

    /// When the motion leaves the ranges, if it does.
    fn time_in_ranges(&self, way: &Way) -> Option<f64> {
        let of = |extent: &super::domain::Extent, motion: Motion, t: f64, rate: f64| {
            if motion == Motion::Still && rate != 0.0 {
                return Some(0.0);
            }
            let limited = matches!(
                extent.kind,
                ExtentKind::TurnLimits | ExtentKind::SlideLimits
            );
            match rate {
                r if !limited || r == 0.0 => None,
                r if r > 0.0 => Some(((extent.hi - t) / r).max(0.0)),
                r => Some(((extent.lo - t) / r).max(0.0)),
            }
        };
        let a = of(&self.x, self.motions.first, way.x, way.dx);
        let b = of(&self.y, self.motions.second, way.y, way.dy);
        match (a, b) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    }

    /// The first time at which the motion goes through a cell into blocked space, up to `until`.
    fn meets(&self, way: &Way, cell: u32, until: f64, starts_touching: bool) -> Option<f64> {
        let along = Along {
            condition: self.condition_of(cell),
            way,
        };
        let mut found = None;
        let resolution = self.resolution() * self.map.frame.scale;
        if starts_touching && self.touches_at(way, cell, 0.0) {
            let (value, slope) = along.distance(0.0);
            if value.abs() <= resolution && slope < 0.0 {
                return Some(0.0);
            }
        }
        along.falls(0.0, until, &mut |time| {
            let here = self.touches_at(way, cell, time);
            if here {
                found = Some(time);
            }
            here
        });
        found
    }

    fn condition_of(&self, cell: u32) -> &Condition {
        let (_, piece) = self.cell_and_piece(cell);
        &self.pairs[piece.pair as usize].condition
    }

    fn touches_at(&self, way: &Way, cell: u32, time: f64) -> bool {
        let (u, v) = self.map.outer(way.x + way.dx * time, way.y + way.dy * time);
        self.placed(u, v)
            .is_some_and(|(x, y)| self.near_cell(cell, x, y, NEAR).is_some())
    }
}

/// A straight way in the (x, y) plane.
#[derive(Debug, Clone, Copy)]
struct Way {
    x: f64,
    y: f64,
    dx: f64,
    dy: f64,
}

/// A condition along a way.
struct Along<'a> {
    condition: &'a Condition,
    way: &'a Way,
}

impl Along<'_> {
    /// The contact function and its derivative by time.
    fn distance(&self, t: f64) -> (f64, f64) {
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
        match self.condition.carriers {
            Carriers::Circles {
                first: p,
                second: q,
                radius,
            } => {
                let (p, q) = (first.point(x, p), second.point(y, q));
                let w = q - p;
                let velocity = second.velocity(q) * dy - first.velocity(p) * dx;
                let speed =
                    second.velocity(q).length() * dy.abs() + first.velocity(p).length() * dx.abs();
                let acceleration = second.velocity(q).length() * dy.abs() * turn
                    + first.velocity(p).length() * dx.abs() * spin;
                let reach = w.length() + speed * half;
                let sign = radius.signum();
                let bend = 2.0 * (speed * speed + reach * acceleration);
                let value = (w.length() - radius.abs()) * (w.length() + radius.abs());
                (sign * value, sign * 2.0 * w.dot(velocity), bend)
            }
            Carriers::FirstLine { through, point, .. } => {
                let (value, slope) = self.distance(mid);
                let (l, q) = (first.point(x, through), second.point(y, point));
                let arms = (first.velocity(l).length(), second.velocity(q).length());
                let speed = arms.0 * dx.abs() + arms.1 * dy.abs();
                let acceleration = arms.0 * dx.abs() * spin + arms.1 * dy.abs() * turn;
                let reach = (q - l).length() + speed * half;
                (
                    value,
                    slope,
                    spin * spin * reach + 2.0 * spin * speed + acceleration,
                )
            }
            Carriers::SecondLine { through, point, .. } => {
                let (value, slope) = self.distance(mid);
                let (l, p) = (second.point(y, through), first.point(x, point));
                let arms = (first.velocity(p).length(), second.velocity(l).length());
                let speed = arms.0 * dx.abs() + arms.1 * dy.abs();
                let acceleration = arms.0 * dx.abs() * spin + arms.1 * dy.abs() * turn;
                let reach = (p - l).length() + speed * half;
                (
                    value,
                    slope,
                    turn * turn * reach + 2.0 * turn * speed + acceleration,
                )
            }
        }
    }

    /// Calls `take` with every time at which the condition falls through zero, in order, until it returns true. Returns
    /// whether it did.
    fn falls(&self, lo: f64, hi: f64, take: &mut impl FnMut(f64) -> bool) -> bool {
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
