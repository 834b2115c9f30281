//! Options and results of a motion.

use super::world::{Acting, State};

/// Kind of an event.
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
    /// Kind of the event.
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
    /// A driven part strikes parts that cannot give way.
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
    /// Joints that leave no freedom come to a point from which parts can go on in more than one way, or in none.
    Folded,
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
    /// Events, in order.
    pub events: Vec<Event>,
    /// Steps between events.
    pub steps: usize,
    /// How far closed contacts and joints were open at most after a step, before they were brought together.
    pub open: f64,
    /// Work done by drives and energy lost.
    pub work: Work,
}

/// Work done by drives, and energy lost.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Work {
    /// By drives.
    pub drives: f64,
    /// To friction and dampers.
    pub friction: f64,
    /// To impacts.
    pub impacts: f64,
}

/// Options of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// When it ends, s.
    pub until: f64,
    /// No step is longer, s.
    pub longest: f64,
}
