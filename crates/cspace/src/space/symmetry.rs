//! Use of symmetry, and the symmetry found.

/// Whether the rotational symmetry of the parts is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Symmetry {
    /// Symmetry is detected, and used where it saves work.
    #[default]
    Detect,
    /// The general method is used for all parts.
    Ignore,
}

/// The symmetry with which a contact space was computed.
///
/// A fixed part of fold k and a moving part of fold m divide the turn into lcm(k, m) periods (slabs) that are images of each other (figure
/// 4 of Sacks 1999 has one symmetric part): one is computed, the others are copies.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PairSymmetry {
    /// Fold of the fixed part about its own centre; 1 if it is not symmetric, or symmetry was not used.
    pub fixed: u32,
    /// Fold of the moving part.
    pub moving: u32,
    /// Number of periods in a turn; 1 where the whole turn was computed: without symmetry, for a window within one period, and where
    /// contacts are on circles whose halves, as drawn, meet in places that the symmetry does not map to each other.
    pub slabs: u32,
    /// Deviation of the outlines as computed from the parts as drawn, in the model's unit of length: 0 for the general method, and within
    /// rounding for parts drawn exactly.
    pub deviation: f64,
}

impl PairSymmetry {
    /// Whether either part is symmetric.
    pub const fn is_any(&self) -> bool {
        self.fixed > 1 || self.moving > 1
    }
}

impl Default for PairSymmetry {
    /// No symmetry.
    fn default() -> Self {
        Self {
            fixed: 1,
            moving: 1,
            slabs: 1,
            deviation: 0.0,
        }
    }
}
