//! Parts.

use cspace::Point;
use pyo3::prelude::*;

use crate::error::{error, of_model};

/// Vertices (x, y, bulge) of a loop.
type Outline = Vec<(f64, f64, f64)>;

fn outline(of: &cspace::Loop) -> Outline {
    let vertices = of.vertices().iter();
    vertices.map(|v| (v.x, v.y, v.bulge)).collect()
}

/// A rigid part: closed loops of line segments and circular arcs.
#[pyclass(frozen, module = "cspace._rust", name = "Part", subclass)]
pub(crate) struct Part {
    pub(crate) part: cspace::Part,
}

#[pymethods]
impl Part {
    /// The part in a model's JSON, of which it is the only one.
    #[staticmethod]
    fn _from_json(text: &str) -> PyResult<Self> {
        let model = cspace_model::model::from_json(text, "part").map_err(|e| of_model(&e))?;
        match <[_; 1]>::try_from(model.parts) {
            Ok([entry]) => Ok(Self { part: entry.part }),
            Err(_) => Err(error("the model has not one part")),
        }
    }

    /// The name.
    #[getter]
    fn name(&self) -> &str {
        self.part.name()
    }

    /// The loops as lists of vertices (x, y, bulge): outer ones counter-clockwise, holes clockwise. The bulge is that of the edge to
    /// the next vertex, tan of a quarter of the angle it turns by, positive to the left and 0 of a line.
    #[getter]
    fn loops(&self) -> Vec<Outline> {
        self.part.loops().iter().map(outline).collect()
    }

    /// The layers: for each its heights (lowest, highest), or None at every height, and its loops.
    #[getter]
    fn layers(&self) -> Vec<(Option<[f64; 2]>, Vec<Outline>)> {
        let loops = |l: &cspace::Layer| {
            let own = self.part.loops()[l.loops()].iter();
            (l.z(), own.map(outline).collect())
        };
        self.part.layers().iter().map(loops).collect()
    }

    /// The area.
    #[getter]
    fn area(&self) -> f64 {
        self.part.moments().area
    }

    /// The smallest and the largest x and y: (x, y, x, y).
    #[getter]
    fn bounds(&self) -> (f64, f64, f64, f64) {
        let b = self.part.bounds();
        (b.min.x, b.min.y, b.max.x, b.max.y)
    }

    /// Whether a point is in the part or on its outline.
    fn contains(&self, x: f64, y: f64) -> bool {
        /// Points this near to the outline, as a share of the coordinates' and the part's size, are on it: their own coordinates are
        /// rounded.
        const ON: f64 = 16.0 * f64::EPSILON;
        let p = Point::new(x, y);
        let on = ON * (self.part.size() + x.abs() + y.abs());
        self.part.contains(p) || self.part.edges().any(|edge| edge.distance(p) <= on)
    }

    /// The outline in points no farther than `tolerance` from it: for each loop a list of (x, y).
    fn _points(&self, tolerance: f64) -> PyResult<Vec<Vec<(f64, f64)>>> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(error("`tolerance` is not a positive number"));
        }
        let of = |l: &cspace::Loop| {
            l.points(tolerance)
                .into_iter()
                .map(|p| (p.x, p.y))
                .collect()
        };
        Ok(self.part.loops().iter().map(of).collect())
    }

    fn __repr__(&self) -> String {
        let b = self.part.bounds();
        let loops = self.part.loops().len();
        format!(
            "Part({:?}, {loops} loop{}, {} x {})",
            self.part.name(),
            if loops == 1 { "" } else { "s" },
            cspace_model::shown::number(b.max.x - b.min.x),
            cspace_model::shown::number(b.max.y - b.min.y),
        )
    }
}
