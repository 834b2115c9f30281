//! Effects of tolerances on requirements: sensitivities, worst cases, yield, and where the structure changes.
//!
//! Contact spaces make the answers exact: a requirement's value anywhere within the tolerances is that of the contact that comes first there, whichever
//! it is. Sources: Sacks and Joskowicz 1998 (variation of contact functions, sensitivities), Kyung and Sacks 2003 (contact zones).
//!
//! ```
//! use cspace_design::{ToleranceOptions, tolerances};
//! use cspace_model::Host;
//! use cspace_model::model::Template;
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

mod allocate;
mod along;
mod extremes;
mod linear;
mod monte_carlo;
mod proof;
mod structure;
mod study;
mod vary;
mod zones;

use cspace::{ComputeError, Progress, space::Stage};
use cspace_model::model::{Requirement, Setting, Template};
use cspace_model::{Host, Model};

use crate::check::{Checked, Interrupted, Spaces};
use crate::sensitivity::{Sensitivity, sensitivities_on};
use crate::value::Value;

pub use allocate::{Allocation, Criterion, Unallocated, allocate};
pub use along::{Band, Station, along};
pub use extremes::Extreme;
pub use linear::{Contribution, Linear};
pub use monte_carlo::MonteCarlo;
pub use structure::{ChangeKind, LARGEST_FACTOR, Margin, Structural};
pub use vary::{Variation, Variations, Zone};
pub use zones::{Cell, NoZones, ZoneBand, Zones, area, zones};

use study::Study;

/// Options beside the worst cases.
#[derive(Debug, Clone, Default)]
pub struct ToleranceOptions {
    /// The number of samples; none without.
    pub samples: u64,
    /// Seed of the samples.
    pub seed: u64,
    /// The names of the requirements that are analysed; all if there are none.
    pub requirements: Vec<String>,
    /// Whether extremes are left as they are found, without the proof that nothing is beyond them.
    pub without_proof: bool,
}

/// Effects of tolerances on one requirement.
#[derive(Debug, Clone)]
pub struct Tolerances {
    /// The requirement as drawn.
    pub nominal: Checked,
    /// The linear analysis; `None` of yes and no, and of what has no value as drawn.
    pub linear: Option<Linear>,
    /// The smallest and the largest value; `None` of yes and no.
    pub exact: Option<[Extreme; 2]>,
    /// Structural changes up to [`LARGEST_FACTOR`] times the tolerances, the first first.
    pub structure: Vec<Structural>,
    /// The factor on all tolerances at which the requirement or the structure fails.
    pub margin: Margin,
    /// Result of the samples, if they are asked for.
    pub monte_carlo: Option<MonteCarlo>,
    /// Whether the progress ended the computation: what needs more than derivatives as drawn is not known then.
    pub interrupted: bool,
}

/// Analyses the tolerances of every requirement of a model, which is that of the template with the values set.
///
/// If the progress ends the computation, what is known by then is the answer ([`Tolerances::interrupted`]).
///
/// # Errors
/// If the progress ends the computation before anything is known.
pub fn tolerances(
    template: &Template,
    set: &[Setting],
    model: &Model,
    options: &ToleranceOptions,
    progress: &dyn Progress,
) -> Result<Vec<Tolerances>, Interrupted> {
    tolerances_with(template, set, model, options, &|_| {}, progress)
}

/// As [`tolerances`]; `known` is told at once what derivatives as drawn say of each requirement, which is all of an interrupted answer.
///
/// # Errors
/// As there.
pub fn tolerances_with(
    template: &Template,
    set: &[Setting],
    model: &Model,
    options: &ToleranceOptions,
    known: &dyn Fn(&[Tolerances]),
    progress: &dyn Progress,
) -> Result<Vec<Tolerances>, Interrupted> {
    let analysis = Analysis::new(template, set, model, options, progress)?;
    let variations = Variations::of(model);
    let mut all = analysis.at_once(&variations);
    known(&all);
    for known in &mut all {
        let whole = (analysis.go_on()).and_then(|()| analysis.beyond(&variations, known));
        known.interrupted = whole.is_err();
    }
    Ok(all)
}

/// The requirements that are analysed, with their nominal values.
struct Analysis<'a> {
    template: &'a Template,
    set: &'a [Setting],
    /// With these requirements alone.
    model: Model,
    options: &'a ToleranceOptions,
    /// Whether extremes are proved: the margin does not need it.
    proves: bool,
    spaces: Spaces,
    progress: &'a dyn Progress,
}

