//! Errors, as Python's.

use pyo3::prelude::*;
use pyo3::types::PyType;

/// A class of the module in which Python defines them, so that they can be sent between processes.
fn class<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyType>> {
    Ok(py.import("cspace._errors")?.getattr(name)?.cast_into()?)
}

fn made(name: &str, message: String) -> PyErr {
    Python::attach(|py| match class(py, name) {
        Ok(class) => PyErr::from_type(class, (message,)),
        Err(error) => error,
    })
}

/// A `cspace.Error`: what is wrong with what was given, or cannot be computed.
pub(crate) fn error(message: impl ToString) -> PyErr {
    made("Error", message.to_string())
}

/// A `cspace.Error` with advice.
pub(crate) fn with_help(message: impl core::fmt::Display, help: impl core::fmt::Display) -> PyErr {
    error(format_args!("{message}\nhelp: {help}"))
}

/// A `cspace.InternalError`: the library is wrong.
pub(crate) fn internal(message: impl core::fmt::Display) -> PyErr {
    made(
        "InternalError",
        format!("a fault of the library: {message}"),
    )
}

/// An error of a model, with its place.
pub(crate) fn of_model(error: &cspace_model::ModelError) -> PyErr {
    match error.help() {
        Some(help) => with_help(error, help),
        None => self::error(error),
    }
}

/// An error of a model that no text was written for: where in the model, without file, line and column.
pub(crate) fn of_values(error: &cspace_model::ModelError) -> PyErr {
    let place = error.place();
    let colon = if place.is_empty() { "" } else { ": " };
    let message = format!("{place}{colon}{}", error.message());
    match error.help() {
        Some(help) => with_help(message, help),
        None => self::error(message),
    }
}
