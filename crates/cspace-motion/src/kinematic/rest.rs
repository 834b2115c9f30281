//! Detection of rest for parts that move towards a balance of forces.

use crate::contact::{Path, Watch};
use crate::system::System;

use super::flow::{Flow, close};

/// Parts that go farther than this, relative to the size of the mechanism, are stopped by nothing.
const ENDLESS: f64 = 50.0;
/// Parts are at rest if they are slower than this share of the fastest before, or of what forces would give.
const REST: f64 = 1e-10;
/// A balance is looked for once they are slower than this share,
const SLOW: f64 = 0.5;
/// and taken if it is no farther than this, relative to the size of the mechanism.
const NEAR: f64 = 1e-2;

/// State of parts that move towards a balance.
#[derive(Debug)]
pub(super) struct Settling<'a> {
    /// System with forces that balance, and the time at which the drives stand.
    balanced: &'a System,
    time: f64,
    /// Speed that forces would give to unconstrained parts, and the largest speed so far.
    forced: f64,
    fastest: f64,
    /// Distance travelled by each coordinate.
    gone: Vec<f64>,
    rests: bool,
    /// Whether the parts have gone so far that nothing will stop them.
    endless: bool,
}

impl<'a> Settling<'a> {
    /// Starts to settle a system with balanced forces at a time; `forced` is the speed that forces would give to parts
    /// that nothing holds.
    pub(super) fn new(balanced: &'a System, time: f64, forced: f64) -> Self {
        Self {
            balanced,
            time,
            forced,
            fastest: 0.0,
            gone: vec![0.0; balanced.count()],
            rests: false,
            endless: false,
        }
    }

    /// Whether the parts are at rest.
    pub(super) fn rests(&self) -> bool {
        self.rests
    }

    /// Whether the settling has ended.
    pub(super) fn is_done(&self) -> bool {
        self.rests || self.endless
    }

    /// The part that has gone farthest: nothing stops it, if the parts are not at rest.
    pub(super) fn farthest(&self) -> Option<usize> {
        let parts = self.balanced.parts().iter().enumerate();
        let gone = parts.map(|(i, p)| (self.gone[p.indices()].iter().sum::<f64>(), i));
        gone.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
    }

    /// Whether the parts are at rest or go on for ever; at rest, `flow` is set to that configuration.
    pub(super) fn is_over(&mut self, flow: &mut Flow<'_>, from: &[f64]) -> bool {
        let system = flow.system;
        let speed = system.speed(&flow.velocity.rates);
        self.fastest = self.fastest.max(speed);
        let lengths = system.lengths();
        for (i, gone) in self.gone.iter_mut().enumerate() {
            *gone += (flow.q[i] - from[i]).abs() * lengths[i];
        }
        if self.gone.iter().any(|&gone| gone > ENDLESS * system.size()) {
            self.endless = true;
            return true;
        }
        if speed <= REST * self.fastest.max(self.forced) {
            self.rests = true;
        } else if speed < SLOW * self.fastest {
            let mut q = flow.q.clone();
            let room = NEAR * system.size();
            let balanced = self.balanced;
            if close(balanced, flow.pairs, &flow.held, self.time, &mut q, room).is_some() {
                let still = vec![0.0; q.len()];
                let path = Path::new((&flow.q, &still), (&q, &still), 1.0);
                let mut watch = Watch::new(system, flow.pairs);
                if watch.check(&flow.held, &path).is_none() {
                    flow.q = q;
                    self.rests = true;
                }
            }
        }
        self.rests
    }
}
