//! Options and results of a motion.

use super::world::{Acting, State};
use crate::complementarity::Mode;

pub use crate::record::EventKind;

/// Something that happens to a contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// Time, s.
    pub t: f64,
    /// Kind of the event: none of a limit, a balance or a drive, of which contacts know nothing.
    pub kind: EventKind,
    /// The number of the contact; of several, of the first.
    pub contact: usize,
    /// Other motions that were possible, of a choice.
    pub choice: Option<Choice>,
    /// The end of the time that steps led over, and the largest overlap in it, of a bridge.
    pub bridge: Option<[f64; 2]>,
}

impl Event {
    /// An event of one contact.
    pub(super) fn of(t: f64, kind: EventKind, contact: usize) -> Self {
        Self {
            t,
            kind,
            contact,
            choice: None,
            bridge: None,
        }
    }
}

/// Motions that all agree with the laws of contact and friction, of which one was taken.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// The contacts concerned.
    pub contacts: Vec<usize>,
    /// Their modes in the motion that is taken.
    pub taken: Vec<Mode>,
    /// Their modes in each of the others.
    pub others: Vec<Vec<Mode>>,
}

/// Reason for the end of a motion.
#[derive(Debug, Clone, PartialEq)]
pub enum Ended {
    /// The requested time is reached.
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
    /// More events in a time than can be distinguished, or an equation of motion without a solution.
    Stuck {
        /// The contacts concerned.
        contacts: Vec<usize>,
    },
    /// Joints that leave no freedom come to a configuration from which parts can go on in more than one direction, or
    /// in none.
    Folded {
        /// Whether it is a dead point, towards which rates grow without bound: nothing goes on from there.
        dead: bool,
    },
    /// Steps are too long for how fast parts move: one may come through another in a step.
    Coarse {
        /// The displacement in a step.
        displacement: f64,
    },
    /// Steps are too many, because forces are too stiff or rates too large.
    TooMany,
    /// The observer wants no more.
    Interrupted,
}

/// Receiver of samples and events during a motion.
pub trait Observer {
    /// Time of the next requested sample, s.
    fn next(&self) -> f64 {
        f64::INFINITY
    }

    /// The state and the forces at that time.
    fn sample(&mut self, _state: &State, _acting: &Acting<'_>) {}

    /// The state at the start and at the ends of all steps.
    fn step(&mut self, _state: &State) {}

    /// Receives the state after an event: rates may differ from those at the end of the step.
    fn changed(&mut self, _state: &State) {}

    /// An event, and the state just after it.
    fn event(&mut self, _event: &Event, _state: &State) {}

    /// Whether the motion is to go on; called at intervals with its current time.
    fn goes_on(&self, _t: f64) -> bool {
        true
    }
}

/// Nobody.
impl Observer for () {}

/// A motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Reason for the end.
    pub ended: Ended,
    /// First state: the start, with the rates nearest to its own that joints allow.
    pub first: State,
    /// Last state.
    pub last: State,
    /// Events, in order.
    pub events: Vec<Event>,
    /// Steps between events.
    pub steps: usize,
    /// Largest gap or penetration of closed contacts and joints after a step, before they were projected.
    pub open: f64,
    /// Work done by drives and energy lost.
    pub work: Work,
}

/// Work done by drives, and energy lost.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Work {
    /// Work done by drives.
    pub drives: f64,
    /// Energy lost to friction and dampers.
    pub friction: f64,
    /// Energy lost to impacts.
    pub impacts: f64,
}

/// Options of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// End of the motion, s.
    pub until: f64,
    /// Longest step, s.
    pub longest: f64,
    /// Whether the motion ends where several agree with the laws of contact and friction, and where steps would have to lead over a time.
    pub strict: bool,
}
