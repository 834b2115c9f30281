//! Jumps at the end of a balance of forces: the parts go at once to the next balance, with drives at rest.
//!
//! The parts move as in heavy oil, M v = s F: a lost balance is left in the direction of the instability, and contacts
//! on the path are met as in any motion. The factor s does not matter. Close to a balance, Newton's step leads there.

use crate::contact::{Bound, Path, Watch, brakes, touching};
use crate::linear::dot;
use crate::pairs::{Grip, Pairs};
use crate::record::{Event, EventKind, Record, Status, What};
use crate::system::{Law, System};

use super::balance::Closed;
use super::flow::Flow;
use super::holding::friction;
use super::rest::Settling;
use super::run::{Run, State, Stop, moment};
use super::there::close;
use super::velocity::Local;

/// Time limit for settling, in units of the time in which the forces at the beginning would move the parts by the
/// mechanism's size.
const DURATION: f64 = 1e6;
/// Factors by which a motion is sped up if it is much slower than forces at the beginning would make it, as where
/// friction nearly holds.
const RUSHES: [f64; 3] = [1.0, 1e5, 1e10];
/// Displacement of drives before a second attempt, relative to the size of the mechanism. Where a balance ends, forces
/// may balance to rounding, as at the edge of a cone of friction.
const LATER: f64 = 1e-8;
/// Displacements of parts that balance on an edge, relative to the size of the mechanism, in the order in which they
/// are tried: the nearer to the edge, the more slowly it is left.
const NUDGES: [f64; 4] = [1e-4, 1e-5, 1e-6, 1e-3];
/// Displacements count as equal if they differ by no more than this share.
const ALIKE: f64 = 1e-6;
/// Displacement below which a part counts as not moved, relative to the size of the mechanism.
const STANDS: f64 = 1e-9;

/// Result of the motion of parts that were out of balance.
enum Settled {
    /// The parts have come to another configuration.
    At(Vec<f64>),
    /// The parts have not moved.
    Stands,
    /// The parts are still moving.
    Slow,
    /// The parts reach no balance, for this reason.
    Lost(String),
}

/// Follows the motion from a configuration, from one time to another.
pub(crate) fn run(
    system: &System,
    pairs: &Pairs,
    q: Vec<f64>,
    times: [f64; 2],
    every: f64,
    progress: &dyn Fn(f64) -> bool,
) -> Record {
    let mut run = Run::new(system, pairs, times, every);
    let mut state = State::new(times[0], q);
    loop {
        let Some(stop) = run.go(&mut state, progress) else {
            return run.stopped_short(state);
        };
        if system.law() == Law::Balance && !matches!(stop, Stop::Over) {
            let Some(settled) = run.settle(state.time, &state.q, progress) else {
                return run.stopped_short(state);
            };
            match settled {
                Settled::At(q) => {
                    if state.moved(q) {
                        continue;
                    }
                }
                Settled::Lost(reason) => {
                    run.end(state.time, &state.q, Status::Undetermined, Some(reason));
                    return run.record;
                }
                Settled::Stands | Settled::Slow => {}
            }
        }
        return run.stopped(state, stop);
    }
}

