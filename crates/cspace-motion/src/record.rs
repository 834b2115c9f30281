//! Recording of a motion: samples and events.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Status at the end of a simulation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// The simulation reached the end of its time.
    Done,
    /// No velocity is allowed: a driven part cannot go on.
    Jammed,
    /// The continuation of the motion is not determined.
    Undetermined,
    /// No accelerations and forces satisfy the laws of contact and friction.
    Inconsistent,
    /// The user wanted no more of it.
    Interrupted,
}

/// Kind of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum EventKind {
    /// Two parts strike each other: their rates change at once.
    Impact,
    /// Two parts come into contact that lasts.
    Touch,
    /// Two parts that were in contact separate.
    Release,
    /// Two parts no longer slide on each other.
    Stick,
    /// Two parts begin to slide on each other.
    Slip,
    /// Impacts accumulate, and are over here.
    Rest,
    /// A part comes to an end of its range.
    Limit,
    /// The balance of forces ends, and parts jump to the next one.
    Snap,
    /// A driven part cannot go on: a contact or an end of a range forbids it.
    Jam,
    /// Several motions agree with the laws of contact and friction, and one is taken.
    Choice,
    /// Steps of one length lead over a time in which events cannot be told apart.
    Bridge,
}

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum End {
    /// The smallest value.
    Lower,
    /// The largest.
    Upper,
}

impl core::fmt::Display for End {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Lower => "lower",
            Self::Upper => "upper",
        })
    }
}

/// Subject of an event.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum What {
    /// Two features.
    Contact {
        /// Name of the pair's fixed part.
        fixed: String,
        /// Name of its moving part.
        moving: String,
        /// The features of the two.
        features: [String; 2],
    },
    /// A part at an end of its range.
    Limit {
        /// Name of the part.
        part: String,
        /// End of the range.
        limit: End,
    },
    /// A part.
    Part {
        /// Name of the part.
        part: String,
    },
}

impl core::fmt::Display for What {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Contact {
                fixed,
                moving,
                features: [a, b],
            } => write!(f, "{a} of {fixed} and {b} of {moving}"),
            Self::Part { part } => f.write_str(part),
            Self::Limit { part, limit } => write!(f, "the {limit} end of the range of {part}"),
        }
    }
}

/// Something that happens.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Event {
    /// Time, in seconds.
    pub t: f64,
    /// Kind of the event.
    pub kind: EventKind,
    /// Parts concerned.
    #[serde(flatten)]
    pub what: What,
    /// Position, in the assembly's frame; `None` for limits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<[f64; 2]>,
    /// Possible motions, of a choice.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub choice: Option<Choice>,
    /// Extent of a bridge.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bridge: Option<Bridge>,
}

impl Event {
    /// An event at a place.
    pub(crate) fn new(t: f64, kind: EventKind, what: What, at: Option<[f64; 2]>) -> Self {
        Self {
            t,
            kind,
            what,
            at,
            choice: None,
            bridge: None,
        }
    }
}

/// Motions that all agree with the laws of contact and friction, and the one that is taken: that with the least energy of the change, then with
/// the least forces, then the first.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Choice {
    /// The contacts and limits concerned.
    pub contacts: Vec<What>,
    /// Conduct of each in the motion that is taken.
    pub taken: Vec<Conduct>,
    /// Conduct of each in the other motions.
    pub others: Vec<Vec<Conduct>>,
}

/// Conduct of a contact in a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Conduct {
    /// It opens.
    Opens,
    /// It bears, and does not slide.
    Sticks,
    /// It slides in the direction of its tangent.
    Slides,
    /// It slides against its tangent.
    SlidesBack,
}

/// A time that steps lead over.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Bridge {
    /// The end of the time, in seconds.
    pub until: f64,
    /// The largest overlap of parts in it, in the model's unit of length.
    pub overlap: f64,
}

/// All coordinates of the system at a time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sample {
    /// Time, in seconds.
    pub t: f64,
    /// The coordinates, in the order of the system's.
    pub coordinates: Vec<f64>,
    /// Rates of all coordinates.
    pub rates: Vec<f64>,
    /// The forces there, of a motion with masses.
    pub forces: Option<Forces>,
}

/// The forces between parts at a time, in kg·unit/s², torques in kg·unit²/s².
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Forces {
    /// Forces of all closed contacts and all ends of ranges that are reached.
    pub contacts: Vec<ContactForce>,
    /// Forces of the joints between two parts, in the order of the mechanism's pairs.
    pub joints: Vec<JointForce>,
    /// Forces of the drives.
    pub drives: Vec<DriveForce>,
}

