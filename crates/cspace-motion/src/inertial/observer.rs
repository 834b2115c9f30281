//! Recording of a motion with masses: samples and events.

use crate::contact::{Bound, named};
use crate::dynamic::{self, Acting, Mode, Observer, State};
use crate::forces::{drive_force, joint_forces};
use crate::record::{
    Bridge, Choice, Conduct, ContactForce, Event, EventKind, Forces, MOST_TRACED, Sample,
};

use super::bodies::All;
use super::world::Mechanical;

/// Gathers samples and events.
pub(super) struct Gathering<'a> {
    pub(super) world: &'a Mechanical<'a>,
    pub(super) every: f64,
    /// The number of the first sample: those before are of a motion that is taken up.
    pub(super) first: usize,
    pub(super) duration: f64,
    pub(super) samples: Vec<Sample>,
    pub(super) events: Vec<Event>,
    pub(super) trace: Vec<Sample>,
    pub(super) progress: &'a dyn Fn(f64) -> bool,
}

impl Gathering<'_> {
    fn forces(&self, state: &State, acting: &Acting<'_>) -> Forces {
        let all = &self.world.bodies.all(state);
        let system = &self.world.bodies.system;
        let contacts = (acting.contacts.iter())
            .map(|&(number, normal, tangential)| ContactForce {
                what: named(system, self.world.pairs, &self.world.bound(number)),
                at: self.world.place(number, &all.q).map(|p| [p.x, p.y]),
                normal,
                tangential,
            })
            .collect();
        let joints = joint_forces(system, &all.q, acting.joints.as_slice());
        let drives = (self.world.drive_forces(state, acting).into_iter())
            .map(|(i, force)| drive_force(system, i, force, all.v[i]))
            .collect();
        Forces {
            contacts,
            joints,
            drives,
        }
    }

    /// State as it is recorded: in terms of the parts' own frames.
    pub(super) fn told(&self, state: &State, forces: Option<Forces>) -> Sample {
        let All { mut q, mut v, .. } = self.world.bodies.all(state);
        self.world.bodies.system.shift(&mut q, &mut v, true);
        Sample {
            t: state.t,
            coordinates: q,
            rates: v,
            forces,
        }
    }
}

/// Conduct of contacts in modes.
fn conducts(modes: &[Mode]) -> Vec<Conduct> {
    let one = |mode: &Mode| match mode {
        Mode::Open => Conduct::Opens,
        Mode::Stick => Conduct::Sticks,
        Mode::Forward => Conduct::Slides,
        Mode::Backward => Conduct::SlidesBack,
    };
    modes.iter().map(one).collect()
}

impl Observer for Gathering<'_> {
    fn next(&self) -> f64 {
        let next = (self.first + self.samples.len()) as f64 * self.every;
        if next <= self.duration {
            next
        } else {
            f64::INFINITY
        }
    }

    fn sample(&mut self, state: &State, acting: &Acting<'_>) {
        let forces = self.forces(state, acting);
        let mut sample = self.told(state, Some(forces));
        sample.t = self.next();
        self.samples.push(sample);
    }

    fn step(&mut self, state: &State) {
        if self.trace.len() < MOST_TRACED {
            self.trace.push(self.told(state, None));
        }
    }

    fn changed(&mut self, state: &State) {
        self.trace.push(self.told(state, None));
    }

    fn event(&mut self, event: &dynamic::Event, state: &State) {
        let all = self.world.bodies.all(state);
        let bound = self.world.bound(event.contact);
        let kind = match (event.kind, bound) {
            (EventKind::Impact | EventKind::Touch, Bound::Limit { .. }) => EventKind::Limit,
            (kind, _) => kind,
        };
        let what = |contact: usize| {
            let bound = self.world.bound(contact);
            named(&self.world.bodies.system, self.world.pairs, &bound)
        };
        let bridge = event
            .bridge
            .map(|[until, overlap]| Bridge { until, overlap });
        if let Some(next) = bridge {
            // One that goes on where another ends is the same.
            let earlier = self.events.iter_mut().rev();
            let mut recent = earlier.take_while(|e| e.t == event.t || e.bridge.is_some());
            let last = recent.find_map(|e| e.bridge.as_mut().filter(|b| b.until == event.t));
            if let Some(last) = last {
                last.until = next.until;
                last.overlap = last.overlap.max(next.overlap);
                return;
            }
        }
        let choice = event.choice.as_ref().map(|choice| Choice {
            contacts: choice.contacts.iter().map(|&i| what(i)).collect(),
            taken: conducts(&choice.taken),
            others: choice.others.iter().map(|modes| conducts(modes)).collect(),
        });
        let at = self.world.place(event.contact, &all.q).map(|p| [p.x, p.y]);
        let event = Event {
            choice,
            bridge,
            ..Event::new(event.t, kind, what(event.contact), at)
        };
        // A stop that is struck and holds is reported once.
        let is_told = kind == EventKind::Limit
            && (self.events.iter().rev())
                .take_while(|e| e.t == event.t)
                .any(|e| e.kind == kind && e.what == event.what);
        if !is_told {
            self.events.push(event);
        }
    }

    fn goes_on(&self, t: f64) -> bool {
        (self.progress)(t / self.duration)
    }
}
