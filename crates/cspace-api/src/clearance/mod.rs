//! The smallest gap of every two parts, or what overlaps: over all motions that their ranges allow, over a cycle of drives, as drawn, or over a
//! motion.

mod cycle;
mod order;
mod ranges;

use std::collections::BTreeMap;
use std::time::Instant;

use cspace::{Coordinates, PairError, Part, Point};
use cspace_model::{Mechanism, PairEntry};
use cspace_plan::clash::{Assembly, Clash, Clashes, Question as Limits, Sample, State};
use cspace_plan::ranges::Pairs;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::frame::{Answer, Content, PairAnswer};
use crate::given;
use crate::host::Host;
use crate::outcome::outcomes;
use crate::subject::{Subject, Which, named_pair, tell_starts};

/// Number of parts up to which all pairs are listed: so many parts make some 20,000 pairs.
const MANY: usize = 200;
/// Number of pairs on axes up to which all are listed over their ranges: each takes some milliseconds.
const MANY_ON_AXES: usize = 500;
/// Default of `within` for more parts, as a share of the largest part's size.
const NEARBY: f64 = 0.1;

/// Which parts are looked at, and where.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// This pair alone: names of its two parts, with a comma between.
    #[cfg_attr(feature = "command", arg(long, value_name = "FIRST,SECOND"))]
    pub pair: Option<String>,
    /// All pairs as drawn, in place of over the ranges of their parts and the cycles of drives.
    #[cfg_attr(feature = "command", arg(long))]
    pub drawn: bool,
    /// List pairs nearer than this, in the model's unit, and count the others [default: all; of more than 200 parts, or 500 pairs over their
    /// ranges, a tenth of the largest part's size]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::distance, allow_negative_numbers = true))]
    pub within: Option<f64>,
    /// Parts touch that are nearer than this, or overlap by less, in the model's unit [default: 1e-11 of the larger part's size]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::distance, allow_negative_numbers = true, hide_short_help = true))]
    pub touch: Option<f64>,
    /// A motion, by samples in order of time, between which coordinates have constant rates.
    #[cfg_attr(feature = "command", arg(skip))]
    pub along: Option<Vec<Sample>>,
}

outcomes! {
    /// How two parts are to each other.
    Outcome {
        /// No pair is listed.
        Done = "done" is Yes,
        /// They overlap.
        Overlaps = "overlaps" is No,
        /// No pair overlaps, and a part does not come to an end of its range: outcome of all pairs together.
        Stopped = "stopped" is No,
        /// It could not be decided.
        Undecided = "undecided" is Open,
        /// Over a motion, their boundaries meet between two samples at which they are apart.
        Meets = "meets" is Yes,
        /// They touch, over their ranges somewhere.
        Touches = "touches" is Yes,
        /// Neither can turn without the other.
        Meshes = "meshes" is Yes,
        /// There is a gap between them.
        Clear = "clear" is Yes,
        /// A joint connects them; they are not judged.
        Joined = "joined" is Yes,
    }
}

impl From<State> for Outcome {
    fn from(state: State) -> Self {
        match state {
            State::Overlap => Self::Overlaps,
            State::Meets => Self::Meets,
            State::Touching => Self::Touches,
            State::Clear => Self::Clear,
            State::Joined => Self::Joined,
        }
    }
}

impl Content for Clearances {
    const COMMAND: &'static str = "clearance";
    type Outcome = Outcome;
}

impl Content for Clearance {
    const COMMAND: &'static str = "clearance";
    type Outcome = Outcome;
}

/// The gaps of pairs of parts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Clearances {
    /// The number of parts.
    pub parts: usize,
    /// Pairs of parts, the worst first.
    pub pairs: Vec<PairAnswer<Clearance>>,
    /// The number of pairs that are not listed, because their gap is `within` or more.
    pub beyond: usize,
    /// The number of pairs that are not listed, because their parts are at different heights and never touch.
    #[serde(skip_serializing_if = "is_none")]
    pub different_heights: usize,
    /// Pairs with a smaller gap are listed, in the model's unit; none if all are.
    pub within: Option<f64>,
    /// The first and the last time of the motion (s).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub along: Option<[f64; 2]>,
    /// How long it took (s).
    pub seconds: f64,
}

