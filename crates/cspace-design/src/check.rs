//! All requirements of a model.

use cspace::{ComputeError, Options, PairError, PairSpace, Progress, Silent};
use cspace_model::model::{OverRanges, Quantity, Requirement, Subject, Target};
use cspace_model::{Compute, Model, ModelError, PairEntry, compute_anew};
use cspace_plan::ranges::Pairs;

use crate::exact_fit::measured;
use crate::in_motion::{Found, Motion};
use crate::measure::measure;
use crate::value::{Measured, Unmeasured, Value};

/// Values that are measured with a gap are known to so many resolutions of contacts.
const KNOWN: f64 = 16.0;

/// A requirement that was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Checked {
    /// The requirement.
    pub requirement: Requirement,
    /// Measured value, or why there is none.
    pub measured: Result<Measured, Unmeasured>,
    /// The indices of the two parts that it is about: of an event those that it happens to.
    pub parts: Option<[usize; 2]>,
    /// Features in contact where the quantity ends, of the two parts, as messages call them.
    pub touching: Vec<[String; 2]>,
    /// The gap by which the moving part is smaller, where the parts fit exactly and it is measured with one (the model's unit of length).
    pub gap: Option<f64>,
    /// How well a value that is measured with a gap is known: a limit that is missed by less is met.
    within: f64,
}

impl Checked {
    /// Whether it is met; one without a value is not. `None` of one that only measures, and of one that is not decided.
    pub fn is_met(&self) -> Option<bool> {
        let target = self.requirement.target?;
        if self.is_undecided() {
            return None;
        }
        let value = self.measured.as_ref().ok().map(|m| m.value);
        Some(match (target, value) {
            (Target::Limits(lo, hi), Some(Value::Number(_))) => {
                let allowed = lo - self.within..=hi + self.within;
                self.values().iter().all(|x| allowed.contains(x))
            }
            (Target::Equals(wanted), Some(Value::Truth(found))) => wanted == found,
            _ => false,
        })
    }

    /// Whether its quantity may have a value, which could not be found ([`Unmeasured::is_undecided`]).
    pub fn is_undecided(&self) -> bool {
        self.measured.as_ref().is_err_and(Unmeasured::is_undecided)
    }

    /// How far the value is within its limits; negative if it is outside.
    pub fn margin(&self) -> Option<f64> {
        match (self.requirement.target?, self.measured.as_ref().ok()?.value) {
            (Target::Limits(lo, hi), Value::Number(_)) => {
                let margins = self.values().into_iter().map(|x| (x - lo).min(hi - x));
                margins.reduce(f64::min)
            }
            _ => None,
        }
    }

    /// The values that must be within limits: of a backlash the least and the largest.
    fn values(&self) -> Vec<f64> {
        let is_backlash = matches!(
            self.requirement.subject,
            Subject::Pair(
                _,
                Quantity::Ranges {
                    what: OverRanges::Backlash(_),
                    ..
                }
            )
        );
        match self.measured.as_ref().map(|m| (m.value, m.range)) {
            Ok((Value::Number(_), Some((least, most)))) if is_backlash => vec![least, most],
            Ok((Value::Number(x), _)) => vec![x],
            _ => Vec::new(),
        }
    }
}

/// Measures all requirements of a model, in the order of the model.
///
/// A quantity that cannot be measured has its reason in [`Checked::measured`].
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
    Ok(spaces.check_all(model))
}

/// As [`check_with`], with the spaces from elsewhere.
///
/// # Errors
/// If the progress ends the computation.
pub fn check_by(
    model: &Model,
    compute: &Compute<'_>,
    progress: &dyn Progress,
) -> Result<Vec<Checked>, Interrupted> {
    Ok(Spaces::compute_by(model, compute, progress)?.check_all(model))
}

/// Why there is no model with some values, in words.
pub(crate) fn reason(error: &ModelError) -> String {
    match error.place() {
        "" => error.message().to_owned(),
        place => format!("{place}: {}", error.message()),
    }
}

/// Spaces that requirements are measured on, each computed once: the configuration spaces of pairs, and motions.
pub(crate) struct Spaces {
    pairs: Vec<(PairEntry, Result<PairSpace, Unmeasured>)>,
    motions: Vec<(f64, Result<Motion, Unmeasured>)>,
    /// Pairs of parts that a chain of joints connects.
    linked: Vec<PairEntry>,
}

impl Spaces {
    pub(crate) fn compute(model: &Model, progress: &dyn Progress) -> Result<Self, Interrupted> {
        Self::compute_by(model, &compute_anew(progress), progress)
    }

