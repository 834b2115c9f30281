//! Why it is not known how much room a part has.

use cspace::{PairError, PartError};

/// Why it is not known how much room a part has.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A space cannot be computed, or a progress ended that.
    #[error(transparent)]
    Pair(#[from] PairError),
    /// No orientation of the box is in the window.
    #[error("the box has no orientation in the pair's window")]
    Outside,
    /// In the space of the part, held in the box, some contacts contradict each other.
    #[error("some features of the parts lie closer than can be told apart")]
    Doubtful,
    /// The part grown by some distance has no outline that a part can have.
    #[error("the part grown or shrunk: {0}")]
    Part(#[from] PartError),
}
