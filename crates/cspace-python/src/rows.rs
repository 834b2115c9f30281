//! Configurations as rows of numbers.

use core::f64::consts::TAU;
use std::fmt::Display;
use std::time::{Duration, Instant};

use cspace::{Configuration, Coordinates, PairSpace, PatchId};
use numpy::{PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
use rayon::prelude::*;

use crate::error::error;
use crate::work::{self, Listener};

/// Rows of the first block, after which it is asked whether the user has pressed Ctrl-C. Blocks grow while they take less than this.
const BLOCK: usize = 1 << 6;
const LISTEN: Duration = Duration::from_millis(50);

/// A thread answers rows for at least so long before it looks for more: to hand rows to threads takes some microseconds.
const TASK: Duration = Duration::from_micros(200);

/// Orientations beyond this may be meant in degrees, which `cspace._arrays` says.
const FAR: f64 = 2.0 * TAU;

/// One configuration, or many.
pub(crate) enum Asked<'py> {
    One(Coordinates),
    Many(PyReadonlyArray2<'py, f64>),
}

impl Asked<'_> {
    /// The numbers of all configurations.
    pub(crate) fn numbers(&self) -> PyResult<Vec<f64>> {
        match self {
            Self::One(at) => Ok(numbers(*at)),
            Self::Many(rows) => Ok(rows.as_slice()?.to_vec()),
        }
    }
}

/// How many coordinates a configuration of a space has.
pub(crate) fn width(space: &PairSpace) -> usize {
    match space {
        PairSpace::FixedAxes(_) => 2,
        _ => 3,
    }
}

/// The patch of a number.
pub(crate) fn patch_id(space: &PairSpace, patch: i64) -> PyResult<PatchId> {
    let count = space.patch_count();
    let id = u32::try_from(patch).ok().map(PatchId);
    id.filter(|id| id.index() < count).ok_or_else(|| {
        error(format_args!(
            "there is no patch {patch}: they are numbered from 0, and there are {count}"
        ))
    })
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

/// The answers to all rows of configurations: see [`each_of`].
pub(crate) fn each<T: Send, E: Display + Send>(
    py: Python<'_>,
    array: &PyReadonlyArray2<'_, f64>,
    answer: impl Fn(Coordinates) -> Result<T, E> + Sync + Send,
) -> PyResult<Vec<T>> {
    let (numbers, width) = (array.as_slice()?, array.shape()[1]);
    each_of(py, numbers, width, |row| answer(coordinates(row)))
}

/// The answers to all rows of so many numbers, in their order, on all threads if they are many; between blocks Ctrl-C is heard, and the
/// share that is done is told.
pub(crate) fn each_of<T: Send, E: Display + Send>(
    py: Python<'_>,
    numbers: &[f64],
    width: usize,
    answer: impl Fn(&[f64]) -> Result<T, E> + Sync + Send,
) -> PyResult<Vec<T>> {
    let (pool, listener, begin) = (work::pool()?, Listener::of(py)?, Instant::now());
    let count = numbers.len() / width;
    let mut all = Vec::with_capacity(count);
    // The first block is answered here, which tells how long a row takes.
    let (mut rest, mut rows, mut task) = (numbers, BLOCK, BLOCK);
    while !rest.is_empty() {
        let began = Instant::now();
        let block;
        (block, rest) = rest.split_at(rest.len().min(rows * width));
        let first = all.len();
        let one = |(i, row): (usize, &[f64])| answer(row).map_err(|e| (first + i, e));
        let found: Result<Vec<T>, (usize, E)> = work::here(py, || {
            Ok(if block.len() <= task * width {
                block.chunks_exact(width).enumerate().map(one).collect()
            } else {
                pool.install(|| {
                    (block.par_chunks_exact(width).enumerate())
                        .with_min_len(task)
                        .map(one)
                        .collect()
                })
            })
        })?;
        all.extend(found.map_err(|(i, e)| error(format_args!("row {i}: {e}")))?);
        py.check_signals()?;
        let done = all.len() as f64 / count as f64;
        listener.tell(py, ("rows", begin.elapsed().as_secs_f64(), Some(done)))?;
        let took = began.elapsed();
        let alike = TASK.as_secs_f64() / took.as_secs_f64() * (all.len() - first) as f64;
        task = (alike as usize).max(1);
        rows = match took < LISTEN {
            true => 2 * rows,
            false => (rows / 2).max(1),
        };
    }
    Ok(all)
}

/// Poses (x, y, theta) as rows.
pub(crate) fn poses<'py, T: Copy>(
    py: Python<'py>,
    of: &[T],
    pose: impl Fn(T) -> Configuration,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let rows = of
        .iter()
        .map(|&one| numbers(Coordinates::Planar(pose(one))));
    matrix(py, rows.collect())
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
