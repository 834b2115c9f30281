//! Events: changes of rates at an event, and the mode of each contact after it.

use std::collections::HashMap;

use nalgebra::DVector;

use super::STILL;
use super::accumulate::Impacts;
use super::motion::{Choice, Ended, Event, EventKind};
use super::run::{Reached, Run};
use super::step::Watched;
use super::world::{State, Step, Surface, Touch, World};
use crate::complementarity::{Mode, Problem, Solution};

/// Lengths of trials of one of several sets of contacts, as shares of the size: beyond the error of contacts, and
/// shorter than the distance to the next event. A shorter one is used where another event follows at once.
const TRIALS: [f64; 4] = [1e-6, 1e-7, 1e-8, 3e-9];
/// Contacts that cease to stick within this share of the time that is simulated do so together.
const LOOSE: f64 = 1e-8;
/// The part of a gap's acceleration due to curvature and rates counts as rounding if in the longest step it moves the
/// gap by less than this share of the size. An example is a part that turns about the centre of an arc that touches.
const SLIGHT: f64 = 1e-15;
/// Share of the largest rate so far below which a rate counts as slow.
const SLOW: f64 = 1e-5;

impl<W: World + ?Sized> Run<'_, W> {
    pub(super) fn touch(&self, contact: usize) -> Touch {
        let state = &self.state;
        self.flow.world.touch(contact, state.t, &state.q)
    }

    pub(super) fn is_same(&self, a: usize, b: usize) -> bool {
        let state = &self.state;
        self.flow.world.is_same(a, b, state.t, &state.q)
    }

    /// A rate that counts as none, of a row.
    pub(super) fn still(&self, row: &DVector<f64>) -> f64 {
        /// Rounding of a row, as a share of its length: a part that moves across a normal moves along it by as much.
        const ROUNDING: f64 = 16.0 * f64::EPSILON;
        let terms = row.iter().zip(self.largest.iter());
        let sum: f64 = terms.map(|(r, v)| (r * v).abs()).sum();
        STILL * sum + ROUNDING * row.norm() * self.largest.norm()
    }

    /// The rate at which a closed contact opens, and what counts as none.
    pub(super) fn opening(&self, contact: usize) -> (f64, f64) {
        let touch = self.touch(contact);
        let still = self.still(&touch.normal) + STILL * touch.drift[0].abs();
        (touch.opening(&self.state.v), still)
    }

    pub(super) fn happen(&mut self, events: &[(usize, Watched)]) -> Result<(), Ended> {
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
        if self.bearings != before {
            self.looked.steady.clear();
        }
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

    pub(super) fn tell(&mut self, kind: EventKind, contact: usize) {
        let t = self.state.t;
        let told = self.events.iter().rev().take_while(|e| e.t == t);
        // Features that take each other's place are one contact.
        let mut same = told.filter(|e| e.kind == kind);
        if same.any(|e| self.is_same(e.contact, contact)) {
            return;
        }
        self.events.push(Event::of(t, kind, contact));
    }

    /// Determines the modes of the closed contacts from now on: the first of the world's alternatives by which the
    /// motion goes on.
    pub(super) fn settle(&mut self, closed: Vec<usize>, at: &Reached) -> Result<(), Ended> {
        let closed = self.in_the_way(closed);
        let mut sets = (self.flow.world).alternatives(&closed, self.state.t, &self.state.q);
        let is_one = sets.len() < 2;
        let ending = self.ending(&closed);
        if !ending.is_empty() {
            let goes_on = |set: &Vec<usize>| -> Vec<usize> {
                let all = set.iter().copied();
                all.filter(|i| !ending.contains(i)).collect()
            };
            let others: Vec<Vec<usize>> = sets.iter().map(goes_on).collect();
            sets.extend(others);
        }
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
        if is_one {
            return self.settle_with(closed, at);
        }
        Err(failed.unwrap_or(Ended::Stuck { contacts: closed }))
    }

    /// If no closed contact strikes: the contacts whose features do not touch any more a very little later although
    /// they do not part. An example is the edge of a notch, once a part that bridges the notch rests on its other side.
    fn ending(&self, closed: &[usize]) -> Vec<usize> {
        let State { t, q, v } = &self.state;
        let world = self.flow.world;
        let speed = world.reach(v);
        if speed == 0.0 || closed.iter().any(|&i| self.strikes(i)) {
            return Vec::new();
        }
        let h = TRIALS[0] * world.size() / speed;
        let ahead = (t + h, q + v * h);
        let ends = |&i: &usize| {
            let (rate, still) = self.opening(i);
            rate <= still && !world.is_there(i, ahead.0, &ahead.1)
        };
        closed.iter().copied().filter(ends).collect()
    }

    /// The closed contacts without those that would strike while another at the same convex corner does not and is not overlapping: parts
    /// pass each other there. And without those that are yet to close.
    fn in_the_way(&self, mut closed: Vec<usize>) -> Vec<usize> {
        let world = self.flow.world;
        let (hits, others): (Vec<usize>, Vec<usize>) =
            closed.iter().partition(|&&i| self.strikes(i));
        let overlaps = |&i: &usize| {
            let gap = self.touch(i).gap;
            world.seat(i, gap).is_some_and(|seat| gap < seat)
        };
        let apart: Vec<usize> = others.into_iter().filter(|i| !overlaps(i)).collect();
        let is_passed = |hit: usize| {
            let mut apart = apart.iter();
            apart.any(|&o| world.one_is_enough(hit, o) && self.is_same(hit, o))
        };
        let is_closed = |i: usize| {
            let bears = self.bearings.iter().any(|b| b.0 == i);
            bears || world.seat(i, self.touch(i).gap).is_some()
        };
        closed.retain(|&i| is_closed(i) && !(hits.contains(&i) && is_passed(i)));
        closed
    }

    /// Whether a closed contact has a rate that closes it further.
    fn strikes(&self, contact: usize) -> bool {
        let (rate, still) = self.opening(contact);
        rate < -still
    }

    /// Whether a very short step, with a length given as a share of the size, meets nothing.
    pub(super) fn leads_on(&self, scale: f64) -> bool {
        /// Largest ratio of a trial's actual length to the intended one.
        const FARTHER: f64 = 10.0;
        /// Factor by which the duration of a trial that is too long is shortened, repeatedly down to rounding.
        const SHORTER: f64 = 0.1;
        const MOST: usize = 16;
        let far = scale * self.flow.world.size();
        let speed = self.flow.world.reach(&self.state.v);
        let mut h = (far / speed).min(1e-3 * self.span);
        let bearing: Vec<usize> = self.bearings.iter().map(|b| b.0).collect();
        for _ in 0..MOST {
            if let Some(taken) = self.flow.take(self.span_from(&self.state), h)
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
    pub(super) fn settle_with(
        &mut self,
        mut closed: Vec<usize>,
        at: &Reached,
    ) -> Result<(), Ended> {
        /// Impacts follow each other at one time where contacts pass them on.
        const MOST: usize = 50;
        let known: Vec<usize> = self.bearings.iter().map(|b| b.0).collect();
        let (mut struck, mut rested) = (Vec::new(), Vec::new());
        for round in 0..=MOST {
            let hits: Vec<usize> = closed
                .iter()
                .copied()
                .filter(|&i| self.strikes(i))
                .collect();
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
                // Bouncing contacts are closed for good: the rates at which they open are gone in the limit.
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
                    // A contact that slides no longer than the impacts last sticks in the limit.
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
        // Contacts that separate are open from now on.
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
        let (solution, choice) = self.one(&problem, problem.solutions(), &resting)?;
        let goes_on = self.goes_on(&problem, &solution, &resting);
        self.bearings = (resting.iter().copied())
            .zip(goes_on.unwrap_or(solution.modes))
            .filter(|(_, mode)| *mode != Mode::Open)
            .collect();
        self.choose(choice);
        self.flow.seats = self.seats();
        if let Some((state, _)) = self.flow.projected(self.state.clone(), &self.bearings) {
            self.state = state;
        }
        self.looked.idle = self.flow.idle(&self.state, &self.bearings);
        for (contact, _) in self.bearings.clone() {
            // A contact that has come to rest has no event of touching as well.
            let mut before = known.iter().chain(&rested);
            if !before.any(|&k| k == contact || self.is_same(k, contact)) {
                self.tell(EventKind::Touch, contact);
            }
        }
        Ok(())
    }

    /// The gaps at which the contacts that bear are held: those at which they have been, or with which they are found.
    fn seats(&self) -> HashMap<usize, f64> {
        let seat = |i: usize| {
            let known = self.flow.seats.get(&i).copied();
            known.or_else(|| self.flow.world.seat(i, self.touch(i).gap))
        };
        (self.bearings.iter())
            .filter_map(|b| seat(b.0).map(|seat| (b.0, seat)))
            .collect()
    }

    /// Modes of contacts of which some have neither a force nor an acceleration, from the forces a little later: the
    /// present state does not determine which of them bear, as where a box comes to be balanced on the edge of a step.
    /// `None` if all of them have one, or the later forces are ambiguous.
    fn goes_on(
        &self,
        problem: &Problem<'_>,
        solution: &Solution,
        resting: &[usize],
    ) -> Option<Vec<Mode>> {
        let state = &self.state;
        let speed = self.flow.world.reach(&state.v);
        if speed == 0.0 || !problem.is_tied(solution) {
            return None;
        }
        let h = (TRIALS[0] * self.flow.world.size() / speed).min(1e-3 * self.span);
        let ahead = State {
            t: state.t + h,
            q: &state.q + &state.v * h + &solution.x * (0.5 * h * h),
            v: &state.v + &solution.x * h,
        };
        let mut later = self.problem_at(&ahead, resting);
        for (later, now) in later.bearings.iter_mut().zip(&problem.bearings) {
            later.slides = now.slides;
            later.lets_go = now.lets_go;
        }
        match &later.solutions()[..] {
            [only] => Some(only.modes.clone()),
            _ => None,
        }
    }

    pub(super) fn problem(&self, contacts: &[usize]) -> Problem<'_> {
        self.problem_at(&self.state, contacts)
    }

    fn problem_at(&self, state: &State, contacts: &[usize]) -> Problem<'_> {
        let mut problem = self.flow.problem(state, contacts, 0.0);
        let far = self.flow.world.longest(state);
        for (k, &i) in contacts.iter().enumerate() {
            let touch = self.flow.world.touch(i, state.t, &state.q);
            let rate = touch.sliding(&state.v);
            if problem.bearings[k].b.abs() * far * far < SLIGHT * self.flow.world.size() {
                problem.bearings[k].b = 0.0;
            }
            let still = self.still(&touch.tangent) + STILL * touch.drift[1].abs();
            let slides = rate.abs() > still;
            problem.bearings[k].slides = slides.then_some(rate.signum());
        }
        problem
    }

    /// Contacts do not open any more: the impulses, of either sign, that take away the rates at which they do, and what gaps are left.
    ///
    /// Halted contacts do not slide either.
    pub(super) fn stay(&mut self, closed: &[usize], halted: &[usize]) -> Result<(), Ended> {
        let mode = |i: &usize| match halted.contains(i) {
            true => Mode::Stick,
            false => Mode::Forward,
        };
        let modes: Vec<Mode> = closed.iter().map(mode).collect();
        let solution = self.impulses(closed, &|_| Surface::DEAD).within(&modes);
        self.pass(&solution.ok_or_else(|| self.stuck())?, closed);
        self.flow.seats.clear();
        let bearings = closed.iter().copied().zip(modes).collect();
        let state = self.flow.projected(self.state.clone(), &bearings);
        self.state = state.ok_or_else(|| self.stuck())?.0;
        Ok(())
    }

    /// The solution that is taken, and of several what else there is.
    pub(super) fn one(
        &self,
        problem: &Problem<'_>,
        mut solutions: Vec<Solution>,
        contacts: &[usize],
    ) -> Result<(Solution, Option<Choice>), Ended> {
        match solutions.len() {
            0 => Err(match &problem.contradictions()[..] {
                [] => Ended::Stuck {
                    contacts: contacts.to_vec(),
                },
                some => Ended::Inconsistent {
                    contacts: some.iter().map(|&k| contacts[k]).collect(),
                },
            }),
            1 => Ok((solutions.remove(0), None)),
            _ => (problem.chosen(solutions, contacts).filter(|_| !self.strict))
                .map(|(solution, choice)| (solution, Some(choice)))
                .ok_or_else(|| Ended::Undetermined {
                    contacts: contacts.to_vec(),
                }),
        }
    }

    /// Reports a choice.
    pub(super) fn choose(&mut self, choice: Option<Choice>) {
        if let Some(choice) = choice {
            let event = Event::of(self.state.t, EventKind::Choice, choice.contacts[0]);
            self.events.push(Event {
                choice: Some(choice),
                ..event
            });
        }
    }
}
