//! Values of parameters at which a requirement's quantity is what it must be.

use core::cmp::Ordering;
use std::collections::BTreeMap;

use cspace_design::{Goal, Solved, Span, Value};
use cspace_model::Model;
use cspace_model::model::Dimension;
use cspace_model::shown::quoted;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::given;
use crate::host::{Host, is_interrupted};
use crate::outcome::outcomes;
use crate::subject::{ModelFile, Subject, parameters_of, requirements_of, varied_twice};

/// The values at which one parameter is measured before solutions are sought between them, unless their number is given.
pub const SAMPLES: u32 = 65;

/// A condition, and the parameters that may change for it.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// A parameter that may be from LO to HI; of several the smallest change from the model's values is sought, relative to their ranges.
    #[cfg_attr(feature = "command", arg(long, value_name = "NAME=LO:HI", value_parser = span, allow_hyphen_values = true, required = true))]
    pub vary: Vec<Span>,
    /// Condition to satisfy: the name of a requirement, =, <= or >=, and a value such as 0.1, 0.5deg or true.
    #[cfg_attr(feature = "command", arg(long, value_name = "MEASURE = VALUE", value_parser = goal, allow_hyphen_values = true))]
    pub so_that: Goal,
    /// One parameter: the number of values at which is measured before solutions are sought between them.
    #[cfg_attr(feature = "command", arg(long, value_name = "N", default_value_t = SAMPLES, value_parser = given::whole::<u32>(2..=100_000), allow_negative_numbers = true, hide_short_help = true))]
    #[serde(default = "usual_samples")]
    pub samples: u32,
}

const fn usual_samples() -> u32 {
    SAMPLES
}

/// Reads the range of a parameter, such as `play=0.05:0.3`.
#[cfg(feature = "command")]
fn span(text: &str) -> Result<Span, String> {
    const HELP: &str = "give it as NAME=LO:HI, such as play=0.05:0.3";
    let (name, range) = text.split_once('=').ok_or(HELP)?;
    let (lo, hi) = range.split_once(':').ok_or(HELP)?;
    let (lo, hi) = (given::value(lo).ok_or(HELP)?, given::value(hi).ok_or(HELP)?);
    if lo >= hi {
        return Err("the range is empty: give the smaller bound first".to_owned());
    }
    Ok(Span {
        parameter: name.trim().to_owned(),
        lo,
        hi,
    })
}

/// Reads a condition, such as `tilt = 0.5deg`.
#[cfg(feature = "command")]
fn goal(text: &str) -> Result<Goal, String> {
    use cspace_design::Relation;

    const HELP: &str =
        "give it as \"MEASURE = VALUE\", with =, <= or >=, such as --so-that \"tilt = 0.5deg\"";
    let at = text.find('=').ok_or(HELP)?;
    let (name, right) = (&text[..at], text[at + 1..].trim());
    let (name, relation) = match name.strip_suffix('<') {
        Some(name) => (name, Relation::AtMost),
        None => match name.strip_suffix('>') {
            Some(name) => (name, Relation::AtLeast),
            None => (name, Relation::Equal),
        },
    };
    let value = match right {
        "true" | "yes" => Value::Truth(true),
        "false" | "no" => Value::Truth(false),
        number => Value::Number(given::value(number).ok_or(HELP)?),
    };
    if relation != Relation::Equal && matches!(value, Value::Truth(_)) {
        return Err("yes and no have no order: use =".to_owned());
    }
    Ok(Goal {
        requirement: name.trim().to_owned(),
        relation,
        value,
    })
}

outcomes! {
    /// Whether values were found.
    Outcome {
        /// There are values at which it is so.
        Solved = "solved" is Yes,
        /// The quantity may have a value, which could not be found.
        Undecided = "undecided" is Open,
        /// There are none.
        None = "none" is No,
    }
}

/// The values that were found.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Solutions {
    /// Values of the parameters: of an equation in one parameter all that were found, otherwise the nearest.
    pub solutions: Vec<BTreeMap<String, f64>>,
    /// With one parameter: the ranges in which it is so; left out where it is so at single values alone, or nowhere.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub ranges: Vec<[f64; 2]>,
    /// With one parameter: the ranges in which the quantity may have a value, which could not be found; left out where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub undecided: Vec<[f64; 2]>,
    /// Why there is no solution; null where there is one.
    pub none: Option<String>,
}

