//! Answers to a question for a path.

use cspace::{Coordinates, FeatureName, RegionId, Vector};
use serde::Serialize;

/// The answer to a question for a way.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// Whether there is one.
    pub verdict: Verdict,
    /// The free regions of start and goal; none where the parts overlap.
    pub regions: (Option<RegionId>, Option<RegionId>),
    /// Where the widest way is narrowest, if it was asked for and there is a way.
    pub bottleneck: Option<Bottleneck>,
}

/// Where the widest way is narrowest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Bottleneck {
    /// Where that is.
    pub narrow: Narrow,
    /// No path has more clearance than this, in the model's unit of length. None for a path that starts or ends in contact: by another
    /// leg off the contact there may be more.
    pub most: Option<f64>,
}

/// Whether there is a way.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub enum Verdict {
    /// There is.
    Path(Path),
    /// There is none: start and goal are in different free regions.
    NoPath(Enclosed),
    /// There is none with the clearance that was asked for; the [`Answer::bottleneck`] says why.
    TooNarrow,
    /// The parts overlap at the start.
    FromBlocked(Blocked),
    /// The parts overlap at the goal.
    ToBlocked(Blocked),
    /// It is not known: at these doubtful orientations (radians) the contact space is not relied upon; if there are none, rounding
    /// hides a path, or paths by another leg off a contact may have the requested clearance.
    Unknown(Vec<(f64, f64)>),
}

/// A path through free space.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Path {
    /// Configurations joined by motions of constant rates of all coordinates. The first is the start; the last the goal up to whole
    /// turns. Angles go on beyond π: nothing is taken modulo a turn.
    pub configurations: Vec<Coordinates>,
    /// The point of a planar part, in its frame, that legs move straight and about which they turn the part: its place and the
    /// orientation have constant rates. (0, 0) is the origin of the frame.
    pub about: Vector,
    /// Where it is narrowest.
    pub narrowest: Narrow,
}

/// Where a path is narrowest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Narrow {
    /// The least distance of the parts, in the model's unit of length.
    pub clearance: f64,
    /// The configuration.
    pub at: Coordinates,
    /// The features of the fixed and of the moving part that are nearest there.
    pub features: Option<(FeatureName, FeatureName)>,
}

/// The enclosure that keeps start and goal apart.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Enclosed {
    /// The region that is enclosed: that of start or goal which is bounded, or has fewer patches.
    pub region: RegionId,
    /// How many contact patches enclose it.
    pub patches: usize,
    /// The pairs of features, of the fixed and of the moving part, of these patches.
    pub features: Vec<(FeatureName, FeatureName)>,
}

/// Parts that overlap, or leave too little clearance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Blocked {
    /// How far it is to the nearest free configuration, in the model's unit: the length of the displacement, where a radian counts the
    /// reach of a part that turns.
    pub depth: f64,
    /// The nearest free configuration, up to contact.
    pub nearest: Option<Coordinates>,
    /// The features that touch there, and overlap at the configuration asked about.
    pub features: Option<(FeatureName, FeatureName)>,
}
