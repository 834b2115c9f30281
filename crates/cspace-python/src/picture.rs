//! Pictures of spaces, as the command draws them.

use cspace::PairSpace;
use cspace_draw::{PictureOptions, SlicesPicture, plane, slices, svg};
use pyo3::prelude::*;

use crate::space::Space;
use crate::work;

/// A slice at an orientation, or the plane of two motions, as SVG.
#[pyfunction]
pub(crate) fn _svg(py: Python<'_>, space: &Space, theta: f64) -> PyResult<String> {
    let space = space.shared(py)?;
    work::run(py, move |_| {
        let title = format!(
            "{} (fixed), {} (moving)",
            space.fixed().name(),
            space.moving().name()
        );
        let options = PictureOptions {
            title,
            ..PictureOptions::default()
        };
        match &*space {
            PairSpace::FixedAxes(space) => Ok(svg(&plane(space, &options))),
            PairSpace::Planar(space) => Ok(svg(&slices(
                &SlicesPicture {
                    space,
                    slices: &[space.slice(theta)],
                    parts: None,
                },
                &options,
            ))),
            PairSpace::Lower(_) => Err(format!("a {} pair has no picture", space.class())),
        }
    })
}
