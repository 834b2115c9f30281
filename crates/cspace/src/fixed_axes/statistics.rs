//! Counts of a computation.

/// Counts of a computation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesStatistics {
    /// Pairs of features that touch somewhere.
    pub pairs: usize,
    /// Monotone pieces of their contact curves.
    pub pieces: usize,
    /// Crossings of pieces.
    pub crossings: usize,
    /// Tests of overlap. A part that is symmetric about its pivot is tested in one period only.
    pub tests: usize,
    /// Places at which tests and structure told different things, or the structure contradicts itself, that no attempt was
    /// without; 0 unless something lies closer than the resolution. If there are any, configurations are classified by
    /// intersecting the placed parts, and regions and patches are not to be relied upon.
    pub conflicts: usize,
}
