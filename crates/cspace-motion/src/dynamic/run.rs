//! The motion from event to event.

use nalgebra::DVector;

use super::STILL;
use super::accumulate::Impacts;
use super::flow::{Bearings, Flow, ZERO};
use super::modes::{Bearing, Mode, Problem, Solution};
use super::step::{Looked, Watched};
use super::world::{Acting, State, Step, Touch, World};

/// What happens.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// Velocities change at once.
    Impact,
    /// A contact closes without an impact.
    Touch,
    /// A contact opens.
    Release,
    /// A contact that slid sticks.
    Stick,
    /// One that stuck slides.
    Slip,
    /// Impacts have accumulated, and the contact stays closed.
    Rest,
}

/// Something that happens to a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event {
    /// When, s.
    pub t: f64,
    /// What.
    pub kind: EventKind,
    /// The number of the contact.
    pub contact: usize,
}

/// How a motion ends.
#[derive(Debug, Clone, PartialEq)]
pub enum Ended {
    /// At the time asked for.
    Done,
    /// No accelerations, or velocities after an impact, agree with the laws of contact and friction.
    Inconsistent {
        /// The contacts concerned.
        contacts: Vec<usize>,
    },
    /// What is driven strikes what cannot give way.
    Jammed {
        /// The contacts concerned.
        contacts: Vec<usize>,
    },
    /// Several do.
    Undetermined {
        /// The contacts concerned.
        contacts: Vec<usize>,
    },
    /// More events in a time than can be told apart, or an equation of motion without a solution.
    Stuck {
        /// The contacts concerned.
        contacts: Vec<usize>,
    },
    /// Steps are too many, because forces are too stiff or rates too large.
    TooMany,
    /// The observer wants no more.
    Interrupted,
}

/// Who is told of a motion on its way.
pub trait Observer {
    /// The next time at which a sample is wanted, s.
    fn next(&self) -> f64 {
        f64::INFINITY
    }

    /// The state and the forces at that time.
    fn sample(&mut self, _state: &State, _acting: &Acting<'_>) {}

    /// The state at the start and at the ends of all steps.
    fn step(&mut self, _state: &State) {}

    /// The state after what happened at an event: rates may not be what they were at the end of the step.
    fn changed(&mut self, _state: &State) {}

    /// An event, and the state just after it.
    fn event(&mut self, _event: &Event, _state: &State) {}

    /// Whether it is to go on, asked now and then with the time it has come to.
    fn goes_on(&self, _t: f64) -> bool {
        true
    }
}

/// Nobody.
impl Observer for () {}

/// A motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// How it ended.
    pub ended: Ended,
    /// Where it began: the start, with the rates nearest to its own that joints allow.
    pub first: State,
    /// Where it ended.
    pub last: State,
    /// What happened.
    pub events: Vec<Event>,
    /// Steps between events.
    pub steps: usize,
    /// How far closed contacts and joints were open at most after a step, before they were brought together.
    pub open: f64,
    /// What became of energy.
    pub work: Work,
}

/// What drives put in, and what is lost.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Work {
    /// By drives.
    pub drives: f64,
    /// To friction and dampers.
    pub friction: f64,
    /// To impacts.
    pub impacts: f64,
}

/// What is asked of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// When it ends, s.
    pub until: f64,
    /// No step is longer, s.
    pub longest: f64,
}

/// Events within this share of the time that is simulated happen at one time.
const AT_ONE_TIME: f64 = 1e-13;
/// No more events happen at one time.
const AT_ONCE: usize = 200;

/// There are no more steps than that.
const MOST_STEPS: usize = 10_000_000;
/// Where steps are so short that more than this would follow, and have been for so many steps in a row, it is given up: they would
/// take minutes. What is fast for a moment, as a part that is thrown against another, is followed.
const FORESEEN: f64 = 1e6;
/// See [`FORESEEN`].
const MOST_SHORT: usize = 20_000;
/// So many impacts within [`CROWD`] of the time that is simulated do not bounce any more.
const MOST_IMPACTS: usize = 300;
/// A share of the time that is simulated.
const CROWD: f64 = 1e-6;
/// Trials of one of several sets of contacts go as far as this, as shares of the size: beyond what contacts are known to, and less than
/// what follows next. A shorter one is made where something follows at once.
const TRIALS: [f64; 4] = [1e-6, 1e-7, 1e-8, 3e-9];

