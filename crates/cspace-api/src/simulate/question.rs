//! The question for a motion.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

/// How long a mechanism moves, and how it is followed.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// How long, in seconds.
    pub time: f64,
    /// The time between samples, in seconds; a 200th of the whole without.
    #[serde(default)]
    pub every: Option<f64>,
    /// Whether inertia plays a part; without, it does if a part has a mass.
    #[serde(default)]
    pub mode: Option<Mode>,
    /// How a motion with masses is followed.
    #[serde(default)]
    pub scheme: Scheme,
    /// With the scheme `stepping`: the longest step, in seconds; a 10000th of the whole without.
    #[serde(default)]
    pub step: Option<f64>,
    /// Whether the rates of all coordinates are reported.
    #[serde(default)]
    pub rates: bool,
    /// Whether the forces at contacts, in joints and of drives are reported.
    #[serde(default)]
    pub forces: bool,
    /// Whether all states and hashes of the model are reported, so that the motion can go on where it ends.
    #[serde(default)]
    pub states: bool,
    /// An earlier answer of the same model with its states: the motion goes on where that ends.
    #[serde(default)]
    pub resume: Option<Earlier>,
}

/// Whether inertia plays a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Mode {
    /// Masses move by forces.
    Dynamic,
    /// Drives move slowly; forces of loads, springs and weights balance at every instant.
    Kinematic,
}

/// How a motion with masses is followed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Scheme {
    /// From event to event, each located to rounding.
    #[default]
    Event,
    /// Moreau-Jean: in steps of one length, right to the order of a step; a check of the other.
    Stepping,
}

/// An earlier answer.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Earlier {
    /// Where it was read from, for messages.
    pub path: PathBuf,
    /// The answer.
    pub answer: Value,
}