    /// The spaces from elsewhere, and motions that are followed on them.
    pub(crate) fn compute_by(
        model: &Model,
        compute: &Compute<'_>,
        progress: &dyn Progress,
    ) -> Result<Self, Interrupted> {
        let mut found = Self {
            pairs: Vec::new(),
            motions: Vec::new(),
            linked: Vec::new(),
        };
        let pairs = Pairs::of(&model.mechanism);
        for requirement in &model.requirements {
            match requirement.subject {
                Subject::Pair(pair, _) => {
                    if found.pairs.iter().all(|s| s.0 != pair) {
                        found.pairs.push((pair, space(model, &pair, compute)?));
                        if pairs.are_linked([pair.fixed, pair.moving]) {
                            found.linked.push(pair);
                        }
                    }
                }
                Subject::Motion(time, _) => {
                    if found.motions.iter().all(|m| m.0 != time) {
                        let motion = Motion::follow(&model.mechanism, time, compute, progress)
                            .map_err(|_| Interrupted)?;
                        found.motions.push((time, motion));
                    }
                }
            }
        }
        Ok(found)
    }

    fn check_all(&self, model: &Model) -> Vec<Checked> {
        let all = model.requirements.iter();
        all.map(|r| self.with_room(self.check(r))).collect()
    }

    /// A requirement that was checked, and measured with a gap where the parts fit exactly.
    pub(crate) fn with_room(&self, mut checked: Checked) -> Checked {
        if checked.measured == Err(Unmeasured::Blocked)
            && let (Subject::Pair(_, quantity), Some(space)) =
                (&checked.requirement.subject, self.of(&checked.requirement))
        {
            match measured(space, quantity) {
                Ok(measured) => {
                    checked.touching = measured.touching(space);
                    checked.gap = measured.gap;
                    checked.measured = Ok(measured);
                    checked.within = KNOWN * space.resolution();
                }
                Err(error) => checked.measured = Err(error),
            }
        }
        checked
    }

    /// Measures a requirement, and names what touches.
    pub(crate) fn check(&self, requirement: &Requirement) -> Checked {
        let mut checked = Checked {
            requirement: requirement.clone(),
            measured: Err(Unmeasured::Unknown),
            parts: requirement.subject.parts(),
            touching: Vec::new(),
            gap: None,
            within: 0.0,
        };
        match self.found(requirement) {
            Ok(On::Pair(space, measured)) => {
                checked.touching = measured.touching(space);
                checked.gap = measured.gap;
                checked.measured = Ok(measured);
            }
            Ok(On::Motion(found)) => {
                checked.measured = Ok(Measured::number(found.value));
                checked.parts = found.parts.or(checked.parts);
                checked.touching = found.features;
                checked.gap = found.gap;
            }
            Err(error) => checked.measured = Err(error),
        }
        checked
    }

    /// Measures a requirement.
    pub(crate) fn measure(&self, requirement: &Requirement) -> Result<Measured, Unmeasured> {
        Ok(match self.found(requirement)? {
            On::Pair(_, measured) => measured,
            On::Motion(found) => Measured::number(found.value),
        })
    }

    fn found(&self, requirement: &Requirement) -> Result<On<'_>, Unmeasured> {
        match requirement.subject {
            Subject::Pair(pair, quantity) => {
                let known = self.pairs.iter().find(|s| s.0 == pair);
                let space = (known.ok_or(Unmeasured::Unknown)?.1.as_ref()).map_err(Clone::clone)?;
                if matches!(quantity, Quantity::Ranges { .. }) && self.linked.contains(&pair) {
                    return Err(Unmeasured::Linked);
                }
                Ok(On::Pair(space, measure(space, &quantity)?))
            }
            Subject::Motion(time, quantity) => {
                let known = self.motions.iter().find(|m| m.0 == time);
                let motion =
                    (known.ok_or(Unmeasured::Unknown)?.1.as_ref()).map_err(Clone::clone)?;
                Ok(On::Motion(motion.measure(quantity)?))
            }
        }
    }

    /// The space that a requirement is about; `None` where it is about a motion, or the space cannot be computed.
    pub(crate) fn of(&self, requirement: &Requirement) -> Option<&PairSpace> {
        let Subject::Pair(pair, _) = requirement.subject else {
            return None;
        };
        self.pairs.iter().find(|s| s.0 == pair)?.1.as_ref().ok()
    }
}

/// A quantity, and on what it is measured.
enum On<'a> {
    Pair(&'a PairSpace, Measured),
    Motion(Found),
}

fn space(
    model: &Model,
    pair: &PairEntry,
    compute: &Compute<'_>,
) -> Result<Result<PairSpace, Unmeasured>, Interrupted> {
    let mechanism = &model.mechanism;
    let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &mechanism.parts[i].part);
    let options = Options {
        window: pair.window,
        ..Options::default()
    };
    let relation = mechanism.relation(pair);
    match compute(fixed, moving, relation, &options) {
        Ok(space) => Ok(Ok(space)),
        Err(PairError::Compute(ComputeError::Interrupted)) => Err(Interrupted),
        Err(error) => Ok(Err(Unmeasured::Space(error.to_string()))),
    }
}
