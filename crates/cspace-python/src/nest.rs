//! Positions of a part beside others or within one, exact fits among them.

use cspace::{Configuration, NoFit, Slice, Vector, Vertex};
use cspace_drawing::Drawn;
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::error::error;
use crate::part::Part;
use crate::work;

/// Loops of (x, y, bulge).
pub(crate) type Loops = Vec<Vec<(f64, f64, f64)>>;

/// The boundary of free space, and whether it is in doubt.
pub(crate) fn loops(slice: &Slice) -> (Loops, bool) {
    let vertex = |v: Vertex| (v.x, v.y, v.bulge);
    let of_loop = |l: Vec<Vertex>| l.into_iter().map(vertex).collect();
    let loops = Drawn::slice("", slice).loops.into_iter().map(of_loop);
    (loops.collect(), slice.doubtful)
}

/// The positions at every orientation, on all threads.
fn at_each(
    py: Python<'_>,
    thetas: Vec<f64>,
    make: impl FnOnce() -> Result<NoFit, String> + Send + 'static,
) -> PyResult<Vec<(Loops, bool)>> {
    if let Some(theta) = thetas.iter().find(|t| !t.is_finite()) {
        return Err(error(format_args!(
            "`theta` is {theta}: give an orientation in radians"
        )));
    }
    work::run(py, move |progress| {
        let no_fit = make()?;
        let one = |&theta: &f64| {
            progress
                .stage(cspace::Stage::Graph)
                .map_err(|e| e.to_string())?;
            Ok(loops(&no_fit.at(theta)))
        };
        thetas.par_iter().map(one).collect()
    })
}

/// Beside parts, each placed by a configuration, for every orientation.
#[pyfunction]
pub(crate) fn _beside(
    py: Python<'_>,
    placed: Vec<(PyRef<'_, Part>, (f64, f64, f64))>,
    moving: &Part,
    thetas: Vec<f64>,
) -> PyResult<Vec<(Loops, bool)>> {
    let placed: Vec<(cspace::Part, Configuration)> = (placed.iter())
        .map(|(part, at)| (part.part.clone(), Configuration::from(*at)))
        .collect();
    let moving = moving.part.clone();
    at_each(py, thetas, move || {
        if let [(fixed, at)] = &placed[..]
            && *at == Configuration::default()
        {
            return Ok(NoFit::new(fixed, &moving));
        }
        let placed: Vec<_> = placed.iter().map(|(part, at)| (part, *at)).collect();
        NoFit::beside(&placed, &moving).map_err(|e| e.to_string())
    })
}

/// Within a part, for every orientation.
#[pyfunction]
pub(crate) fn _within(
    py: Python<'_>,
    container: &Part,
    moving: &Part,
    thetas: Vec<f64>,
) -> PyResult<Vec<(Loops, bool)>> {
    let (container, moving) = (container.part.clone(), moving.part.clone());
    at_each(py, thetas, move || Ok(NoFit::within(&container, &moving)))
}

/// The shortest translation that separates two parts.
#[pyfunction]
pub(crate) fn _separation(
    py: Python<'_>,
    fixed: &Part,
    moving: &Part,
    at: (f64, f64, f64),
) -> PyResult<(f64, f64)> {
    let (fixed, moving) = (fixed.part.clone(), moving.part.clone());
    let by = work::run(py, move |_| {
        Ok(NoFit::new(&fixed, &moving).least_separation(Configuration::from(at)))
    })?;
    // Beside a part there is always a position.
    let Vector { x, y } = by.unwrap_or(Vector::ZERO);
    Ok((x, y))
}
