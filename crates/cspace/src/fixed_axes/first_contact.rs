//! The first contact along a motion of constant rates.

use super::condition::Condition;
use super::motion::{Extent, ExtentKind, Motion};
use super::patches::AxesBranch;
use super::space::FixedAxesSpace;
use super::tolerance::NEAR;
use crate::contact::Cycle;
use crate::geometry::time_of_known_angle;
use crate::ids::PatchId;
use crate::number::{Ball, Dual, Real, halved};
use crate::query::{Classification, MotionError};
use core::f64::consts::TAU;

/// Length of a motion, as a share of the extent, below which branches are looked up along it.
const SHORT: f64 = 0.125;

/// Share of a depth at which a contact function counts as that deep: the rest is small compared with the contact distance.
const AT_DEPTH: f64 = 0.8;

/// Rounding of a condition (length of the pair's frame).
const FLAT: f64 = 4.0 * f64::EPSILON;

/// An enclosure over an interval of time, with its derivative by time.
type Jet = Dual<1, Ball>;

/// First contact along a motion on fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesContact {
    /// Time of contact, in the unit of time of the rates.
    pub time: f64,
    /// The configuration (u, v) at that time.
    pub at: (f64, f64),
    /// Patch that is touched; one of them, if several are.
    pub patch: PatchId,
}

/// Outcome of a motion on fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum AxesMotionOutcome {
    /// The motion is free to the end.
    Free,
    /// The motion touches a contact curve.
    Contact(AxesContact),
    /// The motion is free until it leaves the range of a part's motion, at this time.
    Leaves {
        /// Time at which it leaves.
        time: f64,
    },
}

