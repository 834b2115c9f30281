//! Models: parts, how they move, parameters and requirements.

use std::fmt::Display;
use std::sync::Arc;

use cspace::{AxisMotion, Progress};
use cspace_api::subject::ModelFile;
use cspace_api::{Error, Host, Question, Subject, plan};
use cspace_model::model::{Setting, Template};
use cspace_model::{Document, Host as ReadHost, Mechanism, PairEntry};
use numpy::{PyArray2, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::{error, internal, of_model, of_values, with_help};
use crate::part::Part;
use crate::plan::{Planned, Told};
use crate::rows::poses;
use crate::space::{Pair, Space};
use crate::work;

/// A model of parts, with values for its parameters.
#[pyclass(frozen, module = "cspace._rust", name = "Model")]
pub(crate) struct Model {
    subject: Arc<Subject>,
    /// Whether its text was written for values, so that no place in it means anything.
    of_values: bool,
}

impl Model {
    fn new(template: Arc<Template>, set: Vec<Setting>, of_values: bool) -> PyResult<Self> {
        let host = ReadHost {
            set: &set,
            ..ReadHost::default()
        };
        let model = (template.model(&host)).map_err(|e| placed(of_values)(&e))?;
        let path = template.path().to_owned();
        let document = Document::Model(Box::new(model));
        let subject = Subject::of(path, document, Some(template), set);
        let subject = Arc::new(subject);
        Ok(Self { subject, of_values })
    }

    fn file(&self) -> PyResult<&ModelFile> {
        self.subject.model("it is one").map_err(error)
    }

    fn template(&self) -> PyResult<&Arc<Template>> {
        let template = self.file()?.template.as_ref();
        template.ok_or_else(|| internal("a model without its text"))
    }

    fn mechanism(&self) -> PyResult<&Mechanism> {
        Ok(&self.file()?.model.mechanism)
    }

    fn part_index(&self, name: &str) -> PyResult<usize> {
        let mechanism = self.mechanism()?;
        mechanism.part_index(name).ok_or_else(|| {
            let names: Vec<&str> = mechanism.parts.iter().map(|p| p.part.name()).collect();
            with_help(
                format_args!("there is no part named {name:?}"),
                format_args!("the parts are {}", names.join(", ")),
            )
        })
    }
}

#[pymethods]
impl Model {
    /// The model in a file: .toml or .json.
    #[staticmethod]
    fn _load(path: std::path::PathBuf) -> PyResult<Self> {
        let template = Template::read(&path, &ReadHost::default()).map_err(|e| of_model(&e))?;
        if cspace_model::saved::is_saved(template.text()) {
            let what = format_args!("{}: the file is a saved contact space", path.display());
            return Err(with_help(what, "give the model file"));
        }
        Self::new(Arc::new(template), Vec::new(), false)
    }

    /// The model in a text, TOML unless the extension of `path` is .json; errors in one that was written for values name no place in it.
    #[staticmethod]
    fn _loads(
        text: String,
        path: std::path::PathBuf,
        set: Vec<(String, String)>,
        of_values: bool,
    ) -> PyResult<Self> {
        let template = Template::from_text(text, path).map_err(|e| placed(of_values)(&e))?;
        let set = set.into_iter().map(|(name, value)| Setting { name, value });
        Self::new(Arc::new(template), set.collect(), of_values)
    }

    /// The source of the model: the text, the path, the values that are set, and whether the text was written for values.
    #[expect(clippy::type_complexity, reason = "a tuple of Python")]
    fn _source(&self) -> PyResult<(String, String, Vec<(String, String)>, bool)> {
        let (file, template) = (self.file()?, self.template()?);
        let set = file.set.iter().map(|s| (s.name.clone(), s.value.clone()));
        Ok((
            template.text().to_owned(),
            template.path().display().to_string(),
            set.collect(),
            self.of_values,
        ))
    }

    /// The model with other values of its parameters: numbers, or expressions such as "18deg".
    fn __call__(&self, parameters: &Bound<'_, PyDict>) -> PyResult<Self> {
        let mut set = self.file()?.set.clone();
        for (name, value) in parameters {
            let name: String = name.extract()?;
            let setting = if let Ok(x) = value.extract::<f64>() {
                if !x.is_finite() {
                    return Err(error(format_args!("the parameter {name} is set to {x}")));
                }
                Setting::number(name, x)
            } else {
                let Ok(value) = value.extract::<String>() else {
                    return Err(error(format_args!(
                        "the parameter {name} is set to neither a number nor an expression"
                    )));
                };
                Setting { name, value }
            };
            set.retain(|s| s.name != setting.name);
            set.push(setting);
        }
        Self::new(Arc::clone(self.template()?), set, self.of_values)
    }

    /// The name.
    #[getter]
    fn name(&self) -> PyResult<&str> {
        Ok(&self.mechanism()?.name)
    }

    /// The unit of length, if the model says one.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.subject.unit()
    }

    /// The parts by name.
    #[getter]
    fn parts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let parts = PyDict::new(py);
        for entry in &self.mechanism()?.parts {
            let part = entry.part.clone();
            parts.set_item(part.name().to_owned(), Part { part })?;
        }
        Ok(parts)
    }

    /// The values of the parameters by name; angles in radians.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for parameter in &self.file()?.model.parameters {
            all.set_item(&parameter.name, parameter.value)?;
        }
        Ok(all)
    }

    /// The pairs: names of the fixed and of the moving part.
    #[getter]
    fn pairs(&self) -> PyResult<Vec<(String, String)>> {
        let mechanism = self.mechanism()?;
        let name = |i: usize| mechanism.parts[i].part.name().to_owned();
        let of = |p: &PairEntry| (name(p.fixed), name(p.moving));
        Ok(mechanism.pairs.iter().map(of).collect())
    }

    /// The axis of a part, if it moves on one or not at all.
    fn _is_on_axis(&self, part: &str) -> PyResult<Option<bool>> {
        let axis = self.mechanism()?.parts[self.part_index(part)?].axis;
        Ok(axis.map(|axis| axis.motion != AxisMotion::Fixed))
    }

    /// Where a part on an axis is for its coordinates: rows (x, y, theta).
    fn _poses<'py>(
        &self,
        py: Python<'py>,
        part: &str,
        coordinates: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let axis = self.mechanism()?.parts[self.part_index(part)?].axis;
        let axis = axis.ok_or_else(|| internal("a part in the plane has no axis"))?;
        poses(py, coordinates.as_slice()?, |t| axis.configuration(t))
    }

    /// The names of the requirements.
    #[getter]
    fn requirements(&self) -> PyResult<Vec<String>> {
        let all = self.file()?.model.requirements.iter();
        Ok(all.map(|r| r.name.clone()).collect())
    }

    /// The configuration space of two parts, by name; of the only pair without names. `theta` is a window of orientations.
    #[pyo3(signature = (fixed=None, moving=None, theta=None))]
    fn compute(
        &self,
        py: Python<'_>,
        fixed: Option<&str>,
        moving: Option<&str>,
        theta: Option<(f64, f64)>,
    ) -> PyResult<Space> {
        let mechanism = self.mechanism()?;
        let entry = match (fixed, moving, &mechanism.pairs[..]) {
            (Some(fixed), Some(moving), pairs) => {
                let (fixed, moving) = (self.part_index(fixed)?, self.part_index(moving)?);
                if fixed == moving {
                    return Err(error("a part is paired with itself"));
                }
                let listed = pairs
                    .iter()
                    .find(|p| (p.fixed, p.moving) == (fixed, moving));
                PairEntry {
                    fixed,
                    moving,
                    window: listed.and_then(|p| p.window),
                }
            }
            (None, None, [pair]) => *pair,
            _ => {
                return Err(with_help(
                    "it is not said which pair is computed",
                    "name the fixed and the moving part: model.compute(\"plate\", \"pin\")",
                ));
            }
        };
        let part = |i: usize| mechanism.parts[i].part.clone();
        Space::computed(
            py,
            Pair {
                fixed: part(entry.fixed),
                moving: part(entry.moving),
                relation: mechanism.relation(&entry),
                window: theta.or(entry.window),
                unit: self.subject.unit().map(str::to_owned),
            },
        )
    }

    /// The answer to a question of this kind, as what the command prints as JSON.
    fn _ask<'py>(
        &self,
        py: Python<'py>,
        kind: &str,
        arguments: &Bound<'py, PyDict>,
    ) -> PyResult<Bound<'py, PyAny>> {
        arguments.set_item("question", kind)?;
        let question: Question = pythonize::depythonize(arguments.as_any())
            .map_err(|e| error(format_args!("{kind}: {e}")))?;
        let (subject, said) = (Arc::clone(&self.subject), said(self.of_values));
        let answer = work::run(py, move |progress| {
            question.ask(&subject, &Asking { progress }).map_err(said)
        })?;
        pythonize::pythonize(py, &answer).map_err(error)
    }

    /// The answer to the question for a path of a pair, and the rows of the path.
    fn _plan<'py>(&self, py: Python<'py>, arguments: &Bound<'py, PyDict>) -> PyResult<Told<'py>> {
        let question: plan::Question = pythonize::depythonize(arguments.as_any())
            .map_err(|e| error(format_args!("plan: {e}")))?;
        let (subject, said) = (Arc::clone(&self.subject), said(self.of_values));
        let planned = work::run(py, move |progress| {
            let host = Asking { progress };
            let pair = subject.one_pair(&question.which, &host).map_err(said)?;
            Planned::new(question.ask(&[pair]).map_err(said)?)
        })?;
        planned.told(py)
    }

    fn __repr__(&self) -> PyResult<String> {
        let ModelFile { model, .. } = self.file()?;
        let mechanism = &model.mechanism;
        let names: Vec<&str> = mechanism.parts.iter().map(|p| p.part.name()).collect();
        let values: Vec<String> = (model.parameters.iter())
            .map(|p| format!("{}={}", p.name, cspace_model::shown::number(p.value)))
            .collect();
        let and = if values.is_empty() { "" } else { "; " };
        Ok(format!(
            "Model({:?}: {}{and}{})",
            mechanism.name,
            names.join(", "),
            values.join(", ")
        ))
    }
}

