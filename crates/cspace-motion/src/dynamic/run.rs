//! The motion from event to event.

use nalgebra::DVector;

use super::STILL;
use super::accumulate::Impacts;
use super::bridges::Bridges;
use super::crowd::Crowd;
use super::flow::{Bearings, Flow};
use super::motion::{Ended, Event, Motion, Observer, Options, Work};
use super::step::{Looked, Span};
use super::world::{Acting, State, Step, World};

/// Events within this share of the time that is simulated happen at one time.
const AT_ONE_TIME: f64 = 1e-13;
/// Largest number of events at one time, for each contact that bears and beside: contacts that share a load let go one after the other.
const AT_ONCE: [usize; 2] = [2, 16];

/// So often contacts may come back to the modes that they had at the same time: each leads to the next in a circle then.
const AGAIN: usize = 2;

/// Determinant at which joints count as folded: closer to such a configuration the rounding in accelerations, which are
/// divided by it, may choose any of the possible directions.
const FOLD: f64 = 1e-6;

/// There are no more steps than that.
const MOST_STEPS: usize = 10_000_000;
/// Number of steps to come beyond which the motion is given up, if it has been exceeded for many steps in a row: they
/// would take minutes. Fast motion for a moment, as of a part that is thrown against another, is followed.
const FORESEEN: f64 = 1e6;
/// See [`FORESEEN`].
const MOST_SHORT: usize = 20_000;

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
/// let motion = run(&ball, start, &Options { until: 3.0, longest: 1.0, strict: false }, &mut ());
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

/// As [`run`], for drives that do not move smoothly at some times, which are in order: no step goes across them, and
/// where rates jump there, joints and contacts transmit impulses.
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
        bridges: Bridges::from(start.t),
        state: start,
        bearings: Vec::new(),
        looked: Looked::default(),
        loose: (0.0, Vec::new()),
        impacts: Impacts::default(),
        events: Vec::new(),
        steps: 0,
        open: 0.0,
        work: Work::default(),
        is_led: false,
        strict: options.strict,
        fold: None,
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

/// Contacts that end a step at an event, by reason.
#[derive(Debug, Clone)]
pub(super) struct Reached {
    /// Contacts whose sliding has come to its end: they do not slide at this moment, regardless of rounding.
    pub(super) halted: Vec<usize>,
    /// Contacts that have used up all of their friction.
    pub(super) loose: Vec<usize>,
    /// Contacts that closed again without having opened by more than rounding: they stay closed if they open slowly.
    pub(super) back: Vec<usize>,
}

/// The last time before another that all stages of a step may come to, whatever rounding does to them.
fn before(corner: f64) -> f64 {
    corner * (1.0 - 4.0 * f64::EPSILON)
}

pub(super) struct Run<'a, W: World + ?Sized> {
    pub(super) flow: Flow<'a, W>,
    pub(super) first: State,
    pub(super) state: State,
    /// Largest value of each rate so far.
    pub(super) largest: DVector<f64>,
    /// Largest rate so far, as the world measures rates.
    pub(super) fastest: f64,
    pub(super) span: f64,
    pub(super) bearings: Bearings,
    /// Contacts that have begun to open at the last event, and may close again; and those that others keep from sliding.
    pub(super) looked: Looked,
    /// Contacts that did not stick any more, since a time.
    pub(super) loose: (f64, Vec<usize>),
    pub(super) impacts: Impacts,
    pub(super) events: Vec<Event>,
    pub(super) steps: usize,
    pub(super) open: f64,
    pub(super) work: Work,
    /// Whether joints and drives leave no freedom.
    is_led: bool,
    /// Whether the motion ends where several are possible.
    pub(super) strict: bool,
    pub(super) bridges: Bridges,
    /// For a mechanism without freedom: [`Flow::fold`] at the end of the last step, and its rate.
    pub(super) fold: Option<(f64, f64)>,
}

