//! Projection of a configuration to where contacts and joints hold, and forces balance if required; and the constraints
//! there.

use crate::contact::Bound;
use crate::linear::add_scaled;
use crate::pairs::Pairs;
use crate::system::{Law, Row, System};

use super::balance::Closed;
use super::holding::Holding;
use super::velocity::{Held, Local};

/// Closed contacts and joints hold to this, relative to the size of the mechanism: rounding, a hundredth of the resolution.
pub(super) const CLOSED: f64 = 1e-13;
/// Largest remaining Newton step, relative to the size of the mechanism, with which forces count as balanced once it no
/// longer decreases.
const BALANCED: f64 = 1e-10;
/// Newton's steps back to closed contacts. They converge quadratically from nearby, or not at all.
const MOST_CORRECTIONS: usize = 12;

/// Joints, constraints and equations of motion at a configuration.
pub(super) struct There<'a> {
    joints: Vec<Row>,
    holding: Holding,
    local: Option<Local<'a>>,
}

impl<'a> There<'a> {
    pub(super) fn at(system: &System, pairs: &Pairs, held: &[Bound], q: &[f64]) -> Self {
        Self {
            joints: system.joints(q),
            holding: Holding::of(system, pairs, held, q),
            local: None,
        }
    }

    pub(super) fn velocity(
        self,
        system: &'a System,
        pairs: &Pairs,
        held: &[Bound],
        time: f64,
        q: &[f64],
    ) -> Option<Held> {
        let local = match self.local {
            Some(local) => local,
            None => Local::with_joints(system, q, time, &self.joints)?,
        };
        let mut found = local.held(&self.holding)?;
        if system.law() == Law::Balance {
            let closed = Closed {
                system,
                pairs,
                bounds: held,
                q,
            };
            found = closed.follow(&local, found)?;
        }
        found.rates.iter().all(|r| r.is_finite()).then_some(found)
    }
}

/// Projects a configuration to where contacts and joints hold, and forces balance if required, by no more than `room`
/// (length).
pub(crate) fn close(
    system: &System,
    pairs: &Pairs,
    held: &[Bound],
    time: f64,
    q: &mut [f64],
    room: f64,
) -> Option<()> {
    closed(system, pairs, held, time, q, room).map(|_| ())
}

/// As [`close`], and returns the constraints at the corrected configuration.
pub(super) fn closed<'a>(
    system: &'a System,
    pairs: &Pairs,
    held: &[Bound],
    time: f64,
    q: &mut [f64],
    room: f64,
) -> Option<There<'a>> {
    let mut there = constrained(system, pairs, held, time, q, room)?;
    if system.law() != Law::Balance {
        return Some(there);
    }
    let size = system.size();
    let (mut moved, mut before) = (0.0, f64::INFINITY);
    for _ in 0..MOST_CORRECTIONS {
        let local = Local::with_joints(system, q, time, &there.joints)?;
        let closed = Closed {
            system,
            pairs,
            bounds: held,
            q,
        };
        let balance = closed.balance(&local).filter(|b| !b.is_lost())?;
        let step = local.displaced(&balance.step(local.forces.len()));
        let far = system.speed(&step);
        if far == 0.0 || (far > 0.25 * before && before < BALANCED * size) {
            there.local = Some(local);
            return Some(there);
        }
        before = far;
        moved += far;
        if moved.is_nan() || moved > room {
            return None;
        }
        add_scaled(q, 1.0, &step);
        there = constrained(system, pairs, held, time, q, room)?;
    }
    (before < BALANCED * size).then_some(there)
}

/// Projects a configuration to where contacts and joints hold, by the shortest displacement, by no more than `room`
/// (length).
fn constrained<'a>(
    system: &'a System,
    pairs: &Pairs,
    held: &[Bound],
    time: f64,
    q: &mut [f64],
    room: f64,
) -> Option<There<'a>> {
    system.drive(time, q);
    let lengths = system.lengths();
    let (mut moved, mut before) = (0.0, f64::INFINITY);
    for _ in 0..MOST_CORRECTIONS {
        let there = There::at(system, pairs, held, q);
        let rows = &there.holding.rows;
        let changes: Vec<f64> = (there.joints.iter().chain(rows))
            .map(|r| -r.value)
            .collect();
        let off = changes.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        if off == 0.0 || (off < CLOSED * system.size() && off > 0.25 * before) {
            return Some(there);
        }
        before = off;
        let local = Local::with_joints(system, q, time, &there.joints)?;
        let step = local.displacement(rows, &changes);
        let mut farthest = 0.0_f64;
        for (&i, d) in system.free().iter().zip(&step) {
            q[i] += d;
            farthest = farthest.max(d.abs() * lengths[i]);
        }
        moved += farthest;
        if moved.is_nan() || moved > room {
            return None;
        }
    }
    (before < CLOSED * system.size()).then(|| There::at(system, pairs, held, q))
}