impl FixedAxesSpace {
    /// The first contact when the parts move from `from` at constant rates (du/dt, dv/dt) at times from 0 to `duration`.
    ///
    /// Along the motion the contact condition of each curve is a smooth function of time (for two arcs the square of the centres'
    /// distance). A bound on its second derivative shows, for an interval of time, that it holds no root, or at most one; other intervals
    /// are halved. A root counts if the parts come closer there and the configuration is on the curve. Nothing is found by sampling.
    /// Motions that touch without going deeper go on. A motion that requires a fixed part to move leaves its range at once.
    ///
    /// The time this takes grows with the number of turns until the contact.
    ///
    /// # Errors
    /// If numbers are not finite, the motion begins in blocked space or outside the ranges, or a part turns farther than
    /// [`LARGEST_ANGLE`](crate::LARGEST_ANGLE) before it touches.
    ///
    /// ```
    /// use cspace::fixed_axes::AxesMotionOutcome;
    /// use cspace::{Axis, FixedAxesSpace, Part, Vector, Vertex};
    /// let square = |name: &str, x: f64| {
    ///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slide = Axis::prismatic(Vector::new(-1.0, 0.0));
    /// let space = FixedAxesSpace::compute(&square("wall", 0.0)?, Axis::FIXED, &square("slider", 5.0)?, slide)?;
    /// let AxesMotionOutcome::Contact(contact) = space.first_contact((0.0, 0.0), (0.0, 2.0), 10.0)? else {
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
    ) -> Result<AxesMotionOutcome, MotionError> {
        self.first_contact_below(from, rates, duration, 0.0)
    }

    /// The first contact, where contact is defined as the contact function falling to −`depth` (model length): so that a motion along
    /// contact, which rounding and curvature bring a little below it and above, goes on. If the depth is less than the
    /// [`contact_distance`](Self::contact_distance), such a motion stays in contact.
    ///
    /// # Errors
    /// As [`first_contact`](Self::first_contact), and if the depth is negative or not finite.
    pub fn first_contact_below(
        &self,
        from: (f64, f64),
        rates: (f64, f64),
        duration: f64,
        depth: f64,
    ) -> Result<AxesMotionOutcome, MotionError> {
        if !(depth >= 0.0 && depth.is_finite()) {
            return Err(MotionError::NotFinite);
        }
        MotionError::check([from.0, from.1, rates.0, rates.1], duration)?;
        let depth = depth * self.setting.map.frame.scale;
        let touches = match self.classify(from.0, from.1) {
            None => return Err(MotionError::StartsOutside),
            Some(Classification::Blocked) => return Err(MotionError::StartsBlocked),
            Some(class) => class == Classification::Contact,
        };
        let way = self.way(from, rates);
        let leaves = self.time_in_ranges(&way).filter(|&t| t < duration);
        let all = leaves.unwrap_or(duration);
        let end = all.min(self.time_known(&way));
        if end < 0.0 {
            return Err(MotionError::TurnsTooFar);
        }
        let mut first: Option<(f64, PatchId)> = None;
        let mut look = |b: &AxesBranch| {
            let until = first.map_or(end, |f| f.0);
            if let Some(time) = self.meets(&way, b.cell, until, touches, depth) {
                let earlier = first.is_none_or(|f| (time, b.patch) < f);
                if earlier {
                    first = Some((time, b.patch));
                }
            }
        };
        self.along(&way, end, &mut look);
        Ok(match (first, leaves) {
            (Some((time, patch)), _) => AxesMotionOutcome::Contact(AxesContact {
                time,
                at: (from.0 + rates.0 * time, from.1 + rates.1 * time),
                patch,
            }),
            (None, _) if end < all => return Err(MotionError::TurnsTooFar),
            (None, Some(time)) => AxesMotionOutcome::Leaves { time },
            (None, None) => AxesMotionOutcome::Free,
        })
    }

    /// All contacts that the motion crosses at times from 0 to `duration`, also where the parts overlap: time, patch, and whether the
    /// motion enters blocked space there; in order of time.
    ///
    /// Roots are found as by [`first_contact`](Self::first_contact); a motion that only touches crosses nothing.
    ///
    /// # Errors
    /// If numbers are not finite, the motion begins outside the ranges, or a part turns farther than
    /// [`LARGEST_ANGLE`](crate::LARGEST_ANGLE).
    pub fn crossings(
        &self,
        from: (f64, f64),
        rates: (f64, f64),
        duration: f64,
    ) -> Result<Vec<(f64, PatchId, bool)>, MotionError> {
        MotionError::check([from.0, from.1, rates.0, rates.1], duration)?;
        if !self.covers(from.0, from.1) {
            return Err(MotionError::StartsOutside);
        }
        let way = self.way(from, rates);
        let end = self
            .time_in_ranges(&way)
            .map_or(duration, |t| t.min(duration));
        if self.time_known(&way) < end {
            return Err(MotionError::TurnsTooFar);
        }
        // Crossings out of blocked space are those into it on the reversed motion.
        let back = Way {
            x: way.x + way.dx * end,
            y: way.y + way.dy * end,
            dx: -way.dx,
            dy: -way.dy,
        };
        let mut found = Vec::new();
        self.along(&way, end, &mut |b| {
            let mut add = |way: &Way, enters: bool| {
                self.falls_through(way, b.cell, end, 0.0, |time| {
                    let time = if enters { time } else { end - time };
                    found.push((time, b.patch, enters));
                    false
                });
            };
            add(&way, true);
            add(&back, false);
        });
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        Ok(found)
    }

    /// All branches that a motion may reach until a time, and some others, each once and in order.
    fn along(&self, way: &Way, end: f64, look: &mut dyn FnMut(&AxesBranch)) {
        // A short motion is near few branches.
        let (x, to) = (way.x, way.x + way.dx * end);
        if (to - x).abs() < SHORT * (self.setting.x.hi - self.setting.x.lo) {
            for i in self.by_x.between(x.min(to), x.max(to)) {
                look(&self.data.branches[i as usize]);
            }
        } else {
            self.data.branches.iter().for_each(look);
        }
    }

    /// The motion in the coordinates of the sweep.
    fn way(&self, from: (f64, f64), rates: (f64, f64)) -> Way {
        let (x, y) = self.setting.map.inner(from.0, from.1);
        let (dx, dy) = self.setting.map.inner(rates.0, rates.1);
        // As for configurations.
        match self.setting.on_one_line() {
            Some(share) => Way {
                x: 0.0,
                y: y - x * share,
                dx: 0.0,
                dy: dy - dx * share,
            },
            None => Way { x, y, dx, dy },
        }
    }

    /// Time from which an angle of a part that turns without limits is no longer known.
    fn time_known(&self, way: &Way) -> f64 {
        let of = |extent: &Extent, angle: f64, rate: f64| match extent.is_circle() {
            true => time_of_known_angle(angle, rate),
            false => f64::INFINITY,
        };
        of(&self.setting.x, way.x, way.dx).min(of(&self.setting.y, way.y, way.dy))
    }

    /// Time at which the motion leaves the ranges, if it does.
    fn time_in_ranges(&self, way: &Way) -> Option<f64> {
        let of = |extent: &Extent, motion: Motion, t: f64, rate: f64| {
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
        let a = of(&self.setting.x, self.setting.motions.first, way.x, way.dx);
        let b = of(&self.setting.y, self.setting.motions.second, way.y, way.dy);
        [a, b].into_iter().flatten().reduce(f64::min)
    }

    /// The first time up to `until` at which the motion passes through a cell into blocked space.
    fn meets(
        &self,
        way: &Way,
        cell: u32,
        until: f64,
        starts_touching: bool,
        depth: f64,
    ) -> Option<f64> {
        let along = Along::new(self.graphs().condition(cell), way, depth);
        let mut found = None;
        let distance = self.setting.inner_contact_distance();
        if starts_touching && self.touches_at(way, cell, 0.0) {
            let (value, slope) = along.distance(0.0);
            // At the depth already, or nearly.
            let is_deep = depth == 0.0 || value <= -AT_DEPTH * depth;
            if value.abs() <= distance && slope < 0.0 && is_deep {
                return Some(0.0);
            }
        }
        self.falls_through(way, cell, until, depth, |time| {
            found = Some(time);
            true
        });
        found
    }

    /// Calls `take` with every time at which the motion passes through a cell into blocked space, until it returns true.
    fn falls_through(
        &self,
        way: &Way,
        cell: u32,
        until: f64,
        depth: f64,
        mut take: impl FnMut(f64) -> bool,
    ) {
        let along = Along::new(self.graphs().condition(cell), way, depth);
        // Only while the motion is in the cell's box.
        let (x_range, y_range) = self.graphs().cell_box(cell);
        let both = (
            Visits::new((way.x, way.dx), x_range, self.setting.x.is_circle(), until),
            Visits::new((way.y, way.dy), y_range, self.setting.y.is_circle(), until),
        );
        let (Some(in_x), Some(in_y)) = both else {
            return;
        };
        in_x.shared(&in_y, until, |lo, hi| {
            along.falls(lo, hi, &mut |time| {
                self.touches_at(way, cell, time) && take(time)
            })
        });
    }

    fn touches_at(&self, way: &Way, cell: u32, time: f64) -> bool {
        let (x, y) = way.at(time);
        let (u, v) = self.setting.map.outer(x, y);
        let distance = self.setting.inner_contact_distance();
        self.setting.placed(u, v).is_some_and(|(x, y)| {
            self.in_box(cell, x, y, NEAR) && self.on_own_root(cell, x, y, distance)
        })
    }
}

