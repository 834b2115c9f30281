//! Steps over a time in which events cannot be told apart, or no modes of the contacts lead on.
//!
//! Moreau's and Jean's steps ([`stepping`](super::stepping)) need neither: all that happens in a step is one problem of impulses. A bridge
//! takes a few of them, so short that parts move by a small share of their size in each, and overlap by no more; then gaps are
//! closed exactly, and the motion is tried from event to event again. Where that fails at once, the next bridge takes over, and steps become
//! longer.

use super::CLOSED;
use super::motion::{Event, EventKind, Observer, Options};
use super::run::Run;
use super::stepping::step_through;
use super::world::{Acting, State, World};
use crate::complementarity::Mode;

/// Displacements in a step, as shares of the size: of the first bridges of a row, and of later ones.
const SHARES: [f64; 3] = [1e-8, 1e-7, 1e-6];
/// Number of bridges in a row that have the same length of steps.
const ALIKE: usize = 4;
/// Number of steps of a bridge: of the first of a row, and of the longest.
const STEPS: [usize; 2] = [16, 1024];

/// An observer to whom the events of steps are not told: they are late or early by a step.
struct Quiet<'o>(&'o mut dyn Observer);

impl Observer for Quiet<'_> {
    fn next(&self) -> f64 {
        self.0.next()
    }

    fn sample(&mut self, state: &State, acting: &Acting<'_>) {
        self.0.sample(state, acting);
    }

    fn goes_on(&self, t: f64) -> bool {
        self.0.goes_on(t)
    }
}

impl<W: World + ?Sized> Run<'_, W> {
    /// Goes on by steps for a short time, from where a contact leads no further. Returns whether it could.
    pub(super) fn bridge(
        &mut self,
        contact: usize,
        options: &Options,
        observer: &mut dyn Observer,
    ) -> bool {
        let left = options.until - self.state.t;
        let Some(row) = self.bridges.next(self.state.t, left).filter(|_| left > 0.0) else {
            return false;
        };
        let world = self.flow.world;
        let far = SHARES[(row / ALIKE).min(SHARES.len() - 1)] * world.size();
        let steps = (STEPS[0] << row.min(STEPS[1].ilog2() as usize)).min(STEPS[1]);
        let from = self.state.t;
        let time = (steps as f64 * self.time_for(far)).min(left);
        let until = match time < left {
            true => from + time,
            false => options.until,
        };
        let start = self.state.clone();
        let stepped = step_through(world, start, until, steps, &mut Quiet(observer));
        if stepped.steps < steps {
            return false;
        }
        self.state = stepped.last;
        self.work.drives += stepped.work.drives;
        self.work.friction += stepped.work.friction;
        self.work.impacts += stepped.work.impacts;
        self.seat_closed(stepped.open.max(far));
        self.look();
        observer.step(&self.state);
        let told = self.events.len();
        self.events.push(Event {
            bridge: Some([self.state.t, stepped.open]),
            ..Event::of(from, EventKind::Bridge, contact)
        });
        self.announce(told, observer);
        self.bridges.ended(from, self.state.t);
        true
    }

    /// The time in which parts move by a length.
    fn time_for(&self, length: f64) -> f64 {
        let world = self.flow.world;
        let forced = self.flow.pushed(&world.force(&self.state));
        let by_speed = length / world.speed(&self.state);
        let by_force = (2.0 * length / world.reach(&forced)).sqrt();
        by_speed.min(by_force).min(1e-3 * self.span)
    }

    /// Brings contacts that steps have left closed, or overlapping by no more than `way`, to where they are closed exactly.
    fn seat_closed(&mut self, way: f64) {
        let world = self.flow.world;
        let State { t, q, .. } = &self.state;
        let mut closed = world.closed(*t, q);
        closed.extend(world.overlapping(*t, q, way).unwrap_or_default());
        closed.sort_unstable();
        closed.dedup();
        // A contact that opens faster than steps let it has left.
        let stays = |&i: &usize| {
            let (rate, still) = self.opening(i);
            rate.abs() <= still.max(way / self.time_for(way))
        };
        let resting = closed.into_iter().filter(stays);
        let bearings = resting.map(|i| (i, Mode::Forward)).collect();
        self.flow.seats.clear();
        if let Some((state, _)) = self.flow.projected(self.state.clone(), &bearings) {
            self.state = state;
        }
        let limit = CLOSED * world.size();
        let open: Vec<usize> = (self.bearings.iter())
            .map(|b| b.0)
            .filter(|&i| self.touch(i).gap > limit)
            .collect();
        self.bearings.retain(|b| !open.contains(&b.0));
        for contact in open {
            self.tell(EventKind::Release, contact);
        }
    }
}
