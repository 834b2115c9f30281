//! Requirements measured over many values of parameters and coordinates.

use std::sync::{Arc, Mutex, PoisonError};

use cspace::{Silent, parallel};
use cspace_model::model::{Coordinate, Requirement, Setting, Template};
use cspace_model::{Host, Model};

use crate::check::{Spaces, reason};
use crate::value::Value;

/// Parameter or coordinate that varies from row to row.
#[derive(Debug, Clone, PartialEq)]
pub enum Varied {
    /// A parameter of the model, by name.
    Parameter(String),
    /// A coordinate of the configurations at which quantities are measured.
    Coordinate(Coordinate),
}

impl Varied {
    /// Resolves a name in a model: a parameter, or else a coordinate.
    pub fn named(name: &str, model: &Model) -> Option<Self> {
        if model.parameters.iter().any(|p| p.name == name) {
            return Some(Self::Parameter(name.to_owned()));
        }
        let all = [
            Coordinate::X,
            Coordinate::Y,
            Coordinate::Theta,
            Coordinate::U,
            Coordinate::V,
        ];
        all.into_iter()
            .find(|c| c.name() == name)
            .map(Self::Coordinate)
    }

    /// Whether a model, and what some of its requirements measure, can depend on it: of a coordinate, one of them is measured at a
    /// configuration that has it.
    pub fn is_of(&self, measures: &[String], model: &Model) -> bool {
        let Self::Coordinate(of) = *self else {
            return true;
        };
        let mut measured = (model.requirements.iter()).filter(|r| measures.contains(&r.name));
        measured.any(|r| r.subject.clone().put(of, 0.0))
    }
}

/// One row: what every measure is, or why it has no value, in the order of the measures.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The values and reasons.
    pub measured: Vec<Result<Value, String>>,
}

/// Many rows of a model: what is varied, and what is measured.
pub struct Sweep<'a> {
    template: &'a Template,
    /// Values of parameters that all rows have.
    set: &'a [Setting],
    varied: &'a [Varied],
    measures: &'a [String],
    /// The design of the last rows: those that vary coordinates alone have one.
    last: Mutex<Option<Arc<Design>>>,
}

/// A model with values for its parameters.
struct Design {
    /// The values of what is varied, of which those of parameters count.
    values: Vec<f64>,
    /// The requirements that are measured, with their spaces; or why there is no such model.
    spaces: Result<(Vec<Requirement>, Spaces), String>,
}

/// Words that count as the same where numbers alone differ.
#[derive(Debug, Clone)]
struct Words {
    text: String,
    /// Without the numbers.
    key: String,
}

impl PartialEq for Words {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key
    }
}

impl Eq for Words {}

impl Words {
    /// Words of which every number counts.
    fn exact(text: String) -> Self {
        Self {
            key: text.clone(),
            text,
        }
    }

    /// A reason, in which numbers change from row to row.
    fn reason(text: String) -> Self {
        Self {
            key: text.replace(
                |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e'),
                "",
            ),
            text,
        }
    }
}

/// State of a measure that can change between rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct State {
    /// The free regions of the pair, and what is so of the value.
    is: [Words; 2],
    /// Features in contact.
    touching: Vec<String>,
}

impl State {
    /// Differences between two states, in words.
    pub(crate) fn unlike(&self, other: &Self) -> (String, String) {
        let mut both = [Vec::new(), Vec::new()];
        for (a, b) in self.is.iter().zip(&other.is).filter(|(a, b)| a != b) {
            both[0].push(a.text.clone());
            both[1].push(b.text.clone());
        }
        let gone = |a: &Self, b: &Self| -> Vec<String> {
            let only = a.touching.iter().filter(|t| !b.touching.contains(t));
            only.cloned().collect()
        };
        both[0].extend(gone(self, other));
        both[1].extend(gone(other, self));
        let [before, after] = both.map(|words| words.join("; "));
        (before, after)
    }
}

impl<'a> Sweep<'a> {
    /// A sweep over what is varied, by rows of values in that order. `measures` are names of requirements.
    pub const fn new(
        template: &'a Template,
        set: &'a [Setting],
        varied: &'a [Varied],
        measures: &'a [String],
    ) -> Self {
        Self {
            template,
            set,
            varied,
            measures,
            last: Mutex::new(None),
        }
    }

    /// Measures some rows, in parallel. What comes out does not depend on the number of threads.
    ///
    /// Spaces are computed once for neighbouring rows in which all parameters are the same.
    pub fn rows(&self, rows: &[Vec<f64>]) -> Vec<Row> {
        let designs: Vec<&[Vec<f64>]> = rows.chunk_by(|a, b| self.is_same(a, b)).collect();
        let known = self
            .last
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take();
        let found: Vec<(Vec<Row>, Arc<Design>)> = parallel::map(&designs, 1, |rows| {
            let known = known.as_ref().filter(|d| self.is_same(&d.values, &rows[0]));
            let design = known
                .cloned()
                .unwrap_or_else(|| Arc::new(self.design(&rows[0])));
            let measured = parallel::map(rows, 1, |values| self.row(&design, values));
            (measured, design)
        });
        let last = found.last().map(|(_, design)| Arc::clone(design)).or(known);
        *self.last.lock().unwrap_or_else(PoisonError::into_inner) = last;
        found.into_iter().flat_map(|(rows, _)| rows).collect()
    }

