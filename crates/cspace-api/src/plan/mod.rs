//! Whether there is a path from one configuration to another, and which.

mod answer;
mod judge;
mod proof;

use std::time::Instant;

use cspace::Coordinates;
use cspace_plan::{Clearance, PlanError, Planner, Prefer, Wishes};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;
use crate::frame::{Answer, Pairs};
use crate::given::{self, Given};
use crate::subject::{Chosen, Which, about};

pub(crate) use answer::Parts;
pub use answer::{Bottleneck, Contact, Enclosed, Outcome, Overlap, Place, Plan, Regions};
pub use judge::Judge;

/// Reason for a missing proof: there is a path, but it is too narrow.
const NARROW: &str = "there is a way, with less clearance than is asked for; what is proved is that there is no way at all";

/// The goal that is where the part is out.
const OUT: &str = "out";

/// Which path is asked for.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Question {
    /// The pair; the one of the model without.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub which: Which,
    /// The point of the moving part, in its frame, that moves straight and about which the part turns [default: its origin, or the middle of
    /// a part that is drawn beside its origin]
    #[cfg_attr(feature = "command", arg(long, value_name = "X,Y", value_parser = crate::command::point, allow_hyphen_values = true, hide_short_help = true))]
    pub about: Option<[f64; 2]>,
    /// The configuration to begin at, x,y,theta, or u,v of a pair on fixed axes; as drawn unless given.
    #[cfg_attr(
        feature = "command",
        arg(long, value_name = "C", allow_hyphen_values = true)
    )]
    pub from: Option<Given>,
    /// The configuration to come to; `out`, where the parts can be taken apart for good, unless given.
    #[cfg_attr(
        feature = "command",
        arg(long, value_name = "C", allow_hyphen_values = true)
    )]
    pub to: Option<Given>,
    /// The path whose smallest clearance is largest, and its bottleneck.
    #[cfg_attr(feature = "command", arg(long, conflicts_with = "clearance"))]
    pub widest: bool,
    /// A path with at least this clearance, in the model's unit [default: half of what is possible]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::distance, allow_negative_numbers = true))]
    pub clearance: Option<f64>,
    /// Property by which the path is chosen among those with that clearance.
    #[cfg_attr(feature = "command", arg(long, value_name = "WHAT", value_parser = crate::command::words::<Prefer>(), default_value = "legs", hide_short_help = true))]
    pub prefer: Prefer,
    /// No leg turns by more than this, in radians or such as 18deg.
    #[cfg_attr(feature = "command", arg(long, value_name = "A", value_parser = crate::command::turn, allow_hyphen_values = true, hide_short_help = true))]
    pub turn: Option<f64>,
    /// No leg moves along a coordinate by more than this, in the model's unit.
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::length, allow_negative_numbers = true, hide_short_help = true))]
    pub travel: Option<f64>,
    /// Prove it where there is no path.
    #[cfg_attr(feature = "command", arg(skip))]
    pub proof: bool,
    /// How deep the surface of a proof lies in blocked space, in the model's unit [default: as deep as can be]; it asks for a proof
    #[cfg_attr(feature = "command", arg(long, value_name = "D", value_parser = crate::command::length, allow_negative_numbers = true, hide_short_help = true))]
    pub depth: Option<f64>,
}

impl Question {
    /// The start.
    ///
    /// # Errors
    /// If what is given is no configuration of the pair.
    pub fn start(&self, pair: &Chosen<'_>) -> Result<Coordinates, Error> {
        pair.at("from", self.from.as_ref())
    }

    /// The goal; none if it is any configuration in which the part is out.
    ///
    /// # Errors
    /// If what is given is no configuration of the pair.
    pub fn goal(&self, pair: &Chosen<'_>) -> Result<Option<Coordinates>, Error> {
        goal(pair, self.to.as_ref())
    }

