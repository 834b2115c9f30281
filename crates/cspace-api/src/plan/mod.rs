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
#[serde(default)]
pub struct Question {
    /// The pair; the one of the model without.
    #[serde(flatten)]
    pub which: Which,
    /// The start; as drawn without.
    pub from: Option<Given>,
    /// The goal; `out`, where the parts can be taken apart for good, without.
    pub to: Option<Given>,
    /// The point of the moving part, in its frame, that legs move straight and about which they turn the part; its origin without, or the
    /// middle of a part that is drawn beside its origin.
    pub about: Option<[f64; 2]>,
    /// Whether the path is asked for whose smallest clearance is largest.
    pub widest: bool,
    /// The least clearance that the path must have, in the model's unit; half of what is possible without, or with `widest` all of it.
    pub clearance: Option<f64>,
    /// By what the path is chosen among those with that clearance.
    pub prefer: Prefer,
    /// The largest turn of a leg, in radians; none without.
    pub turn: Option<f64>,
    /// The farthest that a leg moves along a coordinate, in the model's unit; any distance without.
    pub travel: Option<f64>,
    /// Whether it is to be proved where there is no path.
    pub proof: bool,
    /// How deep the surface of the proof lies in blocked space, in the model's unit; as deep as can be without. With it the proof is asked for.
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