impl<'a> Run<'a> {
    /// Moves parts that are out of balance to the next balance, at a time, and records the jump.
    fn settle(&mut self, time: f64, q: &[f64], progress: &dyn Fn(f64) -> bool) -> Option<Settled> {
        let Some(local) = Local::at(self.system, q, time) else {
            return Some(Settled::Stands);
        };
        let speed = self.system.speed(&local.displaced(&local.forces));
        let scale = match speed {
            s if s > 0.0 => (self.system.size() / s).log2().round().exp2(),
            _ => 1.0,
        };
        let driven: f64 = (self.system.drives().iter())
            .map(|(i, _)| (local.rates(&local.free)[*i] * self.system.lengths()[*i]).abs())
            .fold(0.0, f64::max);
        let mut later = time + LATER * self.system.size() / driven;
        if !later.is_finite() || later > self.duration {
            later = time;
        }
        // First as it is; then with drives a little farther.
        let first = core::iter::once((RUSHES[0], time));
        let rest = RUSHES.iter().map(|&rush| (rush, later));
        for (rush, at) in first.chain(rest.filter(|r| *r != (RUSHES[0], time))) {
            let scale = rush * scale;
            let steady = self.system.settling(at, scale);
            let mut begin = q.to_vec();
            if at > time {
                // Touching parts are moved along: with all contacts closed, or all but one.
                let room = 1e2 * LATER * self.system.size();
                let moved = all_but_one(&touching(self.system, self.pairs, q)).find_map(|held| {
                    let mut q = q.to_vec();
                    close(&steady, self.pairs, &held, at, &mut q, room).map(|()| q)
                });
                let Some(moved) = moved else { continue };
                begin = moved;
            }
            let starts = core::iter::once(begin.clone()).chain(self.nudged(&steady, at, &begin));
            let mut slow = false;
            for start in starts {
                let last = rush == RUSHES[RUSHES.len() - 1];
                match self.settled(&steady, [time, at], start, (scale * speed, last), progress)? {
                    Settled::At(end)
                        if self.system.moved(&begin, &end) <= STANDS * self.system.size() => {}
                    Settled::Slow => slow = true,
                    other => return Some(other),
                }
                if slow {
                    break;
                }
            }
            if !slow && at >= later {
                break;
            }
        }
        Some(Settled::Stands)
    }

    fn settled(
        &mut self,
        steady: &System,
        [time, at]: [f64; 2],
        start: Vec<f64>,
        (forced, last): (f64, bool),
        progress: &dyn Fn(f64) -> bool,
    ) -> Option<Settled> {
        let mut run = Run::new(steady, self.pairs, [0.0, DURATION], f64::INFINITY);
        run.told = self.told.clone();
        run.settling = Some(Settling::new(self.system, at, forced));
        let begun = start.clone();
        let mut state = State::new(0.0, start);
        let Some(stop) = run.go(&mut state, &|_| progress(time / self.duration)) else {
            // As far as they have come.
            let (_, q) = run.interrupted.unwrap_or((0.0, state.q));
            self.interrupted = Some((time, q));
            return None;
        };
        // A creeping motion is followed faster.
        if run.gave_up.is_some() && !last {
            return Some(Settled::Slow);
        }
        let is_over = matches!(stop, Stop::Over);
        let over = run.settling.take();
        let told = core::mem::take(&mut run.told);
        let end = state.q.clone();
        let name = |i: usize| self.system.mechanism().parts[i].part.name();
        if is_over && !over.as_ref().is_some_and(Settling::is_done) {
            return Some(Settled::Slow);
        }
        if is_over && !over.as_ref().is_some_and(Settling::rests) {
            let part = over.and_then(|o| o.farthest()).map_or("", name);
            return Some(Settled::Lost(format!(
                "nothing stops {part}, which loads, springs or its weight push: add what it comes to rest on, or a range of its motion"
            )));
        }
        let record = run.stopped(state, stop);
        if !is_over {
            let reason = record.reason.unwrap_or_default();
            return Some(Settled::Lost(format!(
                "on the way to where forces balance: {reason}"
            )));
        }
        if self.system.moved(&begun, &end) > STANDS * self.system.size() {
            self.told = told;
            let parts = self.system.parts().iter().enumerate();
            let moved = |p: core::ops::Range<usize>| {
                let each = p.map(|i| (end[i] - begun[i]).abs() * self.system.lengths()[i]);
                each.fold(0.0, f64::max)
            };
            let ways: Vec<(f64, &str)> =
                parts.map(|(i, p)| (moved(p.indices()), name(i))).collect();
            let most = ways.iter().fold(0.0_f64, |m, w| m.max(w.0));
            // Among parts that go equally far, the first by name.
            let farthest = ways.iter().filter(|w| w.0 >= most * (1.0 - ALIKE));
            let part = farthest.map(|w| w.1).min().unwrap_or("").to_owned();
            self.record
                .events
                .push(Event::new(time, EventKind::Snap, What::Part { part }, None));
            let now = |e: Event| Event { t: time, ..e };
            self.record
                .events
                .extend(record.events.into_iter().map(now));
            // The path of the jump; its end is traced when the motion goes on.
            let still = vec![0.0; begun.len()];
            let way = record.trace.into_iter().map(|at| at.coordinates);
            let way = core::iter::once(begun).chain(way);
            let told = way.map(|q| moment(time, &q, still.clone()));
            self.record.trace.extend(told);
        }
        Some(Settled::At(end))
    }