/// Contacts that cease to stick within this share of the time that is simulated do so together.
const LOOSE: f64 = 1e-8;
/// What curvature and rates add to the acceleration of a gap is rounding if in the longest step it moves the gap by less than this
/// share of the size: as where a part turns about the centre of an arc that touches.
const SLIGHT: f64 = 1e-15;
/// Slow are rates of this share of the largest so far.
const SLOW: f64 = 1e-5;

/// A motion from a state; `observer` is told the states it asks for.
///
/// Times are in s, coordinates and forces in units that fit together.
///
/// ```
/// use cspace_motion::dynamic::{EventKind, Options, State, Surface, Touch, World, run};
/// use nalgebra::{DMatrix, DVector};
/// /// A ball of 1 kg that bounces with a restitution of one half.
/// struct Ball(DMatrix<f64>);
/// impl World for Ball {
///     fn mass(&self) -> &DMatrix<f64> {
///         &self.0
///     }
///     fn force(&self, _: &State) -> DVector<f64> {
///         DVector::from_element(1, -9.81)
///     }
///     fn watched(&self) -> Vec<usize> {
///         vec![0]
///     }
///     fn touch(&self, _: usize, _: f64, q: &DVector<f64>) -> Touch {
///         Touch {
///             gap: q[0],
///             normal: DVector::from_element(1, 1.0),
///             tangent: DVector::zeros(1),
///             drift: [0.0; 2],
///         }
///     }
///     fn surface(&self, _: usize) -> Surface {
///         Surface { friction: 0.0, restitution: 0.5 }
///     }
///     fn size(&self) -> f64 {
///         1.0
///     }
/// }
/// let ball = Ball(DMatrix::identity(1, 1));
/// let start = State { t: 0.0, q: DVector::from_element(1, 1.0), v: DVector::zeros(1) };
/// let motion = run(&ball, start, &Options { until: 3.0, longest: 1.0 }, &mut ());
/// // It falls for √(2 h / g), and is at rest three times as late.
/// let fall = f64::sqrt(2.0 / 9.81);
/// assert!((motion.events[0].t - fall).abs() < 1e-12);
/// let rest = motion.events.iter().find(|e| e.kind == EventKind::Rest).ok_or("it rests")?;
/// assert!((rest.t - 3.0 * fall).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run<W: World + ?Sized>(
    world: &W,
    start: State,
    options: &Options,
    observer: &mut dyn Observer,
) -> Motion {
    run_through(world, start, options, &[], observer)
}

/// As [`run`], where what is driven does not move smoothly at some times, which are in order: no step goes across them, and where rates
/// jump there, joints and contacts pass impulses on.
pub fn run_through<W: World + ?Sized>(
    world: &W,
    start: State,
    options: &Options,
    corners: &[f64],
    observer: &mut dyn Observer,
) -> Motion {
    let stopped = |ended, last: State| Motion {
        ended,
        first: last.clone(),
        last,
        events: Vec::new(),
        steps: 0,
        open: 0.0,
        work: Work::default(),
    };
    let Some(flow) = Flow::new(world) else {
        let contacts = Vec::new();
        return stopped(Ended::Stuck { contacts }, start);
    };
    let mut run = Run {
        flow,
        largest: DVector::zeros(start.q.len()),
        fastest: 0.0,
        span: options.until - start.t,
        first: start.clone(),
        state: start,
        bearings: Vec::new(),
        looked: Looked::default(),
        loose: (0.0, Vec::new()),
        impacts: Impacts::default(),
        events: Vec::new(),
        steps: 0,
        open: 0.0,
        work: Work::default(),
    };
    let ended = run
        .go(options, corners, observer)
        .err()
        .unwrap_or(Ended::Done);
    Motion {
        ended,
        first: run.first,
        last: run.state,
        events: run.events,
        steps: run.steps,
        open: run.open,
        work: run.work,
    }
}

/// What contacts have come to at an event.
#[derive(Debug, Clone, Default)]
struct Reached {
    /// Their sliding to its end: they do not slide at this moment, whatever rounding says.
    halted: Vec<usize>,
    /// All the friction there is.
    loose: Vec<usize>,
    /// The other side, without having opened by more than rounding: they stay, if they open slowly.
    back: Vec<usize>,
}

/// The last time before another that all stages of a step may come to, whatever rounding does to them.
fn before(corner: f64) -> f64 {
    corner * (1.0 - 4.0 * f64::EPSILON)
}

