//! What becomes of an assembly.

use cspace::FeatureName;
use serde::Serialize;

use crate::answer::Path;

/// Whether an assembly comes apart, and how. Parts are indices into the mechanism's.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TakenApart {
    /// Whether it does.
    pub outcome: Outcome,
    /// What is taken away, one after the other; also if not all comes apart.
    pub steps: Vec<Step>,
    /// The smallest set of parts that lock each other, if there is one.
    pub locked: Option<Locked>,
    /// Contact spaces that were computed.
    pub spaces: usize,
}

/// Whether an assembly comes apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// All parts that may leave do, in this order.
    Apart,
    /// Some do not: no part and no group of them can be taken out of the rest.
    Locked,
    /// No way was found, and none is excluded: there are too many parts for all groups, parts on axes or joints that could move were
    /// not moved, or a contact space is in doubt.
    Unknown,
}

/// Parts that are taken out of others.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// What moves, as one.
    pub moving: Vec<usize>,
    /// What stays, as drawn.
    pub staying: Vec<usize>,
    /// The motion of the moving parts in the frame of those that stay: from where they are drawn, which is (0, 0, 0), to where discs
    /// around both are apart.
    pub path: Path,
}

/// Parts of which no proper subset can be taken out of the rest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Locked {
    /// The parts.
    pub parts: Vec<usize>,
    /// Why: every division of the parts into two divides the two sides of one of these.
    pub why: Vec<Enclosure>,
}

/// Parts that cannot be taken out of others: their configuration as drawn is in a bounded region of their contact space.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Enclosure {
    /// What is enclosed.
    pub moving: Vec<usize>,
    /// By what.
    pub staying: Vec<usize>,
    /// How many contact patches bound the region.
    pub patches: usize,
    /// The features of these patches: part and feature of what stays, and of what moves.
    pub features: Vec<(PartFeature, PartFeature)>,
    /// Orientations at which the space is in doubt, radians.
    pub doubtful: Vec<(f64, f64)>,
}

/// A feature of a part, as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct PartFeature {
    /// The part.
    pub part: usize,
    /// The feature.
    pub feature: FeatureName,
}
