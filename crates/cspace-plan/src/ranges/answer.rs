//! Answers about two parts over their ranges, as data.

use cspace::{FeatureName, Point};

/// How two parts are to each other over all motions that their ranges allow.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// They never touch, and the smallest gap is less than was asked for.
    Clear(Tightest),
    /// They never come nearer than was asked for.
    Beyond,
    /// They touch somewhere.
    Touches(Held),
    /// It is not known, for this reason.
    Undecided(&'static str),
}

/// The smallest gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tightest {
    /// The distance of the parts at a configuration, in the model's unit of length.
    pub gap: f64,
    /// No configuration that the ranges allow has a smaller distance: a billionth of the gap less than it, or 10⁻¹⁰ of the parts' size if
    /// that is more; and 0 where it could not be proved.
    pub least: f64,
    /// The configuration (u, v).
    pub at: (f64, f64),
    /// The features that are nearest there, of the fixed and of the moving part.
    pub features: Option<[FeatureName; 2]>,
    /// The nearest points, in the assembly's frame.
    pub points: Option<[Point; 2]>,
}

/// How far two parts go that touch somewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct Held {
    /// Least and greatest u and v in the region in which the parts are drawn.
    pub reach: [Limits; 2],
    /// Ends of ranges, or of turns, to which parts do not come, and what stops them.
    pub stopped: Vec<Stop>,
    /// If a part can turn only with the other: v per u, in whole numbers of turns (of v, of u).
    pub ratio: Option<(i64, i64)>,
    /// The play of the moving part while the other is held, over a turn, where the parts turn together.
    pub backlash: Option<Backlash>,
    /// The gap by which the moving part is smaller all around in all of this, where the parts fit exactly: else they had no room to move.
    pub room: Option<f64>,
    /// A configuration of contact: that of the first stop if there is one.
    pub at: Option<(f64, f64)>,
    /// The features that touch there.
    pub features: Vec<[FeatureName; 2]>,
    /// The points that touch there, in the assembly's frame.
    pub points: Option<[Point; 2]>,
}

/// How far a coordinate goes, radians or the model's unit of length; infinite where it goes on without end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The least value.
    pub lo: f64,
    /// The greatest value.
    pub hi: f64,
}

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The least value of the coordinate.
    Lo,
    /// The greatest value.
    Hi,
}

/// End of a range or turn to which a part does not come, and what stops it.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// The part: 0 the fixed, 1 the moving one.
    pub part: usize,
    /// Which way it goes.
    pub end: End,
    /// Whether the part has a range in the model, the end of which it does not come to.
    pub is_declared: bool,
    /// The configuration (u, v) in which it has come farthest.
    pub at: (f64, f64),
    /// The features that touch there, of the fixed and of the moving part.
    pub features: Vec<[FeatureName; 2]>,
}

/// A configuration of contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// The configuration (u, v).
    pub at: (f64, f64),
    /// The features that touch there, of the fixed and of the moving part.
    pub features: Vec<[FeatureName; 2]>,
}

/// The play of the moving part while the other is held: how far it goes from contact to contact, radians or the model's unit of length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Backlash {
    /// The least over a turn of the fixed part.
    pub least: f64,
    /// The largest.
    pub most: f64,
    /// A configuration (u, v) at which it is the least, in the middle of the play.
    pub at: (f64, f64),
    /// One at which it is the largest.
    pub most_at: (f64, f64),
}
