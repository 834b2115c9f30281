//! The least energy with which a part gets out, or to a goal, against gravity, loads and springs.

use std::time::Instant;

use cspace::{ComputeError, Coordinates, Vector};
use cspace_design::FeaturePair;
use cspace_plan::PlanError;
use cspace_plan::escape::{Escape as Search, Escaped, Field, FieldError};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::frame::{Answer, Content, Pairs};
use crate::given::{self, Given};
use crate::outcome::outcomes;
use crate::plan::{Enclosed, Overlap, Parts, goal};
use crate::subject::{Chosen, Which, about};

/// The start from which a part is to get out, and the forces against it.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[cfg_attr(feature = "command", group(skip))]
#[serde(default)]
pub struct Question {
    /// The pair; the one of the model without.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", arg(skip))]
    pub which: Which,
    /// The start; as drawn without.
    #[cfg_attr(feature = "command", arg(skip))]
    pub from: Option<Given>,
    /// The goal; `out`, where the parts can be taken apart for good, without.
    #[cfg_attr(feature = "command", arg(skip))]
    pub to: Option<Given>,
    /// For the least energy: the acceleration of gravity, unit/s², in place of the model's.
    #[cfg_attr(feature = "command", arg(long, value_name = "X,Y", value_parser = crate::command::acceleration, allow_hyphen_values = true, requires = "energy", hide_short_help = true))]
    pub gravity: Option<[f64; 2]>,
    /// For the least energy: how near its bounds are brought, kg·unit²/s² [default: 3 % of it]
    #[cfg_attr(feature = "command", arg(long, value_name = "E", value_parser = crate::command::energy, allow_negative_numbers = true, requires = "energy", hide_short_help = true))]
    pub accuracy: Option<f64>,
}

outcomes! {
    /// Whether an energy is enough.
    Outcome {
        /// There is a way.
        Escapes = "escapes" is Yes,
        /// No energy is enough.
        Cage = "cage" is No,
        /// The parts overlap at the start.
        FromBlocked = "from-blocked" is No,
        /// The parts overlap at the goal.
        ToBlocked = "to-blocked" is No,
    }
}

impl Content for Escape {
    const COMMAND: &'static str = "plan";
    type Outcome = Outcome;
}

/// How much energy a part needs to get out, in kg·unit²/s², counted from that at the start.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Escape {
    /// How it came out, as `outcome`.
    pub verdict: Outcome,
    /// The gap by which the moving part is smaller all around, where the parts fit exactly at the start or the goal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// The least energy of a way: that of the one pass between the bounds, to rounding. None where there are several or none, where the
    /// bounds could not be brought together, and without a way.
    pub energy: Option<f64>,
    /// No way needs less; none without a way.
    pub least: Option<f64>,
    /// The path needs no more; none without one.
    pub most: Option<f64>,
    /// Places between the bounds where contacts balance the energy, the lowest first, and start or goal if their energy is between the
    /// bounds.
    pub passes: Vec<Pass>,
    /// Configurations joined by motions of constant rates, from the start to the goal or out; empty if there is no path. Angles go on beyond a
    /// turn.
    pub path: Vec<Coordinates>,
    /// Enclosure of the region of the start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosed: Option<Enclosed>,
    /// Overlap at the start or the goal.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blocked: Option<Overlap>,
    /// Whether energies are those of a mass of 1 kg, because the model has none.
    pub unit_mass: bool,
    /// How long the search took, without the contact space (s).
    pub seconds: f64,
}

/// A place at which a way may be highest.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Pass {
    /// Its configuration.
    pub at: Coordinates,
    /// Its energy, counted from that at the start.
    pub energy: f64,
    /// The features that balance it, of the fixed and of the moving part.
    pub touching: Vec<[String; 2]>,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Vec<FeaturePair>,
}