/// How errors of a model are told.
fn placed(no_text: bool) -> fn(&cspace_model::ModelError) -> PyErr {
    match no_text {
        true => of_values,
        false => of_model,
    }
}

/// Python as the one that asks.
struct Asking<'a> {
    progress: &'a dyn Progress,
}

impl Host for Asking<'_> {
    fn begin(&self, _: &str) -> Box<dyn Progress + '_> {
        Box::new(self.progress)
    }

    fn note(&self, _: &dyn Display) {}

    fn warn(&self, _: &Error) {}

    fn option(&self, name: &str) -> String {
        // The methods call some of them otherwise.
        let name = match name {
            "from" => "start",
            "to" => "goal",
            "so-that" => "value",
            "measure" => "measures",
            "requirement" => "requirements",
            other => other,
        };
        format!("`{name}`")
    }
}

/// How errors of questions are told, with their advice; of a model that no text was written for without a place in it.
fn said(of_values: bool) -> fn(Error) -> String {
    fn with_advice(error: Error) -> String {
        match &error.help {
            Some(help) => format!("{error}\nhelp: {help}"),
            None => error.to_string(),
        }
    }
    fn without_place(mut error: Error) -> String {
        let place = match (&error.file, error.line.zip(error.column)) {
            (Some(file), Some((line, column))) => format!("{file}:{line}:{column}: "),
            (Some(file), None) => format!("{file}: "),
            (None, _) => String::new(),
        };
        if let Some(message) = error.message.strip_prefix(&place) {
            error.message = message.to_owned();
        }
        with_advice(error)
    }
    if of_values {
        without_place
    } else {
        with_advice
    }
}
