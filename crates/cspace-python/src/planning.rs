//! Escapes from a pair, and mechanisms taken apart.

use std::sync::Arc;

use cspace::Vector;
use cspace_design::texts;
use cspace_model::PairEntry;
use cspace_plan::assembly::{Assembly, Enclosure, PartFeature};
use cspace_plan::escape::{Escape, Escaped, Field};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::error;
use crate::model::Model;
use crate::rows::{numbers, one};
use crate::space::{Space, matrix};
use crate::work;

/// The least energy with which the moving part leaves a place, as a dictionary; `gravity` in place of the model's.
#[pyfunction]
#[pyo3(signature = (model, pair, space, start, goal=None, gravity=None))]
pub(crate) fn _escape<'py>(
    py: Python<'py>,
    model: &Model,
    pair: (String, String),
    space: &Space,
    start: &Bound<'py, PyAny>,
    goal: Option<&Bound<'py, PyAny>>,
    gravity: Option<(f64, f64)>,
) -> PyResult<Bound<'py, PyDict>> {
    let mechanism = model.mechanism();
    let entry = PairEntry {
        fixed: model.part_index(&pair.0)?,
        moving: model.part_index(&pair.1)?,
        window: None,
    };
    let space = space.shared(py)?;
    let from = one(start, &space, "start")?;
    let to = goal.map(|g| one(g, &space, "goal")).transpose()?;
    let gravity = gravity.map_or(mechanism.dynamics.gravity, |(x, y)| Vector::new(x, y));
    let (field, weighs) = Field::of_pair(mechanism, &entry, gravity).map_err(error)?;
    let asked = Arc::clone(&space);
    let answer = work::run(py, move |progress| {
        let escape = Escape::new(&asked, &field).map_err(|e| e.to_string())?;
        (escape.from_with(from, to, progress)).map_err(|e| e.to_string())
    })?;
    let told = PyDict::new(py);
    told.set_item("unit_mass", !weighs && gravity != Vector::ZERO)?;
    told.set_item(
        "verdict",
        match answer {
            Escaped::Held(held) => {
                told.set_item("energy", held.energy)?;
                told.set_item("least", held.least)?;
                told.set_item("most", held.most)?;
                let path: Vec<Vec<f64>> = held.path.into_iter().map(numbers).collect();
                told.set_item("path", matrix(py, path)?)?;
                let of = |pass: cspace_plan::escape::Pass| {
                    let touching = pass.touching.into_iter().map(|p| texts(&space, p));
                    (numbers(pass.at), pass.energy, touching.collect::<Vec<_>>())
                };
                told.set_item(
                    "passes",
                    held.passes.into_iter().map(of).collect::<Vec<_>>(),
                )?;
                "escapes"
            }
            Escaped::Caged(enclosed) => {
                told.set_item("region", enclosed.region.index())?;
                let touching = enclosed.features.into_iter().map(|p| texts(&space, p));
                told.set_item("touching", touching.collect::<Vec<_>>())?;
                "cage"
            }
            Escaped::FromBlocked(_) => "from-blocked",
            Escaped::ToBlocked(_) => "to-blocked",
        },
    )?;
    Ok(told)
}

/// The order in which a mechanism comes apart, as a dictionary.
#[pyfunction]
#[pyo3(signature = (model, gap=None))]
pub(crate) fn _assembly<'py>(
    py: Python<'py>,
    model: &Model,
    gap: Option<f64>,
) -> PyResult<Bound<'py, PyDict>> {
    let mechanism = model.mechanism().clone();
    let (gap, apart) = work::run(py, move |progress| {
        let assembly = Assembly::new(&mechanism, gap).map_err(|e| e.to_string())?;
        let apart = assembly
            .take_apart_with(progress)
            .map_err(|e| e.to_string())?;
        Ok((assembly.gap(), apart))
    })?;
    let mechanism = model.mechanism();
    let names = |parts: &[usize]| -> Vec<String> {
        let name = |&i: &usize| mechanism.parts[i].part.name().to_owned();
        parts.iter().map(name).collect()
    };
    let feature = |f: &PartFeature| {
        let part = &mechanism.parts[f.part].part;
        format!("{} of {}", part.feature_text(f.feature), part.name())
    };
    let told = PyDict::new(py);
    told.set_item(
        "verdict",
        pythonize::pythonize(py, &apart.outcome).map_err(error)?,
    )?;
    told.set_item("gap", gap)?;
    let mut steps = Vec::new();
    for step in apart.steps {
        let path = step.path.straight().map_err(error)?;
        let path = path.into_iter().map(numbers).collect();
        let legs = (step.path.configurations.into_iter())
            .map(numbers)
            .collect();
        steps.push((
            names(&step.moving),
            names(&step.staying),
            matrix(py, path)?,
            matrix(py, legs)?,
            step.path.narrowest.clearance,
            pythonize::pythonize(py, &step.kind).map_err(error)?,
            (step.path.about.x, step.path.about.y),
        ));
    }
    told.set_item("steps", steps)?;
    let why = |e: &Enclosure| {
        let touching = e.features.iter().map(|(a, b)| [feature(a), feature(b)]);
        (
            names(&e.moving),
            names(&e.staying),
            touching.collect::<Vec<_>>(),
        )
    };
    let (parts, reasons) = match &apart.locked {
        None => (Vec::new(), Vec::new()),
        Some(locked) => (names(&locked.parts), locked.why.iter().map(why).collect()),
    };
    told.set_item("locked", parts)?;
    told.set_item("why", reasons)?;
    Ok(told)
}
