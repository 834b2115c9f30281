//! Balance of forces: loads, weights and springs against contacts, ends of ranges and joints.
//!
//! With the potential V of the forces F = −∇V and the closed contacts and joints fᵢ, a configuration is in balance where
//!
//! F + Σ λᵢ ∇fᵢ = 0 over the free coordinates, with λᵢ ≥ 0 of contacts,
//!
//! and it is stable where the second derivative of L = V − Σ λᵢ fᵢ is positive along the directions in which no fᵢ changes. Its eigenvectors
//! there are the modes. While drives move, a mode of stiffness e > 0 follows them: differentiating the balance, e ż + ∂²L(mode, velocity of
//! all else) = 0. A mode of stiffness 0 that no force acts on is not loaded: it moves only where contacts push it, the shortest way.
//!
//! Second derivatives of L are central differences of exact first ones. They determine the step towards the balance;
//! the balance itself is verified by the forces.

use crate::contact::{Bound, brakes, named};
use crate::forces::{drive_force, joint_forces};
use crate::linear::{Pushing, Rows, add_scaled, dot, length};
use crate::pairs::{Grip, Pairs};
use crate::record::{ContactForce, Forces};
use crate::system::{Row, System};

use super::friction::tangential;
use super::holding::{Holding, friction, grip};
use super::modes::{Mode, modes};
use super::velocity::{Held, Local, Nearest};

/// Displacement for the differences of first derivatives, relative to the size of the mechanism: ten digits are left.
const DIFFERENCE: f64 = 1e-6;
/// A force along a mode without stiffness counts as 0 below this share of all forces: rounding.
const UNLOADED: f64 = 1e-10;
/// A contact carries nothing if it is pressed by less than this share of all forces.
const UNPRESSED: f64 = 1e-11;
/// A contact is pressed by what forces a brake if its share of the speed is larger.
const FORCED: f64 = 1e-9;
/// A configuration is taken for one in balance if that is no farther than this, relative to the size of the mechanism.
const IN_BALANCE: f64 = 1e-6;

/// The forces at a configuration.
#[derive(Debug, Clone)]
pub(super) struct Balance {
    /// λ of joints, then of bounds.
    pub(super) multipliers: Vec<f64>,
    /// Number of the rows that belong to joints.
    pub(super) joints: usize,
    /// The lengths in y of the directions in which they push.
    lengths: Vec<f64>,
    pushing: Pushing,
    pub(super) modes: Vec<Mode>,
    /// Whether the parts return after small displacements along the modes.
    is_stable: bool,
    /// Sum of the magnitudes of all forces, in y.
    total: f64,
    /// Largest stiffness that counts as 0.
    neutral: f64,
}

/// Closed bounds at a configuration.
#[derive(Clone, Copy)]
pub(super) struct Closed<'a> {
    pub(super) system: &'a System,
    pub(super) pairs: &'a Pairs,
    pub(super) bounds: &'a [Bound],
    pub(super) q: &'a [f64],
}

