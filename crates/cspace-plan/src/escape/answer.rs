//! Answer to a question for an escape.

use cspace::{Coordinates, FeatureName};
use serde::Serialize;

use crate::answer::{Blocked, Enclosed};

/// The answer to a question for an escape.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Escaped {
    /// No energy lets the part out.
    Caged(Enclosed),
    /// So much does.
    Held(Held),
    /// The parts overlap at the start.
    FromBlocked(Blocked),
    /// The parts overlap at the goal.
    ToBlocked(Blocked),
}

/// How much energy lets a part out. Energies are counted from that at the start.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Held {
    /// The least energy: that of the one pass between the bounds, to rounding. None where there are several, where none was found, and
    /// where the bounds could not be brought together.
    pub energy: Option<f64>,
    /// No way needs less.
    pub least: f64,
    /// The path needs no more; infinite if none was found.
    pub most: f64,
    /// The places between these bounds where contacts balance the energy, the lowest first, and start or goal if their energy is
    /// between them.
    pub passes: Vec<Pass>,
    /// Configurations joined by motions of constant rates, from the start to the goal or out. Angles go on beyond π.
    pub path: Vec<Coordinates>,
}

/// A place at which a way may be highest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Pass {
    /// Where.
    pub at: Coordinates,
    /// Its energy, counted from that at the start.
    pub energy: f64,
    /// The features of the fixed and of the moving part that balance it.
    pub touching: Vec<(FeatureName, FeatureName)>,
}
