//! What tolerances do to requirements: sensitivities, worst cases, yield, and where the structure changes.
//!
//! Contact spaces make the answers exact: a requirement's value anywhere within the tolerances is that of the contact that comes first there, whichever
//! it is. Sources: Sacks and Joskowicz 1998 (variation of contact functions, sensitivities), Kyung and Sacks 2003 (contact zones).
//!
//! ```
//! use cspace_design::{ToleranceOptions, tolerances};
//! use cspace_io::Host;
//! use cspace_io::model::Template;
//! let template = Template::from_text(r#"
//! [parameter]
//! pin = { value = 6.0, tol = 0.02 }
//! slot = { value = 6.1, tol = 0.03 }
//!
//! [[part]]
//! name = "slot"
//! loops = [[[-9, -9], [9, -9], [9, 0], ["slot/2", 0], ["slot/2", -5], ["-slot/2", -5], ["-slot/2", 0], [-9, 0]]]
//!
//! [[part]]
//! name = "key"
//! loops = [[["-pin/2", -4], ["pin/2", -4], ["pin/2", 4], ["-pin/2", 4]]]
//!
//! [[requirement]]
//! name = "sideways"
//! measure = "play"
//! of = "x"
//! limits = [0, 0.2]
//! "#.to_owned(), "key.toml")?;
//! let model = template.model(&Host::default())?;
//! let found = tolerances(&template, &[], &model, &ToleranceOptions::default(), &cspace::Silent)?;
//! let sideways = &found[0];
//! let [lo, hi] = sideways.exact.clone().ok_or("a play has extremes")?;
//! assert!((lo.value? - 0.05).abs() < 1e-9 && (hi.value? - 0.15).abs() < 1e-9 && lo.certified && hi.certified);
//! // The limits hold until the tolerances are doubled.
//! assert!((sideways.margin.factor.ok_or("it has limits")? - 2.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod drawing;
mod extremes;
mod linear;
mod monte_carlo;
mod proof;
mod structure;
mod study;
mod vary;

use cspace::{ComputeError, Progress, space::Stage};
use cspace_io::model::{Requirement, Setting, Template};
use cspace_io::{Host, Model};

use crate::check::{Checked, Interrupted, Spaces};
use crate::sensitivity::sensitivities_on;

pub use extremes::Extreme;
pub use linear::{Contribution, Linear};
pub use monte_carlo::MonteCarlo;
pub use structure::{ChangeKind, LARGEST_FACTOR, Margin, Structural};
pub use vary::{Variation, Variations, Zone};

use study::Study;

/// What is asked beside the worst cases.
#[derive(Debug, Clone, Default)]
pub struct ToleranceOptions {
    /// The number of samples; none without.
    pub samples: u64,
    /// What the samples follow from.
    pub seed: u64,
    /// The names of the requirements that are analysed; all if there are none.
    pub requirements: Vec<String>,
}

/// What tolerances do to one requirement.
#[derive(Debug, Clone)]
pub struct Tolerances {
    /// The requirement as drawn.
    pub nominal: Checked,
    /// The linear analysis; `None` of yes and no, and of what has no value as drawn.
    pub linear: Option<Linear>,
    /// The smallest and the largest value; `None` of yes and no.
    pub exact: Option<[Extreme; 2]>,
    /// What changes, up to [`LARGEST_FACTOR`] times the tolerances, the first first.
    pub structure: Vec<Structural>,
    /// The factor on all tolerances at which the requirement or the structure fails.
    pub margin: Margin,
    /// What samples give, if they are asked for.
    pub monte_carlo: Option<MonteCarlo>,
}

/// Analyses the tolerances of every requirement of a model, which is that of the template with the values set.
///
/// # Errors
/// If the progress ends the computation.
pub fn tolerances(
    template: &Template,
    set: &[Setting],
    model: &Model,
    options: &ToleranceOptions,
    progress: &dyn Progress,
) -> Result<Vec<Tolerances>, Interrupted> {
    let variations = Variations::of(model);
    let host = Host {
        set,
        ..Host::default()
    };
    // A template has all requirements.
    let is_chosen =
        |r: &Requirement| options.requirements.is_empty() || options.requirements.contains(&r.name);
    let mut model = model.clone();
    model.requirements.retain(is_chosen);
    let model = &model;
    let spaces = Spaces::compute(model, progress)?;
    let checked = sensitivities_on(&spaces, template, &host, model);
    let go_on = || match progress.stage(Stage::Graph) {
        Err(ComputeError::Interrupted) => Err(Interrupted),
        _ => Ok(()),
    };
    let mut all = Vec::new();
    for (nominal, by) in checked {
        go_on()?;
        let mut study = Study::new(
            template,
            set,
            &variations,
            model,
            nominal.requirement.clone(),
            &spaces,
            progress,
        );
        let zero = vec![0.0; variations.len()];
        let is_number = matches!(
            nominal.measured.as_ref().map(|m| m.value),
            Ok(crate::Value::Number(_))
        );
        let linear = is_number.then(|| study.linear(&by)).flatten();
        study.know();
        go_on()?;
        let structure = study.all_changes();
        let fails = |c: &&Structural| c.kind != ChangeKind::Contact && c.share < 1.0;
        let failure = structure.iter().find(fails);
        go_on()?;
        let mut ends = [None, None];
        let exact = is_number.then(|| {
            [(-1.0, 0), (1.0, 1)].map(|(sign, i)| match study.summit(sign, 1.0) {
                Ok(summit) => {
                    let (certified, gap) = match failure {
                        Some(_) if sign < 0.0 => (false, None),
                        _ => study.prove(&summit, sign, 1.0),
                    };
                    let extreme = Extreme {
                        value: Ok(summit.value),
                        at: summit.at.clone(),
                        certified,
                        gap,
                    };
                    ends[i] = Some(summit);
                    extreme
                }
                Err((failure, at)) => Extreme {
                    value: Err(failure.reason),
                    at,
                    certified: false,
                    gap: None,
                },
            })
        });
        go_on()?;
        // Where parts jam within the tolerances, there is no smallest value.
        let exact = exact.map(|[lo, hi]| [failure.map_or(lo, without_value), hi]);
        let margin = study.margin([ends[0].as_ref(), ends[1].as_ref()], &structure);
        let monte_carlo = if options.samples > 0 && study.at(&zero).value.is_ok() {
            let between = |_| progress.stage(Stage::Graph).is_ok();
            Some(
                study
                    .sample(options.samples, options.seed, &between)
                    .ok_or(Interrupted)?,
            )
        } else {
            None
        };
        all.push(Tolerances {
            nominal,
            linear,
            exact,
            structure,
            margin,
            monte_carlo,
        });
    }
    Ok(all)
}

/// What stands for the smallest value where something fails within the tolerances.
fn without_value(failure: &Structural) -> Extreme {
    Extreme {
        value: Err(failure.what.clone()),
        at: failure.at.clone(),
        certified: false,
        gap: None,
    }
}
