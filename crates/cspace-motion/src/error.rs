//! Why a mechanism cannot be set in motion.

use cspace::{ComputeError, PairError, QueryError};
use cspace_model::MechanismError;

/// Error of a simulation.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SimulateError {
    /// The mechanism is invalid, or the space of a pair cannot be computed.
    #[error(transparent)]
    Mechanism(#[from] MechanismError),
    /// The duration is not positive, or the time between samples is not.
    #[error("{what} must be positive and finite, and is {value:?}")]
    Time {
        /// Name of the setting.
        what: &'static str,
        /// Value of the setting.
        value: f64,
    },
    /// Samples are too many to hold.
    #[error(
        "{samples} samples are asked for, and there may be {most}; sample less often, or simulate a shorter time"
    )]
    TooMany {
        /// Number of samples.
        samples: f64,
        /// Largest allowed number of samples.
        most: usize,
    },
    /// Steps are too many to take.
    #[error(
        "{steps:e} steps are asked for, and there may be {most:e}; take longer steps, or simulate a shorter time"
    )]
    TooManySteps {
        /// Number of steps.
        steps: f64,
        /// Largest allowed number of steps.
        most: f64,
    },
    /// Nothing can move.
    #[error("no part can move; give a part a motion other than fixed")]
    NothingMoves,
    /// A part that is free to move has no mass.
    #[error(
        "{part} has no mass, and others have one; give it a mass or a density, or ask for the kinematic mode"
    )]
    NoMass {
        /// Name of the part.
        part: String,
    },
    /// A mass or an inertia is too small beside the others, or too large, to be computed with.
    #[error(
        "the mass or the inertia of {part} is {value:e}, which is out of all proportion to the others; correct it"
    )]
    Mass {
        /// Name of the part.
        part: String,
        /// Its mass or inertia.
        value: f64,
    },
    /// Two parts overlap at the start.
    #[error(
        "{fixed} and {moving} overlap at the start, {depth:.3e} from where they would only touch; give one of them another `start`, draw them apart, or one of them smaller"
    )]
    Overlap {
        /// Name of the fixed part.
        fixed: String,
        /// Name of the moving part.
        moving: String,
        /// Penetration depth, along or about the axis if both parts are on axes, otherwise by translation.
        depth: f64,
    },
    /// Two parts fit exactly at the start, and neither can be made smaller by a gap.
    #[error(
        "{fixed} and {moving} fit exactly at the start, and {moving} has edges too short to be made smaller by a gap; draw a gap between them"
    )]
    ExactFit {
        /// Name of the fixed part.
        fixed: String,
        /// Name of the moving part.
        moving: String,
    },
    /// A pair starts where its space was not computed.
    #[error(
        "{fixed} and {moving} start outside of the window of orientations of their pair; widen `theta`, or start elsewhere"
    )]
    Outside {
        /// Name of the fixed part.
        fixed: String,
        /// Name of the moving part.
        moving: String,
    },
    /// A part starts outside of the range of its motion.
    #[error("{part} starts outside of the range of its motion; start within, or widen the range")]
    Range {
        /// Name of the part.
        part: String,
    },
    /// The joints cannot all hold at the start.
    #[error(
        "the joints cannot all hold at the start: {part} misses {other} by {gap:.3e}; give them a `start` at which they meet, or correct the joints"
    )]
    Joints {
        /// Name of a part of the joint that is worst.
        part: String,
        /// Name of the other.
        other: String,
        /// Gap of the joint, in the model's unit of length.
        gap: f64,
    },
    /// A part is not among those of the mechanism.
    #[error("part {part} is asked for, and the mechanism has {count}, counted from 0")]
    NoPart {
        /// Index of the part.
        part: usize,
        /// Number of parts.
        count: usize,
    },
    /// A part cannot be dragged as requested.
    #[error("{part} {why}")]
    Drag {
        /// Name of the part.
        part: String,
        /// Why.
        why: &'static str,
    },
    /// A state is not one of the mechanism.
    #[error(
        "a state has {found} coordinates, and the mechanism has {count}: it is of another model"
    )]
    Count {
        /// Number of coordinates of the state.
        found: usize,
        /// Number of coordinates of the mechanism.
        count: usize,
    },
    /// The computation was interrupted.
    #[error("interrupted")]
    Interrupted,
    /// A question to a space failed.
    #[error("{fixed} and {moving}: {error}")]
    Query {
        /// Name of the fixed part.
        fixed: String,
        /// Name of the moving part.
        moving: String,
        /// Why.
        error: QueryError,
    },
}

impl SimulateError {
    /// Whether the computation, of a space or of the motion, was interrupted by its progress callback.
    pub const fn is_interrupted(&self) -> bool {
        matches!(
            self,
            Self::Interrupted
                | Self::Mechanism(MechanismError::Pair {
                    error: PairError::Compute(ComputeError::Interrupted),
                    ..
                })
        )
    }
}
