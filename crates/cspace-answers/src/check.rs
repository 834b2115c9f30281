//! Answer of `cspace check`.

use cspace::Coordinates;
use cspace_design::{Checked, Sensitivity, Value as Found};
use cspace_model::Model;
use cspace_model::model::{Dimension, MotionQuantity, Quantity, Subject};
use serde::Serialize;
use serde_json::{Map, Value};

use crate::frame::Outcome;

/// A requirement, measured.
#[derive(Debug, Serialize)]
pub struct Row {
    /// The name of the requirement.
    pub name: String,
    /// The two parts that it is about, if it is about two.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pair: Option<[String; 2]>,
    /// The part that it is about, if it is about one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
    /// The kind of the quantity.
    pub measure: &'static str,
    /// In the model's unit or radians, or true or false; none where it has no value.
    pub value: Option<Told>,
    /// The unit of the value.
    pub dimension: Dimension,
    /// The smallest and the largest value that are allowed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<[f64; 2]>,
    /// The truth that is required.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub equals: Option<bool>,
    /// Absent for a requirement without limits, and for one that is not decided.
    pub met: Option<bool>,
    /// How it came out.
    pub outcome: Outcome,
    /// Whether the quantity may have a value, which could not be found.
    #[serde(skip_serializing_if = "core::ops::Not::not")]
    pub undecided: bool,
    /// The gap by which the moving part is smaller, where the parts fit exactly.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// How far the value is within its limits; negative outside.
    pub margin: Option<f64>,
    /// The two ends of a play.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<[f64; 2]>,
    /// Where a position is measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<Coordinates>,
    /// Features of the two parts that touch where the quantity ends.
    pub touching: Vec<[String; 2]>,
    /// Why there is no value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// The derivatives by parameters; where they differ for smaller and larger values, that for larger ones.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivities: Option<Map<String, Value>>,
    /// The derivatives for smaller and for larger values, where they differ.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub one_sided: Map<String, Value>,
    /// All derivatives, and why there is none.
    #[serde(skip)]
    pub by: Vec<Sensitivity>,
}

/// The value of a quantity.
#[derive(Debug, Clone, Copy, Serialize)]
#[serde(untagged)]
pub enum Told {
    /// In the model's unit, or radians.
    Number(f64),
    /// Yes or no.
    Truth(bool),
}

impl Row {
    /// The answer for a requirement of a model that was measured, with derivatives if they were computed.
    pub fn of(model: &Model, checked: &Checked, by: Option<Vec<Sensitivity>>) -> Self {
        let derivatives = |one_sided: bool| -> Map<String, Value> {
            let of = |s: &Sensitivity| {
                let [below, above] = *s.derivative.as_ref().ok()?;
                let value = if one_sided {
                    Value::from(vec![below, above])
                } else {
                    above.into()
                };
                (!one_sided || below != above).then(|| (s.parameter.clone(), value))
            };
            by.iter().flatten().filter_map(of).collect()
        };
        let requirement = &checked.requirement;
        let name = |i: usize| model.mechanism.parts[i].part.name().to_owned();
        let measured = checked.measured.as_ref().ok();
        Self {
            name: requirement.name.clone(),
            pair: checked.parts.map(|parts| parts.map(name)),
            part: match requirement.subject {
                Subject::Motion(_, MotionQuantity::Stroke { part, .. }) => Some(name(part)),
                _ => None,
            },
            measure: requirement.subject.name(),
            value: measured.map(|m| match m.value {
                Found::Number(x) => Told::Number(x),
                Found::Truth(b) => Told::Truth(b),
            }),
            limits: requirement.limits(),
            equals: requirement.equals(),
            met: checked.is_met(),
            outcome: match (checked.is_met(), measured) {
                _ if checked.is_undecided() => Outcome::open("undecided"),
                (Some(true), _) => Outcome::yes("met"),
                (Some(false), _) => Outcome::no("not-met"),
                (None, Some(_)) => Outcome::yes("measured"),
                (None, None) => Outcome::open("no-value"),
            },
            undecided: checked.is_undecided(),
            gap: checked.gap,
            margin: checked.margin(),
            range: measured.and_then(|m| m.range).map(|(lo, hi)| [lo, hi]),
            at: match requirement.subject {
                Subject::Pair(_, Quantity::Position { .. }) => {
                    measured.and_then(|m| m.stops.first()).map(|s| s.at)
                }
                _ => None,
            },
            touching: checked.touching.clone(),
            failure: checked.measured.as_ref().err().map(ToString::to_string),
            sensitivities: by.as_ref().map(|_| derivatives(false)),
            one_sided: derivatives(true),
            by: by.unwrap_or_default(),
            dimension: requirement.dimension,
        }
    }
}