/// The force at a contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ContactForce {
    /// Contact or limit.
    #[serde(flatten)]
    pub what: What,
    /// Position, in the assembly's frame; `None` for limits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<[f64; 2]>,
    /// Magnitude of the normal force between the parts, 0 or more.
    pub normal: f64,
    /// The force of friction.
    pub tangential: f64,
}

/// Force in a joint: the force on the second of its parts.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct JointForce {
    /// The names of its two parts.
    pub parts: [String; 2],
    /// The force on the second part, in the assembly's frame.
    pub force: [f64; 2],
    /// The torque on the second part, about the joint's place in it.
    pub torque: f64,
}

/// Force and power of a drive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DriveForce {
    /// The name of the driven part.
    pub part: String,
    /// Torque, or force if the part slides.
    pub force: f64,
    /// Power: force times rate, in kg·unit²/s³.
    pub power: f64,
}

/// Energy balance, in kg·unit²/s²: the energy at the end is that at the start plus the work of drives less the losses,
/// but for `drift`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct Energy {
    /// Kinetic energy, and the potential energy of weights, loads and springs, at the start.
    pub start: f64,
    /// Energy at the end.
    pub end: f64,
    /// Work done by drives.
    pub drives: f64,
    /// Energy lost to friction and dampers.
    pub friction: f64,
    /// Energy lost to impacts.
    pub impacts: f64,
    /// Remainder of the balance: the error of the integration.
    pub drift: f64,
}

/// A contact that forbids a motion, with its share of the proof.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Obstacle {
    /// Contact or limit.
    #[serde(flatten)]
    pub what: What,
    /// Multiplier: positive.
    pub multiplier: f64,
}

/// Largest number of steps that are traced; of longer motions only instants at which contacts change are.
pub const MOST_TRACED: usize = 200_000;

/// Recording of a mechanism's motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// Status at the end.
    pub status: Status,
    /// Time of the end, in seconds.
    pub until: f64,
    /// Why it ended early.
    pub reason: Option<String>,
    /// The contacts and limits that jam it. The multipliers combine the conditions that no contact function decreases to a
    /// contradiction: Σ λ ∇f vanishes on all free coordinates, and the drives make Σ λ f decrease.
    pub obstacles: Vec<Obstacle>,
    /// Samples at even times, and at the end.
    pub samples: Vec<Sample>,
    /// Events in order of time.
    pub events: Vec<Event>,
    /// Trace of all coordinates in order of time, independent of the samples: after each step, unless there are more
    /// than [`MOST_TRACED`], and twice where contacts change or drives are not smooth, with the rates right before and
    /// right after.
    pub trace: Vec<Sample>,
    /// The balance of energy, of a motion with masses.
    pub energy: Option<Energy>,
    /// Largest gap or penetration of closed contacts and joints after a step, before it was corrected, in the model's
    /// unit of length.
    pub open: f64,
}

/// Contacts and ends of ranges that begin within this share of the time after a motion is taken up were there before.
const TAKEN_UP: f64 = 1e-9;

impl Record {
    /// Coordinates and rates at the end.
    pub fn last(&self) -> Option<&Sample> {
        self.trace.last().or(self.samples.last())
    }

    /// The record of a motion that was taken up where another ended, with that before it.
    pub fn after(self, mut earlier: Self) -> Self {
        let (from, near) = (earlier.until, TAKEN_UP * self.until);
        // The end of what was before is a sample only if it is one of the whole.
        let early = |s: &Sample| s.t > from + near;
        if let [first, second, ..] = &self.samples[..] {
            let every = second.t - first.t;
            let is_even = |s: &Sample| s.t < first.t - every * (1.0 - TAKEN_UP);
            earlier.samples.retain(is_even);
        }
        earlier.samples.extend(self.samples);
        earlier.trace.extend(self.trace.into_iter().filter(early));
        let again =
            |e: &Event| e.t <= from + near && matches!(e.kind, EventKind::Touch | EventKind::Limit);
        let events = self.events.into_iter().filter(|e| !again(e));
        earlier.events.extend(events);
        let energy = self.energy.map(|now| match earlier.energy {
            None => now,
            Some(before) => Energy {
                start: before.start,
                end: now.end,
                drives: before.drives + now.drives,
                friction: before.friction + now.friction,
                impacts: before.impacts + now.impacts,
                drift: before.drift + now.drift,
            },
        });
        Self {
            status: self.status,
            until: self.until,
            reason: self.reason,
            obstacles: self.obstacles,
            energy,
            open: self.open.max(earlier.open),
            ..earlier
        }
    }
}