impl Closed<'_> {
    fn rows(&self, q: &[f64]) -> Vec<Row> {
        let of = |b: &Bound| b.function(self.system, self.pairs, q);
        self.bounds.iter().map(of).collect()
    }

    /// Constraints of the bounds, and the brakes that do not hold.
    fn holding(&self, q: &[f64]) -> Holding {
        let mut holding = Holding::of(self.system, self.pairs, self.bounds, q);
        let released = self.released();
        if let Some(along) = &mut holding.along {
            along.extend(&released);
        }
        holding.rows.extend(released);
        holding
    }

    /// −∇L at a configuration near.
    fn pull(&self, multipliers: &[f64], q: &[f64]) -> Vec<f64> {
        let mut pull = self.system.forces(q);
        let holding = self.holding(q);
        let joints = self.system.joints(q);
        for (row, multiplier) in joints.iter().chain(holding.pushes()).zip(multipliers) {
            row.push_on(&mut pull, *multiplier);
        }
        pull
    }

    /// The derivative of −∇L along a displacement of all coordinates.
    fn pull_along(&self, multipliers: &[f64], by: &[f64]) -> Vec<f64> {
        let speed = self.system.speed(by);
        if speed == 0.0 {
            return vec![0.0; by.len()];
        }
        let step = DIFFERENCE * self.system.size() / speed;
        let at = |s: f64| {
            let mut q = self.q.to_vec();
            add_scaled(&mut q, s, by);
            self.pull(multipliers, &q)
        };
        // Differences of fourth order.
        let [near, far] = [step, 2.0 * step].map(|s| (at(s), at(-s), s));
        let half = |(after, before, s): &(Vec<f64>, Vec<f64>, f64), i: usize| {
            (after[i] - before[i]) / (2.0 * s)
        };
        (0..by.len())
            .map(|i| (4.0 * half(&near, i) - half(&far, i)) / 3.0)
            .collect()
    }

    /// Forces of the closed bounds, with the modes that they leave; `None` if sliding contacts cannot push so that
    /// anything holds.
    pub(super) fn balance(&self, local: &Local<'_>) -> Option<Balance> {
        let n = local.forces.len();
        let pushing = local.pushing(&self.holding(self.q))?;
        let (rest, multipliers) = pushing.hold(&local.forces)?;
        let lengths = pushing.lengths();
        let pressed = multipliers.iter().zip(&lengths).map(|(m, l)| m.abs() * l);
        let total = length(&local.forces) + pressed.sum::<f64>();
        let basis = complement(pushing.rows(), n);
        let mut fastest = 0.0_f64;
        let mut changes = Vec::new();
        for along in &basis {
            let by = local.displaced(along);
            fastest = fastest.max(self.system.speed(&by));
            let change = local.reduced_force(&self.pull_along(&multipliers, &by));
            changes.push(if pushing.is_smooth() {
                change
            } else {
                pushing.hold(&change)?.0
            });
        }
        let of_forces = total * fastest / self.system.size();
        let (modes, is_stable, neutral) =
            modes(&basis, &changes, &rest, of_forces, pushing.is_smooth());
        Some(Balance {
            joints: local.joints.len(),
            modes,
            is_stable,
            multipliers,
            lengths,
            pushing,
            total,
            neutral,
        })
    }

    /// The velocity with which the balance is kept, while drives move; `None` if it is not stable.
    pub(super) fn follow(&self, local: &Local<'_>, held: Held) -> Option<Held> {
        let balance = self.balance(local).filter(|b| !b.is_lost())?;
        self.keeping(&balance, local, held)
    }

    /// As [`follow`](Self::follow), for a known balance.
    fn keeping(&self, balance: &Balance, local: &Local<'_>, held: Held) -> Option<Held> {
        let mut found = held;
        let stiff = || balance.modes.iter().filter(|m| balance.is_stiff(m));
        if stiff().next().is_some() {
            for mode in stiff() {
                let along = dot(&mode.along, &found.y);
                add_scaled(&mut found.y, -along, &mode.along);
            }
            let moves = local.rates(&found.y);
            let mut change = local.reduced_force(&self.pull_along(&balance.multipliers, &moves));
            if !balance.pushing.is_smooth() {
                change = balance.pushing.hold(&change)?.0;
            }
            for mode in stiff() {
                let far = dot(&mode.against, &change) / mode.stiffness;
                add_scaled(&mut found.y, far, &mode.along);
            }
            found.rates = local.rates(&found.y);
            found.fastest = found.fastest.max(self.system.speed(&found.rates));
            found.speed = found.speed.max(length(&found.y));
        }
        let slips = !self.released().is_empty();
        let speed = if found.speed > 0.0 { found.speed } else { 1.0 };
        let holding = self.holding(self.q);
        found.determined = holding.is_of_places() && found.rank + stiff().count() == found.y.len();
        for (k, push) in found.pushes.iter_mut().enumerate() {
            // A brake that slips withstands more than loads do.
            if balance.is_pressed(holding.bound(k)) && (!slips || push.abs() < FORCED * speed) {
                *push = balance.push(k) * speed;
            }
        }
        Some(found)
    }

    /// The bounds that carry the forces, as far as they can; `None` if parts cannot stand.
    fn carrying(&self, local: &Local<'_>, rows: &[Row]) -> Option<Vec<usize>> {
        let mut still = local.still();
        let released = self.released();
        still
            .joints
            .extend(released.iter().map(|row| (local.reduced(row).0, 0.0)));
        match still.nearest_with(rows, &self.kept()) {
            Nearest::Held { held, .. } => Some(held),
            Nearest::None { .. } => None,
        }
    }

    /// Bounds found by [`carrying`](Self::carrying); empty if parts cannot stand.
    pub(super) fn pressed(&self, local: &Local<'_>) -> Vec<Bound> {
        let carrying = self.carrying(local, &self.rows(self.q));
        let all = carrying.into_iter().flatten();
        all.map(|i| self.bounds[i]).collect()
    }

    /// Nearest velocity at which the touching bounds allow the balance to be kept; `None` if it cannot be kept, or
    /// there is no such velocity.
    pub(super) fn nearest(&self, local: &Local<'_>) -> Option<Nearest> {
        let rows = self.rows(self.q);
        let carrying = self.carrying(local, &rows)?;
        let bounds: Vec<Bound> = carrying.iter().map(|&i| self.bounds[i]).collect();
        let carried = Closed {
            bounds: &bounds,
            ..*self
        };
        let mut with = local.clone();
        with.free = carried.kept_by(local)?.y;
        Some(with.nearest_with(&rows, &carrying))
    }

    /// Velocity with which the holding bounds keep the balance; `None` if there is none.
    pub(super) fn kept_by(&self, local: &Local<'_>) -> Option<Held> {
        let balance = self.balance(local).filter(|b| !b.is_lost())?;
        if balance.distance(self.system, local) > IN_BALANCE * self.system.size() {
            return None;
        }
        let holding = Holding::of(self.system, self.pairs, self.bounds, self.q);
        self.keeping(&balance, local, local.held(&holding)?)
    }

    /// The forces of contacts, joints and drives, at rates of all coordinates.
    pub(super) fn forces(&self, local: &Local<'_>, rates: &[f64]) -> Option<Forces> {
        let balance = self.balance(local)?;
        let (joints, bounds) = balance.multipliers.split_at(balance.joints);
        let place = |bound: &Bound| {
            let at = bound.place(self.system, self.pairs, self.q);
            at.filter(|p| p.is_finite()).map(|p| [p.x, p.y])
        };
        let tangential = tangential(self.pairs, self.bounds, bounds);
        let contacts = self.bounds.iter().zip(bounds.iter().zip(tangential));
        let contacts = contacts.filter(|(b, _)| !b.is_brake());
        let pull = self.pull(&balance.multipliers, self.q);
        let drives = self.system.drives().iter();
        Some(Forces {
            contacts: contacts
                .map(|(bound, (&normal, tangential))| ContactForce {
                    what: named(self.system, self.pairs, bound),
                    at: place(bound),
                    normal: normal.max(0.0),
                    tangential,
                })
                .collect(),
            joints: joint_forces(self.system, self.q, joints),
            drives: drives
                .map(|(i, _)| drive_force(self.system, *i, -pull[*i], rates[*i]))
                .collect(),
        })
    }

    /// Indices of the brakes among the bounds.
    fn kept(&self) -> Vec<usize> {
        let all = 0..self.bounds.len();
        all.filter(|&i| self.bounds[i].is_brake()).collect()
    }

    /// Brakes that are not among the bounds: their parts are moved by drives. No load moves them all the same.
    fn released(&self) -> Vec<Row> {
        let all = brakes(self.system, self.q).into_iter();
        let rest = all.filter(|b| self.bounds.iter().all(|other| !b.is_same(other)));
        rest.map(|b| b.function(self.system, self.pairs, self.q))
            .collect()
    }
}

