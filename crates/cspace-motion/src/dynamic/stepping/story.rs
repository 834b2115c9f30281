//! Events from the impulses of steps, as far as steps can resolve them.

use super::super::motion::{Event, EventKind};
use super::super::world::State;

/// A contact counts as lasting if it bears in so many of the last steps; one that bears in none of them has opened.
const LASTS: usize = 5;
/// A contact strikes if it closes at more than this multiple of the rate that forces produce in a step.
const STRIKES: f64 = 4.0;

/// A contact that has impulses.
struct Bearing {
    contact: usize,
    /// Before the step in which it began.
    began: State,
    /// Last step with an impulse, and the state after it.
    last: usize,
    after: State,
    /// Number of steps with an impulse.
    count: usize,
    is_told: bool,
}

/// Bearings and events so far, updated step by step.
#[derive(Default)]
pub(super) struct Story {
    bearings: Vec<Bearing>,
    events: Vec<(Event, State)>,
}

impl Story {
    /// Whether a contact that begins to bear strikes: `closing` is its closing rate before the step, `pushed` the
    /// change by forces.
    pub(super) fn strikes(closing: f64, pushed: f64) -> bool {
        closing > STRIKES * pushed.abs()
    }

    /// Whether a contact, or one that takes its place, has borne recently.
    pub(super) fn bears(&self, contact: usize, is_same: &dyn Fn(usize, usize) -> bool) -> bool {
        self.bearings.iter().any(|b| is_same(b.contact, contact))
    }

    /// Records that a contact has an impulse in a step.
    pub(super) fn impulse(
        &mut self,
        (step, from, to): (usize, &State, &State),
        contact: usize,
        is_impact: bool,
        is_same: &dyn Fn(usize, usize) -> bool,
    ) {
        if is_impact {
            self.tell(EventKind::Impact, contact, from.clone());
        }
        let known = (self.bearings.iter()).position(|b| is_same(b.contact, contact));
        let Some(known) = known else {
            self.bearings.push(Bearing {
                contact,
                began: from.clone(),
                last: step,
                after: to.clone(),
                count: 1,
                is_told: false,
            });
            return;
        };
        let bearing = &mut self.bearings[known];
        if bearing.last < step {
            bearing.count += 1;
        }
        (bearing.contact, bearing.last) = (contact, step);
        bearing.after.clone_from(to);
    }

    /// Ends a step: reports the touches that have lasted and the releases.
    pub(super) fn over(&mut self, step: usize) {
        let mut told = Vec::new();
        self.bearings.retain_mut(|b| {
            if !b.is_told && b.count >= LASTS {
                b.is_told = true;
                told.push((EventKind::Touch, b.contact, b.began.clone()));
            }
            let stays = step < b.last + LASTS;
            if !stays && b.is_told {
                told.push((EventKind::Release, b.contact, b.after.clone()));
            }
            stays
        });
        for (kind, contact, state) in told {
            self.tell(kind, contact, state);
        }
    }

    fn tell(&mut self, kind: EventKind, contact: usize, state: State) {
        let t = state.t;
        self.events.push((Event::of(t, kind, contact), state));
    }

    /// All events and their states, in order of time.
    pub(super) fn events(mut self) -> Vec<(Event, State)> {
        self.events.sort_by(|a, b| a.0.t.total_cmp(&b.0.t));
        self.events
    }
}