    /// Whether parameters have the same values in two rows.
    fn is_same(&self, a: &[f64], b: &[f64]) -> bool {
        let mut all = self.varied.iter().zip(a.iter().zip(b));
        all.all(|(varied, (a, b))| {
            matches!(varied, Varied::Coordinate(_)) || a.to_bits() == b.to_bits()
        })
    }

    fn design(&self, values: &[f64]) -> Design {
        let mut set = self.set.to_vec();
        for (varied, value) in self.varied.iter().zip(values) {
            if let Varied::Parameter(name) = varied {
                set.push(Setting::number(name, *value));
            }
        }
        let host = Host {
            set: &set,
            ..Host::default()
        };
        let spaces = self
            .template
            .model(&host)
            .map_err(|e| reason(&e))
            .and_then(|mut model| {
                model
                    .requirements
                    .retain(|r| self.measures.contains(&r.name));
                let spaces = Spaces::compute(&model, &Silent).map_err(|e| e.to_string())?;
                Ok((model.requirements, spaces))
            });
        Design {
            values: values.to_vec(),
            spaces,
        }
    }

    fn row(&self, design: &Design, values: &[f64]) -> Row {
        let measure = |name: &String| {
            let (requirement, spaces) = self.measured(design, values, name)?;
            let measured = spaces.with_room(spaces.check(&requirement)).measured;
            measured.map(|m| m.value).map_err(|e| e.to_string())
        };
        Row {
            measured: self.measures.iter().map(measure).collect(),
        }
    }

    /// A requirement at the values of a row, and the spaces of its design.
    fn measured<'d>(
        &self,
        design: &'d Design,
        values: &[f64],
        name: &str,
    ) -> Result<(Requirement, &'d Spaces), String> {
        let (requirements, spaces) = design.spaces.as_ref().map_err(String::clone)?;
        let known = requirements.iter().find(|r| r.name == *name);
        let mut requirement = known.ok_or("the model has no such requirement")?.clone();
        for (varied, value) in self.varied.iter().zip(values) {
            if let Varied::Coordinate(of) = varied {
                requirement.subject.put(*of, *value);
            }
        }
        Ok((requirement, spaces))
    }

    /// The names of what is measured.
    pub const fn measures(&self) -> &[String] {
        self.measures
    }

    /// State of every measure at the values of a row.
    pub(crate) fn states(&self, values: &[f64]) -> Vec<State> {
        let last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let known = last.as_ref().filter(|d| self.is_same(&d.values, values));
        let known = known.cloned();
        drop(last);
        let design = known.unwrap_or_else(|| {
            let design = Arc::new(self.design(values));
            let last = Some(Arc::clone(&design));
            *self.last.lock().unwrap_or_else(PoisonError::into_inner) = last;
            design
        });
        let failed = |reason: String| State {
            is: [Words::exact(String::new()), Words::reason(reason)],
            touching: Vec::new(),
        };
        let state = |name: &String| {
            let (requirement, spaces) = match self.measured(&design, values, name) {
                Ok(found) => found,
                Err(reason) => return failed(reason),
            };
            let checked = spaces.check(&requirement);
            let value = match &checked.measured {
                Ok(measured) => match measured.value {
                    Value::Number(_) => Words::exact("a value".to_owned()),
                    Value::Truth(true) => Words::exact("yes".to_owned()),
                    Value::Truth(false) => Words::exact("no".to_owned()),
                },
                Err(error) => Words::reason(error.to_string()),
            };
            let Some(space) = spaces.of(&requirement) else {
                let mut touching: Vec<String> = (checked.touching.iter())
                    .map(|[a, b]| format!("{a} touches {b}"))
                    .collect();
                touching.sort_unstable();
                return State {
                    is: [Words::exact(String::new()), value],
                    touching,
                };
            };
            let regions = space.regions();
            let caged = regions.iter().filter(|r| !r.unbounded).count();
            let s = if regions.len() == 1 { "" } else { "s" };
            let regions = format!("{} free region{s}, {caged} caged", regions.len());
            let (fixed, moving) = (space.fixed().name(), space.moving().name());
            let mut touching: Vec<String> = (checked.touching.iter())
                .map(|[a, b]| format!("{a} of {fixed} touches {b} of {moving}"))
                .collect();
            touching.sort_unstable();
            State {
                is: [Words::exact(regions), value],
                touching,
            }
        };
        self.measures.iter().map(state).collect()
    }
}
