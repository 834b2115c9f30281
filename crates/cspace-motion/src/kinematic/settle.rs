//! Where a balance of forces ends: the parts go at once to the next one, with drives that stand.
//!
//! They go as they would in heavy oil, M v = s F: a balance that is lost is left in the direction in which it is lost, and what is met on
//! the way is met as in any motion. The factor s is of no consequence. Once the way to a balance is short, Newton's step leads there.

use crate::contact::{Bound, Path, Watch, touching};
use crate::linear::dot;
use crate::record::{Event, EventKind, Status, What};
use crate::system::System;

use super::balance::Closed;
use super::choose::pressing;
use super::flow::{Flow, close};
use super::run::{Run, at};
use super::velocity::Local;

/// How long parts take to settle, in units of the time in which the forces at the beginning would move them by the mechanism's size.
const DURATION: f64 = 1e6;
/// Parts that go farther than this, relative to the size of the mechanism, are stopped by nothing.
const ENDLESS: f64 = 50.0;
/// Parts are at rest if they are slower than this share of the fastest before.
const REST: f64 = 1e-10;
/// A balance is looked for once they are slower than this share,
const SLOW: f64 = 0.5;
/// and taken if it is no farther than this, relative to the size of the mechanism.
const NEAR: f64 = 1e-2;
/// Who stands on an edge is pushed by this, relative to the size of the mechanism, the first that leads on: an edge is left the more slowly the nearer.
const NUDGES: [f64; 4] = [1e-4, 1e-5, 1e-6, 1e-3];
/// Parts go equally far if ways differ by no more than this share.
const ALIKE: f64 = 1e-6;
/// What moves by no more than this, relative to the size of the mechanism, has not moved.
const STANDS: f64 = 1e-9;

/// Parts on their way to a balance.
#[derive(Debug)]
pub(super) struct Settling<'a> {
    /// The system with forces that balance, and the time at which the drives stand.
    balanced: &'a System,
    time: f64,
    fastest: f64,
    /// How far each coordinate has gone.
    gone: Vec<f64>,
    rests: bool,
    /// A part that nothing stops.
    endless: Option<usize>,
}

/// What became of parts that were out of balance.
pub(super) enum Settled {
    /// They have come to another place.
    At(Vec<f64>),
    /// They have not moved.
    Stands,
    /// Nothing stops this part.
    Endless(usize),
    /// It cannot be told, for this reason; or no more is wanted.
    Lost(Option<String>),
}

