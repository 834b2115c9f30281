//! Measured values, what decides them, and why there is none.

use cspace::{Coordinates, MotionError, PairSpace, QueryError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::touching::{FeaturePair, texts};

/// Measured value of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// A length in the model's unit, or an angle in radians.
    Number(f64),
    /// Yes or no.
    Truth(bool),
}

/// A quantity and what it comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: Value,
    /// For a play the two ends of the range, as values of its coordinate; for a backlash the least and the largest, and for
    /// a fit values between which it is.
    pub range: Option<(f64, f64)>,
    /// Stops that determine the quantity: for a play both ends, the lower first; for a position the contact; for a clearance the
    /// configuration itself.
    pub stops: Vec<Stop>,
    /// The gap by which the moving part is smaller, where the parts fit exactly and it is measured with one (the model's unit of length).
    pub gap: Option<f64>,
}

/// A configuration that decides a quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// The configuration, features touching as they are drawn.
    pub at: Coordinates,
    /// The features of both parts that touch there, or are nearest; none at the end of a part's range.
    pub features: Vec<FeaturePair>,
}

impl Measured {
    /// A number that no configuration of a pair decides.
    pub(crate) const fn number(value: f64) -> Self {
        Self::at(Value::Number(value), Vec::new())
    }

    /// Yes or no, decided by no single configuration.
    pub(crate) const fn truth(value: bool) -> Self {
        Self::at(Value::Truth(value), Vec::new())
    }

    /// A value, and what decides it.
    pub(crate) const fn at(value: Value, stops: Vec<Stop>) -> Self {
        Self {
            value,
            range: None,
            stops,
            gap: None,
        }
    }

    /// A number with a range.
    pub(crate) fn with_range(value: f64, range: (f64, f64), stops: Vec<Stop>) -> Self {
        Self {
            range: Some(range),
            ..Self::at(Value::Number(value), stops)
        }
    }

    /// Features in contact where the quantity ends: of the fixed and of the moving part, as messages call them.
    pub fn touching(&self, space: &PairSpace) -> Vec<[String; 2]> {
        let mut all: Vec<FeaturePair> = Vec::new();
        for &pair in self.stops.iter().flat_map(|s| &s.features) {
            if !all.contains(&pair) {
                all.push(pair);
            }
        }
        all.into_iter().map(|pair| texts(space, pair)).collect()
    }
}

/// Why a quantity has no value.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Unmeasured {
    /// The parts overlap at the configuration at which it is measured.
    #[error("the parts overlap at the configuration: choose one that is free")]
    Blocked,
    /// Nothing ends a play.
    #[error("nothing stops the part in this coordinate: there is no play to measure")]
    Unlimited,
    /// A motion meets nothing.
    #[error("nothing touches along the motion: give a longer `along`, or another direction")]
    NoContact,
    /// A motion ends at the limit of a range or window before it meets anything.
    #[error(
        "the motion leaves the range of a part's motion, or the window of orientations, before anything touches"
    )]
    Leaves,
    /// No motion leads from one configuration to another.
    #[error("no motion without overlap leads there")]
    NoWay,
    /// Whether a motion leads from one configuration to another is not known.
    #[error("it is not known whether a motion leads there: the space is doubtful on the way")]
    Undecided,
    /// A configuration in contact is between regions.
    #[error("the configuration is in contact between two free regions: choose one in either")]
    Between,
    /// A coordinate of a region goes on without end.
    #[error("the coordinate has no end in the free region: it goes on")]
    Endless,
    /// Nothing moves at a contact.
    #[error("the point where the parts touch does not move when this coordinate changes")]
    Still,
    /// Nothing is at a common height.
    #[error("the parts share no height, so that nothing of them can meet: there is no distance")]
    NeverLevel,
    /// Parts of a linkage.
    #[error(
        "joints connect the parts, which do not move independently: measure the motion that a drive makes"
    )]
    Linked,
    /// Each of two parts can turn without the other.
    #[error("one part can turn without the other: there is no ratio, and no backlash")]
    TurnsAlone,
    /// A region has a hole.
    #[error(
        "the parts pass contacts on two sides in their play, so that it is not one range: measure the play at places"
    )]
    PassedOnTwoSides,
    /// An extreme is not proved.
    #[error("{found} was found, but that there is nothing beyond it could not be proved")]
    Unproved {
        /// The value (the model's unit of length).
        found: f64,
    },
    /// The question has no answer at the configuration.
    #[error("{0}")]
    Query(QueryError),
    /// An event does not happen.
    #[error("this does not happen within the time: give a longer `time`, or another event")]
    Never,
    /// A part does not go on, so that there is no ratio by it.
    #[error("the part `by` does not move on: there is no ratio")]
    NoAdvance,
    /// A motion does not come to the end of its time.
    #[error("the motion ends at {until} s: {why}")]
    EndsEarly {
        /// When it ends, in seconds.
        until: f64,
        /// Why.
        why: &'static str,
        /// Whether it is known that it does not go on.
        is_known: bool,
    },
    /// The pair's configuration space cannot be computed, or the motion cannot be followed.
    #[error("{0}")]
    Space(String),
    /// The requirement is not one of the model.
    #[error("the requirement is not one of the model")]
    Unknown,
}

impl Unmeasured {
    /// Whether the quantity may have a value, which could not be found: nothing is known of it, not even that it has none.
    pub fn is_undecided(&self) -> bool {
        match self {
            Self::Undecided | Self::Unproved { .. } | Self::Space(_) | Self::Unknown => true,
            Self::EndsEarly { is_known, .. } => !is_known,
            _ => false,
        }
    }
}

impl From<QueryError> for Unmeasured {
    fn from(error: QueryError) -> Self {
        match error {
            QueryError::Blocked | QueryError::Motion(MotionError::StartsBlocked) => Self::Blocked,
            other => Self::Query(other),
        }
    }
}
