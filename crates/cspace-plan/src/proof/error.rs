//! Why there is no proof.

use cspace::{PairError, PartError, QueryError};

/// Why there is no proof.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProofError {
    /// The pair is of another class.
    #[error("proofs are written for planar pairs only")]
    NotPlanar,
    /// Start or goal cannot be classified.
    #[error(transparent)]
    Query(#[from] QueryError),
    /// The shrunk part is no valid part.
    #[error("the moving part shrunk by {depth:?}: {error}")]
    Part {
        /// Distance by which it was to be shrunk.
        depth: f64,
        /// Reason why it is no part.
        error: PartError,
    },
    /// The requested depth is invalid.
    #[error("a depth has to be positive and finite, not {0:?}")]
    Depth(f64),
    /// The pair with the moving part shrunk cannot be computed.
    #[error("the pair with the moving part shrunk: {0}")]
    Pair(#[from] PairError),
    /// Start and goal are in one region at all depths that were tried.
    #[error(
        "start and goal are in one region also when the moving part is smaller by {least:?} only: no proof is as fine"
    )]
    TooShallow {
        /// The least depth that was tried.
        least: f64,
    },
    /// The requested depth is less than the resolution.
    #[error(
        "a depth of {depth:?} is too fine: a surface so near to the contacts is not resolved; the least depth for this moving part is \
         {finest:?}"
    )]
    TooFine {
        /// Requested depth.
        depth: f64,
        /// The least that is tried.
        finest: f64,
    },
    /// The proof needs more triangles than the limit.
    #[error(
        "with a depth of {depth:?} the proof takes more than {limit} triangles; their number grows as one over the depth or faster, and {}",
        more(*given)
    )]
    TooManyTriangles {
        /// The most that are made.
        limit: usize,
        /// Depth of the surface.
        depth: f64,
        /// Whether the depth was requested.
        given: bool,
    },
    /// Triangles around a configuration became as small as is worth trying.
    #[error(
        "no two discs of material that overlap were found near x {:?}, y {:?}, theta {:?} (of the middle of the moving part)", at[0], at[1], at[2]
    )]
    NoWitness {
        /// Centre of the moving part's box, and its orientation.
        at: [f64; 3],
    },
    /// The proof was made, and is wrong: a fault of this library.
    #[error("the proof does not pass its check: {0}")]
    Unsound(String),
}

fn more(given: bool) -> &'static str {
    if given {
        "without one that is given it is as deep as can be"
    } else {
        "this depth is about the largest at which start and goal are apart"
    }
}