impl<'a> Analysis<'a> {
    fn new(
        template: &'a Template,
        set: &'a [Setting],
        model: &Model,
        options: &'a ToleranceOptions,
        progress: &'a dyn Progress,
    ) -> Result<Self, Interrupted> {
        // A template has all requirements.
        let is_chosen = |r: &Requirement| {
            options.requirements.is_empty() || options.requirements.contains(&r.name)
        };
        let mut model = model.clone();
        model.requirements.retain(is_chosen);
        let spaces = Spaces::compute(&model, progress)?;
        Ok(Self {
            template,
            set,
            model,
            options,
            proves: !options.without_proof,
            spaces,
            progress,
        })
    }

    fn study<'s>(&'s self, variations: &'s Variations, requirement: &Requirement) -> Study<'s> {
        Study::new(
            self.template,
            self.set,
            (variations, &self.model, requirement.clone()),
            self.progress,
        )
        .on(&self.spaces)
    }

    fn go_on(&self) -> Result<(), Interrupted> {
        match self.progress.stage(Stage::Graph) {
            Err(ComputeError::Interrupted) => Err(Interrupted),
            _ => Ok(()),
        }
    }

    /// Effects of these variations on each requirement.
    fn of(&self, variations: &Variations) -> Result<Vec<Tolerances>, Interrupted> {
        let mut all = self.at_once(variations);
        for known in &mut all {
            self.go_on()?;
            self.beyond(variations, known)?;
            known.interrupted = false;
        }
        Ok(all)
    }

    /// Effects of tolerances on each requirement as far as derivatives as drawn say.
    fn at_once(&self, variations: &Variations) -> Vec<Tolerances> {
        let host = Host {
            set: self.set,
            ..Host::default()
        };
        let all = sensitivities_on(&self.spaces, self.template, &host, &self.model);
        let known = |(nominal, by): (Checked, Vec<Sensitivity>)| {
            let mut known = unmeasured(self.spaces.with_room(nominal));
            let nominal = &known.nominal;
            if let Ok(measured) = &nominal.measured {
                if let Value::Number(_) = measured.value {
                    known.linear = self.study(variations, &nominal.requirement).linear(&by);
                }
                known.interrupted = true;
                known.margin = Margin {
                    factor: None,
                    what: "not known: the computation was interrupted".to_owned(),
                };
            }
            known
        };
        all.into_iter().map(known).collect()
    }

    /// Adds to what is known at once of a requirement, as far as the progress lets it.
    fn beyond(&self, variations: &Variations, known: &mut Tolerances) -> Result<(), Interrupted> {
        let nominal = &known.nominal;
        let Ok(measured) = &nominal.measured else {
            return Ok(());
        };
        let is_number = matches!(measured.value, Value::Number(_));
        let mut study = self.study(variations, &nominal.requirement);
        study.know();
        self.go_on()?;
        let structure = study.all_changes();
        self.go_on()?;
        known.structure.clone_from(&structure);
        let fails = |c: &&Structural| c.kind != ChangeKind::Contact && c.share < 1.0;
        let failure = structure.iter().find(fails);
        let mut ends = [None, None];
        let exact = is_number.then(|| {
            [(-1.0, 0), (1.0, 1)].map(|(sign, i)| {
                let has_end = failure.is_none() || sign > 0.0;
                let (extreme, summit) = study.extreme(sign, self.proves && has_end);
                ends[i] = summit;
                extreme
            })
        });
        self.go_on()?;
        // Where parts jam within the tolerances, there is no smallest value.
        let without =
            |failure: &Structural| Extreme::none(failure.what.clone(), failure.at.clone());
        known.exact = exact.map(|[lo, hi]| [failure.map_or(lo, without), hi]);
        let margin = study.margin([ends[0].as_ref(), ends[1].as_ref()], &structure);
        self.go_on()?;
        known.margin = margin;
        if self.options.samples > 0 {
            known.monte_carlo = Some(self.sampled(&study, self.options.samples)?);
        }
        Ok(())
    }

    fn sampled(&self, study: &Study<'_>, samples: u64) -> Result<MonteCarlo, Interrupted> {
        let found = study.sample(samples, self.options.seed);
        found.ok_or(Interrupted)
    }
}

/// Answer for a requirement that has no value as drawn.
fn unmeasured(nominal: Checked) -> Tolerances {
    Tolerances {
        nominal,
        linear: None,
        exact: None,
        structure: Vec::new(),
        margin: Margin {
            factor: Some(0.0),
            what: "it has no value as drawn".to_owned(),
        },
        monte_carlo: None,
        interrupted: false,
    }
}
