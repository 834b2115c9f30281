//! The motion from event to event.

use nalgebra::DVector;

use super::accumulate::Impacts;
use super::flow::{Bearings, Flow, ZERO};
use super::modes::{Bearing, Mode, Problem, Solution};
use super::step::Watched;
use super::world::{State, Touch, World};
use super::{CLOSED, STILL};

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
}

/// A motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// How it ended.
    pub ended: Ended,
    /// Where.
    pub last: State,
    /// What happened.
    pub events: Vec<Event>,
    /// Steps between events.
    pub steps: usize,
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

/// A motion from a state; `sample` is told the states at the ends of all steps.
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
///     fn force(&self, _: f64, _: &DVector<f64>, _: &DVector<f64>) -> DVector<f64> {
///         DVector::from_element(1, -9.81)
///     }
///     fn joints(&self, _: f64, _: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
///         (DVector::zeros(0), DMatrix::zeros(0, 1))
///     }
///     fn drift(&self, _: f64) -> (DVector<f64>, DVector<f64>) {
///         (DVector::zeros(0), DVector::zeros(0))
///     }
///     fn contacts(&self) -> usize {
///         1
///     }
///     fn touch(&self, _: usize, q: &DVector<f64>) -> Touch {
///         Touch {
///             gap: q[0],
///             normal: DVector::from_element(1, 1.0),
///             tangent: DVector::zeros(1),
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
/// let motion = run(&ball, start, &Options { until: 3.0, longest: 1.0 }, &mut |_| ());
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
    sample: &mut dyn FnMut(&State),
) -> Motion {
    let Some(flow) = Flow::new(world) else {
        let contacts = Vec::new();
        return Motion {
            ended: Ended::Stuck { contacts },
            last: start,
            events: Vec::new(),
            steps: 0,
        };
    };
    let mut run = Run {
        flow,
        largest: (DVector::zeros(start.q.len()), DVector::zeros(start.q.len())),
        span: options.until - start.t,
        state: start,
        bearings: Vec::new(),
        impacts: Impacts::default(),
        events: Vec::new(),
        steps: 0,
    };
    let ended = run.go(options, sample).err().unwrap_or(Ended::Done);
    Motion {
        ended,
        last: run.state,
        events: run.events,
        steps: run.steps,
    }
}

struct Run<'a, W: World + ?Sized> {
    flow: Flow<'a, W>,
    state: State,
    /// The largest values of coordinates and rates so far.
    largest: (DVector<f64>, DVector<f64>),
    span: f64,
    bearings: Bearings,
    impacts: Impacts,
    events: Vec<Event>,
    steps: usize,
}

