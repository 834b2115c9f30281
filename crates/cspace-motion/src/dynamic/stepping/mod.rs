//! Moreau–Jean time stepping: steps of one length, with impulses for all that happens in each.
//!
//! ```text
//! q_m = q + h/2 v                                    contacts of which the gap is closed there have impulses λ
//! M (v' − v) = h f(t + h/2, q_m, v) + Jᵀ μ + Hᵀ λ
//! q' = q + h/2 (v + v')                              then joints are brought to where they hold
//! 0 ≤ λ_N ⟂ u_N' + e min(u_N, 0) ≥ 0                 Newton's law of impact, along normals
//! |λ_T| ≤ μ λ_N, against u_T'                        Coulomb's, of impulses; e_T = 0
//! ```
//!
//! Events are not located: an impact is late or early by a step at most, and parts overlap by up to the displacement in
//! one step. Errors fall with h. The scheme shares the mechanism with the event-driven motion, and neither its steps
//! nor, but where sweeps do not converge, its method for contacts: each is a check of the other. After J. J. Moreau (1988) and M. Jean (1999); joints are
//! not penalised but eliminated from the problem of contacts exactly, once by their directions at q_m, so that they
//! neither brake nor drive, and once by those at q'.

mod joined;
mod story;
mod sweeps;

use std::collections::HashMap;

use nalgebra::{DMatrix, DVector};

use super::flow::ZERO;
use super::motion::{Ended, Motion, Observer, Work};
use super::world::{Acting, State, Touch, World};
use crate::complementarity::Problem;

use joined::{Joined, held};
use story::Story;
use sweeps::Impulses;

/// Contacts are searched within this multiple of the penetration plus the displacement in a step.
const FARTHER: f64 = 2.0;
/// Parts that overlap by more than this multiple of the farthest displacement in a step are not kept apart by their contacts: what is met
/// is as deep as one displacement, and curved contacts drift.
const DEEPER: f64 = 2.0;
/// And by more than this share of the size of what moves.
const DEEP: f64 = 0.01;
/// A step is too long in which parts move by more than this share of the thinnest.
const COARSE: f64 = 0.5;
/// Times within this share of a step are one.
const SAME_TIME: f64 = 1e-6;

/// Computes a motion from a state until a time in a number of steps; `observer` receives states, interpolated linearly
/// between those of steps, and the events after all else.
///
/// `open` is the largest penetration of contacts. Energy balances but for the errors of steps.
pub fn step_through<W: World + ?Sized>(
    world: &W,
    start: State,
    until: f64,
    steps: usize,
    observer: &mut dyn Observer,
) -> Motion {
    let mut stepping = Stepping {
        world,
        inverse: DMatrix::zeros(0, 0),
        start: start.t,
        h: (until - start.t) / steps as f64,
        known: HashMap::new(),
        story: Story::default(),
        open: 0.0,
        fastest: 0.0,
        coarse: COARSE * world.thinnest(),
        work: Work::default(),
    };
    let mut first = start.clone();
    let mut state = start;
    let mut taken = 0;
    let ended = match world.mass().clone().try_inverse() {
        Some(inverse) => {
            stepping.inverse = inverse;
            // Parts joined to driven parts move with them from the start on.
            if let Some(joined) = Joined::at(world, &stepping.inverse, state.t, &state.q) {
                state.v = joined.allowed(&state.v);
            }
            first.v.clone_from(&state.v);
            (stepping.go(&mut state, steps, &mut taken, observer).err()).unwrap_or(Ended::Done)
        }
        None => stuck(Vec::new()),
    };
    if ended == Ended::Done {
        state.t = until;
    }
    let events = stepping.story.events();
    for (event, at) in &events {
        observer.event(event, at);
    }
    let events = events.into_iter().map(|e| e.0).collect();
    Motion {
        ended,
        first,
        last: state,
        events,
        steps: taken,
        open: stepping.open,
        work: stepping.work,
    }
}

fn stuck(contacts: Vec<usize>) -> Ended {
    Ended::Stuck { contacts }
}

/// The number of a contact, and its impulses along the normal and the tangent.
type Impulse = (usize, f64, f64);

struct Stepping<'a, W: World + ?Sized> {
    world: &'a W,
    /// Inverse of the mass matrix.
    inverse: DMatrix<f64>,
    start: f64,
    h: f64,
    /// The impulses of the last step.
    known: HashMap<usize, [f64; 2]>,
    story: Story,
    open: f64,
    /// The largest speed so far.
    fastest: f64,
    /// A step in which parts move by more than this is too long where they may meet.
    coarse: f64,
    work: Work,
}

/// Result of a step.
struct Taken {
    to: State,
    contacts: Vec<(usize, f64, f64)>,
    joints: DVector<f64>,
}

/// A contact in a step.
struct Active {
    contact: usize,
    touch: Touch,
    /// The rate of opening before the step, and without impulses of contacts.
    opening: f64,
    pushed: f64,
}

