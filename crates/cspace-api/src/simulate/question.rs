//! The question for a motion.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;

/// How long a mechanism moves, and how it is followed.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// How long, in seconds.
    #[cfg_attr(feature = "command", arg(long, value_name = "T", value_parser = crate::command::duration, allow_negative_numbers = true))]
    pub time: f64,
    /// The time between samples, in seconds [default: a 200th of the whole]
    #[cfg_attr(feature = "command", arg(long, value_name = "DT", value_parser = crate::command::duration, allow_negative_numbers = true))]
    #[serde(default)]
    pub every: Option<f64>,
    /// Whether inertia plays a part [default: dynamic if a part has a mass, otherwise kinematic]
    #[cfg_attr(feature = "command", arg(long, value_parser = crate::command::words::<Mode>()))]
    #[serde(default)]
    pub mode: Option<Mode>,
    /// How the dynamic mode goes on.
    #[cfg_attr(feature = "command", arg(long, value_parser = crate::command::words::<Scheme>(), default_value = "event", hide_short_help = true))]
    #[serde(default)]
    pub scheme: Scheme,
    /// The longest step of the scheme `stepping`, in seconds [default: a 10000th of the whole]
    #[cfg_attr(feature = "command", arg(long, value_name = "DT", value_parser = crate::command::duration, allow_negative_numbers = true, hide_short_help = true))]
    #[serde(default)]
    pub step: Option<f64>,
    /// End where several motions agree with the laws of contact and friction, or events cannot be told apart, instead of going on with one of
    /// the motions, or by steps.
    #[cfg_attr(feature = "command", arg(long, hide_short_help = true))]
    #[serde(default)]
    pub strict: bool,
    /// Report the rates of all coordinates as well.
    #[cfg_attr(feature = "command", arg(long))]
    #[serde(default)]
    pub rates: bool,
    /// Report the forces at contacts, in joints and of drives as well.
    #[cfg_attr(feature = "command", arg(long))]
    #[serde(default)]
    pub forces: bool,
    /// Report all states and hashes of the model as well, so that the motion can go on where it ends.
    #[cfg_attr(feature = "command", arg(skip))]
    #[serde(default)]
    pub states: bool,
    /// An earlier answer of the same model with its states: the motion goes on where that ends.
    #[cfg_attr(feature = "command", arg(skip))]
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
