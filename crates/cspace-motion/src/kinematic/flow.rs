//! Motion with constant closed contacts: an ordinary differential equation on the configurations at which they are
//! closed.
//!
//! Each step uses Dormand and Prince's pair of orders 5 and 4; then the configuration is projected to where contacts
//! and joints hold, by the shortest displacement in the metric. Where these leave no freedom the configuration follows
//! from them alone, and the step is only a first guess.

use crate::contact::Bound;
use crate::dormand_prince::{DIFFERENCE, STAGES};
use crate::linear::add_scaled;
use crate::pairs::Pairs;
use crate::record::Forces;
use crate::system::{Law, System};

use super::balance::Closed;
use super::there::{CLOSED, There, closed};
use super::velocity::{Held, Local};

pub(crate) use super::there::close;

/// A step's error, relative to the size of the mechanism: that of a thousand steps is below a contact's tolerance.
const ERROR: f64 = 1e-13;
/// Largest correction of a configuration by joints and contacts, as a share of the step: a larger one would lead to
/// another solution.
const CORRECTION: f64 = 0.25;
/// Rounding of sums of slopes, as a share of the largest slope: a smaller difference is no error of the step.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// A motion with the same contacts closed, from a configuration on.
#[derive(Debug, Clone)]
pub(crate) struct Flow<'a> {
    pub(crate) system: &'a System,
    pub(crate) pairs: &'a Pairs,
    pub(crate) held: Vec<Bound>,
    pub(crate) time: f64,
    pub(crate) q: Vec<f64>,
    /// The velocity there.
    pub(crate) velocity: Held,
}

/// Configuration and velocity at the end of a step.
#[derive(Debug, Clone)]
pub(crate) struct Arrived {
    pub(crate) q: Vec<f64>,
    pub(crate) velocity: Held,
    /// The estimated error of the free coordinates, the largest, weighted as [`System::lengths`].
    pub(crate) error: f64,
}

impl Arrived {
    /// Error of the step as a multiple of the tolerance.
    pub(crate) fn excess(&self, system: &System) -> f64 {
        if self.velocity.determined {
            0.0
        } else {
            self.error / (ERROR * system.size())
        }
    }
}

impl<'a> Flow<'a> {
    /// Starts at a configuration, which is projected to where contacts and joints hold; `None` if they cannot hold.
    pub(crate) fn new(
        system: &'a System,
        pairs: &'a Pairs,
        held: Vec<Bound>,
        time: f64,
        q: &[f64],
    ) -> Option<Self> {
        let mut q = q.to_vec();
        let room = 1e-3 * system.size();
        let there = closed(system, pairs, &held, time, &mut q, room)?;
        let velocity = there.velocity(system, pairs, &held, time, &q)?;
        Some(Self {
            system,
            pairs,
            held,
            time,
            q,
            velocity,
        })
    }

    /// The forces at a configuration of the motion; none where nothing acts.
    pub(super) fn forces(&self, time: f64, at: &Arrived) -> Option<Forces> {
        if self.system.law() != Law::Balance {
            return None;
        }
        let closed = Closed {
            system: self.system,
            pairs: self.pairs,
            bounds: &self.held,
            q: &at.q,
        };
        let local = Local::at(self.system, &at.q, time)?;
        closed.forces(&local, &at.velocity.rates)
    }

    /// A configuration near the motion a while later, brought to where contacts and joints hold.
    pub(crate) fn brought(&self, h: f64, mut q: Vec<f64>) -> Option<Arrived> {
        let there = self.bring(h, &mut q)?;
        let time = self.time + h;
        let velocity = there.velocity(self.system, self.pairs, &self.held, time, &q)?;
        let error = 0.0;
        Some(Arrived { q, velocity, error })
    }

    /// A configuration a while later as it is, with the velocity there.
    pub(super) fn moving(&self, h: f64, q: Vec<f64>) -> Option<Arrived> {
        let there = There::at(self.system, self.pairs, &self.held, &q);
        let time = self.time + h;
        let velocity = there.velocity(self.system, self.pairs, &self.held, time, &q)?;
        let error = 0.0;
        Some(Arrived { q, velocity, error })
    }

    /// As `brought`, without the velocity.
    pub(crate) fn placed(&self, h: f64, mut q: Vec<f64>) -> Option<Vec<f64>> {
        self.bring(h, &mut q)?;
        Some(q)
    }

    fn bring(&self, h: f64, q: &mut [f64]) -> Option<There<'a>> {
        let room = CORRECTION * self.system.moved(&self.q, q) + CLOSED * self.system.size();
        closed(self.system, self.pairs, &self.held, self.time + h, q, room)
    }

    /// A while later, where contacts and joints leave no freedom: the rates in the middle lead near enough.
    fn led(&self, h: f64) -> Option<Arrived> {
        if !self.velocity.determined {
            return None;
        }
        let along = |share: f64, rates: &[f64]| {
            let mut q = self.q.clone();
            add_scaled(&mut q, share * h, rates);
            self.system.drive(self.time + share * h, &mut q);
            q
        };
        let middle = self.moving(0.5 * h, along(0.5, &self.velocity.rates))?;
        let arrived = self.brought(h, along(1.0, &middle.velocity.rates))?;
        arrived.velocity.determined.then_some(arrived)
    }

    /// A while later; `None` if the contacts and joints cannot hold until then.
    pub(crate) fn after(&self, h: f64) -> Option<Arrived> {
        if h == 0.0 {
            return Some(Arrived {
                q: self.q.clone(),
                velocity: self.velocity.clone(),
                error: 0.0,
            });
        }
        if let Some(arrived) = self.led(h) {
            return Some(arrived);
        }
        let mut slopes = vec![self.velocity.rates.clone()];
        let mut q = self.q.clone();
        for (share, weights) in STAGES {
            q.copy_from_slice(&self.q);
            for (weight, slope) in weights.iter().zip(&slopes) {
                add_scaled(&mut q, h * weight, slope);
            }
            let time = self.time + share * h;
            self.system.drive(time, &mut q);
            let there = There::at(self.system, self.pairs, &self.held, &q);
            let velocity = there.velocity(self.system, self.pairs, &self.held, time, &q)?;
            slopes.push(velocity.rates);
        }
        let mut error = 0.0_f64;
        let lengths = self.system.lengths();
        for &i in self.system.free() {
            let difference: f64 = (DIFFERENCE.iter().zip(&slopes))
                .map(|(d, slope)| d * slope[i])
                .sum();
            let fastest = slopes
                .iter()
                .fold(0.0_f64, |m, slope| m.max(slope[i].abs()));
            let beyond = difference.abs() - ROUNDING * fastest;
            error = error.max(h * beyond * lengths[i]);
        }
        let arrived = self.brought(h, q)?;
        Some(Arrived { error, ..arrived })
    }
}
