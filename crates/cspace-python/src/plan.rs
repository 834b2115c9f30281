//! Answers to the question for a path, with its rows.

use cspace::Coordinates;
use cspace_api::plan::Plan;
use cspace_api::{Answer, Pairs};
use cspace_plan::straight;
use numpy::PyArray2;
use pyo3::prelude::*;

use crate::error::error;
use crate::rows::{matrix, numbers};

/// The answer about one pair, and the path in rows that are free as they stand.
pub(crate) struct Planned {
    answer: Answer<Pairs<Plan>>,
    rows: Vec<Coordinates>,
}

/// The answer as what the command prints as JSON, and the rows, where there is a path.
pub(crate) type Told<'py> = (Bound<'py, PyAny>, Option<Bound<'py, PyArray2<f64>>>);

impl Planned {
    /// An answer about one pair, with its rows.
    pub(crate) fn new(answer: Answer<Pairs<Plan>>) -> Result<Self, String> {
        let plan = answer.content.pairs.first().map(|pair| &pair.content);
        let rows = match plan.and_then(|plan| Some((plan.scene.as_ref()?, &plan.path))) {
            Some((scene, path)) => straight(scene, path).map_err(|e| e.to_string())?,
            None => Vec::new(),
        };
        Ok(Self { answer, rows })
    }

    /// The answer and its rows, as Python reads them.
    pub(crate) fn told(self, py: Python<'_>) -> PyResult<Told<'_>> {
        let answer = pythonize::pythonize(py, &self.answer).map_err(error)?;
        let rows: Vec<Vec<f64>> = self.rows.into_iter().map(numbers).collect();
        let rows = match rows.is_empty() {
            true => None,
            false => Some(matrix(py, rows)?),
        };
        Ok((answer, rows))
    }
}
