//! Simulation from event to event.

use crate::contact::{Bound, LONGEST, Watch, pinched, touching};
use crate::pairs::Pairs;
use crate::record::{MOST_TRACED, Record, Sample, Status};
use crate::system::System;

use super::check::{goes_on, step};
use super::choose::{Choice, choose, wedged};
use super::events::Told;
use super::flow::{Arrived, Flow};
use super::locate::{add, first_event};
use super::rest::Settling;
use super::there::CLOSED;

/// Factor by which a step that diverges is shortened.
const DIVERGED: f64 = 0.2;
/// Largest number of steps of even length to the next stop; if there would be more, longer steps are taken where
/// nothing is near.
const HURRIES: f64 = 1e4;
/// Number of steps after which it is checked whether an obstacle is still near.
const ASK_AGAIN: usize = 64;
/// Largest number of successive steps so short that [`MOST_STEPS`] of them would not reach the next stop.
const MOST_HURRIED: usize = 50_000;
/// Shortest step, relative to the time so far and to come.
const SHORTEST: f64 = 1e-15;
/// Largest number of successive events without progress in time.
const MOST_IDLE: usize = 64;
/// A step ends no farther from where its rates lead than this share of its way.
const STRAYS: f64 = 0.05;
/// Smallest progress, as a share of the duration.
const PROGRESS: f64 = 1e-12;
/// Steps of a simulation, some minutes.
const MOST_STEPS: usize = 10_000_000;
/// Steps whose error is small enough only if they are shorter than this, relative to the duration, do not come to an end in
/// half a minute: forces are too stiff for them.
const STIFF: f64 = 1e-6;
/// Displacement below which such a step counts as crawling, relative to the size of the mechanism.
const CRAWLS: f64 = 1e-6;
/// Largest number of successive crawling steps.
const MOST_CRAWLED: usize = 1000;

const TOO_STIFF: &str = "springs, loads or dampers are too stiff for their parts to be followed; make them softer, or the damping larger";
const TOO_FAST: &str = "parts move too fast to be followed; make drives slower or forces weaker, or ask for a shorter time";

/// State of a running simulation.
pub(super) struct Run<'a> {
    pub(super) system: &'a System,
    pub(super) pairs: &'a Pairs,
    pub(super) duration: f64,
    samples: Samples,
    /// Times at which drives are not smooth, and the end; the next first.
    stops: Vec<f64>,
    pub(super) record: Record,
    pub(super) told: Told,
    /// Why the motion cannot be followed, if that has nothing to do with contacts.
    pub(super) gave_up: Option<&'static str>,
    /// The rates of all coordinates at the last step.
    pub(super) rates: Vec<f64>,
    /// State of the parts if they move towards a balance of forces.
    pub(super) settling: Option<Settling<'a>>,
    /// Time and configuration at which the user interrupted the simulation.
    pub(super) interrupted: Option<(f64, Vec<f64>)>,
}

/// The times of samples.
struct Samples {
    every: f64,
    next: usize,
}

impl Samples {
    /// The next that is not before a time.
    fn after(time: f64, every: f64) -> Self {
        let next = (time / every).ceil() as usize;
        Self { every, next }
    }

    fn time(&self) -> f64 {
        self.next as f64 * self.every
    }
}

/// Current state of a simulation.
pub(super) struct State {
    pub(super) time: f64,
    pub(super) q: Vec<f64>,
    /// Bounds that were closed on the path to `q`.
    before: Vec<Bound>,
    /// Events in a row without progress in time, and since when.
    idle: usize,
    /// Moves to another place in a row without such progress.
    moves: usize,
    idle_since: f64,
    steps: usize,
}

/// Why it does not go on.
pub(super) enum Stop {
    /// The simulation has reached its end.
    Over,
    /// No velocity is allowed: the forbidding bounds, each with its multiplier.
    Jammed(Vec<(Bound, f64)>),
    /// No allowed velocity leads to a further configuration, with these bounds.
    Undetermined(Vec<Bound>),
}

