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
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// The names of the requirements; all of the model without one.
    pub requirement: Vec<String>,
    /// Whether extremes are left as they are found, without the proof that nothing is beyond them.
    pub no_proof: bool,
    /// The number of samples by chance on which the yield is measured; none without.
    pub samples: u64,
    /// Seed of the samples: the same seed gives the same numbers, on any number of threads.
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