impl<W: World + ?Sized> Run<'_, W> {
    fn go(
        &mut self,
        options: &Options,
        corners: &[f64],
        observer: &mut dyn Observer,
    ) -> Result<(), Ended> {
        self.look();
        // Parts joined to driven parts move with them from the start on.
        if let Some((state, _)) = self.flow.projected(self.state.clone(), &Vec::new()) {
            self.state = state;
        }
        self.first.clone_from(&self.state);
        let joints = self.flow.world.joints(self.state.t, &self.state.q).rows;
        self.is_led = joints.nrows() > 0 && joints.is_square();
        observer.step(&self.state);
        loop {
            let contacts = match self.advance(options, corners, observer) {
                Err(Ended::Stuck { contacts }) => contacts,
                ended => return ended,
            };
            if let Some(contacts) = self.wedged() {
                return Err(Ended::Jammed { contacts });
            }
            if options.strict {
                return Err(Ended::Stuck { contacts });
            }
            if !observer.goes_on(self.state.t) {
                return Err(Ended::Interrupted);
            }
            // Where nothing touches, a pair has left its space, or joints cannot hold.
            let closed = || self.flow.world.closed(self.state.t, &self.state.q);
            let contact = contacts.first().copied();
            let contact = contact.or_else(|| closed().first().copied());
            let leads_on = contact.is_some_and(|i| self.bridge(i, options, observer));
            if !leads_on {
                return Err(Ended::Stuck { contacts });
            }
        }
    }

    /// Goes on from event to event.
    fn advance(
        &mut self,
        options: &Options,
        corners: &[f64],
        observer: &mut dyn Observer,
    ) -> Result<(), Ended> {
        let told = self.events.len();
        let settled = self.happen(&[]);
        self.announce(told, observer);
        settled?;
        let mut longest = options.longest.min(1e-3 * self.span);
        let (mut at_once, mut since) = (0, self.state.t);
        let mut known: Vec<Bearings> = Vec::new();
        let (mut short, mut crowd) = (0, Crowd::default());
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
            if self.is_led && self.go_through(corner, options, observer) {
                continue;
            }
            let left = corner.map_or(options.until, before) - self.state.t;
            let far = self.flow.world.longest(&self.state);
            let h = longest.min(left).min(far).min(self.to_fold());
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
                .step(self.span_from(&self.state), h, &looked)
                .ok_or_else(|| self.stuck())?;
            self.steps += 1;
            let before = self.fold;
            let folds = self.folds(&stepped.state);
            let from = core::mem::replace(&mut self.state, stepped.state);
            if folds {
                // Rates go with the inverse of the determinant, or do not depend on it.
                let [slow, fast] = [&from, &self.state].map(|s| self.flow.world.reach(&s.v));
                let share = before
                    .zip(self.fold)
                    .map_or(0.0, |(a, b)| (a.0 / b.0).abs());
                let dead = share > 1.0 && fast > share.sqrt() * slow;
                return Err(Ended::Folded { dead });
            }
            if self.state.t + 1e-15 * options.until.abs() >= options.until {
                self.state.t = options.until;
            }
            if let Err(ended) = self.show(&from, self.state.t, observer) {
                // The step leads over what its contacts do not allow.
                self.state = from;
                return Err(ended);
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
            observer.step(&self.state);
            if stepped.events.is_empty() && !stepped.met {
                if !self.looked.steady.is_empty() {
                    // Whether they still can is asked as a whole.
                    let told = self.events.len();
                    let happened = self.happen(&[]);
                    self.announce(told, observer);
                    happened?;
                }
                continue;
            }
            at_once += 1;
            if self.state.t > since + AT_ONE_TIME * self.span {
                (at_once, since) = (0, self.state.t);
                known.clear();
            }
            let most = AT_ONCE[0] * self.bearings.len() + AT_ONCE[1];
            if at_once > most || crowd.grows(self.state.t, self.span) {
                return Err(self.stuck());
            }
            let told = self.events.len();
            let before = self.bearings.clone();
            let happened = self.happen(&stepped.events);
            self.announce(told, observer);
            happened?;
            let all_of_forces = stepped.events.iter().all(|e| e.1.is_of_force());
            if self.bearings == before && !stepped.met && all_of_forces {
                (self.looked.steady).extend(stepped.events.iter().map(|e| e.0));
            } else if known.iter().filter(|k| **k == self.bearings).count() > AGAIN {
                return Err(self.stuck());
            } else {
                known.push(self.bearings.clone());
            }
            observer.changed(&self.state);
            longest = longest.min(1e-3 * self.span);
        }
        Ok(())
    }

    /// Half of the time after which joints that leave no freedom would fold, as it seems.
    fn to_fold(&self) -> f64 {
        let time = self.fold.map_or(0.0, |(fold, rate)| -fold / rate);
        if time > 0.0 {
            0.5 * time
        } else {
            f64::INFINITY
        }
    }

    /// Whether the joints are folded at the end of a step.
    fn folds(&mut self, to: &State) -> bool {
        if !self.is_led {
            return false;
        }
        let after = self.flow.fold(to);
        let before = self.fold.map(|(before, _)| before);
        let rate = before.map_or(0.0, |before| (after - before) / (to.t - self.state.t));
        self.fold = Some((after, rate));
        after.abs() <= FOLD || before.is_some_and(|before| before * after < 0.0)
    }

    /// Passes a time at which a drive does not move smoothly.
    fn turn(&mut self, corner: f64, observer: &mut dyn Observer) -> Result<(), Ended> {
        let world = self.flow.world;
        let kinetic = world.kinetic(&self.state);
        self.state.t = corner.next_up();
        // Driven parts have their new rates at once.
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

    /// Reports the events from an index on.
    pub(super) fn announce(&self, from: usize, observer: &mut dyn Observer) {
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
                let taken = self.flow.take(self.span_from(from), h);
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

    pub(super) fn stuck(&self) -> Ended {
        Ended::Stuck {
            contacts: self.bearings.iter().map(|b| b.0).collect(),
        }
    }

    /// Steps from a state with the contacts that bear.
    pub(super) fn span_from<'s>(&'s self, from: &'s State) -> Span<'s> {
        Span {
            from,
            bearings: &self.bearings,
            fastest: self.fastest,
        }
    }

    pub(super) fn look(&mut self) {
        // A mechanism that has not moved yet is as slow as one that crosses a millionth of the size in the time of the
        // simulation.
        let slow = 1e-6 * self.flow.world.size() / self.span;
        let fastest = self.flow.world.reach(&self.state.v);
        self.fastest = self.fastest.max(fastest).max(slow);
        let floor = 1e-6 * self.largest.amax().max(self.state.v.amax()).max(slow);
        for k in 0..self.state.v.len() {
            self.largest[k] = self.largest[k].max(self.state.v[k].abs()).max(floor);
        }
    }
}