impl Balance {
    pub(super) fn is_stiff(&self, mode: &Mode) -> bool {
        mode.stiffness > self.neutral
    }

    /// Whether the forces do not balance, or not stably, or are not finite.
    pub(super) fn is_lost(&self) -> bool {
        !self.total.is_finite()
            || !self.is_stable
            || (self.modes.iter())
                .any(|mode| !self.is_stiff(mode) && mode.force.abs() > UNLOADED * self.total)
    }

    /// Whether the forces of bounds that stick are within their cones of friction.
    pub(super) fn is_within(&self, closed: &Closed<'_>) -> bool {
        let bounds = &self.multipliers[self.joints..];
        let sideways = tangential(closed.pairs, closed.bounds, bounds);
        let each = closed.bounds.iter().zip(bounds).zip(sideways);
        each.filter(|((bound, _), _)| grip(bound) == Grip::Sticks)
            .all(|((bound, normal), along)| {
                along.abs() <= friction(closed.pairs, bound) * normal + UNLOADED * self.total
            })
    }

    /// Displacement to the balance, in y: Newton's step.
    pub(super) fn step(&self, n: usize) -> Vec<f64> {
        let mut step = vec![0.0; n];
        for mode in self.modes.iter().filter(|m| self.is_stiff(m)) {
            add_scaled(&mut step, mode.force / mode.stiffness, &mode.along);
        }
        step
    }

    /// Distance to the balance.
    pub(super) fn distance(&self, system: &System, local: &Local<'_>) -> f64 {
        system.speed(&local.displaced(&self.step(local.forces.len())))
    }

    /// The force of a row as a share of all.
    fn push(&self, row: usize) -> f64 {
        let k = self.joints + row;
        self.multipliers[k] * self.lengths[k] / self.total
    }

    /// Whether a bound carries forces.
    fn is_pressed(&self, bound: usize) -> bool {
        self.total > 0.0 && self.push(bound).abs() > UNPRESSED
    }
}

/// An orthonormal basis of what rows leave of n dimensions.
fn complement(rows: &Rows, n: usize) -> Vec<Vec<f64>> {
    let mut all = rows.clone();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    while rows.rank() + basis.len() < n {
        let rest = (0..n).map(|i| {
            let mut unit = vec![0.0; n];
            unit[i] = 1.0;
            all.take_out(&mut unit);
            unit
        });
        let Some(mut longest) = rest.max_by(|a, b| length(a).total_cmp(&length(b))) else {
            break;
        };
        let long = length(&longest);
        longest.iter_mut().for_each(|x| *x /= long);
        all.push(&longest);
        basis.push(longest);
    }
    basis
}
