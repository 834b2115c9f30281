//! Models: parts, how they move, parameters and requirements.

use std::sync::Arc;
use std::time::Instant;

use cspace_api::modes::OperatingModes;
use cspace_design::{Checked, Goal, Relation, Span, Value};
use cspace_model::model::{Setting, Template};
use cspace_model::{Host, Mechanism, PairEntry};
use cspace_motion::{Report, Settings, Simulation};
use cspace_plan::modes::Modes;
use numpy::{IntoPyArray, PyArray2};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::error::{error, of_model, with_help};
use crate::part::Part;
use crate::space::{Pair, Space};
use crate::work;

/// A model of parts, with values for its parameters.
#[pyclass(frozen, module = "cspace._rust", name = "Model")]
pub(crate) struct Model {
    template: Arc<Template>,
    set: Vec<Setting>,
    model: Arc<cspace_model::Model>,
}

impl Model {
    fn new(template: Arc<Template>, set: Vec<Setting>) -> PyResult<Self> {
        let host = Host {
            set: &set,
            ..Host::default()
        };
        let model = template.model(&host).map_err(|e| of_model(&e))?;
        Ok(Self {
            template,
            set,
            model: Arc::new(model),
        })
    }

    pub(crate) fn mechanism(&self) -> &Mechanism {
        &self.model.mechanism
    }

    pub(crate) fn part_index(&self, name: &str) -> PyResult<usize> {
        let mechanism = &self.model.mechanism;
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
        let template = Template::read(&path, &Host::default()).map_err(|e| of_model(&e))?;
        Self::new(Arc::new(template), Vec::new())
    }

    /// The model in a text, TOML unless the extension of `path` is .json.
    #[staticmethod]
    fn _loads(
        text: String,
        path: std::path::PathBuf,
        set: Vec<(String, String)>,
    ) -> PyResult<Self> {
        let template = Template::from_text(text, path).map_err(|e| of_model(&e))?;
        let set = set.into_iter().map(|(name, value)| Setting { name, value });
        Self::new(Arc::new(template), set.collect())
    }

    /// The source of the model: the text, the path, and the values that are set.
    fn _source(&self) -> (String, String, Vec<(String, String)>) {
        let set = self.set.iter().map(|s| (s.name.clone(), s.value.clone()));
        (
            self.template.text().to_owned(),
            self.template.path().display().to_string(),
            set.collect(),
        )
    }

    /// The model with other values of its parameters: numbers, or expressions such as "18deg".
    #[pyo3(signature = (**parameters))]
    fn __call__(&self, parameters: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let mut set = self.set.clone();
        for (name, value) in parameters.into_iter().flatten() {
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
        Self::new(Arc::clone(&self.template), set)
    }

    /// The name.
    #[getter]
    fn name(&self) -> &str {
        &self.model.mechanism.name
    }

    /// The unit of length, if the model says one.
    #[getter]
    fn unit(&self) -> Option<&str> {
        self.model.mechanism.unit.as_deref()
    }

    /// The parts by name.
    #[getter]
    fn parts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let parts = PyDict::new(py);
        for entry in &self.model.mechanism.parts {
            let part = entry.part.clone();
            parts.set_item(part.name().to_owned(), Part { part })?;
        }
        Ok(parts)
    }

