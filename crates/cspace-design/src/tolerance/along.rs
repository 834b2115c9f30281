//! Bands of a requirement along a motion: its nominal value and its extremes where one coordinate has each of many values.

use cspace::{Progress, parallel};
use cspace_model::Model;
use cspace_model::model::{
    Coordinate, Dimension, Quantity, Requirement, Setting, Subject, Template,
};

use super::study::Study;
use super::{Analysis, Extreme, ToleranceOptions, Variations};
use crate::check::Interrupted;
use crate::value::{Measured, Unmeasured, Value};

/// A requirement along a motion.
#[derive(Debug, Clone)]
pub struct Band {
    /// The requirement.
    pub requirement: Requirement,
    /// Results at each value of the coordinate.
    pub stations: Vec<Station>,
}

/// A requirement where a coordinate has a value.
#[derive(Debug, Clone)]
pub struct Station {
    /// The value of the coordinate.
    pub at: f64,
    /// The value as drawn, or why there is none.
    pub nominal: Result<f64, String>,
    /// The smallest and the largest value within the tolerances.
    pub exact: [Extreme; 2],
}

impl Station {
    /// How far apart the extremes are, where there are both.
    pub fn width(&self) -> Option<f64> {
        let [lo, hi] = &self.exact;
        Some(*hi.value.as_ref().ok()? - *lo.value.as_ref().ok()?)
    }
}

/// The bands of all requirements that are numbers measured at a configuration with the coordinate, over some of its values. A play is measured
/// about the middle of that at the value before, where that is free, so that it follows the part; otherwise where the model has it.
///
/// # Errors
/// If the progress ends the computation.
pub fn along(
    template: &Template,
    set: &[Setting],
    model: &Model,
    options: &ToleranceOptions,
    (coordinate, values): (Coordinate, &[f64]),
    progress: &dyn Progress,
) -> Result<Vec<Band>, Interrupted> {
    let variations = Variations::of(model);
    let analysis = Analysis::new(template, set, model, options, progress)?;
    let mut bands = Vec::new();
    for requirement in &analysis.model.requirements {
        let has_it = requirement.subject.clone().put(coordinate, 0.0);
        if !has_it || requirement.dimension == Dimension::Truth {
            continue;
        }
        // First where it is measured, one after the other; then the extremes.
        let mut before: Option<(Coordinate, f64)> = None;
        let mut places = Vec::new();
        for &value in values {
            analysis.go_on()?;
            // Where the part was, if that is free.
            let at = |follow: Option<(Coordinate, f64)>| {
                let held: Vec<_> = [(coordinate, value)].into_iter().chain(follow).collect();
                let measured = analysis.spaces.measure(&put(requirement, &held));
                (held, measured)
            };
            let followed = before.map(|_| at(before)).filter(|(_, m)| m.is_ok());
            let (held, measured) = followed.unwrap_or_else(|| at(None));
            before = middle(requirement, measured.as_ref());
            places.push((value, held, measured));
        }
        let stations = parallel::map(&places, 1, |place| {
            analysis.station(&variations, requirement, place.clone())
        });
        let stations = stations.into_iter().collect::<Result<_, _>>()?;
        bands.push(Band {
            requirement: requirement.clone(),
            stations,
        });
    }
    Ok(bands)
}

/// A requirement measured at other coordinates.
fn put(requirement: &Requirement, held: &[(Coordinate, f64)]) -> Requirement {
    let mut requirement = requirement.clone();
    for &(of, value) in held {
        requirement.subject.put(of, value);
    }
    requirement
}

/// The middle of a play.
fn middle(
    requirement: &Requirement,
    measured: Result<&Measured, &Unmeasured>,
) -> Option<(Coordinate, f64)> {
    let Subject::Pair(_, Quantity::Play { of, .. }) = requirement.subject else {
        return None;
    };
    let (lo, hi) = measured.ok()?.range?;
    Some((of, 0.5 * (lo + hi)))
}

/// The value of the coordinate, all coordinates that are held, and what is measured there.
type Place = (f64, Vec<(Coordinate, f64)>, Result<Measured, Unmeasured>);

impl Analysis<'_> {
    fn station(
        &self,
        variations: &Variations,
        requirement: &Requirement,
        (at, held, measured): Place,
    ) -> Result<Station, Interrupted> {
        self.go_on()?;
        let nominal = match measured.map(|m| m.value) {
            Ok(Value::Number(x)) => x,
            other => {
                let reason = other.map_or_else(|e| e.to_string(), |_| "it is yes or no".to_owned());
                let none = || {
                    let reason = "there is no value as drawn".to_owned();
                    Extreme::none(reason, vec![0.0; variations.len()])
                };
                return Ok(Station {
                    at,
                    nominal: Err(reason),
                    exact: [none(), none()],
                });
            }
        };
        let mut model = self.model.clone();
        model.requirements = vec![put(requirement, &held)];
        let (template, set) = (self.template, self.set);
        let of = (variations, &model, requirement.clone());
        let study = Study::new(template, set, of, self.progress);
        let mut study = study.held_at(held).on(&self.spaces);
        study.know();
        let corners = study.corners(1.0).into_iter();
        let mut jams = corners.filter_map(|at| Some((study.at(&at).value.err()?.reason, at)));
        let [lo, hi] = [-1.0, 1.0].map(|sign| study.extreme(sign, true).0);
        let exact = match jams.next() {
            Some((reason, at)) => [Extreme::none(reason, at), hi],
            None => [lo, hi],
        };
        Ok(Station {
            at,
            nominal: Ok(nominal),
            exact,
        })
    }
}
