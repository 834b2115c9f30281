//! Amounts in the reason why there is no solution: to as many digits as say something, and angles in degrees.

use cspace_model::Host;
use cspace_model::model::Dimension;

use super::problem::Problem;

/// Kinds of the numbers of a problem with one parameter.
pub(super) struct Words {
    dimension: Dimension,
    is_angle: bool,
    unit: String,
}

impl Words {
    pub(super) fn of(problem: &Problem<'_>) -> Self {
        let host = Host {
            set: problem.set,
            ..Host::default()
        };
        let model = problem.template.model(&host).ok();
        let mut requirements = model.iter().flat_map(|m| &m.requirements);
        let mut parameters = model.iter().flat_map(|m| &m.parameters);
        let requirement = requirements.find(|r| r.name == problem.goal.requirement);
        let parameter = parameters.find(|p| problem.spans.iter().any(|s| s.parameter == p.name));
        let unit = model.as_ref().and_then(|m| m.mechanism.unit.as_deref());
        Self {
            dimension: requirement.map_or(Dimension::Number, |r| r.dimension),
            is_angle: parameter.is_some_and(|p| p.is_angle),
            unit: unit.map_or_else(String::new, |unit| format!(" {unit}")),
        }
    }

    /// How far the quantity is off, with its sign.
    pub(super) fn quantity(&self, off: f64) -> String {
        match self.dimension {
            Dimension::Angle => format!("{} deg", short(off.to_degrees())),
            Dimension::Time => format!("{} s", short(off)),
            Dimension::Length => format!("{}{}", short(off), self.unit),
            Dimension::Number | Dimension::Truth => short(off),
        }
    }

    /// A value of the parameter.
    pub(super) fn parameter(&self, value: f64) -> String {
        let digits = |x: f64| short(x).trim_start_matches('+').to_owned();
        match self.is_angle {
            true => format!("{} deg", digits(value.to_degrees())),
            false => digits(value),
        }
    }
}

/// A number with its sign to some five digits.
fn short(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e7).contains(&size) => format!("{x:+.4}"),
        _ => format!("{x:+.4e}"),
    }
}