    /// Paths of these pairs.
    ///
    /// # Errors
    /// If a pair cannot be computed, or start or goal are not where can be asked.
    pub fn ask(&self, pairs: &[Chosen<'_>]) -> Result<Answer<Pairs<Plan>>, Error> {
        about(pairs, |pair| {
            let plan = self.of(pair)?;
            Ok(pair.answer(plan.verdict, plan))
        })
    }

    fn of(&self, pair: &Chosen<'_>) -> Result<Plan, Error> {
        let host = pair.host();
        for (option, value) in [
            ("clearance", self.clearance),
            ("turn", self.turn),
            ("travel", self.travel),
            ("depth", self.depth),
        ] {
            given::size(host, option, value)?;
        }
        if self.widest && self.clearance.is_some() {
            let (widest, clearance) = (host.option("widest"), host.option("clearance"));
            let both = format_args!("{widest} and {clearance} are both given");
            return Err(Error::new(both).help(format_args!("leave {clearance} out")));
        }
        let (from, goal) = (self.start(pair)?, self.goal(pair)?);
        let ends: Vec<Coordinates> = [from].into_iter().chain(goal).collect();
        let (space, gap) = pair.space_with_room(&ends)?;
        let failed = |error| failure(pair, &error);
        let begin = Instant::now();
        let planner = match pair.about(self.about)? {
            Some(about) => Planner::with_about(&space, about),
            None => Planner::new(&space),
        }
        .map_err(failed)?;
        let wishes = self.wishes(pair);
        let (to, answer) = {
            let progress = pair.host().begin(&pair.names());
            match goal {
                Some(to) => (planner.plan_with(from, to, &wishes, &*progress)).map(|a| (to, a)),
                None => planner.plan_out(from, &wishes, &*progress),
            }
        }
        .map_err(failed)?;
        let legs = (planner.scene(), pair.unit_label());
        let mut plan = Plan::planned(&space, legs, goal, answer, begin.elapsed().as_secs_f64());
        plan.gap = gap;
        if plan.verdict == Outcome::NoPath && (self.proof || self.depth.is_some()) {
            if plan.enclosed.is_some() {
                proof::add(&mut plan, pair, &space, [from, to], self.depth)?;
            } else {
                plan.unproved = Some(NARROW.to_owned());
            }
        }
        Ok(plan)
    }

    fn wishes(&self, pair: &Chosen<'_>) -> Wishes {
        let turn = self.turn.unwrap_or(f64::INFINITY);
        let travel = self.travel.unwrap_or(f64::INFINITY);
        let (u_turns, v_turns) = pair.turns();
        let limit = |turns: bool| if turns { turn } else { travel };
        Wishes {
            clearance: match self.clearance {
                Some(least) => Clearance::AtLeast(least),
                None if self.widest => Clearance::Widest,
                None => Clearance::Half,
            },
            steps: match pair.is_on_axes() {
                true => [limit(u_turns), limit(v_turns), f64::INFINITY],
                false => [travel, travel, turn],
            },
            prefer: self.prefer,
        }
    }
}

/// The goal that is given; none if it is any configuration in which the part is out.
pub(crate) fn goal(pair: &Chosen<'_>, to: Option<&Given>) -> Result<Option<Coordinates>, Error> {
    let is_out = |to: &&Given| matches!(to, Given::Text(text) if text == OUT);
    (to.filter(|to| !is_out(to)))
        .map(|to| pair.coordinates("to", to))
        .transpose()
}

fn failure(pair: &Chosen<'_>, error: &PlanError) -> Error {
    let option = |name| pair.option(name);
    match error {
        PlanError::From(e) | PlanError::Pair(e) => pair.unanswered(&option("from"), e),
        PlanError::To(e) => pair.unanswered(&option("to"), e),
        PlanError::Grown(e) => pair.failure(e),
        PlanError::NoGoal => Error::new(format_args!(
            "{} is missing: on fixed axes no configuration is out",
            option("to")
        ))
        .help(format_args!(
            "give the configuration to come to: {}=U,V",
            option("to")
        )),
        PlanError::TooFar { .. } => Error::new(error).help("choose one nearer to the parts"),
        PlanError::TooManyLegs(_) => Error::new(format_args!(
            "{}, {}: {error}",
            option("turn"),
            option("travel")
        ))
        .help("give larger ones"),
        _ => Error::new(error),
    }
}
