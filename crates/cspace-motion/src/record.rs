//! What is told of a motion: samples and events.

use serde::Serialize;

/// How a simulation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// It came to the end of its time.
    Done,
    /// No velocity is allowed: what is driven cannot go on.
    Jammed,
    /// It cannot be told how it goes on.
    Undetermined,
}

/// What happens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum EventKind {
    /// Two parts come into contact.
    Touch,
    /// They part.
    Release,
    /// A part comes to an end of its range.
    Limit,
}

/// What an event is about.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
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
        /// Its name.
        part: String,
        /// `upper` or `lower`.
        limit: &'static str,
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
            Self::Limit { part, limit } => write!(f, "the {limit} end of the range of {part}"),
        }
    }
}

/// Something that happens.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Event {
    /// When, in seconds.
    pub t: f64,
    /// What.
    pub kind: EventKind,
    /// Of which parts.
    #[serde(flatten)]
    pub what: What,
    /// Where, in the assembly's frame; limits are nowhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<[f64; 2]>,
}

/// All coordinates of the system at a time.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Sample {
    /// When, in seconds.
    pub t: f64,
    /// The coordinates, in the order of the system's.
    pub coordinates: Vec<f64>,
    /// Their rates.
    pub rates: Vec<f64>,
}

/// A contact that forbids a motion, with its share of the proof.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Obstacle {
    /// Which.
    #[serde(flatten)]
    pub what: What,
    /// Its multiplier: positive.
    pub multiplier: f64,
}

/// What became of a mechanism.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// How it ended.
    pub status: Status,
    /// When it ended, in seconds.
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
}