impl Settling<'_> {
    /// Whether the way is at its end.
    pub(super) fn is_done(&self) -> bool {
        self.rests || self.endless.is_some()
    }

    /// The part that has gone farthest.
    fn farthest(&self) -> Option<usize> {
        let parts = self.balanced.parts().iter().enumerate();
        let gone = parts.map(|(i, p)| (self.gone[p.indices()].iter().sum::<f64>(), i));
        gone.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, i)| i)
    }

    /// Whether the parts are at rest, or go on for ever; `flow` comes to where they are at rest.
    pub(super) fn is_over(&mut self, flow: &mut Flow<'_>, from: &[f64]) -> bool {
        let system = flow.system;
        let speed = system.speed(&flow.velocity.rates);
        self.fastest = self.fastest.max(speed);
        let lengths = system.lengths();
        for (i, gone) in self.gone.iter_mut().enumerate() {
            *gone += (flow.q[i] - from[i]).abs() * lengths[i];
        }
        if self.gone.iter().any(|&gone| gone > ENDLESS * system.size()) {
            self.endless = self.farthest();
            return true;
        }
        if speed <= REST * self.fastest {
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

impl<'a> Run<'a> {
    /// Lets parts that are out of balance go to the next one, at a time, and tells of it.
    pub(super) fn settle(
        &mut self,
        time: f64,
        q: &[f64],
        progress: &dyn Fn(f64) -> bool,
    ) -> Settled {
        let Some(local) = Local::at(self.system, q, time) else {
            return Settled::Lost(None);
        };
        let speed = self.system.speed(&local.displaced(&local.forces));
        let scale = match speed {
            s if s > 0.0 => (self.system.size() / s).log2().round().exp2(),
            _ => 1.0,
        };
        let steady = self.system.settling(time, scale);
        let starts = core::iter::once(q.to_vec()).chain(self.nudged(&steady, time, q));
        for start in starts {
            match self.settled(&steady, time, start, progress) {
                Settled::At(end) if self.system.moved(q, &end) <= STANDS * self.system.size() => {}
                other => return other,
            }
        }
        Settled::Stands
    }

    fn settled(
        &mut self,
        steady: &System,
        time: f64,
        start: Vec<f64>,
        progress: &dyn Fn(f64) -> bool,
    ) -> Settled {
        let mut run = Run::new(steady, self.pairs, DURATION, f64::INFINITY);
        run.told = self.told.clone();
        run.settling = Some(Settling {
            balanced: self.system,
            time,
            fastest: 0.0,
            gone: vec![0.0; start.len()],
            rests: false,
            endless: None,
        });
        let begun = start.clone();
        let Some(record) = run.go(start, &|_| progress(time / self.duration)) else {
            return Settled::Lost(None);
        };
        let Some(over) = run.settling.take() else {
            return Settled::Lost(None);
        };
        let end = match (record.status, record.samples.last()) {
            (Status::Done, Some(last)) if over.rests => last.coordinates.clone(),
            (Status::Done, _) => {
                return match over.endless.or(over.farthest()) {
                    Some(part) => Settled::Endless(part),
                    None => Settled::Lost(None),
                };
            }
            _ => return Settled::Lost(record.reason),
        };
        if self.system.moved(&begun, &end) > STANDS * self.system.size() {
            self.told = run.told;
            let parts = self.system.parts().iter().enumerate();
            let moved = |p: core::ops::Range<usize>| {
                let each = p.map(|i| (end[i] - begun[i]).abs() * self.system.lengths()[i]);
                each.fold(0.0, f64::max)
            };
            let name = |i: usize| self.system.mechanism().parts[i].part.name();
            let ways: Vec<(f64, &str)> =
                parts.map(|(i, p)| (moved(p.indices()), name(i))).collect();
            let most = ways.iter().fold(0.0_f64, |m, w| m.max(w.0));
            // Of those that go as far, the first by name.
            let farthest = ways.iter().filter(|w| w.0 >= most * (1.0 - ALIKE));
            let part = farthest.map(|w| w.1).min().unwrap_or("").to_owned();
            self.record.events.push(Event {
                t: time,
                kind: EventKind::Snap,
                what: What::Part { part },
                at: None,
            });
            let now = |e: Event| Event { t: time, ..e };
            self.record
                .events
                .extend(record.events.into_iter().map(now));
            // Where they were; where they are is told once it goes on.
            self.record.trace.push(at(time, begun));
        }
        Settled::At(end)
    }

    /// Places beside one at which the forces balance on an edge, from which they lead away.
    fn nudged(&self, steady: &System, time: f64, q: &[f64]) -> Vec<Vec<f64>> {
        let (system, pairs) = (self.system, self.pairs);
        let bounds = touching(system, pairs, q);
        let Some(local) = Local::at(system, q, time) else {
            return Vec::new();
        };
        let held: Vec<Bound> = pressing(&local, system, pairs, &bounds, q);
        let closed = Closed {
            system,
            pairs,
            bounds: &held,
            q,
        };
        let modes = closed.balance(&local).modes;
        let softest = modes
            .iter()
            .min_by(|a, b| a.stiffness.total_cmp(&b.stiffness));
        let Some(softest) = softest else {
            return Vec::new();
        };
        let by = local.displaced(&softest.along);
        let speed = system.speed(&by);
        let lengths = system.lengths();
        let onward: f64 = (0..q.len())
            .map(|i| by[i] * self.rates.get(i).unwrap_or(&0.0) * lengths[i])
            .sum();
        let first = if onward < 0.0 { -1.0 } else { 1.0 };
        let mut places = Vec::new();
        for share in NUDGES {
            for side in [first, -first] {
                let far = side * share * system.size() / speed;
                let beside: Vec<f64> = q.iter().zip(&by).map(|(q, b)| q + far * b).collect();
                let Some(flow) = Flow::new(steady, pairs, held.clone(), time, &beside) else {
                    continue;
                };
                let still = vec![0.0; q.len()];
                let path = Path::new((q, &still), (&flow.q, &still), 1.0);
                let leads = side * dot(&by, &flow.velocity.rates) > 0.0;
                if leads && Watch::new(system, pairs).check(&held, &path).is_none() {
                    places.push(flow.q);
                    return places;
                }
            }
        }
        places
    }
}