    /// The values of the parameters by name; angles in radians.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for parameter in &self.model.parameters {
            all.set_item(&parameter.name, parameter.value)?;
        }
        Ok(all)
    }

    /// The pairs: names of the fixed and of the moving part.
    #[getter]
    fn pairs(&self) -> Vec<(String, String)> {
        let mechanism = &self.model.mechanism;
        let name = |i: usize| mechanism.parts[i].part.name().to_owned();
        let of = |p: &PairEntry| (name(p.fixed), name(p.moving));
        mechanism.pairs.iter().map(of).collect()
    }

    /// The names of the requirements.
    #[getter]
    fn requirements(&self) -> Vec<String> {
        let all = self.model.requirements.iter();
        all.map(|r| r.name.clone()).collect()
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
        let mechanism = &self.model.mechanism;
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
            },
        )
    }

    /// All requirements, measured, as dictionaries.
    #[pyo3(signature = (sensitivities=false))]
    fn _check<'py>(&self, py: Python<'py>, sensitivities: bool) -> PyResult<Bound<'py, PyList>> {
        let (template, model, set) = (
            Arc::clone(&self.template),
            Arc::clone(&self.model),
            self.set.clone(),
        );
        let found = work::run(py, move |progress| {
            if !sensitivities {
                let found = cspace_design::check_with(&model, progress);
                let found = found.map_err(|e| e.to_string())?;
                return Ok(found.into_iter().map(|c| (c, Vec::new())).collect());
            }
            let host = Host {
                set: &set,
                ..Host::default()
            };
            (cspace_design::sensitivities(&template, &host, &model, progress))
                .map_err(|e| e.to_string())
        })?;
        let all = PyList::empty(py);
        for (checked, by) in &found {
            let told = self.told(py, checked)?;
            let slopes = PyDict::new(py);
            for s in by {
                if let Ok(sides) = s.derivative {
                    slopes.set_item(&s.parameter, sides)?;
                }
            }
            told.set_item("sensitivities", slopes)?;
            all.append(told)?;
        }
        Ok(all)
    }

    /// Effects of tolerances on the requirements of some names, or on all, as the command prints them in JSON.
    fn _tolerances<'py>(
        &self,
        py: Python<'py>,
        requirements: Vec<String>,
        samples: u64,
        seed: u64,
    ) -> PyResult<Bound<'py, PyAny>> {
        let template = Arc::clone(&self.template);
        let model = cspace_model::Model::clone(&self.model);
        let (set, model) = (template.about_middles(&self.set, model)).map_err(error)?;
        let options = cspace_design::ToleranceOptions {
            samples,
            seed,
            requirements,
            ..cspace_design::ToleranceOptions::default()
        };
        let variations = cspace_design::Variations::of(&model);
        if variations.is_empty() {
            return Err(error(
                "no parameter has a tolerance: give one in [parameter], such as pin = { value = 6.0, tol = 0.02 }",
            ));
        }
        let found = work::run(py, move |progress| {
            cspace_design::tolerances(&template, &set, &model, &options, progress)
                .map_err(|e| e.to_string())
        })?;
        let answer = cspace_api::tolerances::effects(&variations, &found);
        pythonize::pythonize(py, &answer).map_err(error)
    }

    /// The operating modes of three parts, or of those that move on axes, and where a configuration of them is: what the command prints as JSON.
    fn _modes<'py>(
        &self,
        py: Python<'py>,
        parts: Option<[String; 3]>,
        at: [f64; 3],
    ) -> PyResult<Bound<'py, PyAny>> {
        let mechanism = self.mechanism();
        let parts = match parts {
            None => cspace_plan::modes::moving_parts(mechanism).map_err(error)?,
            Some([a, b, c]) => [
                self.part_index(&a)?,
                self.part_index(&b)?,
                self.part_index(&c)?,
            ],
        };
        let begin = Instant::now();
        let model = Arc::clone(&self.model);
        let (modes, place) = work::run(py, move |_| {
            let modes = Modes::compute(&model.mechanism, parts).map_err(|e| e.to_string())?;
            let place = modes.locate(at).map_err(|e| e.to_string())?;
            Ok((modes, place))
        })?;
        let seconds = begin.elapsed().as_secs_f64();
        let answer = OperatingModes::of(mechanism, modes, (at, place), seconds);
        // Lists of a known length are lists, too.
        let answer = serde_json::to_value(answer).map_err(error)?;
        pythonize::pythonize(py, &answer).map_err(error)
    }

    /// The requirements named in `measures` for every row of values of the parameters or coordinates in `names`: for each row and measure a
    /// value, or text with the reason why there is none.
    fn _sweep<'py>(
        &self,
        py: Python<'py>,
        names: Vec<String>,
        rows: Vec<Vec<f64>>,
        measures: Vec<String>,
    ) -> PyResult<Vec<Vec<Bound<'py, PyAny>>>> {
        let mut varied = Vec::new();
        for name in &names {
            let Some(of) = cspace_design::Varied::named(name, &self.model) else {
                return Err(error(format_args!(
                    "there is no parameter or coordinate {name:?}"
                )));
            };
            varied.push(of);
        }
        if let Some(unknown) =
            (measures.iter()).find(|m| self.model.requirements.iter().all(|r| r.name != **m))
        {
            return Err(error(format_args!("there is no requirement {unknown:?}")));
        }
        for (name, of) in names.iter().zip(&varied) {
            if !of.is_of(&measures, &self.model) {
                return Err(error(format_args!(
                    "nothing is measured at a configuration with the coordinate {name}"
                )));
            }
        }
        if rows.iter().flatten().any(|x| !x.is_finite()) {
            return Err(error("a value that is varied is not finite"));
        }
        let (template, set) = (Arc::clone(&self.template), self.set.clone());
        let found = work::run(py, move |progress| {
            /// Rows between which it is asked whether to go on.
            const TOGETHER: usize = 32;
            let sweep = cspace_design::Sweep::new(&template, &set, &varied, &measures);
            let mut done = Vec::with_capacity(rows.len());
            for some in rows.chunks(TOGETHER) {
                progress
                    .stage(cspace::Stage::Graph)
                    .map_err(|e| e.to_string())?;
                done.extend(sweep.rows(some));
            }
            Ok(done)
        })?;
        let told = |m: Result<Value, String>| match m {
            Ok(Value::Number(x)) => x.into_bound_py_any(py),
            Ok(Value::Truth(b)) => b.into_bound_py_any(py),
            Err(reason) => reason.into_bound_py_any(py),
        };
        let row = |row: cspace_design::Row| row.measured.into_iter().map(told).collect();
        found.into_iter().map(row).collect()
    }

    /// Values of parameters, each from `lo` to `hi`, at which a requirement is `=`, `<=` or `>=` a value.
    fn _solve<'py>(
        &self,
        py: Python<'py>,
        vary: Vec<(String, f64, f64)>,
        requirement: String,
        relation: &str,
        value: &Bound<'py, PyAny>,
        samples: usize,
    ) -> PyResult<Bound<'py, PyDict>> {
        let value = match value.extract::<bool>() {
            Ok(b) => Value::Truth(b),
            Err(_) => Value::Number(value.extract()?),
        };
        let goal = Goal {
            requirement,
            relation: match relation {
                "=" | "==" => Relation::Equal,
                "<=" => Relation::AtMost,
                ">=" => Relation::AtLeast,
                other => return Err(error(format_args!("{other:?} is not =, <= or >="))),
            },
            value,
        };
        let spans: Vec<Span> = (vary.into_iter())
            .map(|(parameter, lo, hi)| Span { parameter, lo, hi })
            .collect();
        let (template, set) = (Arc::clone(&self.template), self.set.clone());
        let names: Vec<String> = spans.iter().map(|s| s.parameter.clone()).collect();
        let found = work::run(py, move |progress| {
            Ok(cspace_design::solve(
                &template, &set, &spans, &goal, samples, progress,
            ))
        })?;
        let told = PyDict::new(py);
        let solutions = PyList::empty(py);
        for values in &found.solutions {
            let one = PyDict::new(py);
            for (name, x) in names.iter().zip(values) {
                one.set_item(name, x)?;
            }
            solutions.append(one)?;
        }
        told.set_item("solutions", solutions)?;
        told.set_item("ranges", found.ranges)?;
        told.set_item("undecided", found.undecided)?;
        told.set_item("none", found.none)?;
        Ok(told)
    }

    /// The motion of the mechanism: times, coordinates and rates as arrays, and what happens, as a dictionary.
    #[pyo3(signature = (time, every=None))]
    fn _simulate<'py>(
        &self,
        py: Python<'py>,
        time: f64,
        every: Option<f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let model = Arc::clone(&self.model);
        let (record, report, columns, gaps) = work::run(py, move |progress| {
            let simulation = Simulation::new_with(&model.mechanism, progress);
            let simulation = simulation.map_err(|e| e.to_string())?;
            let settings = Settings { time, every };
            let record = simulation.follow_with(&settings, progress);
            let record = record.map_err(|e| e.to_string())?;
            let system = simulation.system();
            let report = Report::of(&simulation, &record);
            let columns: Vec<(String, core::ops::Range<usize>)> =
                (model.mechanism.parts.iter().zip(system.parts()))
                    .map(|(entry, part)| (entry.part.name().to_owned(), part.indices()))
                    .filter(|(_, indices)| !indices.is_empty())
                    .collect();
            Ok((record, report, columns, simulation.gaps().to_vec()))
        })?;
        let told = PyDict::new(py);
        let times: Vec<f64> = record.samples.iter().map(|s| s.t).collect();
        told.set_item("t", times.into_pyarray(py))?;
        for (key, rates) in [("coordinates", false), ("rates", true)] {
            let parts = PyDict::new(py);
            for (name, indices) in &columns {
                let of = |s: &cspace_motion::Sample| {
                    let all = if rates { &s.rates } else { &s.coordinates };
                    all[indices.clone()].to_vec()
                };
                let rows: Vec<Vec<f64>> = record.samples.iter().map(of).collect();
                if indices.len() == 1 {
                    parts.set_item(name, rows.concat().into_pyarray(py))?;
                } else {
                    parts.set_item(name, PyArray2::from_vec2(py, &rows).map_err(error)?)?;
                }
            }
            told.set_item(key, parts)?;
        }
        told.set_item(
            "status",
            pythonize::pythonize(py, &record.status).map_err(error)?,
        )?;
        told.set_item("until", record.until)?;
        told.set_item("reason", record.reason)?;
        told.set_item(
            "events",
            pythonize::pythonize(py, &record.events).map_err(error)?,
        )?;
        told.set_item(
            "contacts",
            pythonize::pythonize(py, &report.contacts).map_err(error)?,
        )?;
        told.set_item("gaps", pythonize::pythonize(py, &gaps).map_err(error)?)?;
        told.set_item("period", report.cycle.as_ref().map(|c| c.period))?;
        told.set_item("summary", report.summary)?;
        Ok(told)
    }

    fn __repr__(&self) -> String {
        let mechanism = &self.model.mechanism;
        let names: Vec<&str> = mechanism.parts.iter().map(|p| p.part.name()).collect();
        let values: Vec<String> = (self.model.parameters.iter())
            .map(|p| format!("{}={}", p.name, cspace_model::shown::number(p.value)))
            .collect();
        let and = if values.is_empty() { "" } else { "; " };
        format!(
            "Model({:?}: {}{and}{})",
            mechanism.name,
            names.join(", "),
            values.join(", ")
        )
    }
}

impl Model {
    fn told<'py>(&self, py: Python<'py>, checked: &Checked) -> PyResult<Bound<'py, PyDict>> {
        let told = PyDict::new(py);
        told.set_item("name", &checked.requirement.name)?;
        told.set_item("measure", checked.requirement.subject.name())?;
        let measured = checked.measured.as_ref();
        told.set_item(
            "value",
            match measured.map(|m| m.value) {
                Ok(Value::Number(x)) => x.into_bound_py_any(py)?,
                Ok(Value::Truth(b)) => b.into_bound_py_any(py)?,
                Err(_) => py.None().into_bound(py),
            },
        )?;
        told.set_item(
            "limits",
            (checked.requirement.limits()).map(|[lo, hi]| (lo, hi)),
        )?;
        told.set_item("met", checked.is_met())?;
        told.set_item("undecided", checked.is_undecided())?;
        told.set_item("margin", checked.margin())?;
        told.set_item("range", measured.ok().and_then(|m| m.range))?;
        told.set_item("touching", &checked.touching)?;
        told.set_item("failure", measured.err().map(ToString::to_string))?;
        Ok(told)
    }
}