struct Run<'a, W: World + ?Sized> {
    flow: Flow<'a, W>,
    first: State,
    state: State,
    /// The largest value of each rate so far.
    largest: DVector<f64>,
    /// The largest rate so far, as the world measures rates.
    fastest: f64,
    span: f64,
    bearings: Bearings,
    /// Contacts that have begun to open at the last event, and may close again; and those that others keep from sliding.
    looked: Looked,
    /// Contacts that did not stick any more, since a time.
    loose: (f64, Vec<usize>),
    impacts: Impacts,
    events: Vec<Event>,
    steps: usize,
    open: f64,
    work: Work,
}

impl<W: World + ?Sized> Run<'_, W> {
    fn go(
        &mut self,
        options: &Options,
        corners: &[f64],
        observer: &mut dyn Observer,
    ) -> Result<(), Ended> {
        self.look();
        // What is joined to what is driven moves with it from the start on.
        if let Some((state, _)) = self.flow.projected(self.state.clone(), &Vec::new()) {
            self.state = state;
        }
        self.first.clone_from(&self.state);
        observer.step(&self.state);
        let closed = self.flow.world.closed(self.state.t, &self.state.q);
        let settled = self.settle(closed, &Reached::default());
        self.announce(0, observer);
        settled?;
        let mut longest = options.longest.min(1e-3 * self.span);
        let (mut at_once, mut since) = (0, self.state.t);
        let mut short = 0;
        self.show(&self.state.clone(), self.state.t, observer)?;
        let start = self.state.t;
        let ahead = |&&t: &&f64| t > start && t < options.until;
        let mut corners = corners.iter().filter(ahead).copied().peekable();
        while self.state.t < options.until {
            let corner = corners.peek().copied();
            if let Some(corner) = corner.filter(|&corner| self.state.t >= before(corner)) {
                corners.next();
                self.turn(corner, observer)?;
                longest = longest.min(1e-3 * self.span);
                continue;
            }
            if self.steps.is_multiple_of(64) && !observer.goes_on(self.state.t) {
                return Err(Ended::Interrupted);
            }
            if self.steps > MOST_STEPS {
                return Err(Ended::TooMany);
            }
            let left = corner.map_or(options.until, before) - self.state.t;
            let far = self.flow.world.longest(&self.state);
            let h = longest.min(left).min(far);
            let foreseen = (options.until - self.state.t) / h;
            short = if foreseen > FORESEEN { short + 1 } else { 0 };
            if self.state.t + h <= self.state.t || short > MOST_SHORT {
                return Err(Ended::TooMany);
            }
            let mut looked = self.looked.clone();
            looked.gaps.extend(self.flow.world.watched());
            looked.gaps.sort_unstable();
            looked.gaps.dedup();
            let stepped = self
                .flow
                .step(&self.state, h, &self.bearings, &looked, self.fastest)
                .ok_or_else(|| self.stuck())?;
            self.steps += 1;
            let from = core::mem::replace(&mut self.state, stepped.state);
            if self.state.t + 1e-15 * options.until.abs() >= options.until {
                self.state.t = options.until;
            }
            let bearing: Vec<usize> = self.bearings.iter().map(|b| b.0).collect();
            self.flow.world.taken(Step {
                from: &from,
                to: &self.state,
                bearing: &bearing,
            });
            self.open = self.open.max(stepped.open);
            self.work.drives += stepped.work[0];
            self.work.friction += stepped.work[1];
            longest = stepped.next.min(options.longest);
            self.look();
            self.show(&from, self.state.t, observer)?;
            observer.step(&self.state);
            if stepped.events.is_empty() && !stepped.met {
                continue;
            }
            at_once += 1;
            if self.state.t > since + AT_ONE_TIME * self.span {
                (at_once, since) = (0, self.state.t);
            }
            if at_once > AT_ONCE {
                return Err(self.stuck());
            }
            let told = self.events.len();
            let happened = self.happen(&stepped.events);
            self.announce(told, observer);
            happened?;
            observer.changed(&self.state);
            longest = longest.min(1e-3 * self.span);
        }
        Ok(())
    }

    /// Passes a time at which what is driven does not move smoothly.
    fn turn(&mut self, corner: f64, observer: &mut dyn Observer) -> Result<(), Ended> {
        let world = self.flow.world;
        let kinetic = world.kinetic(&self.state);
        self.state.t = corner.next_up();
        // What is driven has its new rates at once.
        self.work.drives += world.kinetic(&self.state) - kinetic;
        let joints = world.joints(self.state.t, &self.state.q);
        let off = &joints.rows * &self.state.v - &joints.rates;
        let told = self.events.len();
        let mut happened = Ok(true);
        if off.iter().any(|off| off.abs() > STILL * self.fastest) {
            happened = self.impact(&world.closed(self.state.t, &self.state.q));
        }
        let happened = happened.and_then(|_| self.happen(&[]));
        self.announce(told, observer);
        happened?;
        observer.changed(&self.state);
        Ok(())
    }

    /// Tells events from the one of a number on.
    fn announce(&self, from: usize, observer: &mut dyn Observer) {
        for event in &self.events[from..] {
            observer.event(event, &self.state);
        }
    }

    /// Samples up to a time, with the contacts that bear: they are taken from a state before.
    fn show(&self, from: &State, until: f64, observer: &mut dyn Observer) -> Result<(), Ended> {
        while observer.next() <= until {
            let h = (observer.next() - from.t).max(0.0);
            let at = if h == 0.0 {
                from.clone()
            } else if from.t + h >= self.state.t {
                self.state.clone()
            } else {
                let taken = self.flow.take(from, h, &self.bearings, self.fastest);
                taken.ok_or_else(|| self.stuck())?.state
            };
            let solution = self.flow.accelerations(&at, &self.bearings);
            let solution = solution.ok_or_else(|| self.stuck())?;
            let before = observer.next();
            observer.sample(&at, &Acting::of(&solution, &self.bearings));
            debug_assert!(observer.next() > before, "samples go on");
        }
        Ok(())
    }

    fn stuck(&self) -> Ended {
        Ended::Stuck {
            contacts: self.bearings.iter().map(|b| b.0).collect(),
        }
    }

    fn look(&mut self) {
        // What has not moved yet is as slow as what crosses a millionth of the size in the time of the simulation.
        let slow = 1e-6 * self.flow.world.size() / self.span;
        let fastest = self.flow.world.reach(&self.state.v);
        self.fastest = self.fastest.max(fastest).max(slow);
        let floor = 1e-6 * self.largest.amax().max(self.state.v.amax()).max(slow);
        for k in 0..self.state.v.len() {
            self.largest[k] = self.largest[k].max(self.state.v[k].abs()).max(floor);
        }
    }

    fn touch(&self, contact: usize) -> Touch {
        let state = &self.state;
        self.flow.world.touch(contact, state.t, &state.q)
    }

    fn is_same(&self, a: usize, b: usize) -> bool {
        let state = &self.state;
        self.flow.world.is_same(a, b, state.t, &state.q)
    }

    /// A rate that counts as none, of a row.
    fn still(&self, row: &DVector<f64>) -> f64 {
        let terms = row.iter().zip(self.largest.iter());
        STILL * terms.map(|(r, v)| (r * v).abs()).sum::<f64>()
    }

    /// The rate at which a closed contact opens, and what counts as none.
    fn opening(&self, contact: usize) -> (f64, f64) {
        let touch = self.touch(contact);
        let still = self.still(&touch.normal) + STILL * touch.drift[0].abs();
        (touch.opening(&self.state.v), still)
    }

    fn happen(&mut self, events: &[(usize, Watched)]) -> Result<(), Ended> {
        let before = self.bearings.clone();
        let mut closed: Vec<usize> = self.flow.world.closed(self.state.t, &self.state.q);
        let gaps = (events.iter()).filter(|e| matches!(e.1, Watched::Gap | Watched::Back));
        for contact in gaps.map(|e| e.0).chain(before.iter().map(|b| b.0)) {
            if !closed.contains(&contact) {
                closed.push(contact);
            }
        }
        closed.sort_unstable();
        let of = |kind: Watched| -> Vec<usize> {
            let all = events.iter().filter(|e| e.1 == kind);
            all.map(|e| e.0).collect()
        };
        // Contacts that share a load let go one after the other.
        if self.state.t > self.loose.0 + LOOSE * self.span {
            self.loose = (self.state.t, Vec::new());
        }
        self.loose.1.extend(of(Watched::Sticking));
        let reached = Reached {
            halted: of(Watched::Sliding),
            loose: self.loose.1.clone(),
            back: of(Watched::Back),
        };
        self.settle(closed, &reached)?;
        for &(contact, mode) in &before {
            let now = self.bearings.iter().find(|b| b.0 == contact);
            // A contact that passes from one feature to the next goes on.
            let now = now.or_else(|| {
                let is_new = |i: usize| before.iter().all(|b| b.0 != i);
                (self.bearings.iter()).find(|b| is_new(b.0) && self.is_same(b.0, contact))
            });
            let kind = match (mode, now.map(|b| b.1)) {
                (_, None) => EventKind::Release,
                (Mode::Stick, Some(Mode::Forward | Mode::Backward)) => EventKind::Slip,
                (Mode::Forward | Mode::Backward, Some(Mode::Stick)) => EventKind::Stick,
                _ => continue,
            };
            self.tell(kind, contact);
        }
        Ok(())
    }

    fn tell(&mut self, kind: EventKind, contact: usize) {
        let t = self.state.t;
        let told = self.events.iter().rev().take_while(|e| e.t == t);
        // Features that take each other's place are one contact.
        let mut same = told.filter(|e| e.kind == kind);
        if same.any(|e| self.is_same(e.contact, contact)) {
            return;
        }
        self.events.push(Event { t, kind, contact });
    }

    /// What the closed contacts do from now on: the first of the world's alternatives that leads on.
    fn settle(&mut self, closed: Vec<usize>, at: &Reached) -> Result<(), Ended> {
        let sets = (self.flow.world).alternatives(&closed, self.state.t, &self.state.q);
        if sets.len() < 2 {
            return self.settle_with(closed, at);
        }
        let saved = (
            self.state.clone(),
            self.bearings.clone(),
            self.looked.clone(),
            self.impacts.clone(),
            self.events.len(),
            self.work,
        );
        let mut failed = None;
        for scale in TRIALS {
            for set in &sets {
                let settled = self.settle_with(set.clone(), at);
                if settled.is_ok() && self.leads_on(scale) {
                    return Ok(());
                }
                let (state, bearings, looked, impacts, events, work) = &saved;
                self.looked.clone_from(looked);
                self.state.clone_from(state);
                self.bearings.clone_from(bearings);
                self.impacts.clone_from(impacts);
                self.events.truncate(*events);
                self.work = *work;
                failed = failed.or(settled.err());
            }
        }
        Err(failed.unwrap_or(Ended::Stuck { contacts: closed }))
    }

    /// Whether a very short step, as far as a share of the size, meets nothing.
    fn leads_on(&self, scale: f64) -> bool {
        /// A trial may go so many times as far.
        const FARTHER: f64 = 10.0;
        /// Otherwise its time is shortened by this, so many times at most: down to rounding.
        const SHORTER: f64 = 0.1;
        const MOST: usize = 16;
        let far = scale * self.flow.world.size();
        let speed = self.flow.world.reach(&self.state.v);
        let mut h = (far / speed).min(1e-3 * self.span);
        let bearing: Vec<usize> = self.bearings.iter().map(|b| b.0).collect();
        for _ in 0..MOST {
            if let Some(taken) = self.flow.take(&self.state, h, &self.bearings, self.fastest)
                && self.flow.world.reach(&(&taken.state.q - &self.state.q)) <= FARTHER * far
            {
                return !self.flow.world.met(Step {
                    from: &self.state,
                    to: &taken.state,
                    bearing: &bearing,
                });
            }
            h *= SHORTER;
        }
        false
    }

    /// Impacts of the contacts that are closed, then what each of them does from now on.
    fn settle_with(&mut self, mut closed: Vec<usize>, at: &Reached) -> Result<(), Ended> {
        /// Impacts follow each other at one time where contacts pass them on.
        const MOST: usize = 50;
        let known: Vec<usize> = self.bearings.iter().map(|b| b.0).collect();
        let (mut struck, mut rested) = (Vec::new(), Vec::new());
        for round in 0..=MOST {
            let strikes = |i: &usize| {
                let (rate, still) = self.opening(*i);
                rate < -still
            };
            let hits: Vec<usize> = closed.iter().copied().filter(strikes).collect();
            if hits.is_empty() {
                break;
            }
            if round == MOST {
                return Err(Ended::Stuck { contacts: hits });
            }
            if !self.impact(&closed)? {
                // So slow that it is none: the contacts close without.
                break;
            }
            for &hit in &hits {
                if !struck.contains(&hit) {
                    struck.push(hit);
                }
            }
        }
        if !struck.is_empty() {
            self.impacts.add(self.state.t);
            for &contact in &struck {
                self.tell(EventKind::Impact, contact);
            }
            let parts = |&i: &usize| {
                let (rate, still) = self.opening(i);
                if rate > still { rate } else { 0.0 }
            };
            let way = closed.iter().map(parts).fold(0.0, f64::max) / self.flow.world.size();
            if let Some(left) = self.impacts.rest(self.span, way) {
                // What bounces is closed for good: the rates at which it opens are gone in the limit.
                let reach = way * left * self.flow.world.size();
                let watched = self.flow.world.watched();
                for i in watched.into_iter().chain(self.looked.gaps.iter().copied()) {
                    if !closed.contains(&i) && self.touch(i).gap <= reach {
                        closed.push(i);
                    }
                }
                let (state, work) = (self.state.clone(), self.work);
                self.stay(&closed, &[])?;
                let halted = self.rest_for(left, &closed);
                if !halted.is_empty() {
                    // What slides no longer than the impacts last sticks in the limit.
                    (self.state, self.work) = (state, work);
                    self.stay(&closed, &halted)?;
                    self.rest_for(left, &closed);
                }
                for &contact in &closed {
                    self.tell(EventKind::Rest, contact);
                }
                rested.clone_from(&closed);
                self.impacts = Impacts::default();
            }
        }
        // Those that part are open from now on.
        let stays = |i: &usize| {
            let (rate, still) = self.opening(*i);
            let slow = if at.back.contains(i) {
                SLOW * still / STILL
            } else {
                still
            };
            rate <= slow
        };
        let (resting, parting): (Vec<usize>, Vec<usize>) = closed.into_iter().partition(stays);
        self.looked.gaps = parting;
        let mut problem = self.problem(&resting);
        for (k, i) in resting.iter().enumerate() {
            let is_among = |all: &[usize]| all.iter().any(|h| h == i || self.is_same(*h, *i));
            if is_among(&at.halted) {
                problem.bearings[k].slides = None;
            }
            problem.bearings[k].lets_go = is_among(&at.loose);
        }
        let solution = self.one(problem.solutions(), &resting)?;
        self.bearings = (resting.iter().copied())
            .zip(solution.modes)
            .filter(|(_, mode)| *mode != Mode::Open)
            .collect();
        if let Some((state, _)) = self.flow.projected(self.state.clone(), &self.bearings) {
            self.state = state;
        }
        self.looked.idle = self.flow.idle(&self.state, &self.bearings);
        for (contact, _) in self.bearings.clone() {
            // What has come to rest is not told to touch as well.
            let mut before = known.iter().chain(&rested);
            if !before.any(|&k| k == contact || self.is_same(k, contact)) {
                self.tell(EventKind::Touch, contact);
            }
        }
        Ok(())
    }

    fn problem(&self, contacts: &[usize]) -> Problem<'_> {
        let mut problem = self.flow.problem(&self.state, contacts, 0.0);
        let far = self.flow.world.longest(&self.state);
        for (k, &i) in contacts.iter().enumerate() {
            let touch = self.touch(i);
            let rate = touch.sliding(&self.state.v);
            if problem.bearings[k].b.abs() * far * far < SLIGHT * self.flow.world.size() {
                problem.bearings[k].b = 0.0;
            }
            let still = self.still(&touch.tangent) + STILL * touch.drift[1].abs();
            let slides = rate.abs() > still;
            problem.bearings[k].slides = slides.then_some(rate.signum());
        }
        problem
    }

    /// Newton's law of impact along normals, Coulomb's for impulses across them, all closed contacts at once. Whether any contact
    /// passes an impulse.
    fn impact(&mut self, closed: &[usize]) -> Result<bool, Ended> {
        let crowded = self.impacts.is_crowded(CROWD * self.span, MOST_IMPACTS);
        let surface = |i: usize| {
            let surface = self.flow.world.surface(i);
            let restitution = if crowded { 0.0 } else { surface.restitution };
            (surface.friction, restitution)
        };
        let problem = self.impulses(closed, &surface);
        let solutions = problem.solutions();
        if solutions.is_empty() {
            // Impacts of what is free to move have solutions.
            let contacts = closed.to_vec();
            return Err(Ended::Jammed { contacts });
        }
        let solution = self.one(solutions, closed)?;
        self.pass(&solution, closed);
        Ok(solution.modes.iter().any(|mode| *mode != Mode::Open))
    }

    /// What velocities and impulses have to satisfy, with the friction and the restitution of each contact.
    fn impulses(&self, closed: &[usize], surface: &dyn Fn(usize) -> (f64, f64)) -> Problem<'_> {
        let world = self.flow.world;
        let joints = world.joints(self.state.t, &self.state.q);
        let bearings = (closed.iter())
            .map(|&i| {
                let touch = self.touch(i);
                let (friction, restitution) = surface(i);
                let rate = touch.opening(&self.state.v);
                Bearing {
                    b: touch.drift[0] + restitution * rate.min(0.0),
                    c: touch.drift[1],
                    normal: touch.normal,
                    tangent: touch.tangent,
                    friction,
                    slides: None,
                    lets_go: false,
                }
            })
            .collect();
        Problem {
            mass: world.mass(),
            h: world.mass() * &self.state.v,
            joints: joints.rows,
            j: joints.rates,
            bearings,
            zero: ZERO,
        }
    }

    /// Velocities after impulses, and what becomes of the energy.
    fn pass(&mut self, solution: &Solution, closed: &[usize]) {
        let world = self.flow.world;
        let before = world.kinetic(&self.state);
        let forces = solution.normal.iter().zip(&solution.tangential);
        let acting = Acting {
            accelerations: None,
            contacts: (closed.iter().zip(forces))
                .map(|(&i, (&n, &t))| (i, n, t))
                .collect(),
            joints: &solution.joints,
        };
        let drives = world.powers(&self.state, &acting)[0];
        self.state.v.clone_from(&solution.x);
        self.work.drives += drives;
        self.work.impacts += before + drives - world.kinetic(&self.state);
    }

    /// Contacts do not open any more: the impulses, of either sign, that take away the rates at which they do, and what gaps are left.
    ///
    /// Those that are halted do not slide either.
    fn stay(&mut self, closed: &[usize], halted: &[usize]) -> Result<(), Ended> {
        let mode = |i: &usize| match halted.contains(i) {
            true => Mode::Stick,
            false => Mode::Forward,
        };
        let modes: Vec<Mode> = closed.iter().map(mode).collect();
        let solution = self.impulses(closed, &|_| (0.0, 0.0)).within(&modes);
        self.pass(&solution.ok_or_else(|| self.stuck())?, closed);
        let bearings = closed.iter().copied().zip(modes).collect();
        let state = self.flow.projected(self.state.clone(), &bearings);
        self.state = state.ok_or_else(|| self.stuck())?.0;
        Ok(())
    }

    /// The short time that accumulating impacts have left, with their contacts closed; and those whose sliding turned back in it.
    fn rest_for(&mut self, left: f64, closed: &[usize]) -> Vec<usize> {
        let mut halted = Vec::new();
        let solutions = self.problem(closed).solutions();
        let taken = match &solutions[..] {
            [solution] => {
                let modes = closed.iter().copied().zip(solution.modes.iter().copied());
                let bearings = modes.filter(|(_, mode)| *mode != Mode::Open).collect();
                let step = self.flow.take(&self.state, left, &bearings, self.fastest);
                if let Some(taken) = &step {
                    let world = self.flow.world;
                    let turned = |&&(i, mode): &&(usize, Mode)| {
                        let touch = world.touch(i, taken.state.t, &taken.state.q);
                        let rate = touch.sliding(&taken.state.v) * mode.direction();
                        world.surface(i).friction > 0.0 && rate < 0.0
                    };
                    halted.extend(bearings.iter().filter(turned).map(|b| b.0));
                }
                step.map(|taken| (taken.state, taken.work))
            }
            // What it does is told at its end.
            _ => None,
        };
        match taken {
            Some((state, work)) => {
                self.state = state;
                self.work.drives += work[0];
                self.work.friction += work[1];
            }
            None => {
                let v = self.state.v.clone();
                self.state.q += v * left;
                self.state.t += left;
            }
        }
        halted
    }

    /// The one solution there is to be.
    fn one(&self, mut solutions: Vec<Solution>, contacts: &[usize]) -> Result<Solution, Ended> {
        let contacts = contacts.to_vec();
        match solutions.len() {
            0 => Err(Ended::Inconsistent { contacts }),
            1 => Ok(solutions.remove(0)),
            _ => Err(Ended::Undetermined { contacts }),
        }
    }
}