impl Question {
    /// The energies that the moving parts of these pairs need.
    ///
    /// # Errors
    /// If a pair cannot be computed, nothing acts on the moving part, or start or goal are not where can be asked.
    pub fn ask(&self, pairs: &[Chosen<'_>]) -> Result<Answer<Pairs<Escape>>, Error> {
        about(pairs, |pair| {
            let escape = self.of(pair)?;
            Ok(pair.answer(escape.verdict, escape))
        })
    }

    fn of(&self, pair: &Chosen<'_>) -> Result<Escape, Error> {
        given::size(pair.host(), "accuracy", self.accuracy)?;
        let from = pair.at("from", self.from.as_ref())?;
        let to = goal(pair, self.to.as_ref())?;
        let (field, weighs) = self.field(pair)?;
        let failed = |error| failure(pair, &error);
        // Wrong arguments are reported before anything is computed.
        if field.is_none() {
            return Err(failed(PlanError::NoForce));
        }
        let ends: Vec<Coordinates> = [from].into_iter().chain(to).collect();
        let (space, gap) = pair.space_with_room(&ends)?;
        let begin = Instant::now();
        let mut search = Search::new(&space, &field).map_err(failed)?;
        if let Some(within) = self.accuracy {
            search = search.with_bounds_within(within);
        }
        let escaped = {
            let progress = pair.host().begin(&pair.names());
            (search.from_with(from, to, &*progress)).map_err(failed)?
        };
        let mut escape = Escape {
            unit_mass: !weighs,
            seconds: begin.elapsed().as_secs_f64(),
            ..Escape::of(Parts::of(&space), escaped)
        };
        escape.gap = gap;
        Ok(escape)
    }

    /// The force field that acts on the moving part, and whether that part has a mass.
    fn field(&self, pair: &Chosen<'_>) -> Result<(Field, bool), Error> {
        let Some((model, entry)) = pair.in_model() else {
            return Err(
                Error::new("a saved contact space says nothing of masses and forces")
                    .help("give the model file"),
            );
        };
        let given = self.gravity.map(|[x, y]| Vector::new(x, y));
        let gravity = given.unwrap_or(model.dynamics.gravity);
        let (field, weighs) = Field::of_pair(model, entry, gravity).map_err(|error| {
            let help = match error {
                FieldError::Still { .. } => format!(
                    "name the pair in the other order: {} FIXED,MOVING",
                    pair.option("pair")
                ),
                _ => "take it out of the model, or choose another pair".to_owned(),
            };
            Error::new(error).help(help)
        })?;
        Ok((field, weighs || gravity == Vector::ZERO))
    }
}

fn failure(pair: &Chosen<'_>, error: &PlanError) -> Error {
    let option = |name| pair.option(name);
    match error {
        PlanError::From(e) | PlanError::Pair(e) => pair.unanswered(&option("from"), e),
        PlanError::To(e) => pair.unanswered(&option("to"), e),
        PlanError::NoGoal => Error::new(error).help(format_args!("give {} U,V", option("to"))),
        PlanError::NoForce => Error::new(error).help(format_args!(
            "give {} X,Y, or gravity, loads or springs in the model",
            option("gravity")
        )),
        PlanError::TooFar { .. } => Error::new(error).help("choose one nearer to the parts"),
        PlanError::Stopped(ComputeError::Interrupted) => Error::new("interrupted"),
        _ => Error::new(error),
    }
}

impl Escape {
    fn new(verdict: Outcome) -> Self {
        Self {
            verdict,
            gap: None,
            energy: None,
            least: None,
            most: None,
            passes: Vec::new(),
            path: Vec::new(),
            enclosed: None,
            blocked: None,
            unit_mass: false,
            seconds: 0.0,
        }
    }

    fn of(parts: Parts<'_>, escaped: Escaped) -> Self {
        let blocked = |verdict, overlap| Self {
            blocked: Some(Overlap::of(parts, &overlap)),
            ..Self::new(verdict)
        };
        match escaped {
            Escaped::Held(held) => Self {
                energy: held.energy,
                least: Some(held.least),
                most: Some(held.most).filter(|m| m.is_finite()),
                path: held.path,
                passes: (held.passes.into_iter())
                    .map(|pass| Pass {
                        at: pass.at,
                        energy: pass.energy,
                        touching: pass.touching.iter().map(|&f| parts.texts(f)).collect(),
                        features: pass.touching,
                    })
                    .collect(),
                ..Self::new(Outcome::Escapes)
            },
            Escaped::Caged(enclosed) => Self {
                enclosed: Some(Enclosed::of(parts, enclosed)),
                ..Self::new(Outcome::Cage)
            },
            Escaped::FromBlocked(overlap) => blocked(Outcome::FromBlocked, overlap),
            Escaped::ToBlocked(overlap) => blocked(Outcome::ToBlocked, overlap),
        }
    }
}