impl<W: World + ?Sized> Run<'_, W> {
    fn go(&mut self, options: &Options, sample: &mut dyn FnMut(&State)) -> Result<(), Ended> {
        sample(&self.state.clone());
        self.look();
        let closed = self.closed(0.0);
        self.settle(closed, &[])?;
        let mut longest = options.longest.min(1e-3 * self.span);
        let (mut at_once, mut since) = (0, self.state.t);
        while self.state.t < options.until {
            let left = options.until - self.state.t;
            let stepped = self
                .flow
                .step(
                    &self.state,
                    longest.min(left),
                    &self.bearings,
                    &self.largest,
                )
                .ok_or_else(|| self.stuck())?;
            self.steps += 1;
            self.state = stepped.state;
            if self.state.t + 1e-15 * options.until.abs() >= options.until {
                self.state.t = options.until;
            }
            longest = stepped.next.min(options.longest);
            self.look();
            sample(&self.state.clone());
            if stepped.events.is_empty() {
                continue;
            }
            at_once += 1;
            if self.state.t > since + AT_ONE_TIME * self.span {
                (at_once, since) = (0, self.state.t);
            }
            if at_once > AT_ONCE {
                return Err(self.stuck());
            }
            self.happen(&stepped.events)?;
            longest = longest.min(1e-3 * self.span);
        }
        Ok(())
    }

    fn stuck(&self) -> Ended {
        Ended::Stuck {
            contacts: self.bearings.iter().map(|b| b.0).collect(),
        }
    }

    fn look(&mut self) {
        // A coordinate that has not moved yet is as right as a way of the whole size is.
        let floor = 1e-6 * self.flow.world.size();
        for k in 0..self.state.q.len() {
            self.largest.0[k] = self.largest.0[k].max(self.state.q[k].abs()).max(floor);
        }
        let fastest = self.largest.1.amax().max(self.state.v.amax());
        let floor = (1e-6 * fastest).max(1e-6 * self.flow.world.size() / self.span);
        for k in 0..self.state.v.len() {
            self.largest.1[k] = self.largest.1[k].max(self.state.v[k].abs()).max(floor);
        }
    }

    fn touch(&self, contact: usize) -> Touch {
        self.flow.world.touch(contact, &self.state.q)
    }

    /// Contacts that are closed, to a gap more than rounding.
    fn closed(&self, more: f64) -> Vec<usize> {
        let limit = CLOSED * self.flow.world.size() + more;
        (0..self.flow.world.contacts())
            .filter(|&i| self.touch(i).gap <= limit)
            .collect()
    }

    /// A rate that counts as none, of a row.
    fn still(&self, row: &DVector<f64>) -> f64 {
        let terms = row.iter().zip(self.largest.1.iter());
        STILL * terms.map(|(r, v)| (r * v).abs()).sum::<f64>()
    }

    fn happen(&mut self, events: &[(usize, Watched)]) -> Result<(), Ended> {
        let before = self.bearings.clone();
        let mut closed: Vec<usize> = self.closed(0.0);
        for &(contact, kind) in events {
            if kind == Watched::Gap && !closed.contains(&contact) {
                closed.push(contact);
            }
        }
        for &(contact, _) in &before {
            if !closed.contains(&contact) {
                closed.push(contact);
            }
        }
        closed.sort_unstable();
        // A contact whose sliding came to its end does not slide at this moment, whatever rounding says.
        let halted: Vec<usize> = (events.iter())
            .filter(|e| e.1 == Watched::Sliding)
            .map(|e| e.0)
            .collect();
        self.settle(closed, &halted)?;
        for &(contact, mode) in &before {
            let now = self.bearings.iter().find(|b| b.0 == contact).map(|b| b.1);
            let kind = match (mode, now) {
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
        self.events.push(Event {
            t: self.state.t,
            kind,
            contact,
        });
    }

    /// Impacts of the contacts that are closed, then what each of them does from now on.
    fn settle(&mut self, mut closed: Vec<usize>, halted: &[usize]) -> Result<(), Ended> {
        /// Impacts follow each other at one time where contacts pass them on.
        const MOST: usize = 50;
        let known: Vec<usize> = self.bearings.iter().map(|b| b.0).collect();
        let mut struck = Vec::new();
        for _ in 0..MOST {
            let strikes = |i: &usize| {
                let touch = self.touch(*i);
                touch.normal.dot(&self.state.v) < -self.still(&touch.normal)
            };
            let hits: Vec<usize> = closed.iter().copied().filter(strikes).collect();
            if hits.is_empty() {
                break;
            }
            for &hit in &hits {
                if !struck.contains(&hit) {
                    struck.push(hit);
                }
            }
            self.impact(&closed)?;
        }
        if !struck.is_empty() {
            self.impacts.add(self.state.t);
            for &contact in &struck {
                self.tell(EventKind::Impact, contact);
            }
            let parts = |&i: &usize| self.touch(i).normal.dot(&self.state.v);
            let way = closed.iter().map(parts).fold(0.0, f64::max) / self.flow.world.size();
            if let Some(left) = self.impacts.rest(self.span, way) {
                // What bounces is closed for good: the rates at which it opens are gone in the limit.
                closed = self.closed(way * left * self.flow.world.size());
                let stay = closed.iter().map(|&i| (i, Mode::Forward)).collect();
                let state = self.flow.projected(self.state.clone(), &stay);
                self.state = state.ok_or_else(|| self.stuck())?;
                let v = self.state.v.clone();
                self.state.q += v * left;
                self.state.t += left;
                for &contact in &closed {
                    self.tell(EventKind::Rest, contact);
                }
                self.impacts = Impacts::default();
            }
        }
        // Those that part are open from now on.
        let stays = |i: &usize| {
            let touch = self.touch(*i);
            touch.normal.dot(&self.state.v) <= self.still(&touch.normal)
        };
        let resting: Vec<usize> = closed.into_iter().filter(stays).collect();
        let mut problem = self.problem(&resting);
        for (k, i) in resting.iter().enumerate() {
            if halted.contains(i) {
                problem.bearings[k].slides = None;
            }
        }
        let solution = self.one(problem.solutions(), &resting)?;
        self.bearings = (resting.iter().copied())
            .zip(solution.modes)
            .filter(|(_, mode)| *mode != Mode::Open)
            .collect();
        if let Some(state) = self.flow.projected(self.state.clone(), &self.bearings) {
            self.state = state;
        }
        for (contact, _) in self.bearings.clone() {
            if !known.contains(&contact) && !struck.contains(&contact) && self.steps > 0 {
                self.tell(EventKind::Touch, contact);
            }
        }
        Ok(())
    }

    fn problem(&self, contacts: &[usize]) -> Problem<'_> {
        let mut problem = self.flow.problem(&self.state, contacts, 0.0);
        for (k, &i) in contacts.iter().enumerate() {
            let tangent = self.touch(i).tangent;
            let rate = tangent.dot(&self.state.v);
            let slides = rate.abs() > self.still(&tangent);
            problem.bearings[k].slides = slides.then_some(rate.signum());
        }
        problem
    }

    /// Newton's law of impact along normals, Coulomb's for impulses across them, all closed contacts at once.
    fn impact(&mut self, closed: &[usize]) -> Result<(), Ended> {
        let world = self.flow.world;
        let (_, joints) = world.joints(self.state.t, &self.state.q);
        let (rates, _) = world.drift(self.state.t);
        let bearings = (closed.iter())
            .map(|&i| {
                let touch = self.touch(i);
                let surface = world.surface(i);
                let rate = touch.normal.dot(&self.state.v);
                Bearing {
                    b: surface.restitution * rate.min(0.0),
                    c: 0.0,
                    normal: touch.normal,
                    tangent: touch.tangent,
                    friction: surface.friction,
                    slides: None,
                }
            })
            .collect();
        let problem = Problem {
            mass: world.mass(),
            h: world.mass() * &self.state.v,
            joints,
            j: rates,
            bearings,
            zero: ZERO,
        };
        let solution = self.one(problem.solutions(), closed)?;
        self.state.v = solution.x;
        Ok(())
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