// Contact conditions along a motion of constant rates.

/// A motion of constant rates in the (x, y) plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) dx: f64,
    pub(super) dy: f64,
}

impl Way {
    /// The place at a time.
    fn at(&self, t: f64) -> (f64, f64) {
        (self.x + self.dx * t, self.y + self.dy * t)
    }
}

/// A condition along a motion.
pub(super) struct Along<'a> {
    pub(super) condition: &'a Condition,
    pub(super) way: &'a Way,
    /// Value of −G where the contact function is −depth.
    above: f64,
    /// Variation of G that still counts as touching: rounding, or a small part of the depth.
    flat: f64,
}

impl<'a> Along<'a> {
    /// A condition at a depth (length of the pair's frame).
    pub(super) fn new(condition: &'a Condition, way: &'a Way, depth: f64) -> Self {
        // G is K d + λ₁ λ₂ d²/2 for the distance d; the second term is negligible at a depth below the contact distance.
        let above = if depth > 0.0 {
            let (a, b) = condition.moved(way.x, way.y);
            a.total(&b).abs() * depth
        } else {
            0.0
        };
        Self {
            condition,
            way,
            above,
            flat: FLAT.max((1.0 - AT_DEPTH) * above),
        }
    }

    /// The contact function and its derivative by time.
    pub(super) fn distance(&self, t: f64) -> (f64, f64) {
        let (x, y) = self.way.at(t);
        let (by_x, by_y) = self.condition.gradient(x, y);
        (
            self.condition.value(x, y),
            by_x * self.way.dx + by_y * self.way.dy,
        )
    }

