//! Whether symmetry is used, and which was found.

/// Whether rotational symmetry of the parts is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Symmetry {
    /// It is looked for, and used where it saves work.
    #[default]
    Detect,
    /// The general method is used whatever the parts are.
    Ignore,
}

/// The symmetry with which a contact space was computed.
///
/// A fixed part of fold k and a moving part of fold m make lcm(k, m) slabs of orientations that are images of each
/// other (figure 4 of Sacks 1999 has one symmetric part): one is computed, the others are copies.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PairSymmetry {
    /// Fold of the fixed part about its own centre; 1 without symmetry, or where none was looked for.
    pub fixed: u32,
    /// Fold of the moving part.
    pub moving: u32,
    /// Slabs that make a turn; 1 where all was computed: without symmetry, for a window within one slab, and where
    /// contacts are on circles whose halves, as drawn, meet in places that the symmetry does not map to each other.
    pub slabs: u32,
    /// How far the outlines computed are from the parts as drawn, in the model's unit of length: 0 for the general
    /// method, within rounding for parts drawn well.
    pub deviation: f64,
}

impl PairSymmetry {
    /// Whether symmetry was found of either part.
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
