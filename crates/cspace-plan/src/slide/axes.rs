//! Sliding of a pair with fixed axes. The weighted coordinates are u and v, of parts that slide in lengths of the pair's frame.

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::{Axis, AxisMotion, Classification, FixedAxesSpace, MotionError, PatchId, QueryError};

use super::ground::{Constraint, Ground, Stop, last_not_blocked};
use super::tolerance::{DEPTH, TOUCHES};
use super::vector::{Vec3, between};

#[derive(Debug)]
pub(super) struct OnAxes<'a> {
    space: &'a FixedAxesSpace,
    axes: [Axis; 2],
    /// Units of u and v: 1 in the pair's frame for a length, a radian for an angle.
    units: [f64; 2],
    scale: f64,
}

impl<'a> OnAxes<'a> {
    pub(super) fn new(space: &'a FixedAxesSpace) -> Self {
        let axes: [Axis; 2] = space.axes().into();
        let scale = space.frame().scale;
        let unit = |axis: Axis| match axis.motion {
            AxisMotion::Prismatic { .. } => 1.0 / scale,
            _ => 1.0,
        };
        Self {
            space,
            axes,
            units: axes.map(unit),
            scale,
        }
    }

    /// Within the ranges of motion.
    pub(super) fn within(&self, at: [f64; 2]) -> [f64; 2] {
        core::array::from_fn(|i| match (self.axes[i].motion, self.axes[i].range) {
            (AxisMotion::Fixed, _) => 0.0,
            (_, Some((lo, hi))) => at[i].clamp(lo, hi),
            (_, None) => at[i],
        })
    }

    /// The first contact of a straight motion.
    fn straight(&self, from: Vec3, to: Vec3) -> Result<Stop, QueryError> {
        let ([u, v], [a, b]) = (self.unweighted(from), self.unweighted(to));
        let (by, depth) = ((a - u, b - v), DEPTH * self.space.contact_distance());
        let outcome = match self.space.first_contact_below((u, v), by, 1.0, depth) {
            // A little too deep in what it touches: there is no way from there.
            Err(MotionError::StartsBlocked) => {
                return Ok(Stop {
                    at: from,
                    stopped: None,
                });
            }
            outcome => outcome?,
        };
        let (time, stopped) = match outcome {
            AxesMotionOutcome::Free => (1.0, None),
            // The goal is in the ranges, but for rounding.
            AxesMotionOutcome::Leaves { time } => (time, None),
            AxesMotionOutcome::Contact(contact) => (contact.time, Some(contact.patch)),
        };
        Ok(Stop {
            at: between(from, to, time),
            stopped,
        })
    }
}

impl Ground for OnAxes<'_> {
    type At = [f64; 2];

    fn straight_to(
        &self,
        from: [f64; 2],
        goal: [f64; 2],
    ) -> Result<([f64; 2], Option<PatchId>), QueryError> {
        let (start, end) = (self.weighted(from), self.weighted(goal));
        let found = self.straight(start, end)?;
        if !self.is_blocked(found.at) {
            let at = self.unweighted(found.at);
            return Ok((found.stopped.map_or(goal, |_| at), found.stopped));
        }
        let at = |t: f64| between(start, found.at, t);
        let last = last_not_blocked(|t| self.is_blocked(at(t)), 1.0, 0.0);
        let at = self.unweighted(at(last));
        let near = self.space.contacts(at[0], at[1], f64::INFINITY);
        let nearest = near.first().map(|&(patch, _)| patch);
        Ok((at, found.stopped.or(nearest)))
    }

    fn weighted(&self, [u, v]: [f64; 2]) -> Vec3 {
        [u / self.units[0], v / self.units[1], 0.0]
    }

    fn unweighted(&self, at: Vec3) -> [f64; 2] {
        [at[0] * self.units[0], at[1] * self.units[1]]
    }

    fn is_blocked_at(&self, [u, v]: [f64; 2]) -> bool {
        let class = self.space.classify(u, v);
        class.is_none_or(|c| c == Classification::Blocked)
    }

    fn advance(&self, from: Vec3, to: Vec3) -> Result<Stop, QueryError> {
        self.straight(from, self.weighted(self.within(self.unweighted(to))))
    }

    fn touching(&self, at: Vec3) -> Result<Vec<PatchId>, QueryError> {
        let [u, v] = self.unweighted(at);
        let within = TOUCHES * self.space.contact_distance();
        let found = self.space.contacts(u, v, within);
        Ok(found.into_iter().map(|(p, _)| p).collect())
    }

    fn constraint(&self, patch: PatchId, at: Vec3) -> Result<Constraint, QueryError> {
        let [u, v] = self.unweighted(at);
        let value = self.space.contact_function(patch, u, v);
        let slopes = self.space.contact_gradient(patch, u, v);
        let ((by_u, by_v), value) = slopes.zip(value).ok_or(QueryError::Outside)?;
        let [a, b] = self.units.map(|unit| unit * self.scale);
        Ok(Constraint {
            value: value * self.scale,
            gradient: [by_u * a, by_v * b, 0.0],
        })
    }

    fn limits(&self) -> [Option<(f64, f64)>; 3] {
        let of = |i: usize| {
            let unit = self.units[i];
            let range = self.axes[i].range?;
            Some((range.0 / unit, range.1 / unit))
        };
        [of(0), of(1), None]
    }

    fn contact(&self) -> f64 {
        self.space.contact_distance() * self.scale
    }
}