    /// G, its derivative, and a bound on its second derivative over times from `lo` to `hi`.
    ///
    /// The bound comes from the terms of G that move each by itself, in the vector w from one cycle to the other and in both normals n:
    /// with its velocity w′ and its acceleration w″, (w²)″ / 2 = w′² + w·w″ and (n·w)″ = n″·w + 2 n′·w′ + n·w″. A part that turns at a rate
    /// ω has |w′| ≤ ω R and |w″| ≤ ω² R, with R the distance of the point from the pivot; one that slides has no acceleration.
    fn smooth(&self, lo: f64, hi: f64) -> (f64, f64, f64) {
        let mid = 0.5 * (lo + hi);
        let Way { dx, dy, .. } = *self.way;
        let (x, y) = self.way.at(mid);
        let motions = self.condition.motions;
        let (first, second) = (motions.first, motions.second);
        let rate = |m: Motion, d: f64| if m.turns() { d.abs() } else { 0.0 };
        let (spin, turn) = (rate(first, dx), rate(second, dy));
        let half = 0.5 * (hi - lo);
        let (a, b) = self.condition.moved(x, y);
        // Bounds on the speed and acceleration of the points and normals of both cycles, and on their distance.
        let rates = (
            first.velocity(a.through).length() * dx.abs(),
            second.velocity(b.through).length() * dy.abs(),
        );
        let speed = rates.0 + rates.1;
        let acceleration = rates.0 * spin + rates.1 * turn;
        let reach = (b.through - a.through).length() + speed * half;
        let across = |rate: f64| rate * (rate * reach + 2.0 * speed) + acceleration;
        let normal = |c: &Cycle| if c.is_centred() { 0.0 } else { 1.0 };
        let bend = (a.weight * b.weight).abs() * (speed * speed + reach * acceleration)
            + b.weight.abs() * normal(&a) * across(spin)
            + a.weight.abs() * normal(&b) * across(turn)
            + normal(&a) * normal(&b) * (spin + turn) * (spin + turn);
        let slopes = self.condition.slopes(&a, &b);
        let slope = slopes.0 * dx + slopes.1 * dy;
        (a.apart(&b) + self.above, slope, bend)
    }

    /// A bound on the second derivative of G over times from `lo` to `hi`, from an enclosure of the derivative of its slope: close to the
    /// true value on short intervals, and so for a motion along a contact much smaller than that of [`smooth`](Self::smooth).
    fn bends(&self, lo: f64, hi: f64) -> f64 {
        let t = Jet::variable(Ball::between(lo, hi), 0);
        let along = |from: f64, rate: f64| Jet::constant(from) + Jet::constant(rate) * t;
        let Way { x, y, dx, dy } = *self.way;
        let (a, b) = self.condition.moved(along(x, dx), along(y, dy));
        let slopes = self.condition.slopes(&a, &b);
        let slope = slopes.0 * Jet::constant(dx) + slopes.1 * Jet::constant(dy);
        let bend = slope.slope[0];
        bend.mid.abs() + bend.radius
    }

    /// Calls `take` with every time at which the condition decreases through zero, in order, until it returns true. Returns whether it did.
    pub(super) fn falls(&self, lo: f64, hi: f64, take: &mut impl FnMut(f64) -> bool) -> bool {
        /// Relative length below which intervals are not halved: two roots within one are a touch no deeper than rounding.
        const NARROWEST: f64 = 1e-11;
        let half = 0.5 * (hi - lo);
        let (value, slope, mut bend) = self.smooth(lo, hi);
        let varies = |bend: f64| slope.abs() * half + 0.5 * bend * half * half;
        if value.abs() > varies(bend) {
            return false;
        }
        if slope.abs() <= bend * half {
            bend = bend.min(self.bends(lo, hi));
            if value.abs() > varies(bend) {
                return false;
            }
        }
        let narrow = half <= NARROWEST * (1.0 + hi.abs()) || varies(bend) <= self.flat;
        if slope.abs() > bend * half || narrow {
            let (a, b) = (self.smooth(lo, lo).0, self.smooth(hi, hi).0);
            let falls = a >= 0.0 && b < 0.0;
            return falls && take(halved((lo, hi), 0.0, |t| self.smooth(t, t).0 >= 0.0).0);
        }
        let mid = 0.5 * (lo + hi);
        self.falls(lo, mid, take) || self.falls(mid, hi, take)
    }
}

// Intervals of time in which a coordinate with a constant rate is within a range.

