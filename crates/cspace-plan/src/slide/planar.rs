//! Sliding of a pair in the plane. The weighted coordinates are the position of the moving part's centre in the pair's frame, and the
//! orientation times the radius of the part about it.

use cspace::{
    Classification, Configuration, ContactSpace, MotionError, MotionOutcome, PairFrame, PatchId,
    Point, QueryError, Rotation, Vector,
};

use super::ground::{Constraint, Ground, Stop, last_not_blocked};
use super::tolerance::{ABOVE, BESIDE, END_SPEED, LEAST_RADIUS, PROBE, SEAM, TOUCHES};
use super::vector::{Vec3, between, dot, minus, size};

#[derive(Debug)]
pub(super) struct Planar<'a> {
    space: &'a ContactSpace,
    frame: PairFrame,
    /// Radius of the moving part about its centre: the weight of an orientation.
    radius: f64,
}

impl<'a> Planar<'a> {
    pub(super) fn new(space: &'a ContactSpace) -> Self {
        let frame = space.data().frame;
        let vertices = space.moving().loops().iter().flat_map(|l| l.vertices());
        let far = vertices.map(|v| Point::new(v.x, v.y).distance(frame.moving_center));
        Self {
            space,
            frame,
            radius: far.map(|d| d * frame.scale).fold(LEAST_RADIUS, f64::max),
        }
    }

    /// With the orientation brought into the window.
    pub(super) fn within(&self, c: Configuration) -> Configuration {
        let window = self.space.window();
        if window.full_turn {
            return c;
        }
        Configuration::new(c.x, c.y, c.theta.clamp(window.lo, window.hi))
    }

    /// The centre of the moving part in the pair's frame.
    fn inner(&self, c: Configuration) -> Point {
        let arm = Rotation::by(c.theta) * self.frame.moving_center.to_vector();
        let p = (c.position() - self.frame.fixed_center) + arm;
        Point::ORIGIN + p * self.frame.scale
    }

    /// The first contact of a motion that is straight in weighted coordinates.
    fn straight(&self, from: Vec3, to: Vec3) -> Result<Stop, QueryError> {
        let (start, way) = (self.unweighted(from), minus(to, from));
        let unit = 1.0 / self.frame.scale;
        let rates = [way[0] * unit, way[1] * unit, way[2] / self.radius];
        let about = self.frame.moving_center.to_vector();
        let outcome = match self.space.first_contact_about(start, rates, about, 1.0) {
            // A little too deep in what it touches: there is no way from there.
            Err(MotionError::StartsBlocked) => {
                return Ok(Stop {
                    at: from,
                    stopped: None,
                });
            }
            outcome => outcome?,
        };
        let (time, patch) = end_of(outcome);
        let at = between(from, to, time);
        let Some(stopped) = patch else {
            return Ok(Stop { at, stopped: None });
        };
        let rate = dot(self.constraint(stopped, at)?.gradient, way);
        let back = if rate < 0.0 {
            ABOVE * self.contact() / -rate
        } else {
            0.0
        };
        Ok(Stop {
            at: between(from, to, (time - back).max(0.0)),
            stopped: patch,
        })
    }
}

/// When a motion of unit duration ends, and the patch that ends it.
fn end_of(outcome: MotionOutcome) -> (f64, Option<PatchId>) {
    match outcome {
        MotionOutcome::Free => (1.0, None),
        // The goal is in the window, but for rounding.
        MotionOutcome::LeavesWindow { time } => (time, None),
        MotionOutcome::Contact(contact) => (contact.time, Some(contact.patch)),
    }
}

