//! Questions to patches and their contact functions, on arrays.

use cspace::{Band, QueryError};
use numpy::{IntoPyArray, PyArray2, PyReadonlyArray1};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::error;
use crate::rows::{Asked, asked, each, each_of, matrix, numbers, one, patch_id, width};
use crate::space::Space;
use crate::work;

/// The contact function of a patch at configurations: value, gradient and Hessian by the coordinates.
#[pyfunction]
pub(crate) fn _evaluate<'py>(
    py: Python<'py>,
    space: &Space,
    patch: i64,
    q: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyDict>> {
    let space = space.shared(py)?;
    let contact = space.patch(patch_id(&space, patch)?).map_err(error)?;
    let contact = contact.contact().map_err(error)?;
    let n = width(&space);
    let told = PyDict::new(py);
    match asked(q, &space)? {
        Asked::One(at) => {
            let c = contact.evaluate(at).map_err(error)?;
            let rows: Vec<Vec<f64>> = c.hessian[..n].iter().map(|r| r[..n].to_vec()).collect();
            told.set_item("value", c.value)?;
            told.set_item("gradient", c.gradient[..n].to_vec().into_pyarray(py))?;
            told.set_item("hessian", matrix(py, rows)?)?;
            let t = contact.touching(at).map_err(error)?;
            told.set_item("at", vec![t.on_fixed.x, t.on_fixed.y].into_pyarray(py))?;
            told.set_item("normal", vec![t.normal.x, t.normal.y].into_pyarray(py))?;
        }
        Asked::Many(rows) => {
            let all = each(py, &rows, |at| {
                Ok::<_, QueryError>((contact.evaluate(at)?, contact.touching(at)?))
            })?;
            let values: Vec<f64> = all.iter().map(|c| c.0.value).collect();
            let flat = |of: &dyn Fn(usize) -> Vec<f64>| -> Vec<f64> {
                (0..all.len()).flat_map(of).collect()
            };
            let gradients = flat(&|i| all[i].0.gradient[..n].to_vec());
            let hessians = flat(&|i| {
                let rows = all[i].0.hessian[..n].iter();
                rows.flat_map(|r| r[..n].to_vec()).collect()
            });
            let places = flat(&|i| vec![all[i].1.on_fixed.x, all[i].1.on_fixed.y]);
            let normals = flat(&|i| vec![all[i].1.normal.x, all[i].1.normal.y]);
            told.set_item("value", values.into_pyarray(py))?;
            for (key, flat, shape) in [
                ("gradient", gradients, vec![all.len(), n]),
                ("hessian", hessians, vec![all.len(), n, n]),
                ("at", places, vec![all.len(), 2]),
                ("normal", normals, vec![all.len(), 2]),
            ] {
                told.set_item(
                    key,
                    flat.into_pyarray(py).call_method1("reshape", (shape,))?,
                )?;
            }
        }
    }
    Ok(told)
}

/// Where a patch begins and ends at orientations: two arrays n×2 of positions, nan where it does not exist.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "two arrays")]
pub(crate) fn _ends<'py>(
    py: Python<'py>,
    space: &Space,
    patch: i64,
    thetas: PyReadonlyArray1<'py, f64>,
) -> PyResult<(Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>)> {
    let space = space.shared(py)?;
    let patch = space.patch(patch_id(&space, patch)?).map_err(error)?;
    patch.orientations().map_err(error)?;
    let found = each_of(py, thetas.as_slice()?, 1, |row| {
        match patch.ends_at(row[0]) {
            Ok(both) => Ok(both.map(|(at, _)| numbers(at)[..2].to_vec())),
            Err(QueryError::Outside) => Ok([vec![f64::NAN; 2], vec![f64::NAN; 2]]),
            Err(e) => Err(e),
        }
    })?;
    let shaped = |end: usize| -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flat: Vec<f64> = found.iter().flat_map(|both| both[end].clone()).collect();
        let shaped = (flat.into_pyarray(py)).call_method1("reshape", (found.len(), 2))?;
        Ok(shaped.cast_into()?)
    };
    Ok((shaped(0)?, shaped(1)?))
}

/// The bands: the orientations between which nothing but lengths changes.
#[pyfunction]
pub(crate) fn _bands(py: Python<'_>, space: &Space) -> PyResult<Vec<(f64, f64)>> {
    let bands = space.shared(py)?.bands().map_err(error)?;
    Ok(bands.into_iter().map(|Band { lo, hi }| (lo, hi)).collect())
}

/// How many features the parts have, below which clearance there is none, and how near to a contact is in contact.
#[pyfunction]
pub(crate) fn _measures(py: Python<'_>, space: &Space) -> PyResult<((u32, u32), f64, f64)> {
    let space = space.shared(py)?;
    let features = space.features();
    Ok((
        (features.fixed, features.moving),
        space.least_clearance(),
        space.contact_distance(),
    ))
}

/// Whether two configurations are free and in one region; `goal` is one configuration.
#[pyfunction]
pub(crate) fn _connected<'py>(
    py: Python<'py>,
    space: &Space,
    start: &Bound<'py, PyAny>,
    goal: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyAny>> {
    let space = space.shared(py)?;
    let goal = one(goal, &space, "goal")?;
    let answer = |at| space.connected(at, goal);
    match asked(start, &space)? {
        Asked::One(at) => answer(at).map_err(error)?.into_bound_py_any(py),
        Asked::Many(rows) => Ok(each(py, &rows, answer)?.into_pyarray(py).into_any()),
    }
}

/// The contacts that a motion of constant rates from `start` by `by` comes through: for each its patch, the fraction of the displacement,
/// the configuration, and whether it goes into blocked space there.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "Python makes records of it")]
pub(crate) fn _crossings(
    py: Python<'_>,
    space: &Space,
    start: &Bound<'_, PyAny>,
    by: &Bound<'_, PyAny>,
) -> PyResult<Vec<(usize, f64, Vec<f64>, bool)>> {
    let space = space.shared(py)?;
    let (from, by) = (one(start, &space, "start")?, one(by, &space, "by")?);
    let found = work::run(py, move |_| {
        space.crossings(from, by, 1.0).map_err(|e| e.to_string())
    })?;
    let at = |t: f64| -> Vec<f64> {
        let (from, by) = (numbers(from), numbers(by));
        from.iter().zip(by).map(|(a, b)| a + t * b).collect()
    };
    Ok((found.into_iter())
        .map(|c| (c.patch.index(), c.time, at(c.time), c.enters))
        .collect())
}
