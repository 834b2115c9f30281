//! The smallest gap of every two parts, or what overlaps: as drawn, or over a motion.

use std::time::Instant;

use cspace::{Part, Point};
use cspace_model::Mechanism;
use cspace_plan::clash::{Assembly, Clash, Clashes, Question as Limits, Sample, State};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::frame::{Answer, Content, PairAnswer};
use crate::given;
use crate::host::Host;
use crate::outcome::{outcomes, worst};
use crate::subject::{Subject, named_pair, tell_starts};

/// Number of parts up to which all pairs are listed: so many parts make some 20,000 pairs.
const MANY: usize = 200;
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
    /// List pairs nearer than this, in the model's unit, and count the others [default: all; of more than 200 parts a tenth of the largest
    /// part's size]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::distance, allow_negative_numbers = true))]
    pub within: Option<f64>,
    /// Parts touch that are nearer than this, or overlap by less, in the model's unit [default: 1e-11 of the larger part's size]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::distance, allow_negative_numbers = true, hide_short_help = true))]
    pub touch: Option<f64>,
    /// A motion, by samples in order of time, between which coordinates have constant rates; the parts as drawn without.
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
        /// Over a motion, their boundaries meet between two samples at which they are apart.
        Meets = "meets" is Yes,
        /// They touch.
        Touches = "touches" is Yes,
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
    /// The number of pairs that are not listed: their gap is `within` or more.
    pub beyond: usize,
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
    /// The least distance, in the model's unit; 0 of boundaries that meet between samples, none of parts that overlap or are joined.
    pub gap: Option<f64>,
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
    /// Over a motion, when that is (s).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<f64>,
}

/// Motions over which a gap is the smallest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Over {
    /// No motion: the parts are as drawn.
    Drawn,
    /// Motions of a record.
    Record,
}

impl Question {
    /// Finds the gaps.
    ///
    /// # Errors
    /// If it is about no model, or there is no such pair.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Clearances>, Error> {
        let file = subject.model("clashes are found between all of its parts")?;
        given::size(host, "within", self.within)?;
        given::size(host, "touch", self.touch)?;
        let model = &file.model.mechanism;
        let pair = (self.pair.as_ref())
            .map(|names| named_pair(&file.path, model, names, host))
            .transpose()?;
        if self.along.is_none() {
            tell_starts(model, host);
        }
        let begin = Instant::now();
        let within = self.within.unwrap_or_else(|| default_within(model));
        let limits = Limits {
            within,
            touch: self.touch,
            pair: pair.map(|p| [p.fixed, p.moving]),
        };
        let assembly = Assembly::new(model);
        let clashes = match &self.along {
            Some(samples) => assembly.along(samples, &limits),
            None => assembly.drawn(&limits),
        };
        let found = Clearances {
            within: Some(within).filter(|w| w.is_finite()),
            along: (self.along.as_ref()).and_then(|s| Some([s.first()?.time, s.last()?.time])),
            seconds: begin.elapsed().as_secs_f64(),
            ..self.of(model, clashes)
        };
        let outcome = worst(found.pairs.iter().map(|pair| pair.outcome));
        Ok(Answer::new(model.unit.as_deref(), outcome, found))
    }

    fn of(&self, model: &Mechanism, clashes: Clashes) -> Clearances {
        let over = match self.along {
            Some(_) => Over::Record,
            None => Over::Drawn,
        };
        let pairs = clashes.pairs.into_iter();
        Clearances {
            parts: model.parts.len(),
            pairs: pairs.map(|clash| answer(model, over, &clash)).collect(),
            beyond: clashes.beyond,
            within: None,
            along: None,
            seconds: 0.0,
        }
    }
}

fn default_within(model: &Mechanism) -> f64 {
    if model.parts.len() <= MANY {
        return f64::INFINITY;
    }
    let sizes = model.parts.iter().map(|p| p.part.size());
    NEARBY * sizes.fold(0.0, f64::max)
}

fn answer(model: &Mechanism, over: Over, clash: &Clash) -> PairAnswer<Clearance> {
    let [a, b] = clash.parts.map(|i| -> &Part { &model.parts[i].part });
    PairAnswer {
        fixed: a.name().to_owned(),
        moving: b.name().to_owned(),
        outcome: clash.state.into(),
        content: Clearance {
            over,
            gap: clash.gap,
            depth: clash.depth,
            offset: clash.offset,
            points: clash.points.map(|p| p.map(|Point { x, y }| [x, y])),
            touching: (clash.features).map(|[f, g]| [a.feature_text(f), b.feature_text(g)]),
            at: clash.time,
        },
    }
}
