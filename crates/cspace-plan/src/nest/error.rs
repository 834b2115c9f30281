//! Reasons for which a part has no places in a container.

use cspace::{PairError, PartError};

/// Reasons for which nothing is known of a part in a container.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NestError {
    /// A placed part is not within the container.
    #[error("the placed part {number}, counted from 0, overlaps the outside of the container")]
    Outside {
        /// Its number.
        number: usize,
    },
    /// Two placed parts overlap.
    #[error("the placed parts {first} and {second} overlap, counted from 0")]
    Overlap {
        /// Number of the first of them.
        first: usize,
        /// Number of the second.
        second: usize,
    },
    /// A part is not flat.
    #[error("{part:?} has layers: give its outline at the height at which it is to be placed")]
    Layers {
        /// Its name.
        part: String,
    },
    /// The walls are no part.
    #[error(transparent)]
    Part(#[from] PartError),
    /// The space cannot be computed.
    #[error(transparent)]
    Space(#[from] PairError),
}

impl NestError {
    /// Two of the container and the placed parts overlap, which are numbered from 0 and from 1.
    pub(super) fn overlap(first: usize, second: usize) -> Self {
        match first {
            0 => Self::Outside { number: second - 1 },
            _ => Self::Overlap {
                first: first - 1,
                second: second - 1,
            },
        }
    }
}
