//! The effects of tolerances on requirements.

use cspace_design::{ToleranceOptions, Tolerances, tolerances_with};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Effect, Nominal, Outcome, effects};
use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::host::Host;
use crate::outcome::worst;
use crate::subject::Subject;

/// Which requirements are analysed, and how.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// This requirement alone; may be given several times [default: all of the model]
    #[cfg_attr(feature = "command", arg(long, value_name = "NAME"))]
    pub requirement: Vec<String>,
    /// Leave the extremes as they are found, without the proof that nothing is beyond them.
    #[cfg_attr(feature = "command", arg(long, conflicts_with_all = ["allocate", "along"]))]
    pub no_proof: bool,
    /// Measure the yield on this many samples by chance.
    #[cfg_attr(feature = "command", arg(long, value_name = "N", default_value_t = 0, value_parser = crate::given::whole::<u64>(0..=100_000_000), allow_negative_numbers = true, hide_short_help = true))]
    pub samples: u64,
    /// Seed of the random samples: the same seed gives the same numbers, on any number of threads.
    #[cfg_attr(feature = "command", arg(long, value_name = "S", default_value_t = 0, value_parser = crate::given::whole::<u64>(0..=u64::MAX), allow_negative_numbers = true, hide_short_help = true))]
    pub seed: u64,
}

/// The effects of the tolerances.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Analysis {
    /// The effect on each requirement, in the order of the model.
    pub requirements: Vec<Effect>,
    /// The model and what varies.
    #[serde(skip)]
    pub nominal: Nominal,
    /// The effects as they were found.
    #[serde(skip)]
    pub found: Vec<Tolerances>,
}

impl Content for Analysis {
    const COMMAND: &'static str = "tolerances";
    type Outcome = Outcome;
}

impl Question {
    /// The effects of the tolerances. Of an interrupted question what is known by then is the answer.
    ///
    /// # Errors
    /// If the model has no such requirements or no tolerances, or the work is interrupted before anything is known.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Analysis>, Error> {
        self.ask_with(subject, host, &|_, _| {})
    }

    /// As [`ask`](Self::ask); `known` hears at once what derivatives as drawn say, which is all of an interrupted answer.
    ///
    /// # Errors
    /// As there.
    pub fn ask_with(
        &self,
        subject: &Subject,
        host: &dyn Host,
        known: &dyn Fn(&Nominal, &[Tolerances]),
    ) -> Result<Answer<Analysis>, Error> {
        let nominal = Nominal::of(subject, &self.requirement, host)?;
        let (template, set) = nominal.template(subject)?;
        let options = ToleranceOptions {
            samples: self.samples,
            seed: self.seed,
            requirements: nominal.requirements(),
            without_proof: self.no_proof,
        };
        let progress = host.begin(&nominal.model.mechanism.name);
        host.keep();
        let known = |found: &[Tolerances]| known(&nominal, found);
        let found = tolerances_with(template, set, &nominal.model, &options, &known, &*progress)
            .map_err(Error::new)?;
        let requirements = effects(&nominal.variations, &found);
        let outcome = worst(requirements.iter().map(|effect| effect.outcome));
        let analysis = Analysis {
            requirements,
            nominal,
            found,
        };
        Ok(Answer::new(subject.unit(), outcome, analysis))
    }
}
