//! Tolerances of parameters: their effect on what a design requires, and how wide they may be.
//!
//! Each module has one question: the [`analysis`] of requirements, their extremes [`along`] a coordinate, contact [`zones`] of a pair, and
//! the [`allocation`] of tolerances at the least cost.

pub mod allocation;
pub mod along;
pub mod analysis;
mod effect;
pub mod zones;

use cspace_design::Variations;
use cspace_io::Model;
use cspace_io::model::{Setting, Template};
use cspace_io::shown::{number, quoted};

use crate::check::{has_requirements, retain};
use crate::error::Error;
use crate::host::Host;
use crate::subject::Subject;

pub use effect::{
    Change, Effect, Extreme, Extremes, Histogram, Outcome, Samples, Sensitivity, effects,
};

/// A model of which the tolerances are looked at: a parameter outside its limits is in their middle, about which its tolerance is.
#[derive(Debug, Clone)]
pub struct Nominal {
    /// The model, with the requirements that are asked about.
    pub model: Model,
    /// The parameters that vary.
    pub variations: Variations,
    /// The values that parameters are given.
    set: Vec<Setting>,
}

impl Nominal {
    /// The nominal model of a file, with the requirements of these names, or all where none is named.
    pub(crate) fn of(subject: &Subject, names: &[String], host: &dyn Host) -> Result<Self, Error> {
        let file = subject.model("tolerances are those of its parameters")?;
        has_requirements(file)?;
        if Variations::of(&file.model).is_empty() {
            return Err(file
                .error("no parameter has a tolerance")
                .help("give one in [parameter], such as pin = { value = 6.0, tol = 0.02 }"));
        }
        let (template, _) = file.template()?;
        let (set, mut model) =
            (template.about_middles(&file.set, file.model.clone())).map_err(Error::new)?;
        let variations = Variations::of(&model);
        let outside = (model.parameters.iter())
            .find(|p| p.has_limits && p.deviations.is_some_and(|(a, b)| a < 0.0 || b < 0.0));
        if let Some(outside) = outside {
            let name = quoted(&outside.name);
            let (below, above) = outside.deviations.unwrap_or_default();
            let [lo, hi] = [outside.value - below, outside.value + above].map(number);
            return Err(Error::new(format_args!(
                "{name} is set to a value outside its limits, {lo} to {hi}"
            ))
            .help("set it to a value within them"));
        }
        retain(&mut model, names, host)?;
        Ok(Self {
            model,
            variations,
            set,
        })
    }

    /// The text of the model, and the values that its parameters are given.
    fn template<'a>(
        &'a self,
        subject: &'a Subject,
    ) -> Result<(&'a Template, &'a [Setting]), Error> {
        let file = subject.model("tolerances are those of its parameters")?;
        Ok((file.template()?.0, &self.set))
    }

    /// The names of the requirements that are asked about.
    fn requirements(&self) -> Vec<String> {
        (self.model.requirements.iter())
            .map(|r| r.name.clone())
            .collect()
    }
}