impl State {
    pub(super) fn new(time: f64, q: Vec<f64>) -> Self {
        Self {
            time,
            q,
            before: Vec::new(),
            idle: 0,
            moves: 0,
            idle_since: time,
            steps: 0,
        }
    }

    /// Continues at another configuration at the same time; returns whether this has not happened too often.
    pub(super) fn moved(&mut self, q: Vec<f64>) -> bool {
        self.q = q;
        self.before.clear();
        self.idle = 0;
        self.moves += 1;
        self.moves <= MOST_IDLE
    }
}

impl<'a> Run<'a> {
    /// Creates a simulation from one time to another.
    pub(super) fn new(
        system: &'a System,
        pairs: &'a Pairs,
        [from, duration]: [f64; 2],
        every: f64,
    ) -> Self {
        let mut stops: Vec<f64> = (system.drives().iter())
            .flat_map(|(_, curve)| curve.corners())
            .filter(|&t| t > from && t < duration)
            .chain([duration])
            .collect();
        stops.sort_by(|a, b| b.total_cmp(a));
        stops.dedup();
        Self {
            system,
            pairs,
            duration,
            samples: Samples::after(from, every),
            stops,
            record: Record {
                status: Status::Done,
                until: 0.0,
                reason: None,
                obstacles: Vec::new(),
                samples: Vec::new(),
                events: Vec::new(),
                trace: Vec::new(),
                energy: None,
                open: 0.0,
            },
            told: Told::default(),
            gave_up: None,
            rates: Vec::new(),
            settling: None,
            interrupted: None,
        }
    }

    /// Runs until the simulation stops, and returns the reason; `None` if the user interrupts it.
    pub(super) fn go(&mut self, state: &mut State, progress: &dyn Fn(f64) -> bool) -> Option<Stop> {
        while state.time < self.duration && !self.is_settled() {
            let (time, q) = (state.time, &state.q);
            if !progress(time / self.duration) {
                self.interrupted = Some((time, q.clone()));
                return None;
            }
            let mut bounds = touching(self.system, self.pairs, q);
            add(&mut bounds, core::mem::take(&mut state.before));
            let left = self.duration - time;
            let (system, pairs) = (self.system, self.pairs);
            let chosen = |bounds: &[Bound]| choose(system, pairs, bounds, time, q, left);
            let mut choice = chosen(&bounds);
            if let Choice::Undetermined = choice {
                add(&mut bounds, pinched(system, pairs, q));
                choice = chosen(&bounds);
            }
            let (mut flow, next) = match choice {
                Choice::On { flow, next } => (flow, next),
                Choice::Jammed(obstacles) => return Some(Stop::Jammed(obstacles)),
                Choice::Undetermined => return Some(Stop::Undetermined(bounds)),
            };
            let events = self.told.update(self.pairs, &bounds, &flow, &next);
            self.record.events.extend(events);
            self.trace_instant(&flow, q);
            if let Some(settling) = &mut self.settling {
                let from = flow.q.clone();
                if settling.is_over(&mut flow, &from) {
                    state.q = flow.q;
                    return Some(Stop::Over);
                }
            }
            (state.time, state.q, state.before) = self.follow(flow, &mut state.steps, progress)?;
            if state.time > state.idle_since + PROGRESS * self.duration {
                (state.idle, state.moves, state.idle_since) = (0, 0, state.time);
            } else {
                state.idle += 1;
            }
            if self.gave_up.is_some() || state.idle > MOST_IDLE {
                let bounds = touching(system, pairs, &state.q);
                let wedged = match self.gave_up {
                    None => wedged(system, pairs, &bounds, state.time, &state.q),
                    Some(_) => None,
                };
                return Some(match wedged {
                    Some(obstacles) => Stop::Jammed(obstacles),
                    None => Stop::Undetermined(bounds),
                });
            }
        }
        Some(Stop::Over)
    }

    fn is_settled(&self) -> bool {
        self.settling.as_ref().is_some_and(Settling::is_done)
    }

