//! Question and answer of a search for clashes, as data.

use cspace::{FeatureName, Point};

use crate::legs::Coords;

/// Question: the limits of the search for clashes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Question {
    /// Parts that are clear of each other by this or more are counted, not listed; in the model's unit of length.
    pub within: f64,
    /// Parts nearer than this touch, and so do parts that overlap by less; a little more than the resolution unless it is given.
    pub touch: Option<f64>,
    /// The one pair that is asked about, by the numbers of its parts; every two parts if there is none.
    pub pair: Option<[usize; 2]>,
}

impl Default for Question {
    fn default() -> Self {
        Self {
            within: f64::INFINITY,
            touch: None,
            pair: None,
        }
    }
}

/// State of two parts relative to each other, the worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum State {
    /// The parts overlap.
    Overlap,
    /// The boundaries meet between two samples of a motion, at neither of which the parts overlap or touch.
    Meets,
    /// The parts touch.
    Touching,
    /// There is a gap between the parts.
    Clear,
    /// A joint connects the parts. They may overlap as drawn, and are not looked at.
    Joined,
}

/// Two parts and what they are to each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Clash {
    /// The parts' numbers in the mechanism.
    pub parts: [usize; 2],
    /// State of the two parts.
    pub state: State,
    /// The least distance of parts that do not overlap, in the model's unit of length.
    pub gap: Option<f64>,
    /// The length of the shortest translation that separates parts that overlap; none if the parts have too many edges for it.
    pub depth: Option<f64>,
    /// The smallest distance by which the second of two parts that overlap has to be made smaller all around, so that they do not: the
    /// interference of a press fit, for which no short translation separates them. None if edges of the part are too small for it, and over a
    /// motion.
    pub offset: Option<f64>,
    /// A point of each part, in the assembly's frame: the nearest points of parts that are apart; of parts that overlap the points
    /// that touch after the translation, the second where it is before.
    pub points: Option<[Point; 2]>,
    /// The features of the two parts at these points.
    pub features: Option<[FeatureName; 2]>,
    /// When that is, over a motion.
    pub time: Option<f64>,
}

/// All pairs that were asked about, the worst first.
#[derive(Debug, Clone, PartialEq)]
pub struct Clashes {
    /// The pairs that are listed.
    pub pairs: Vec<Clash>,
    /// How many pairs are clear of each other by more than was asked for.
    pub beyond: usize,
}

/// All parts at a time.
#[derive(Debug, Clone, PartialEq, schemars::JsonSchema, serde::Deserialize)]
pub struct Sample {
    /// The time (s).
    pub time: f64,
    /// For every part x, y and θ, or its motion on its axis and twice 0.
    pub parts: Vec<Coords>,
}
