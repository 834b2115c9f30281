//! Options and results of the search for critical orientations.

/// Result of the search for critical orientations, with its cost.
#[derive(Debug, Clone, PartialEq)]
pub struct Criticalities {
    /// The realisable critical orientations, radians in [−π, π), increasing; those within 4e-6 rad of each other are one.
    pub orientations: Vec<f64>,
    /// Contacts: pairs of features that can touch.
    pub contacts: usize,
    /// Solutions of the equations.
    pub candidates: u64,
    /// Candidates not examined because their orientation was known.
    pub skipped: u64,
    /// Configurations tested for overlap of the parts.
    pub overlap_tests: u64,
}

/// Whether an orientation that is known to be critical is examined again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Known {
    /// Every criticality is examined, as the general algorithm does (section 2).
    Examined,
    /// Criticalities at a known orientation are not examined (section 3.3).
    Skipped,
}