    /// Configurations beside one at which the forces balance on an edge and from which they lead away: with all
    /// touching contacts closed, or all but one, where a contact passes from one feature to the next.
    fn nudged(&self, steady: &System, time: f64, q: &[f64]) -> Vec<Vec<f64>> {
        let Some(local) = Local::at(self.system, q, time) else {
            return Vec::new();
        };
        // What friction holds on an edge does not slide off, but may roll off.
        let sticks = |bound: Bound| match bound {
            Bound::Contact(touch) if friction(self.pairs, &bound) > 0.0 => {
                Bound::Contact(touch.with(Grip::Sticks))
            }
            bound => bound,
        };
        let bounds = touching(self.system, self.pairs, q).into_iter();
        let bounds: Vec<Bound> = bounds.map(sticks).collect();
        let brakes = brakes(self.system, q);
        let sets = all_but_one(&bounds).map(|set| [set, brakes.clone()].concat());
        sets.filter_map(|set| self.nudge(steady, &local, time, q, &set))
            .collect()
    }

    fn nudge(
        &self,
        steady: &System,
        local: &Local<'_>,
        time: f64,
        q: &[f64],
        bounds: &[Bound],
    ) -> Option<Vec<f64>> {
        let (system, pairs) = (self.system, self.pairs);
        let touching = Closed {
            system,
            pairs,
            bounds,
            q,
        };
        let held = touching.pressed(local);
        let closed = Closed {
            bounds: &held,
            ..touching
        };
        let balance = closed.balance(local).filter(|b| b.is_within(&closed))?;
        let modes = balance.modes;
        let softest = modes
            .iter()
            .min_by(|a, b| a.stiffness.total_cmp(&b.stiffness))?;
        let by = local.displaced(&softest.along);
        let (speed, lengths) = (system.speed(&by), system.lengths());
        let rate = |i: usize| self.rates.get(i).copied().unwrap_or(0.0);
        let onward: f64 = (0..q.len()).map(|i| by[i] * rate(i) * lengths[i]).sum();
        let first = if onward < 0.0 { -1.0 } else { 1.0 };
        let sides = NUDGES
            .iter()
            .flat_map(|share| [first, -first].map(|side| side * share));
        sides.into_iter().find_map(|share| {
            let far = share * system.size() / speed;
            let beside: Vec<f64> = q.iter().zip(&by).map(|(q, b)| q + far * b).collect();
            let flow = Flow::new(steady, pairs, held.clone(), time, &beside)?;
            let still = vec![0.0; q.len()];
            let path = Path::new((q, &still), (&flow.q, &still), 1.0);
            let leads = share * dot(&by, &flow.velocity.rates) > 0.0;
            let is_free = Watch::new(system, pairs).check(&held, &path).is_none();
            (leads && is_free).then_some(flow.q)
        })
    }
}

/// All bounds, then all but one each.
fn all_but_one(bounds: &[Bound]) -> impl Iterator<Item = Vec<Bound>> {
    let without = (0..bounds.len()).map(|left_out| {
        let rest = bounds.iter().enumerate().filter(|(i, _)| *i != left_out);
        rest.map(|(_, b)| *b).collect()
    });
    core::iter::once(bounds.to_vec()).chain(without)
}
