//! Configurations as rows of numbers.

use core::f64::consts::TAU;
use std::time::{Duration, Instant};

use cspace::{Configuration, Coordinates, PairSpace, QueryError};
use numpy::{PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
use rayon::prelude::*;

use crate::error::error;
use crate::work;

/// Rows that one thread asks about in a row.
const TOGETHER: usize = 4096;

/// Rows of the first block, after which it is asked whether the user has pressed Ctrl-C. Blocks grow while they take less than this.
const BLOCK: usize = 1 << 12;
const LISTEN: Duration = Duration::from_millis(50);
/// Orientations beyond this may be meant in degrees, which `cspace._arrays` says.
const FAR: f64 = 2.0 * TAU;

/// One configuration, or many.
pub(crate) enum Asked<'py> {
    One(Coordinates),
    Many(PyReadonlyArray2<'py, f64>),
}

/// How many coordinates a configuration of a space has.
pub(crate) fn width(space: &PairSpace) -> usize {
    match space {
        PairSpace::FixedAxes(_) => 2,
        _ => 3,
    }
}

/// The configuration in a row.
pub(crate) fn coordinates(row: &[f64]) -> Coordinates {
    match *row {
        [u, v] => Coordinates::Axes { u, v },
        [x, y, theta] => Coordinates::Planar(Configuration::new(x, y, theta)),
        _ => Coordinates::Planar(Configuration::new(f64::NAN, f64::NAN, f64::NAN)),
    }
}

/// The numbers of a configuration.
pub(crate) fn numbers(at: Coordinates) -> Vec<f64> {
    match at {
        Coordinates::Axes { u, v } => vec![u, v],
        Coordinates::Planar(c) => vec![c.x, c.y, c.theta],
    }
}

/// Three or two numbers in a list or a tuple, the quick way.
fn listed(q: &Bound<'_, PyAny>, width: usize) -> Option<Coordinates> {
    let mut row = [0.0_f64; 3];
    let row = &mut row[..width];
    if let Ok(tuple) = q.cast::<PyTuple>() {
        if tuple.len() != width {
            return None;
        }
        for (x, item) in row.iter_mut().zip(tuple.iter_borrowed()) {
            *x = item.extract().ok()?;
        }
    } else {
        let list = q.cast::<PyList>().ok()?;
        if list.len() != width {
            return None;
        }
        for (x, item) in row.iter_mut().zip(list.iter()) {
            *x = item.extract().ok()?;
        }
    }
    (width < 3 || row[2].abs() <= FAR).then(|| coordinates(row))
}

/// Configurations given by a caller: one, or rows of them.
pub(crate) fn asked<'py>(q: &Bound<'py, PyAny>, space: &PairSpace) -> PyResult<Asked<'py>> {
    let width = width(space);
    if let Some(one) = listed(q, width) {
        return Ok(Asked::One(one));
    }
    let names = match width {
        2 => "u, v",
        _ => "x, y, theta",
    };
    // Anything that numpy can make an array of; a float64 array as it is.
    let rows = (q.py().import("cspace._arrays")?).call_method1("rows", (q, width, names))?;
    let array: PyReadonlyArray2<'py, f64> = rows.get_item(0)?.extract()?;
    if rows.get_item(1)?.extract()? {
        return Ok(Asked::One(coordinates(array.as_slice()?)));
    }
    Ok(Asked::Many(array))
}

/// One configuration, and nothing else.
pub(crate) fn one(q: &Bound<'_, PyAny>, space: &PairSpace, name: &str) -> PyResult<Coordinates> {
    match asked(q, space)? {
        Asked::One(at) => Ok(at),
        Asked::Many(_) => Err(error(format_args!(
            "`{name}` is several configurations where one is expected"
        ))),
    }
}

/// The answers to all rows, in their order, on all threads if they are many; Ctrl-C is heard between blocks.
pub(crate) fn each<T: Send>(
    py: Python<'_>,
    array: &PyReadonlyArray2<'_, f64>,
    answer: impl Fn(Coordinates) -> Result<T, QueryError> + Sync + Send,
) -> PyResult<Vec<T>> {
    let width = array.shape()[1];
    let numbers = array.as_slice()?;
    let pool = work::pool()?;
    let mut all = Vec::with_capacity(numbers.len() / width);
    let (mut rest, mut rows) = (numbers, BLOCK);
    while !rest.is_empty() {
        let begin = Instant::now();
        let block;
        (block, rest) = rest.split_at(rest.len().min(rows * width));
        let first = all.len();
        let one = |(i, row): (usize, &[f64])| answer(coordinates(row)).map_err(|e| (first + i, e));
        let found: Result<Vec<T>, (usize, QueryError)> = work::here(py, || {
            Ok(if block.len() <= TOGETHER * width {
                block.chunks_exact(width).enumerate().map(one).collect()
            } else {
                pool.install(|| {
                    (block.par_chunks_exact(width).enumerate())
                        .with_min_len(TOGETHER)
                        .map(one)
                        .collect()
                })
            })
        })?;
        all.extend(found.map_err(|(i, e)| error(format_args!("row {i}: {e}")))?);
        py.check_signals()?;
        rows = match begin.elapsed() < LISTEN {
            true => 2 * rows,
            false => (rows / 2).max(1),
        };
    }
    Ok(all)
}

/// Rows as an array; rows of no array have three columns.
pub(crate) fn matrix<'py, T: numpy::Element>(
    py: Python<'py>,
    rows: Vec<Vec<T>>,
) -> PyResult<Bound<'py, PyArray2<T>>> {
    if rows.is_empty() {
        let zero = PyArray2::zeros(py, [0, 3], false);
        return Ok(zero);
    }
    PyArray2::from_vec2(py, &rows).map_err(error)
}
