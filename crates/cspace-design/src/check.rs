//! All requirements of a model.

use cspace::{ComputeError, Options, PairEntry, PairError, PairSpace, Progress, Silent};
use cspace_io::Model;
use cspace_io::model::{Requirement, Target};

use crate::measure::{Measured, Unmeasured, Value, measure};

/// A requirement that was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// The requirement.
    pub requirement: Requirement,
    /// What it is, or why it has no value.
    pub measured: Result<Measured, Unmeasured>,
    /// What touches where the quantity ends: features of the fixed and of the moving part, as messages call them.
    pub touching: Vec<[String; 2]>,
}

impl Checked {
    /// Whether it is met; one without a value is not. `None` of one that only measures.
    pub fn is_met(&self) -> Option<bool> {
        let target = self.requirement.target?;
        let value = self.measured.as_ref().ok().map(|m| m.value);
        Some(match (target, value) {
            (Target::Limits(lo, hi), Some(Value::Number(x))) => (lo..=hi).contains(&x),
            (Target::Equals(wanted), Some(Value::Truth(found))) => wanted == found,
            _ => false,
        })
    }

    /// How far the value is within its limits; negative if it is outside.
    pub fn margin(&self) -> Option<f64> {
        match (self.requirement.target?, self.measured.as_ref().ok()?.value) {
            (Target::Limits(lo, hi), Value::Number(x)) => Some((x - lo).min(hi - x)),
            _ => None,
        }
    }
}

/// Measures all requirements of a model, in the order of the model.
///
/// What cannot be measured says so in [`Checked::measured`].
pub fn check(model: &Model) -> Vec<Checked> {
    check_with(model, &Silent).unwrap_or_default()
}

/// The computation was ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the computation was interrupted")]
pub struct Interrupted;

/// As [`check`], telling how far it is.
///
/// # Errors
/// If the progress ends the computation.
pub fn check_with(model: &Model, progress: &dyn Progress) -> Result<Vec<Checked>, Interrupted> {
    let spaces = Spaces::compute(model, progress)?;
    Ok(model.requirements.iter().map(|r| spaces.check(r)).collect())
}

/// The configuration spaces of the pairs that requirements are about, each computed once.
pub(crate) struct Spaces(Vec<(PairEntry, Result<PairSpace, Unmeasured>)>);

impl Spaces {
    pub(crate) fn compute(model: &Model, progress: &dyn Progress) -> Result<Self, Interrupted> {
        let mut spaces: Vec<(PairEntry, Result<PairSpace, Unmeasured>)> = Vec::new();
        for requirement in &model.requirements {
            if spaces.iter().all(|s| s.0 != requirement.pair) {
                spaces.push((requirement.pair, space(model, &requirement.pair, progress)?));
            }
        }
        Ok(Self(spaces))
    }

    /// Measures a requirement of one of the pairs, and names what touches.
    pub(crate) fn check(&self, requirement: &Requirement) -> Checked {
        let measured = self.measure(requirement);
        let touching = match (self.of(requirement), &measured) {
            (Ok(space), Ok(measured)) => measured.touching(space),
            _ => Vec::new(),
        };
        Checked {
            requirement: requirement.clone(),
            measured,
            touching,
        }
    }

    /// Measures a requirement of one of the pairs.
    pub(crate) fn measure(&self, requirement: &Requirement) -> Result<Measured, Unmeasured> {
        measure(self.of(requirement)?, &requirement.quantity)
    }

    /// The space that a requirement is about.
    pub(crate) fn of(&self, requirement: &Requirement) -> Result<&PairSpace, Unmeasured> {
        match self.0.iter().find(|s| s.0 == requirement.pair) {
            Some((_, space)) => space.as_ref().map_err(Clone::clone),
            None => Err(Unmeasured::Space("the pair has no space".to_owned())),
        }
    }
}

fn space(
    model: &Model,
    pair: &PairEntry,
    progress: &dyn Progress,
) -> Result<Result<PairSpace, Unmeasured>, Interrupted> {
    let mechanism = &model.mechanism;
    let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &mechanism.parts[i].part);
    let options = Options {
        window: pair.window,
        ..Options::default()
    };
    let relation = mechanism.relation(pair);
    match PairSpace::compute_with(fixed, moving, relation, &options, progress) {
        Ok(space) => Ok(Ok(space)),
        Err(PairError::Compute(ComputeError::Interrupted)) => Err(Interrupted),
        Err(error) => Ok(Err(Unmeasured::Space(error.to_string()))),
    }
}
