//! Goal of a solution, and the quantity at values of the parameters.

use cspace::Progress;
use cspace_model::model::{Requirement, Setting, Template};
use cspace_model::{Host, Model};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::check::Spaces;
use crate::sensitivity::derivative;
use crate::value::Value;

/// A parameter and the values that it may take.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Span {
    /// The parameter.
    pub parameter: String,
    /// The smallest value.
    pub lo: f64,
    /// The largest.
    pub hi: f64,
}

/// How a quantity compares with a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Relation {
    /// It is the value.
    Equal,
    /// It is the value or less.
    AtMost,
    /// It is the value or more.
    AtLeast,
}

/// Goal for a requirement's quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Goal {
    /// The name of the requirement.
    pub requirement: String,
    /// How the quantity compares.
    pub relation: Relation,
    /// With what.
    pub value: Value,
}

/// Values of parameters that meet a goal.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Solved {
    /// The values, in the order of the spans. For an equation in one parameter all that were found; otherwise the one nearest to the
    /// values that the model gives.
    pub solutions: Vec<Vec<f64>>,
    /// For one parameter: ranges in which the goal is met.
    pub ranges: Vec<(f64, f64)>,
    /// For one parameter: ranges in which the quantity could not be found, though it may have a value.
    pub undecided: Vec<(f64, f64)>,
    /// Why there is no solution.
    pub none: Option<String>,
}

/// A quantity nearer to the value than this is the value, relative to both and to how far off it is at other places.
const ZERO: f64 = 1e-14;

/// A quantity at some values of the parameters.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum At {
    /// How much more it is than asked for, and the derivatives for smaller and larger values of each parameter.
    Off(f64, Vec<[f64; 2]>),
    /// Whether it is as asked for.
    Is(bool),
    /// It has no value.
    None(String),
    /// It may have a value, which could not be found.
    Undecided(String),
}

pub(super) struct Problem<'a> {
    pub(super) template: &'a Template,
    pub(super) set: &'a [Setting],
    pub(super) spans: &'a [Span],
    pub(super) goal: &'a Goal,
    /// The requirement of the goal, if it is none of the model's.
    pub(super) own: Option<&'a Requirement>,
    pub(super) progress: &'a dyn Progress,
}

impl Problem<'_> {
    /// The model with values for what is varied.
    fn model(&self, values: &[f64]) -> Result<(Model, Vec<Setting>), String> {
        let mut set = self.set.to_vec();
        let values = self.spans.iter().zip(values);
        set.extend(values.map(|(span, value)| Setting::number(&span.parameter, *value)));
        let host = Host {
            set: &set,
            ..Host::default()
        };
        match self.template.model(&host) {
            Ok(model) => Ok((model, set)),
            Err(error) => Err(error.message().to_owned()),
        }
    }

    pub(super) fn at(&self, values: &[f64]) -> At {
        self.measured(values).unwrap_or_else(At::None)
    }

    fn measured(&self, values: &[f64]) -> Result<At, String> {
        let (mut model, set) = self.model(values)?;
        match self.own {
            Some(own) => model.requirements = vec![own.clone()],
            None => model
                .requirements
                .retain(|r| r.name == self.goal.requirement),
        }
        let spaces = Spaces::compute(&model, self.progress).map_err(|e| e.to_string())?;
        let requirement: &Requirement =
            (model.requirements.first()).ok_or("the model has no such requirement")?;
        let measured = match spaces.with_room(spaces.check(requirement)).measured {
            Ok(measured) => measured,
            Err(error) if error.is_undecided() => return Ok(At::Undecided(error.to_string())),
            Err(error) => return Err(error.to_string()),
        };
        let off = match (measured.value, self.goal.value) {
            (Value::Truth(is), Value::Truth(wanted)) => return Ok(At::Is(is == wanted)),
            (Value::Number(is), Value::Number(wanted)) => is - wanted,
            _ => return Err("the requirement is of another kind than the value".to_owned()),
        };
        let host = Host {
            set: &set,
            ..Host::default()
        };
        let slopes = self.spans.iter().map(|span| {
            let slopes = self.template.slopes(&host, &model, &span.parameter);
            let slopes = slopes.map_err(|e| e.message().to_owned());
            // Without derivatives crossings are bracketed alone.
            slopes
                .and_then(|s| derivative(&spaces, requirement, &measured, &s))
                .unwrap_or([f64::NAN; 2])
        });
        Ok(At::Off(off, slopes.collect()))
    }

    /// The values that the model gives to what is varied, brought into their ranges.
    pub(super) fn given(&self) -> Vec<f64> {
        let host = Host {
            set: self.set,
            ..Host::default()
        };
        let model = self.template.model(&host).ok();
        let of = |span: &Span| {
            let parameters = model.iter().flat_map(|m| &m.parameters);
            let mut given = parameters.filter(|p| p.name == span.parameter);
            let value = given.next().map_or(span.lo, |p| p.value);
            value.clamp(span.lo, span.hi)
        };
        self.spans.iter().map(of).collect()
    }

    /// Whether the goal is met where the quantity is off by so much; `zero` is nothing.
    pub(super) fn is_met(&self, at: &At, zero: f64) -> bool {
        match *at {
            At::Is(is) => is,
            At::Off(off, _) => match self.goal.relation {
                Relation::Equal => off.abs() <= zero,
                Relation::AtMost => off <= zero,
                Relation::AtLeast => off >= -zero,
            },
            At::None(_) | At::Undecided(_) => false,
        }
    }

    /// Magnitude that counts as zero beside the value and some quantities.
    pub(super) fn zero<'m>(&self, measured: impl Iterator<Item = &'m At>) -> f64 {
        let value = match self.goal.value {
            Value::Number(x) => x.abs(),
            Value::Truth(_) => 0.0,
        };
        let off = measured.map(|at| match at {
            At::Off(off, _) => off.abs(),
            _ => 0.0,
        });
        // Each by itself: the sum of the largest numbers is infinite.
        ZERO * value + ZERO * off.fold(0.0, f64::max)
    }
}
