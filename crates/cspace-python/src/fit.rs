//! Where a part goes in a container among placed parts.

use std::sync::Arc;

use cspace::{Configuration, FeatureName, Point, Vector};
use cspace_plan::nest::{Nest, Orientations, Owner, Place};
use pyo3::prelude::*;

use crate::part::{Part, Told as ToldFeature, told};
use crate::space::Space;
use crate::work;

/// A configuration, what touches (the number of a placed part, or none of the container; features of it and of the part), and a length.
type Told = (
    (f64, f64, f64),
    Vec<(Option<usize>, ToldFeature, ToldFeature)>,
    f64,
);

/// A part, and what it is to be placed among.
#[pyclass(frozen, module = "cspace._rust")]
pub(crate) struct Fit {
    nest: Arc<Nest>,
    container: cspace::Part,
    placed: Vec<cspace::Part>,
    /// The centroid of the part without spacing.
    centroid: Point,
}

#[pymethods]
impl Fit {
    /// The part `moving` is `part`, or that grown by a spacing.
    #[staticmethod]
    #[pyo3(signature = (container, placed, part, moving, window, orientations))]
    fn _of(
        py: Python<'_>,
        container: &Part,
        placed: Vec<(PyRef<'_, Part>, (f64, f64, f64))>,
        part: &Part,
        moving: &Part,
        window: Option<(f64, f64)>,
        orientations: Option<Vec<f64>>,
    ) -> PyResult<Self> {
        let allowed = match (orientations, window) {
            (Some(these), _) => Orientations::These(these),
            (None, Some((lo, hi))) => Orientations::Window(lo, hi),
            (None, None) => Orientations::All,
        };
        let container = container.part.clone();
        let (placed, at): (Vec<cspace::Part>, Vec<Configuration>) = (placed.iter())
            .map(|(part, at)| (part.part.clone(), Configuration::from(*at)))
            .unzip();
        let (outer, others, moving) = (container.clone(), placed.clone(), moving.part.clone());
        let nest = work::run(py, move |progress| {
            let placed: Vec<_> = others.iter().zip(at).collect();
            Nest::new(&outer, &placed, &moving, allowed, progress).map_err(|e| e.to_string())
        })?;
        Ok(Self {
            nest: Arc::new(nest),
            container,
            placed,
            centroid: part.part.moments().centroid,
        })
    }

    /// The space of the walls and the part; none of single orientations.
    fn space(&self) -> Option<Space> {
        (self.nest.space()).map(|space| Space::of(Arc::clone(space), None))
    }

    /// Whether the part fits somewhere.
    fn fits(&self, py: Python<'_>) -> PyResult<bool> {
        let nest = Arc::clone(&self.nest);
        work::run(py, move |_| Ok(nest.fits()))
    }

    /// The place at which a point of the part is farthest in a direction: the centroid without one.
    #[pyo3(signature = (direction, about=None))]
    fn lowest(
        &self,
        py: Python<'_>,
        direction: (f64, f64),
        about: Option<(f64, f64)>,
    ) -> PyResult<Option<Told>> {
        let direction = Vector::new(direction.0, direction.1);
        let about = about.map_or(self.centroid, |(x, y)| Point::new(x, y));
        let nest = Arc::clone(&self.nest);
        let place = work::run(py, move |_| Ok(nest.lowest(direction, about)))?;
        Ok(place.map(|p| self.told(p)))
    }

    /// The place at which most of the outline lies flush.
    fn tightest(&self, py: Python<'_>) -> PyResult<Option<Told>> {
        let (nest, about) = (Arc::clone(&self.nest), self.centroid);
        let place = work::run(py, move |_| Ok(nest.tightest(about)))?;
        Ok(place.map(|p| self.told(p)))
    }
}

impl Fit {
    fn told(&self, place: Place) -> Told {
        let text = |(owner, wall, own): (Owner, FeatureName, FeatureName)| {
            let (number, part) = match owner {
                Owner::Container => (None, &self.container),
                Owner::Placed(i) => (Some(i), &self.placed[i]),
            };
            (number, told(part, wall), told(self.nest.moving(), own))
        };
        let Configuration { x, y, theta } = place.at;
        let touching = place.touching.into_iter().map(text).collect();
        ((x, y, theta), touching, place.length)
    }
}