    /// Follows the motion with the same contacts until the next event; returns its time and configuration, and the
    /// touching bounds. `None` if the user interrupts the simulation.
    fn follow(
        &mut self,
        mut flow: Flow<'a>,
        steps: &mut usize,
        progress: &dyn Fn(f64) -> bool,
    ) -> Option<(f64, Vec<f64>, Vec<Bound>)> {
        let mut watch = Watch::new(self.system, self.pairs);
        let mut longest = f64::INFINITY;
        let (mut crawled, mut hurried, mut near) = (0, 0, 0_usize);
        loop {
            *steps += 1;
            if !progress(flow.time / self.duration) {
                self.interrupted = Some((flow.time, flow.q));
                return None;
            }
            while self.stops.last().is_some_and(|&s| s <= flow.time) {
                self.stops.pop();
            }
            let Some(&stop) = self.stops.last() else {
                return Some((flow.time, flow.q, flow.held));
            };
            let left = stop - flow.time;
            let size = self.system.size();
            let mut reach = vec![LONGEST * size; flow.q.len()];
            let mut even = LONGEST * size / self.system.speed(&flow.velocity.rates);
            near = near.saturating_sub(1);
            if left > HURRIES * even && near == 0 {
                let freedom = watch.freedom(&flow.q);
                for (reach, free) in reach.iter_mut().zip(freedom) {
                    *reach = reach.max(free);
                }
                let speeds = flow.velocity.rates.iter().zip(self.system.lengths());
                let times = speeds.zip(&reach).map(|((v, l), r)| r / (v * l).abs());
                let longer = times.fold(f64::INFINITY, f64::min);
                near = if longer > even { 0 } else { ASK_AGAIN };
                even = longer;
            }
            let mut h = left.min(even).min(longest);
            let drives = self.system.drives().iter();
            let driven = drives
                .map(|(i, _)| (flow.velocity.rates[*i] * self.system.lengths()[*i]).abs())
                .fold(0.0, f64::max);
            let many = left * driven > MOST_STEPS as f64 * LONGEST * size;
            if many || flow.time + h <= flow.time || *steps > MOST_STEPS {
                self.gave_up = Some(TOO_FAST);
                return Some((flow.time, flow.q, flow.held));
            }
            let shortest = SHORTEST * stop;
            // As long as it may be.
            let arrived = loop {
                let arrived = flow.after(h);
                let too_long = match &arrived {
                    Some(to) => self.too_long(&flow, h, to, &reach),
                    // Where contacts lead, they come to an end there; what is free only went too far.
                    None => (!flow.velocity.determined).then_some(DIVERGED),
                };
                match too_long {
                    Some(factor) if h * factor > shortest => h *= factor,
                    // A motion that cannot be followed at all has no further step.
                    Some(_) => break None,
                    None => break arrived,
                }
            };
            let arrived = arrived.filter(|to| goes_on(&mut watch, &flow, h, to));
            let Some(to) = arrived else {
                let stop = first_event(&flow, h, &mut watch);
                let time = flow.time + stop.after;
                if let Some(before) = flow.after(stop.after) {
                    self.rates = before.velocity.rates;
                }
                self.sample(&flow, time);
                return Some((time, stop.q, stop.bounds));
            };
            let hurries = h * (MOST_STEPS as f64) < left;
            hurried = if hurries { hurried + 1 } else { 0 };
            if hurried > MOST_HURRIED {
                self.gave_up = Some(if longest < even { TOO_STIFF } else { TOO_FAST });
                return Some((flow.time, flow.q, flow.held));
            }
            if !to.velocity.determined {
                let share = to.excess(self.system).powf(-0.2).clamp(0.2, 4.0);
                longest = 0.9 * h * share;
                // Near a dead point steps are short, too, but there are few of them.
                let crawls = self.system.moved(&flow.q, &to.q) < CRAWLS * size;
                crawled = if longest < STIFF * self.duration && crawls {
                    crawled + 1
                } else {
                    0
                };
                if crawled > MOST_CRAWLED {
                    self.gave_up = Some(TOO_STIFF);
                    return Some((flow.time, flow.q, flow.held));
                }
            }
            let end = if h == left { stop } else { flow.time + h };
            self.sample(&flow, end);
            watch.taken(&step(&flow, h, &to));
            let is_corner = end == stop;
            flow.time = end;
            let from = core::mem::replace(&mut flow.q, to.q);
            flow.velocity = to.velocity;
            self.rates.clone_from(&flow.velocity.rates);
            self.trace_step(&flow);
            let over = (self.settling.as_mut()).is_some_and(|s| s.is_over(&mut flow, &from));
            if is_corner || over {
                // Drives may jump in rate there.
                return Some((flow.time, flow.q, flow.held));
            }
        }
    }

