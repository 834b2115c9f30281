//! Why parts have no operating modes that can be computed.

use cspace_model::MechanismError;

/// Why the modes of parts cannot be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ModesError {
    /// An index is no part's.
    #[error("there is no part {part}: there are {parts}")]
    NoSuchPart {
        /// The index.
        part: usize,
        /// The number of parts.
        parts: usize,
    },
    /// One part is named twice.
    #[error("part {part:?} is named twice; name different parts")]
    Twice {
        /// Name of the part.
        part: String,
    },
    /// A model has fewer parts that move on axes than three.
    #[error(
        "modes are those of three parts or more that each turn or slide on an axis; of such parts this model has {}{}",
        parts.len(),
        listed(parts)
    )]
    NotThree {
        /// Names of the parts.
        parts: Vec<String>,
    },
    /// A part is planar.
    #[error(
        "part {part:?} moves freely in the plane: a mode is of parts with one coordinate each; give it a motion of type revolute or prismatic, or choose another part"
    )]
    Planar {
        /// Name of the part.
        part: String,
    },
    /// A part does not move.
    #[error(
        "part {part:?} does not move: a mode is of parts with one coordinate each; give it a motion of type revolute or prismatic, or choose another part"
    )]
    Still {
        /// Name of the part.
        part: String,
    },
    /// A joint, or a chain of them, connects two of the parts.
    #[error(
        "parts {first:?} and {second:?} are connected by {}: they do not move independently, each on its own axis; remove the joint, or choose parts that meet by contact alone",
        if *direct { "a joint" } else { "a chain of joints" }
    )]
    Joined {
        /// The name of one.
        first: String,
        /// The name of the other.
        second: String,
        /// Whether a single joint connects both.
        direct: bool,
    },
    /// Two parts slide along one direction without limits.
    #[error(
        "parts {first:?} and {second:?} slide along one direction, both without limits: they meet however far they are; give one of them a range"
    )]
    Unlimited {
        /// The name of one.
        first: String,
        /// The name of the other.
        second: String,
    },
    /// A pair's configuration space cannot be computed.
    #[error(transparent)]
    Pair(#[from] MechanismError),
    /// There are more combinations of free intervals than there is room for.
    #[error(
        "the free intervals of the three parts combine in {columns} ways over all critical values, more than {limit}; give the parts ranges of motion, or draw fewer teeth"
    )]
    TooLarge {
        /// The number of combinations.
        columns: usize,
        /// The largest that is accepted.
        limit: usize,
    },
    /// More than three parts touch each other around a cycle.
    #[error(
        "parts {} touch each other around a cycle: more than three parts have modes where their contacts make a tree, as of a cam and its followers; leave one of them out, or choose three, which may touch each other",
        around(parts)
    )]
    Cycle {
        /// Names of the parts, each of which may touch the next, and the last the first.
        parts: Vec<String>,
    },
    /// The free intervals of parts that touch one part combine in too many ways.
    #[error(
        "beside part {part:?} the free intervals of the parts that touch it combine in {products} ways over all critical values, more than {limit}; leave some of these parts out, or give them narrower ranges of motion"
    )]
    TooManyProducts {
        /// The part that the others touch.
        part: String,
        /// The number of combinations at which it was given up.
        products: usize,
        /// The largest that is accepted.
        limit: usize,
    },
    /// Too many parts turn without limits.
    #[error("{turning} parts turn without limits, more than {limit}: give some a range of motion")]
    TooManyTurns {
        /// The number of such parts.
        turning: usize,
        /// The largest that is accepted.
        limit: usize,
    },
    /// There are no parts.
    #[error("modes are those of two parts or more, and {parts} are named")]
    TooFew {
        /// The number of parts that are named.
        parts: usize,
    },
    /// A configuration has another number of coordinates than there are parts.
    #[error("the configuration has {given} coordinates, and there are {parts} parts")]
    Coordinates {
        /// The number of coordinates.
        given: usize,
        /// The number of parts.
        parts: usize,
    },
    /// A configuration has a coordinate that is not finite.
    #[error("coordinate {coordinate} is not a finite number")]
    NotFinite {
        /// Name of the coordinate: `u`, `v`, `w`, and from the fourth part on `q4`, `q5` …
        coordinate: String,
    },
}

fn around(parts: &[String]) -> String {
    let quoted: Vec<String> = parts.iter().map(|p| format!("{p:?}")).collect();
    quoted.join(", ")
}

fn listed(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        parts => format!(": {}", parts.join(", ")),
    }
}