/// Intervals of time, all of one length, a period apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Visits {
    /// Beginning of the first interval that ends at 0 or later.
    first: f64,
    length: f64,
    /// Infinite if there is only one interval.
    period: f64,
}

impl Visits {
    /// Intervals in which t + rate · time is in the range, extended by rounding, at times from 0 to `until`. `None` if there are none. On a
    /// circle values a turn apart are equal.
    pub(super) fn new(
        (t, rate): (f64, f64),
        (lo, hi): (f64, f64),
        circle: bool,
        until: f64,
    ) -> Option<Self> {
        let near = NEAR + 4.0 * f64::EPSILON * (t.abs() + rate.abs() * until);
        let (lo, hi) = (lo - near, hi + near);
        let always = Self {
            first: 0.0,
            length: f64::INFINITY,
            period: f64::INFINITY,
        };
        if circle && hi - lo >= TAU {
            return Some(always);
        }
        // Distance of t above the lower end, modulo whole turns.
        let above = if circle {
            (t - lo).rem_euclid(TAU)
        } else {
            t - lo
        };
        let width = hi - lo;
        if rate == 0.0 {
            return (0.0..=width).contains(&above).then_some(always);
        }
        // Distance to the end at which it enters: it is inside already, or reaches that end, perhaps a turn further.
        let way = if rate > 0.0 { -above } else { above - width };
        let passed = way + width < 0.0;
        let way = match (circle, passed) {
            (true, true) => way + TAU,
            (false, true) => return None,
            _ => way,
        };
        let visits = Self {
            first: way / rate.abs(),
            length: width / rate.abs(),
            period: if circle {
                TAU / rate.abs()
            } else {
                f64::INFINITY
            },
        };
        (visits.first <= until).then_some(visits)
    }

    /// Calls `take` with every interval within [0, until] that is in a visit of both, in order, until it returns true.
    pub(super) fn shared(&self, other: &Self, until: f64, mut take: impl FnMut(f64, f64) -> bool) {
        let (mut mine, mut theirs) = (self.first, other.first);
        while mine <= until && theirs <= until {
            let lo = mine.max(theirs).max(0.0);
            let (my_end, their_end) = (mine + self.length, theirs + other.length);
            let hi = my_end.min(their_end).min(until);
            if lo <= hi && take(lo, hi) {
                return;
            }
            // Advances the one that ends first.
            let before = (mine, theirs);
            if my_end <= their_end {
                mine += self.period;
            } else {
                theirs += other.period;
            }
            if (mine, theirs) == before {
                // Turns are shorter than the rounding of time.
                return;
            }
        }
    }
}

#[cfg(test)]
mod visits_tests {
    use super::*;

    /// Compared with the definition, at many times.
    #[test]
    fn visits_are_when_the_coordinate_is_in_the_range() {
        let ranges = [(-1.0, 0.5), (2.0, 2.0), (-3.0, 3.2), (5.0, 6.5), (0.0, 6.4)];
        let mut inside = 0;
        for (t, rate) in [
            (0.3, 0.7),
            (-4.0, 2.3),
            (9.0, -1.7),
            (0.2, 0.0),
            (2.0, -0.01),
        ] {
            for range in ranges {
                for circle in [false, true] {
                    let until = 20.0;
                    let always = Visits::new((0.0, 0.0), (0.0, 0.0), false, until);
                    let mut found = Vec::new();
                    if let (Some(a), Some(b)) =
                        (Visits::new((t, rate), range, circle, until), always)
                    {
                        a.shared(&b, until, |lo, hi| {
                            found.push((lo, hi));
                            false
                        });
                    }
                    assert!(found.windows(2).all(|w| w[0].1 < w[1].0), "{found:?}");
                    for k in 0..2000 {
                        let time = until * f64::from(k) / 2000.0;
                        let at = t + rate * time;
                        let at = if circle {
                            range.0 + (at - range.0).rem_euclid(TAU)
                        } else {
                            at
                        };
                        let is = (range.0..=range.1).contains(&at);
                        let said = found.iter().any(|&(lo, hi)| (lo..=hi).contains(&time));
                        assert_eq!(said, is, "{t} {rate} {range:?} {circle} {time}");
                        inside += usize::from(is);
                    }
                }
            }
        }
        assert!(inside > 10_000, "{inside}");
    }
}