impl<W: World + ?Sized> Stepping<'_, W> {
    fn go(
        &mut self,
        state: &mut State,
        steps: usize,
        taken: &mut usize,
        observer: &mut dyn Observer,
    ) -> Result<(), Ended> {
        /// Between two questions whether to go on.
        const OFTEN: usize = 64;
        let world = self.world;
        state.q = held(world, &self.inverse, state.t, state.q.clone())
            .ok_or_else(|| stuck(Vec::new()))?;
        for step in 0..steps {
            if step.is_multiple_of(OFTEN) && !observer.goes_on(state.t) {
                return Err(Ended::Interrupted);
            }
            let next = self.step(state, step)?;
            self.show(state, &next, observer);
            *state = next.to;
            *taken = step + 1;
        }
        Ok(())
    }

    fn time(&self, step: usize) -> f64 {
        self.start + step as f64 * self.h
    }

    fn step(&mut self, from: &State, step: usize) -> Result<Taken, Ended> {
        let (world, h) = (self.world, self.h);
        let end = self.time(step + 1);
        let middle = State {
            t: from.t + 0.5 * h,
            q: &from.q + &from.v * (0.5 * h),
            v: from.v.clone(),
        };
        let pushed = &self.inverse * world.force(&middle) * h;
        let failed = || stuck(Vec::new());
        // Joints turn the rates about their directions in the middle, half a turn before it and half after.
        let there = Joined::at(world, &self.inverse, middle.t, &middle.q).ok_or_else(failed)?;
        let mut free = &from.v + &pushed;
        free -= there.change(&(there.missed(&from.v) + there.missed(&free)));
        let ahead = &from.q + (&from.v + &free) * (0.5 * h);
        let joined = Joined::at(world, &self.inverse, end, &ahead).ok_or_else(failed)?;
        let free = joined.allowed(&free);

        let active = self.active(&middle, &free)?;
        let mut to = State {
            t: end,
            q: ahead,
            v: free,
        };
        let mut contacts = Vec::new();
        if !active.is_empty() {
            contacts = self.push(&active, &joined, &mut to.v)?;
        }
        let q = &from.q + (&from.v + &to.v) * (0.5 * h);
        to.q = held(world, &self.inverse, end, q).ok_or_else(failed)?;
        let mut held = &to.v - &from.v - &pushed;
        for (a, &(_, n, t)) in active.iter().zip(&contacts) {
            held -= &self.inverse * (&a.touch.normal * n + &a.touch.tangent * t);
        }
        let joints = joined.multipliers(world.mass(), &held);
        self.book(from, &to, &middle, (step, &active), (&contacts, &joints));
        Ok(Taken {
            to,
            contacts,
            joints,
        })
    }

    /// Largest distance from contact, in the middle of a step, of parts that count as closed, given the speed there.
    fn way(&self, speed: f64) -> f64 {
        FARTHER * (self.open + self.h * speed)
    }

    /// The contacts that are closed in the middle of a step.
    fn active(&mut self, middle: &State, free: &DVector<f64>) -> Result<Vec<Active>, Ended> {
        let world = self.world;
        let speed = world.speed(middle);
        let found = world.overlapping(middle.t, &middle.q, self.way(speed));
        let found = found.ok_or_else(|| stuck(Vec::new()))?;
        let mut active = Vec::new();
        self.fastest = self.fastest.max(speed);
        let displacement = self.h * speed;
        if displacement > self.coarse
            && world.clearance(middle.t, &middle.q) <= FARTHER * displacement
        {
            return Err(Ended::Coarse { displacement });
        }
        let deepest = (DEEPER * self.h * self.fastest).max(DEEP * world.size());
        for contact in found {
            let touch = world.touch(contact, middle.t, &middle.q);
            self.open = self.open.max(-touch.gap);
            if -touch.gap > deepest {
                return Err(stuck(vec![contact]));
            }
            active.push(Active {
                contact,
                opening: touch.opening(&middle.v),
                pushed: touch.opening(free),
                touch,
            });
        }
        Ok(active)
    }

    /// Adds the impulses of contacts to rates.
    fn push(
        &mut self,
        active: &[Active],
        joined: &Joined,
        v: &mut DVector<f64>,
    ) -> Result<Vec<(usize, f64, f64)>, Ended> {
        let world = self.world;
        let count = active.len();
        let mut rows = DMatrix::zeros(2 * count, v.len());
        let mut rates = DVector::zeros(2 * count);
        let mut guess = DVector::zeros(2 * count);
        let mut friction = Vec::with_capacity(count);
        for (k, a) in active.iter().enumerate() {
            let surface = world.surface(a.contact);
            rows.set_row(2 * k, &a.touch.normal.transpose());
            rows.set_row(2 * k + 1, &a.touch.tangent.transpose());
            rates[2 * k] = a.pushed + surface.restitution * a.opening.min(0.0);
            rates[2 * k + 1] = a.touch.sliding(v);
            friction.push(surface.friction);
            let [n, t] = self.known.get(&a.contact).copied().unwrap_or_default();
            (guess[2 * k], guess[2 * k + 1]) = (n, t);
        }
        let moved = &self.inverse * rows.transpose();
        let alone = DVector::from_fn(2 * count, |i, _| {
            rows.row(i).transpose().dot(&moved.column(i))
        });
        let moved = joined.free(&moved);
        let w = &rows * &moved;
        let problem = Impulses {
            w: &w,
            free: &rates,
            friction: &friction,
            alone: &alone,
        };
        let solved = problem.solved(guess);
        let solved = solved.or_else(|| self.pivoted(active, joined, v));
        let impulses = solved.ok_or_else(|| Ended::Jammed {
            contacts: active.iter().map(|a| a.contact).collect(),
        })?;
        *v += moved * &impulses;
        self.known.clear();
        let of = |k: usize, a: &Active| (a.contact, impulses[2 * k], impulses[2 * k + 1]);
        let all: Vec<_> = active.iter().enumerate().map(|(k, a)| of(k, a)).collect();
        self.known.extend(all.iter().map(|&(i, n, t)| (i, [n, t])));
        Ok(all)
    }

    /// Impulses as [`Impulses::solved`] has them, by pivots: sweeps hardly converge where many contacts share a load.
    fn pivoted(
        &self,
        active: &[Active],
        joined: &Joined,
        v: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let bearing = |a: &Active| {
            let surface = self.world.surface(a.contact);
            a.touch.clone().struck(a.opening, surface)
        };
        let mass = self.world.mass();
        let problem = Problem {
            mass,
            h: mass * v,
            joints: joined.joints.rows.clone(),
            j: joined.joints.rates.clone(),
            bearings: active.iter().map(bearing).collect(),
            zero: ZERO,
        };
        let solution = problem.solutions().into_iter().next()?;
        let both = solution.normal.iter().zip(&solution.tangential);
        let impulses: Vec<f64> = both.flat_map(|(&n, &t)| [n, t]).collect();
        Some(DVector::from_vec(impulses))
    }

    /// Events and energy of a step.
    fn book(
        &mut self,
        from: &State,
        to: &State,
        middle: &State,
        (step, active): (usize, &[Active]),
        (contacts, joints): (&[Impulse], &DVector<f64>),
    ) {
        let (world, h) = (self.world, self.h);
        let mean = State {
            t: middle.t,
            q: middle.q.clone(),
            v: (&from.v + &to.v) * 0.5,
        };
        let way = self.way(self.world.speed(middle));
        // A contact that goes on by itself is no other's.
        let goes_on = |a: usize| contacts.iter().any(|c| c.0 == a && c.1 != 0.0);
        let is_same = |a: usize, b: usize| {
            a == b || (!goes_on(a) && world.passes(a, b, middle.t, &middle.q, way))
        };
        let mut strikes = false;
        for (a, &(contact, n, _)) in active.iter().zip(contacts) {
            if n == 0.0 {
                continue;
            }
            let is_impact = !self.story.bears(contact, &is_same)
                && Story::strikes(-a.opening, a.pushed - a.opening);
            strikes |= is_impact;
            self.story
                .impulse((step, from, to), contact, is_impact, &is_same);
        }
        self.story.over(step);
        let accelerations = (&to.v - &from.v) / h;
        let acting = Acting {
            accelerations: Some(&accelerations),
            contacts: contacts
                .iter()
                .map(|&(i, n, t)| (i, n / h, t / h))
                .collect(),
            joints: &(joints / h),
        };
        let [put_in, taken] = world.powers(&mean, &acting);
        self.work.drives += put_in * h;
        if strikes {
            // All that is lost in a step with an impact counts as its.
            let before = world.kinetic(from);
            let pushed = world.force(middle).dot(&mean.v) * h;
            self.work.impacts += before + pushed + put_in * h - world.kinetic(to);
        } else {
            self.work.friction += taken * h;
        }
    }

    /// The samples that are due within a step.
    fn show(&self, from: &State, taken: &Taken, observer: &mut dyn Observer) {
        let (to, h) = (&taken.to, self.h);
        loop {
            let t = observer.next();
            if t > to.t + SAME_TIME * h {
                return;
            }
            let share = ((t - from.t) / h).clamp(0.0, 1.0);
            let between = |a: &DVector<f64>, b: &DVector<f64>| a * (1.0 - share) + b * share;
            let state = State {
                t,
                q: between(&from.q, &to.q),
                v: between(&from.v, &to.v),
            };
            let accelerations = (&to.v - &from.v) / h;
            let acting = Acting {
                accelerations: Some(&accelerations),
                contacts: (taken.contacts.iter())
                    .filter(|c| c.1 != 0.0)
                    .map(|&(i, n, t)| (i, n / h, t / h))
                    .collect(),
                joints: &(&taken.joints / h),
            };
            observer.sample(&state, &acting);
            if observer.next() <= t {
                // One that wants the same time again has had it.
                return;
            }
        }
    }
}