/// The gap of two parts, or their overlap.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Clearance {
    /// The motions over which it is.
    pub over: Over,
    /// The least distance, in the model's unit; 0 of boundaries that meet, none of parts that overlap or are joined.
    pub gap: Option<f64>,
    /// Over their ranges and over a cycle, of parts that are clear: no configuration has a smaller distance than this, which is a billionth less
    /// than the gap, or 10⁻¹⁰ of the parts' size if that is more; less where no more was proved, 0 where nothing was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub least: Option<f64>,
    /// The length of the shortest translation of the second part that separates parts that overlap; none of others, and of parts with too many
    /// edges.
    pub depth: Option<f64>,
    /// The smallest distance by which the second of two parts that overlap has to be made smaller all around so that they do not; none of
    /// others, over a motion, and where its edges are too small for it.
    pub offset: Option<f64>,
    /// A point of each part in the assembly's frame: the nearest; of parts that overlap those that touch after the translation, the second
    /// where it is before.
    pub points: Option<[[f64; 2]; 2]>,
    /// The features of the two parts at these points.
    pub touching: Option<[String; 2]>,
    /// When or where that is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<At>,
    /// Over their ranges, of parts that touch: least and greatest motion of each part that moves, in the region in which the parts are drawn;
    /// none where it goes on without end.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub reach: BTreeMap<String, [Option<f64>; 2]>,
    /// Over their ranges, the gap by which the second part is smaller all around, where the parts fit exactly, so that there is room to move.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub room: Option<f64>,
    /// Ends of ranges, or of turns, to which parts do not come, and what stops them there.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub stopped: Vec<Stopped>,
    /// Turns of the second part for a turn of the first, where they turn only together.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
    /// Play of the second part while the first is held, over a turn of the first, where they turn only together; none where something within
    /// that play is passed on two sides.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub backlash: Option<Backlash>,
    /// Over a cycle, what that is and how far the parts go through it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle: Option<Cycle>,
}

/// One cycle of the drives that move two parts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Cycle {
    /// Its first and last time (s).
    pub times: [f64; 2],
    /// Driven parts that turn round, with the number of their turns.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub turns: BTreeMap<String, u32>,
    /// The time up to which the parts go (s): the last, unless something halts them.
    pub reached: f64,
    /// Reason why they go no farther.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub halt: Option<Halt>,
    /// Where the driven parts are at the time that is told: angles (rad), or lengths in the model's unit.
    pub drives: BTreeMap<String, f64>,
    /// Where the drives are when the parts are halted.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub halted: BTreeMap<String, f64>,
    /// Configurations (x, y, θ) of the two parts at that time.
    pub poses: [[f64; 3]; 2],
    /// Driven parts that turn.
    #[serde(skip)]
    pub angles: Vec<String>,
}

/// Reason why parts do not go through the whole cycle.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Halt {
    /// Joints do not determine where parts go from there, or let them go nowhere.
    DeadPoint,
    /// A part comes to the end of its range.
    Range(String),
}

/// When or where something is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum At {
    /// The time of a motion (s).
    Time(f64),
    /// A configuration of two parts on axes.
    Place(Coordinates),
}

/// End of a range, or of a turn, to which a part does not come.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct Stopped {
    /// The part.
    pub part: String,
    /// The end to which it does not come.
    pub end: End,
    /// How far it should go that way by its range; none if it has none.
    pub of: Option<f64>,
    /// The configuration in which it has come farthest.
    pub at: Coordinates,
    /// The features that touch there, of the first and of the second part.
    pub touching: Vec<[String; 2]>,
    /// Whether its coordinate is an angle.
    #[serde(skip)]
    pub turns: bool,
}

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum End {
    /// The least value.
    Lo,
    /// The greatest value.
    Hi,
}

/// Play over a turn.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Backlash {
    /// The least (rad).
    pub least: f64,
    /// The largest (rad).
    pub most: f64,
    /// A configuration at which it is the least, in its middle.
    pub at: Coordinates,
}

/// Motions over which a gap is the smallest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Over {
    /// All motions that the ranges of two parts on axes allow: of one that turns and has no range, a whole turn.
    Ranges,
    /// No motion: the parts are as drawn.
    Drawn,
    /// Motions of a record.
    Record,
    /// One cycle of the drives that move the parts through joints.
    Cycle,
}

