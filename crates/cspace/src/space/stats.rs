//! Counts and times of one computation.

/// Counts and times of one computation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Statistics {
    /// Sheets: feature pairs that can touch, by intervals in which their ends keep their identity.
    pub sheets: u64,
    /// Pairs of sheets whose boxes meet.
    pub pairs: u64,
    /// Orientations examined as possibly critical, from pairs of sheets.
    pub pair_events: u64,
    /// Orientations at which three sheets meet.
    pub triple_events: u64,
    /// Different orientations among all events.
    pub clusters: u64,
    /// Crossings of two sheets; of large pairs, without those that are certainly in blocked space.
    pub branches: u64,
    /// Pieces of sheets.
    pub cells: u64,
    /// Configurations tested for overlap.
    pub overlap_tests: u64,
    /// Shells whose bounds and tests disagreed and were decided cell by cell; 0 in sound computations.
    pub conflicts: u64,
    /// Counts of decisions, by the certainty reached.
    #[cfg_attr(feature = "serde", serde(default))]
    pub decisions: Decisions,
    /// Seconds taken, by stage.
    pub seconds: StageSeconds,
}

/// Numbers of decisions: how many were made, and how many of these needed a second method or were left to the resolution.
///
/// Decisions for which the error bound of `f64` is too large are made in double-double.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Decisions {
    /// Intervals of orientation in which two branches may pass each other: decided by the polynomial of three carriers.
    pub passings: u64,
    /// Subset of `passings` in which the sign of the polynomial cannot be determined: decided by the order of places before and after.
    pub passings_by_places: u64,
    /// Orientations at which something may change.
    pub orientations: u64,
    /// Pieces of curve that two cells share at an orientation.
    pub overlaps: u64,
    /// Subset of `overlaps` that may be shorter than the errors of their ends: these do not join shells.
    pub overlaps_uncertain: u64,
    /// Shells, each decided by one overlap test and by the bounds of its cells.
    pub shells: u64,
}

/// Seconds taken by each stage.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct StageSeconds {
    /// Features, sheets and their names.
    pub sheets: f64,
    /// Pairs of sheets that may cross.
    pub candidates: f64,
    /// Orientations at which pairs change.
    pub pair_events: f64,
    /// Crossings followed over orientation.
    pub branches: f64,
    /// Orientations at which three sheets meet.
    pub triple_events: f64,
    /// Cutting sheets into cells.
    pub cells: f64,
    /// Deciding which cells bound free space.
    pub shells: f64,
    /// Patches, links, regions.
    pub graph: f64,
    /// All stages, and all of attempts that were not kept.
    pub total: f64,
}
