//! Which requirements of a design are met.

use std::collections::BTreeMap;

use cspace::Coordinates;
use cspace_design::{Checked, Sensitivity, Value};
use cspace_model::Model;
use cspace_model::model::{Dimension, MotionQuantity, Quantity, Subject as About};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::host::{Host, spaces};
use crate::outcome::{outcomes, worst};
use crate::subject::{ModelFile, Subject, requirements_of};

/// Which requirements are measured, and how.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// This requirement alone; may be given several times [default: all of the model]
    #[cfg_attr(feature = "command", arg(long, value_name = "NAME"))]
    pub requirement: Vec<String>,
    /// Report how much each value changes with each parameter.
    #[cfg_attr(feature = "command", arg(long))]
    pub sensitivities: bool,
}

outcomes! {
    /// How a requirement came out.
    Outcome {
        /// It is met.
        Met = "met" is Yes,
        /// It only measures, and has a value.
        Measured = "measured" is Yes,
        /// It is not met.
        NotMet = "not-met" is No,
        /// There may be a value, which could not be found.
        Undecided = "undecided" is Open,
        /// It only measures, and has no value.
        NoValue = "no-value" is Open,
    }
}

/// The requirements, measured.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(title = "What `cspace check --json` prints")]
pub struct Requirements {
    /// In the order of the model.
    pub requirements: Vec<Requirement>,
}

impl Content for Requirements {
    const COMMAND: &'static str = "check";
    type Outcome = Outcome;
}

/// A requirement, measured.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Requirement {
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
    pub value: Option<Amount>,
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
    /// The two ends of a play; the least and the largest backlash; the values between which a fit is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub range: Option<[f64; 2]>,
    /// Where a position is measured; where a clearance over ranges is smallest, a backlash or a fit largest, or a part is stopped first.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<Coordinates>,
    /// Features of the two parts that touch where the quantity ends.
    pub touching: Vec<[String; 2]>,
    /// Why there is no value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// The derivatives by parameters; where they differ for smaller and larger values, that for larger ones.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sensitivities: Option<BTreeMap<String, f64>>,
    /// The derivatives for smaller and for larger values, where they differ.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub one_sided: BTreeMap<String, [f64; 2]>,
    /// All derivatives, and why there is none.
    #[serde(skip)]
    pub by: Vec<Sensitivity>,
}

/// The value of a quantity.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Amount {
    /// In the model's unit, or radians.
    Number(f64),
    /// Yes or no.
    Truth(bool),
}

impl Requirement {
    /// The answer for a requirement of a model that was measured, with derivatives if they were computed.
    pub fn new(model: &Model, checked: &Checked, by: Option<Vec<Sensitivity>>) -> Self {
        let derivatives = || {
            let of = |s: &Sensitivity| Some((s.parameter.clone(), *s.derivative.as_ref().ok()?));
            by.iter().flatten().filter_map(of)
        };
        let requirement = &checked.requirement;
        let name = |i: usize| model.mechanism.parts[i].part.name().to_owned();
        let measured = checked.measured.as_ref().ok();
        Self {
            name: requirement.name.clone(),
            pair: checked.parts.map(|parts| parts.map(name)),
            part: match requirement.subject {
                About::Motion(_, MotionQuantity::Stroke { part, .. }) => Some(name(part)),
                _ => None,
            },
            measure: requirement.subject.name(),
            value: measured.map(|m| match m.value {
                Value::Number(x) => Amount::Number(x),
                Value::Truth(b) => Amount::Truth(b),
            }),
            limits: requirement.limits(),
            equals: requirement.equals(),
            met: checked.is_met(),
            outcome: match (checked.is_met(), measured) {
                _ if checked.is_undecided() => Outcome::Undecided,
                (Some(true), _) => Outcome::Met,
                (Some(false), _) => Outcome::NotMet,
                (None, Some(_)) => Outcome::Measured,
                (None, None) => Outcome::NoValue,
            },
            undecided: checked.is_undecided(),
            gap: checked.gap,
            margin: checked.margin(),
            range: measured.and_then(|m| m.range).map(|(lo, hi)| [lo, hi]),
            at: match requirement.subject {
                About::Pair(
                    _,
                    Quantity::Position { .. } | Quantity::Ranges { .. } | Quantity::Fits { .. },
                ) => measured.and_then(|m| m.stops.first()).map(|s| s.at),
                _ => None,
            },
            touching: checked.touching.clone(),
            failure: checked.measured.as_ref().err().map(ToString::to_string),
            sensitivities: (by.as_ref()).map(|_| {
                derivatives()
                    .map(|(name, [_, above])| (name, above))
                    .collect()
            }),
            one_sided: derivatives()
                .filter(|(_, [below, above])| below != above)
                .collect(),
            by: by.unwrap_or_default(),
            dimension: requirement.dimension,
        }
    }
}

impl Question {
    /// Measures the requirements of a model.
    ///
    /// # Errors
    /// If it has none, or not those that are asked for.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Requirements>, Error> {
        subject.note_on_pairs(host);
        let file = subject.model("requirements are the model's")?;
        let model = chosen(file, &self.requirement, host)?;
        let progress = host.begin(&model.mechanism.name);
        let spaces = spaces(host, &*progress);
        let requirements: Vec<Requirement> = if self.sensitivities {
            let (template, values) = file.template()?;
            cspace_design::sensitivities_by(template, &values, &model, &spaces, &*progress)
                .map_err(Error::new)?
                .into_iter()
                .map(|(checked, by)| Requirement::new(&model, &checked, Some(by)))
                .collect()
        } else {
            cspace_design::check_by(&model, &spaces, &*progress)
                .map_err(Error::new)?
                .iter()
                .map(|checked| Requirement::new(&model, checked, None))
                .collect()
        };
        let outcome = worst(requirements.iter().map(|row| row.outcome));
        let unit = model.mechanism.unit.as_deref();
        Ok(Answer::new(unit, outcome, Requirements { requirements }))
    }
}

/// Refuses a model without requirements.
pub(crate) fn has_requirements(file: &ModelFile) -> Result<(), Error> {
    match file.model.requirements.is_empty() {
        true => Err(file
            .error("the model has no requirements")
            .help("add [[requirement]] tables with name, measure and limits: see docs/design.md")),
        false => Ok(()),
    }
}

/// The model with the requirements of these names alone, or with all.
pub(crate) fn chosen(file: &ModelFile, names: &[String], host: &dyn Host) -> Result<Model, Error> {
    has_requirements(file)?;
    let mut model = file.model.clone();
    retain(&mut model, names, host)?;
    Ok(model)
}

/// Leaves the requirements of these names, or all where none is named.
pub(crate) fn retain(model: &mut Model, names: &[String], host: &dyn Host) -> Result<(), Error> {
    let is_known = |name: &&String| model.requirements.iter().any(|r| r.name == **name);
    if let Some(unknown) = names.iter().find(|name| !is_known(name)) {
        return Err(Error::new(format_args!(
            "{} {}: the model has no such requirement",
            host.option("requirement"),
            cspace_model::shown::quoted(unknown)
        ))
        .help(requirements_of(model)));
    }
    if !names.is_empty() {
        model.requirements.retain(|r| names.contains(&r.name));
    }
    Ok(())
}
