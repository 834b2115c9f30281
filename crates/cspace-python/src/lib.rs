//! The classes of the Python package `cspace`, under its module `cspace._rust`.
//!
//! User documentation is in `python/cspace`: this crate holds the parts that have to be fast, and those that only Rust
//! can do.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod drawing;
mod error;
mod fit;
mod model;
mod nest;
mod part;
mod picture;
mod plan;
mod questions;
mod rows;
mod space;
mod wires;
mod work;

/// The module.
#[pyo3::pymodule]
mod _rust {
    #[pymodule_export]
    use crate::fit::Fit;
    #[pymodule_export]
    use crate::model::Model;
    #[pymodule_export]
    use crate::part::Part;
    #[pymodule_export]
    use crate::space::Space;

    #[pymodule_export]
    use crate::drawing::_dxf;
    #[pymodule_export]
    use crate::nest::{_beside, _separation, _within};
    #[pymodule_export]
    use crate::picture::_svg;
    #[pymodule_export]
    use crate::questions::{_bands, _connected, _crossings, _ends, _evaluate, _measures};

    #[pymodule_export]
    use crate::wires::_of_wires;

    use pyo3::prelude::*;

    /// The version.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");

    /// The configuration space of two parts that move freely in the plane; `theta` is a window of orientations.
    #[pyfunction]
    #[pyo3(signature = (fixed, moving, theta=None))]
    fn compute(
        py: Python<'_>,
        fixed: &Part,
        moving: &Part,
        theta: Option<(f64, f64)>,
    ) -> PyResult<Space> {
        Space::computed(
            py,
            crate::space::Pair {
                fixed: fixed.part.clone(),
                moving: moving.part.clone(),
                relation: cspace::Relation::Planar,
                window: theta,
                unit: None,
            },
        )
    }

    /// Runs the command with its arguments, of which the first is its name, and returns its exit code.
    #[pyfunction]
    fn command(py: Python<'_>, arguments: Vec<std::ffi::OsString>) -> u8 {
        py.detach(|| cspace_cli::main(&arguments))
    }

    /// Raises an error that says how to get the page of the command, if this package was built without it.
    #[pyfunction]
    fn _require_page() -> PyResult<()> {
        let found = cspace_cli::view::Page::bundled();
        found.map_err(|e| crate::error::with_help(&e, e.help()))?;
        Ok(())
    }

    /// Uses so many threads from now on; 0 for one per processor. Results do not depend on it.
    #[pyfunction]
    fn set_threads(threads: usize) -> PyResult<()> {
        crate::work::set_threads(threads)
    }
}
