//! The extremes of requirements along a coordinate.

use cspace_design::{Band as Found, Station as FoundStation, ToleranceOptions, Variations, Varied};
use cspace_model::model::Dimension;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Extreme, Nominal};
use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::host::Host;
use crate::outcome::Done;
use crate::subject::Subject;
use crate::vary::Vary;

/// Which requirements are measured, and along what.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[cfg_attr(feature = "command", group(id = "bands"))]
#[serde(deny_unknown_fields)]
pub struct Question {
    /// The names of the requirements; all of the model without one.
    #[cfg_attr(feature = "command", arg(skip))]
    #[serde(default)]
    pub requirement: Vec<String>,
    /// Report each value and its extremes at N values of a coordinate from LO to HI; a play is measured about where the part was before.
    #[cfg_attr(feature = "command", arg(long, value_name = "NAME=LO:HI:N", allow_hyphen_values = true, required = false, conflicts_with_all = ["allocate", "samples"]))]
    pub along: Vary,
}

/// Requirements along a coordinate.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Bands {
    /// Each requirement that is a number measured at a configuration with the coordinate.
    pub requirements: Vec<Band>,
    /// The model and what varies.
    #[serde(skip)]
    pub nominal: Nominal,
}

impl Content for Bands {
    const COMMAND: &'static str = "tolerances";
    type Outcome = Done;
}

/// A requirement along a coordinate.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Band {
    /// The name of the requirement.
    pub requirement: String,
    /// The kind of the quantity.
    pub measure: &'static str,
    /// The name of the coordinate.
    pub along: String,
    /// The requirement at each value of the coordinate.
    pub stations: Vec<Station>,
    /// The dimension of its values.
    #[serde(skip)]
    pub dimension: Dimension,
    /// The smallest and the largest value that is allowed, if there are limits.
    #[serde(skip)]
    pub limits: Option<[f64; 2]>,
}

/// A requirement where the coordinate has a value.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Station {
    /// The value of the coordinate, in the model's unit or radians.
    pub at: f64,
    /// The value as drawn; null where there is none.
    pub nominal: Option<f64>,
    /// Why it has no value as drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// The smallest value within the tolerances.
    pub lo: Extreme,
    /// The largest value within the tolerances.
    pub hi: Extreme,
}

impl Station {
    /// How far the extremes are apart, if both have a value.
    pub fn width(&self) -> Option<f64> {
        Some(self.hi.value? - self.lo.value?)
    }
}

impl Question {
    /// The bands of the requirements.
    ///
    /// # Errors
    /// If the model has no such requirements or no tolerances, nothing is measured along the coordinate, or the work is interrupted.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Bands>, Error> {
        let nominal = Nominal::of(subject, &self.requirement, host)?;
        let (template, set) = nominal.template(subject)?;
        let (model, name) = (&nominal.model, &self.along.name);
        let Some(Varied::Coordinate(coordinate)) = Varied::named(name, model) else {
            let option = host.option("along");
            return Err(Error::new(format_args!(
                "{option} {name}: a motion goes along a coordinate"
            ))
            .help(format_args!(
                "give one of x, y, theta, u, v, such as {option} u=0deg:360deg:73"
            )));
        };
        let values: Vec<f64> = (0..self.along.count).map(|i| self.along.value(i)).collect();
        let options = ToleranceOptions {
            requirements: nominal.requirements(),
            ..ToleranceOptions::default()
        };
        let progress = host.begin(&model.mechanism.name);
        let places = (coordinate, &values[..]);
        let bands = cspace_design::along(template, set, model, &options, places, &*progress)
            .map_err(Error::new)?;
        if bands.is_empty() {
            return Err(subject
                .error(format_args!(
                    "no number is measured at a configuration with the coordinate {name}"
                ))
                .help("vary a coordinate of the pair that is measured"));
        }
        let band = |band: &Found| Band::of(name, &nominal.variations, band);
        let requirements = bands.iter().map(band).collect();
        let bands = Bands {
            requirements,
            nominal,
        };
        Ok(Answer::new(subject.unit(), Done::Done, bands))
    }
}

impl Band {
    fn of(along: &str, variations: &Variations, band: &Found) -> Self {
        let station = |s: &FoundStation| {
            let [lo, hi] = &s.exact;
            Station {
                at: s.at,
                nominal: s.nominal.as_ref().ok().copied(),
                failure: s.nominal.as_ref().err().cloned(),
                lo: Extreme::of(variations, lo),
                hi: Extreme::of(variations, hi),
            }
        };
        Self {
            requirement: band.requirement.name.clone(),
            measure: band.requirement.subject.name(),
            along: along.to_owned(),
            stations: band.stations.iter().map(station).collect(),
            dimension: band.requirement.dimension,
            limits: band.requirement.limits(),
        }
    }
}
