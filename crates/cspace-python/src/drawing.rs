//! Parts as drawings that other programs read.

use cspace::Configuration;
use cspace_drawing::{Drawn, DxfVersion, Unit, dxf};
use pyo3::prelude::*;

use crate::error::error;
use crate::part::Part;

/// The text of a DXF file with parts, each placed by a configuration and on a layer of its own.
#[pyfunction]
#[pyo3(signature = (placed, unit=None))]
pub(crate) fn _dxf(
    placed: Vec<(PyRef<'_, Part>, (f64, f64, f64))>,
    unit: Option<&str>,
) -> PyResult<String> {
    let of_label = |label: &str| {
        Unit::of_label(label).ok_or_else(|| {
            let known: Vec<_> = Unit::all().map(Unit::label).collect();
            error(format_args!(
                "`unit` is {label:?}: give one of {}",
                known.join(", ")
            ))
        })
    };
    let unit = unit.map(of_label).transpose()?;
    let drawn: Vec<Drawn> = (placed.iter())
        .flat_map(|(part, at)| {
            let layers = Drawn::part(&part.part).into_iter();
            layers.map(|drawn| drawn.moved(Configuration::from(*at)))
        })
        .collect();
    Ok(dxf(&drawn, unit, DxfVersion::R2000))
}
