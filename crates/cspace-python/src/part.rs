//! Parts.

use cspace::{FeatureName, Point};
use pyo3::prelude::*;

use crate::error::{error, of_values, with_help};

/// Vertices (x, y, bulge) of a loop.
type Outline = Vec<(f64, f64, f64)>;

fn outline(of: &cspace::Loop) -> Outline {
    let vertices = of.vertices().iter();
    vertices.map(|v| (v.x, v.y, v.bulge)).collect()
}

/// A feature: its name, its kind, and the numbers of its loop and in it.
pub(crate) type Told = (String, String, u32, u32);

/// A feature of a part as Python reads it.
pub(crate) fn told(part: &cspace::Part, feature: FeatureName) -> Told {
    let FeatureName {
        kind,
        loop_index,
        index,
    } = feature;
    (
        part.feature_text(feature),
        kind.to_string(),
        loop_index,
        index,
    )
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
        let model = cspace_model::model::from_json(text, "part").map_err(|e| of_values(&e))?;
        match <[_; 1]>::try_from(model.parts) {
            Ok([entry]) => Ok(Self { part: entry.part }),
            Err(_) => Err(error("the model has not one part")),
        }
    }

    /// The part as it is sent, with its heights and the names of its features.
    fn _sent(&self) -> PyResult<String> {
        serde_json::to_string(&self.part).map_err(error)
    }

    /// The part that was sent.
    #[staticmethod]
    fn _received(text: &str) -> PyResult<Self> {
        let part = serde_json::from_str(text).map_err(error)?;
        Ok(Self { part })
    }

    /// The part with its vertices elsewhere: as many loops of as many, whose features keep their names.
    fn _redrawn(&self, loops: Vec<Outline>) -> PyResult<Self> {
        let vertex = |(x, y, bulge): (f64, f64, f64)| cspace::Vertex::new(x, y, bulge);
        let of = |l: Outline| l.into_iter().map(vertex).collect();
        let part = self.part.redrawn(loops.into_iter().map(of).collect());
        Ok(Self {
            part: part.map_err(error)?,
        })
    }

    /// A feature by its name: the name, the kind, and the numbers of its loop and in it.
    fn _feature(&self, name: &str) -> PyResult<Told> {
        let found = self.part.feature_called(name).ok_or_else(|| {
            with_help(
                format_args!("{} has no feature {name:?}", self.part.name()),
                "give the name that the part gives it, or its kind and place, such as \"line 0 of loop 0\"",
            )
        })?;
        Ok(told(&self.part, found))
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

    /// The centroid of the area: (x, y).
    #[getter]
    fn centroid(&self) -> (f64, f64) {
        let Point { x, y } = self.part.moments().centroid;
        (x, y)
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
