//! What can be wrong with a part.

/// Why loops do not make a part. Loops and vertices are counted from 0, as given.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PartError {
    /// There is no loop.
    #[error("the part has no loops")]
    Empty,
}
