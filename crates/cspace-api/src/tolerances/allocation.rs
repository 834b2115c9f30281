//! Tolerances that meet the limits of a design at the least cost.

use core::ops::RangeInclusive;
use std::collections::BTreeMap;

use cspace_design::{
    Allocation as Found, Criterion, ToleranceOptions, Unallocated, Variation, Variations, allocate,
};
use cspace_model::shown::quoted;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Effect, Nominal, effects};
use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::host::Host;
use crate::outcome::Done;
use crate::subject::Subject;

/// Yields that may be asked for. Beyond, fewer than a hundred of a million samples would fail.
pub const YIELDS: RangeInclusive<f64> = 0.5..=0.9999;

/// The criterion that tolerances must meet, and what they cost.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[cfg_attr(feature = "command", group(id = "allocation"))]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// The names of the requirements; all of the model without one.
    #[cfg_attr(feature = "command", arg(skip))]
    #[serde(default)]
    pub requirement: Vec<String>,
    /// Find the tolerances of minimum cost at which every part meets the limits (worst), or a share of the parts, such as 99.9%: halving a
    /// tolerance doubles its cost.
    #[cfg_attr(feature = "command", arg(long, value_name = "worst|YIELD", value_parser = criterion, required = false))]
    pub allocate: Criterion,
    /// The cost of a parameter's tolerance at the value given in the model, by the parameter's name; 1 without. Half a tolerance costs
    /// twice as much.
    #[cfg_attr(feature = "command", arg(skip))]
    #[serde(default)]
    pub cost: BTreeMap<String, f64>,
    /// The number of samples by chance on which yields are measured; as many as the criterion needs without.
    #[cfg_attr(feature = "command", arg(skip))]
    #[serde(default)]
    pub samples: u64,
    /// Seed of the samples: the same seed gives the same numbers, on any number of threads.
    #[cfg_attr(feature = "command", arg(skip))]
    #[serde(default)]
    pub seed: u64,
}

/// Reads `worst`, or a yield such as `99.9%`.
#[cfg(feature = "command")]
fn criterion(text: &str) -> Result<Criterion, String> {
    let text = text.trim();
    if text == "worst" {
        return Ok(Criterion::Worst);
    }
    let share = match text.strip_suffix('%') {
        Some(percent) => percent.trim().parse::<f64>().map(|x| x / 100.0),
        None => text.parse(),
    };
    share
        .ok()
        .filter(|share| YIELDS.contains(share))
        .map(Criterion::Yield)
        .ok_or_else(|| "give worst, or a yield from 50% to 99.99%, such as 99.9%".to_owned())
}

/// Tolerances that are allocated.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Allocation {
    /// `worst`, or the share of parts that is to meet the limits.
    pub criterion: Criterion,
    /// The tolerance of each parameter that has one, by its name.
    pub parameters: BTreeMap<String, Allocated>,
    /// Costs of the tolerances given, and of those allocated.
    pub cost: [f64; 2],
    /// The effect of the tolerances allocated on each requirement.
    pub requirements: Vec<Effect>,
    /// The tolerances given.
    #[serde(skip)]
    pub nominal: Nominal,
    /// Costs of the tolerances given, in the order of the parameters.
    #[serde(skip)]
    pub costs: Vec<f64>,
    /// The tolerances as they were found.
    #[serde(skip)]
    pub found: Found,
}

impl Content for Allocation {
    const COMMAND: &'static str = "tolerances";
    type Outcome = Done;
}

/// The tolerance allocated to a parameter.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Allocated {
    /// The tolerance allocated, relative to that given.
    pub factor: f64,
    /// The cost of the tolerance given.
    pub cost: f64,
    /// Whether it has an influence on what is required; otherwise the tolerance stays.
    pub matters: bool,
    /// How far the parameter may be below its value, if it is in no zone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub minus: Option<f64>,
    /// How far it may be above its value, if it is in no zone.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plus: Option<f64>,
    /// The diameter of its zone, if it is a coordinate of a point in one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<f64>,
}

impl Question {
    /// The tolerances at the least cost.
    ///
    /// # Errors
    /// If the model has no such requirements, parameters or tolerances, no tolerances meet the criterion, or the work is interrupted.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Allocation>, Error> {
        let nominal = Nominal::of(subject, &self.requirement, host)?;
        let (template, set) = nominal.template(subject)?;
        if let Criterion::Yield(share) = self.allocate
            && !YIELDS.contains(&share)
        {
            return Err(Error::new(format_args!(
                "{}: no tolerances are found for a yield of {share}",
                host.option("allocate")
            ))
            .help("give `worst`, or a share from 0.5 to 0.9999"));
        }
        let costs = self.costs(&nominal.variations, host)?;
        let options = ToleranceOptions {
            samples: self.samples,
            seed: self.seed,
            requirements: nominal.requirements(),
            ..ToleranceOptions::default()
        };
        let progress = host.begin(&nominal.model.mechanism.name);
        let wanted = (self.allocate, &costs[..]);
        let found = allocate(template, set, &nominal.model, &options, wanted, &*progress)
            .map_err(|error| failure(subject, error))?;
        let allocation = Allocation {
            criterion: self.allocate,
            parameters: allocated(&found, &costs),
            cost: found.cost,
            requirements: effects(&found.variations, &found.tolerances),
            nominal,
            costs,
            found,
        };
        Ok(Answer::new(subject.unit(), Done::Done, allocation))
    }

    /// The cost of each variation's tolerance: 1 unless given.
    fn costs(&self, variations: &Variations, host: &dyn Host) -> Result<Vec<f64>, Error> {
        let mut costs = vec![1.0; variations.len()];
        for (name, cost) in &self.cost {
            let mut all = variations.list.iter();
            let option = host.option("cost");
            let Some(i) = all.position(|v| v.parameter.name == *name) else {
                let names = variations.list.iter().map(|v| v.parameter.name.as_str());
                let names = names.collect::<Vec<_>>().join(", ");
                return Err(Error::new(format_args!(
                    "{option} {}: no parameter of this name has a tolerance",
                    quoted(name)
                ))
                .help(format_args!("parameters with tolerances are {names}")));
            };
            if !(cost.is_finite() && *cost > 0.0) {
                return Err(Error::new(format_args!(
                    "{option} {}: {cost} is no cost",
                    quoted(name)
                ))
                .help("give a number above 0"));
            }
            costs[i] = *cost;
        }
        Ok(costs)
    }
}

fn failure(subject: &Subject, error: Unallocated) -> Error {
    let help = match &error {
        Unallocated::Interrupted => return Error::new(error),
        Unallocated::NoLimits => {
            "give a measure that is a number limits = [0, 0.5]; yes and no are not allocated"
        }
        Unallocated::NotMet(_) => "see what it is with cspace check",
        Unallocated::NoYield(_) => "see what fails with cspace tolerances --samples 10000",
    };
    subject.error(error).help(help)
}

fn allocated(found: &Found, costs: &[f64]) -> BTreeMap<String, Allocated> {
    let allocated = |(i, v): (usize, &Variation)| {
        let zone = found.variations.zone_of(i);
        let [below, above] = v.deviations;
        let allocated = Allocated {
            factor: found.factors[i],
            cost: costs[i],
            matters: found.matters[i],
            minus: zone.is_none().then_some(-below),
            plus: zone.is_none().then_some(above),
            position: zone.map(|zone| 2.0 * zone.radius),
        };
        (v.parameter.name.clone(), allocated)
    };
    let list = found.variations.list.iter().enumerate();
    list.map(allocated).collect()
}