impl Content for Solutions {
    const COMMAND: &'static str = "solve";
    type Outcome = Outcome;
}

impl Question {
    /// The values of the parameters at which the condition is met.
    ///
    /// # Errors
    /// If the model does not have what is named, the condition is none of its measure, or the work is interrupted.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Solutions>, Error> {
        let file = subject.model("solutions are values of its parameters")?;
        self.check(file, host)?;
        let (template, _) = file.template()?;
        let progress = host.begin(&file.model.mechanism.name);
        let samples = self.samples as usize;
        let found = cspace_design::solve(
            template,
            &file.set,
            &self.vary,
            &self.so_that,
            samples,
            &*progress,
        );
        if is_interrupted(&*progress) {
            return Err(Error::new("the computation was interrupted"));
        }
        let outcome = match found.solutions.is_empty() && found.ranges.is_empty() {
            false => Outcome::Solved,
            true if !found.undecided.is_empty() => Outcome::Undecided,
            true => Outcome::None,
        };
        let solutions = Solutions::of(&self.vary, found);
        Ok(Answer::new(subject.unit(), outcome, solutions))
    }

    /// Refuses names that the model does not have, and values of another kind than the measure.
    fn check(&self, file: &ModelFile, host: &dyn Host) -> Result<(), Error> {
        if self.samples < 2 {
            return Err(given::refused(host, "samples", self.samples, "2 or more"));
        }
        if let Value::Number(value) = self.so_that.value
            && !value.is_finite()
        {
            return Err(given::refused(host, "so-that", value, "a finite number"));
        }
        let model: &Model = &file.model;
        for (i, span) in self.vary.iter().enumerate() {
            let name = &span.parameter;
            if model.parameters.iter().all(|p| p.name != *name) {
                let what = format_args!("there is no parameter {}", quoted(name));
                return Err(file.error(what).help(parameters_of(model)));
            }
            if self.vary[..i].iter().any(|other| other.parameter == *name) {
                return Err(varied_twice(name));
            }
            if !(span.lo.is_finite() && span.hi.is_finite()) {
                let range = format!("{name} from {:?} to {:?}", span.lo, span.hi);
                return Err(given::refused(host, "vary", range, "finite bounds"));
            }
            if span.lo.partial_cmp(&span.hi) != Some(Ordering::Less) {
                let option = host.option("vary");
                let what = format_args!("{option}: the range of {} is empty", quoted(name));
                return Err(Error::new(what).help("give the smaller bound first"));
            }
        }
        let goal = &self.so_that;
        let mut all = model.requirements.iter();
        let Some(requirement) = all.find(|r| r.name == goal.requirement) else {
            let what = format_args!("there is no requirement {}", quoted(&goal.requirement));
            return Err(file.error(what).help(requirements_of(model)));
        };
        let is_truth = requirement.dimension == Dimension::Truth;
        if is_truth != matches!(goal.value, Value::Truth(_)) {
            let (is, give) = match is_truth {
                true => ("yes or no", "true or false"),
                false => ("a number", "a number such as 0.1 or 0.5deg"),
            };
            return Err(Error::new(format_args!(
                "{}: the measure {} is {is}",
                host.option("so-that"),
                quoted(&goal.requirement)
            ))
            .help(format_args!("give {give}")));
        }
        Ok(())
    }
}

impl Solutions {
    /// The answer for what was found of some parameters.
    pub fn of(spans: &[Span], found: Solved) -> Self {
        let named = |values: Vec<f64>| {
            let names = spans.iter().map(|span| span.parameter.clone());
            names.zip(values).collect()
        };
        let both = |(lo, hi)| [lo, hi];
        Self {
            solutions: found.solutions.into_iter().map(named).collect(),
            ranges: found.ranges.into_iter().map(both).collect(),
            undecided: found.undecided.into_iter().map(both).collect(),
            none: found.none,
        }
    }
}
