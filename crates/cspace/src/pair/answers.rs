//! Answers to questions about pairs of any class, and reasons why a question has no answer.

use crate::geometry::Configuration;
use crate::ids::PatchId;
use crate::query::MotionError;

use super::relation::{Coordinates, PairClass};

/// First contact along a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PairContact {
    /// Time of contact, in the unit of time of the rates.
    pub time: f64,
    /// Configuration at that time.
    pub at: Coordinates,
    /// Patch that is touched; one of them, if several are.
    pub patch: PatchId,
}

/// The contact nearest to a configuration.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PairNearest {
    /// Patch of the contact.
    pub patch: PatchId,
    /// The configuration in contact.
    pub at: Coordinates,
    /// Displacement of the moving part to the contact: a length, or radians for a part that turns on its axis.
    pub distance: f64,
}

/// Outcome of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum PairMotion {
    /// The motion is free to the end.
    Free,
    /// The motion touches a patch.
    Contact(PairContact),
    /// The motion is free until it leaves the window of orientations or the range of a part's motion, at this time.
    Leaves {
        /// Time at which it leaves.
        time: f64,
    },
}

/// A contact surface that a motion crosses.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PairCrossing {
    /// Time of the crossing, in the unit of time of the rates.
    pub time: f64,
    /// The patch.
    pub patch: PatchId,
    /// Whether the motion enters blocked space there; otherwise it leaves blocked space.
    pub enters: bool,
}

/// The neighbours of a patch along the boundary of free space, each once, in order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Neighbours {
    /// Patches before it, at its left boundary.
    pub before: Vec<PatchId>,
    /// Patches after it, at its right boundary.
    pub after: Vec<PatchId>,
    /// Patches that it continues at its lowest orientation. Patches of fixed axes have none.
    pub below: Vec<PatchId>,
    /// Patches that continue it at its highest orientation.
    pub above: Vec<PatchId>,
}

/// Reasons for which a question has no answer.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QueryError {
    /// The configuration is in the coordinates of another class.
    #[error("a configuration of a {class} pair is given by {wanted}, not by {given}")]
    Coordinates {
        /// The class.
        class: PairClass,
        /// The coordinates it has.
        wanted: &'static str,
        /// Coordinates of the configuration that was passed.
        given: &'static str,
    },
    /// The configuration is not finite, or outside the window or the ranges of motion.
    #[error("the configuration is not finite, or outside the window or the ranges of motion")]
    Outside,
    /// There is no such patch.
    #[error("there is no patch {patch}; the last is {last}")]
    NoPatch {
        /// Number that was given.
        patch: PatchId,
        /// Largest number of a patch.
        last: PatchId,
    },
    /// The parts of a lower pair are always in contact.
    #[error(
        "the parts of a lower pair are in contact for ever: there is no first or nearest contact"
    )]
    Permanent,
    /// The question is about orientations, and the pair has none as a coordinate.
    #[error("a {class} pair has no orientation as a coordinate")]
    NoOrientation {
        /// The class.
        class: PairClass,
    },
    /// A metric's length per radian is not positive and finite, or its square is not.
    #[error(
        "the length per radian of a metric must be positive and finite, and so must be its square"
    )]
    Metric,
    /// The parts overlap at the configuration.
    #[error("the parts overlap at the configuration")]
    Blocked,
    /// A motion cannot be followed.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

impl QueryError {
    /// Coordinates of another class than the pair's.
    pub(super) fn coordinates(class: PairClass, given: Coordinates) -> Self {
        let wanted = match class {
            PairClass::FixedAxes => Coordinates::Axes { u: 0.0, v: 0.0 },
            _ => Coordinates::Planar(Configuration::default()),
        };
        Self::Coordinates {
            class,
            wanted: wanted.names(),
            given: given.names(),
        }
    }
}