impl Ground for Planar<'_> {
    type At = Configuration;

    fn straight_to(
        &self,
        from: Configuration,
        goal: Configuration,
    ) -> Result<(Configuration, Option<PatchId>), QueryError> {
        let by = [goal.x - from.x, goal.y - from.y, goal.theta - from.theta];
        let (time, patch) = end_of(self.space.first_contact(from, by, 1.0)?);
        let at = |t: f64| {
            let [x, y, theta] = by.map(|b| t * b);
            if t >= 1.0 {
                goal
            } else {
                Configuration::new(from.x + x, from.y + y, from.theta + theta)
            }
        };
        let drawn = self.frame.moving_center.to_vector().length() * self.frame.scale;
        let speed = by[0].hypot(by[1]) * self.frame.scale + by[2].abs() * (self.radius + drawn);
        let is_blocked = |t: f64| self.is_blocked_at(at(t));
        let last = last_not_blocked(is_blocked, time, self.contact() / speed);
        if last >= 1.0 {
            return Ok((goal, None));
        }
        let nearest = || Some(self.space.nearest_contact(at(last))?.patch);
        Ok((at(last), patch.or_else(nearest)))
    }

    fn is_blocked_at(&self, c: Configuration) -> bool {
        let class = self.space.classify(c);
        class.is_none_or(|c| c == Classification::Blocked)
    }

    fn weighted(&self, c: Configuration) -> Vec3 {
        let p = self.inner(c);
        [p.x, p.y, c.theta * self.radius]
    }

    fn unweighted(&self, v: Vec3) -> Configuration {
        let window = self.space.window();
        let theta = v[2] / self.radius;
        // At the window's ends rounding may leave it just beyond.
        let at_end = |end: f64| !window.full_turn && (theta - end).abs() <= SEAM;
        let theta = if at_end(window.lo) || at_end(window.hi) {
            theta.clamp(window.lo, window.hi)
        } else {
            theta
        };
        let PairFrame {
            fixed_center,
            moving_center,
            scale,
        } = self.frame;
        let arm = Rotation::by(theta) * moving_center.to_vector();
        let p = fixed_center + (Vector::new(v[0], v[1]) * (1.0 / scale) - arm);
        Configuration::new(p.x, p.y, theta)
    }

    fn advance(&self, from: Vec3, to: Vec3) -> Result<Stop, QueryError> {
        let mut to = to;
        if let [.., Some((lo, hi))] = self.limits() {
            to[2] = to[2].clamp(lo, hi);
        }
        let share = PROBE / size(minus(to, from));
        if share < 0.5 {
            let soon = self.straight(from, between(from, to, share))?;
            if soon.stopped.is_some() {
                return Ok(soon);
            }
        }
        self.straight(from, to)
    }

    /// At a critical orientation some patches begin and others end: both touch.
    fn touching(&self, at: Vec3) -> Result<Vec<PatchId>, QueryError> {
        let within = TOUCHES * self.space.contact_distance();
        let wider = within + END_SPEED * BESIDE / self.frame.scale;
        let mut found = Vec::new();
        for (beside, tolerance) in [(0.0, within), (BESIDE, wider), (-BESIDE, wider)] {
            let theta = at[2] / self.radius + beside;
            let there = self.within(self.unweighted([at[0], at[1], theta * self.radius]));
            for (patch, _) in self.space.contacts(there, tolerance) {
                let is_new = !found.contains(&patch);
                if is_new && self.constraint(patch, at)?.value.abs() <= within * self.frame.scale {
                    found.push(patch);
                }
            }
        }
        Ok(found)
    }

    fn constraint(&self, patch: PatchId, at: Vec3) -> Result<Constraint, QueryError> {
        let found = self.space.patch(patch).ok_or(QueryError::Outside)?;
        let function = &found.data().function;
        let (p, theta) = (Point::new(at[0], at[1]), at[2] / self.radius);
        let (normal, by_theta) = function.gradient(p, theta);
        Ok(Constraint {
            value: function.value(p, theta),
            gradient: [normal.x, normal.y, by_theta / self.radius],
        })
    }

    fn limits(&self) -> [Option<(f64, f64)>; 3] {
        let window = self.space.window();
        let ends = (window.lo * self.radius, window.hi * self.radius);
        [None, None, (!window.full_turn).then_some(ends)]
    }

    fn contact(&self) -> f64 {
        self.space.contact_distance() * self.frame.scale
    }
}