    /// Traces an instant at which contacts may have changed: the rates before, and those after.
    fn trace_instant(&mut self, flow: &Flow<'_>, q: &[f64]) {
        if !self.record.trace.is_empty() {
            let mut rates = self.rates.clone();
            rates.resize(q.len(), 0.0);
            self.record.trace.push(moment(flow.time, q, rates));
        }
        let after = moment(flow.time, &flow.q, flow.velocity.rates.clone());
        self.record.trace.push(after);
    }

    fn trace_step(&mut self, flow: &Flow<'_>) {
        if self.record.trace.len() < MOST_TRACED {
            let here = moment(flow.time, &flow.q, flow.velocity.rates.clone());
            self.record.trace.push(here);
        }
    }

    /// Factor by which a step is to be shortened, if it went too far or its error is too large.
    fn too_long(&self, flow: &Flow<'_>, h: f64, to: &Arrived, reach: &[f64]) -> Option<f64> {
        let changes = (flow.q.iter().zip(&to.q)).zip(self.system.lengths());
        let moved = (changes.zip(reach))
            .map(|(((a, b), l), r)| ((b - a) * l).abs() / r)
            .fold(0.0, f64::max);
        let by_error = to.excess(self.system);
        if to.velocity.determined && strays(self.system, flow, h, to) {
            Some(0.5)
        } else if moved > 2.0 {
            Some((1.0 / moved).max(0.1))
        } else if by_error > 1.0 {
            Some((0.9 * by_error.powf(-0.2)).clamp(0.1, 0.9))
        } else {
            None
        }
    }

    /// Takes samples up to a time that has been reached. The end is a sample, also if it is none of the even times, or
    /// misses one by rounding.
    fn sample(&mut self, flow: &Flow<'_>, end: f64) {
        while self.samples.time() <= end && self.samples.time() <= self.duration {
            let t = self.samples.time();
            self.sample_at(flow, t);
            self.samples.next += 1;
        }
        let last = self.record.samples.last();
        if end >= self.duration && last.is_none_or(|s| s.t < self.duration * (1.0 - 1e-12)) {
            self.sample_at(flow, self.duration);
        }
    }

    fn sample_at(&mut self, flow: &Flow<'_>, t: f64) {
        // Bounds that hold to the end of a step hold before.
        if let Some(to) = flow.after((t - flow.time).max(0.0)) {
            let forces = flow.forces(t, &to);
            self.record.samples.push(Sample {
                t,
                coordinates: to.q,
                rates: to.velocity.rates,
                forces,
            });
        }
    }
}

/// Whether where a step comes to is not where the rates at its ends lead. Joints and contacts that leave no freedom may close at another
/// configuration beyond times at which they do not close at all.
fn strays(system: &System, flow: &Flow<'_>, h: f64, to: &Arrived) -> bool {
    let rates = [&flow.velocity.rates, &to.velocity.rates];
    let half = 0.5 * h;
    let led = (0..flow.q.len()).map(|i| flow.q[i] + half * (rates[0][i] + rates[1][i]));
    let led: Vec<f64> = led.collect();
    let way = half * (system.speed(rates[0]) + system.speed(rates[1]));
    system.moved(&led, &to.q) > STRAYS * way + CLOSED * system.size()
}

/// Coordinates and rates at a time.
pub(super) fn moment(t: f64, q: &[f64], rates: Vec<f64>) -> Sample {
    Sample {
        t,
        coordinates: q.to_vec(),
        rates,
        forces: None,
    }
}
