//! Why an assembly cannot be asked.

use cspace::{PairError, PartError, QueryError};
use cspace_model::MechanismError;

use crate::planner::PlanError;

/// Why an assembly cannot be asked.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AssemblyError {
    /// The mechanism makes no sense.
    #[error(transparent)]
    Mechanism(#[from] MechanismError),
    /// There is nothing to be taken apart.
    #[error(
        "there is nothing to take apart: it takes two parts that are not joined, one of them planar"
    )]
    Nothing,
    /// There are more parts than are searched.
    #[error("{units} parts are too many to take apart (at most {most}); join some by rigid joints")]
    TooMany {
        /// Parts that move on their own.
        units: usize,
        /// The most there may be.
        most: usize,
    },
    /// Parts that are looked at as one have more layers than one part may have.
    #[error(
        "parts {parts} have {count} layers together, and {most} can be looked at as one; merge layers of the same heights"
    )]
    TooManyLayers {
        /// Their names.
        parts: String,
        /// Layers of all.
        count: usize,
        /// The most there may be.
        most: usize,
    },
    /// The gap is no length that can be opened.
    #[error("a gap of {gap} cannot be opened: give a length from {least:e} to {most:e}")]
    Gap {
        /// The gap.
        gap: f64,
        /// The least that the contact spaces can tell.
        least: f64,
        /// The most.
        most: f64,
    },
    /// A part is too small for the gap.
    #[error(
        "part {part}: an edge is too short, or an arc too small, for a gap of {gap:.2e}; give a smaller one"
    )]
    TooSmall {
        /// Its name.
        part: String,
        /// The gap.
        gap: f64,
    },
    /// Two parts overlap as they are drawn.
    #[error(
        "parts {first} and {second} overlap as they are drawn, by {}more than the gap of {gap:.2e}; move them apart in the model, or give a larger gap", by(*.depth)
    )]
    Overlap {
        /// The one's name.
        first: String,
        /// The other's.
        second: String,
        /// The length of the shortest translation that separates them, in the model's unit; none if they have too many edges for it.
        depth: Option<f64>,
        /// The gap.
        gap: f64,
    },
    /// Parts make no outlines together, or with the gap opened.
    #[error("{0}")]
    Part(#[from] PartError),
    /// A contact space cannot be computed, or the computation was interrupted.
    #[error(transparent)]
    Pair(#[from] PairError),
    /// A contact space cannot be asked.
    #[error(transparent)]
    Query(#[from] QueryError),
    /// A way cannot be asked for.
    #[error(transparent)]
    Plan(#[from] PlanError),
}

/// How much an overlap is, where that is known.
fn by(depth: Option<f64>) -> String {
    depth.map_or(String::new(), |d| format!("{d:.6}, which is "))
}