impl Question {
    /// Finds the gaps.
    ///
    /// # Errors
    /// If it is about no model, there is no such pair, or the work is interrupted.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Clearances>, Error> {
        let file = subject.model("clashes are found between all of its parts")?;
        given::size(host, "within", self.within)?;
        given::size(host, "touch", self.touch)?;
        let model = &file.model.mechanism;
        let pair = (self.pair.as_ref())
            .map(|names| named_pair(&file.path, model, names, host))
            .transpose()?;
        let begin = Instant::now();
        let limits = Limits {
            within: self.within.unwrap_or_else(|| self.default_within(model)),
            touch: self.touch,
            pair: pair.map(|p| [p.fixed, p.moving]),
        };
        let assembly = Assembly::new(model);
        let (rows, beyond) = match &self.along {
            Some(samples) => rows(model, Over::Record, &assembly.along(samples, &limits)),
            None if self.drawn => {
                tell_starts(model, host);
                rows(model, Over::Drawn, &assembly.drawn(&limits))
            }
            None => {
                subject.note_on_pairs(host);
                ranges::rows(subject, model, &assembly, &limits, host)?
            }
        };
        let different_heights = different_heights(model, limits.pair);
        let found = Clearances {
            parts: model.parts.len(),
            pairs: rows,
            beyond: beyond.saturating_sub(different_heights),
            different_heights,
            within: Some(limits.within).filter(|w| w.is_finite()),
            along: (self.along.as_ref()).and_then(|s| Some([s.first()?.time, s.last()?.time])),
            seconds: begin.elapsed().as_secs_f64(),
        };
        let outcome = order::of_all(&found.pairs);
        Ok(Answer::new(model.unit.as_deref(), outcome, found))
    }

    fn default_within(&self, model: &Mechanism) -> f64 {
        let is_over_ranges = self.along.is_none() && !self.drawn;
        let is_many = || is_over_ranges && Pairs::of(model).count() > MANY_ON_AXES;
        if model.parts.len() <= MANY && !is_many() {
            return f64::INFINITY;
        }
        let sizes = model.parts.iter().map(|p| p.part.size());
        NEARBY * sizes.fold(0.0, f64::max)
    }
}

/// Why two parts are not looked at, with their names.
fn failure(subject: &Subject, pair: [usize; 2], error: &PairError, host: &dyn Host) -> Error {
    let which = PairEntry {
        fixed: pair[0],
        moving: pair[1],
        window: None,
    };
    (subject.pair_of(which, &Which::default(), host)).failure(error)
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "called by serde")]
fn is_none(count: &usize) -> bool {
    *count == 0
}

/// How many pairs, or whether one, is of parts at different heights that no joint connects.
fn different_heights(model: &Mechanism, pair: Option<[usize; 2]>) -> usize {
    let parts = &model.parts;
    if !parts.iter().any(|p| p.part.has_heights()) {
        return 0;
    }
    let apart =
        |&[a, b]: &[usize; 2]| !parts[a].part.meets(&parts[b].part) && model.joint(a, b).is_none();
    match pair {
        Some(pair) => usize::from(apart(&pair)),
        None => {
            let n = parts.len();
            let all = (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j]));
            all.filter(apart).count()
        }
    }
}

type Row = PairAnswer<Clearance>;

/// The pairs of clashes, and how many are farther apart than was asked for.
fn rows(model: &Mechanism, over: Over, clashes: &Clashes) -> (Vec<Row>, usize) {
    let pairs = clashes.pairs.iter();
    let rows = pairs.map(|clash| row(model, over, clash)).collect();
    (rows, clashes.beyond)
}

fn row(model: &Mechanism, over: Over, clash: &Clash) -> Row {
    let [a, b] = clash.parts.map(|i| -> &Part { &model.parts[i].part });
    PairAnswer {
        fixed: a.name().to_owned(),
        moving: b.name().to_owned(),
        outcome: clash.state.into(),
        content: Clearance {
            gap: clash.gap,
            depth: clash.depth,
            offset: clash.offset,
            points: clash.points.map(numbers),
            touching: (clash.features).map(|[f, g]| [a.feature_text(f), b.feature_text(g)]),
            at: clash.time.map(At::Time),
            ..Clearance::nothing(over)
        },
    }
}

fn numbers(points: [Point; 2]) -> [[f64; 2]; 2] {
    points.map(|Point { x, y }| [x, y])
}

impl Clearance {
    /// Nothing but the motions that were looked at.
    fn nothing(over: Over) -> Self {
        Self {
            over,
            gap: None,
            least: None,
            depth: None,
            offset: None,
            points: None,
            touching: None,
            at: None,
            reach: BTreeMap::new(),
            room: None,
            stopped: Vec::new(),
            ratio: None,
            backlash: None,
            cycle: None,
        }
    }
}
