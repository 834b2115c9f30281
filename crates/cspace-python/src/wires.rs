//! Parts from closed wires of lines, arcs and curves, as programs of CAD have them.

use std::borrow::Cow;

use cspace::{Point, Vector};
use cspace_drawing::{
    Curve, Drawing, DrawingError, EllipseArc, Entity, Origin, Path, Piece, Settings, Spline,
    interpolate,
};
use pyo3::prelude::*;
use serde::Deserialize;

use crate::error::{error, with_help};
use crate::part::Part;
use crate::work;

type At = (f64, f64);

/// Edges end to end, which come back to the start.
#[derive(Deserialize)]
struct Wire {
    name: String,
    start: At,
    edges: Vec<Edge>,
}

/// An edge from where the one before ends.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Edge {
    Line {
        to: At,
    },
    Arc {
        to: At,
        bulge: f64,
    },
    /// The points center + cos t · u + sin t · v.
    Ellipse {
        center: At,
        u: At,
        v: At,
        from: f64,
        to: f64,
    },
    Spline {
        degree: usize,
        knots: Vec<f64>,
        poles: Vec<At>,
        weights: Vec<f64>,
        backward: bool,
    },
    /// The cubic spline through points.
    Through {
        points: Vec<At>,
        closed: bool,
    },
}

impl Edge {
    fn pieces(self) -> Result<Vec<Piece>, Cow<'static, str>> {
        let curve = |curve: Curve| Piece::Curve(Box::new(curve));
        let point = |(x, y): At| Point::new(x, y);
        let vector = |(x, y): At| Vector::new(x, y);
        Ok(match self {
            Self::Line { to } => vec![Piece::Edge {
                to: point(to),
                bulge: 0.0,
            }],
            Self::Arc { to, bulge } => vec![Piece::Edge {
                to: point(to),
                bulge,
            }],
            Self::Ellipse {
                center,
                u,
                v,
                from,
                to,
            } => vec![curve(Curve::Ellipse(EllipseArc {
                center: point(center),
                u: vector(u),
                v: vector(v),
                from,
                to,
            }))],
            Self::Spline {
                degree,
                knots,
                poles,
                weights,
                backward,
            } => {
                let control: Vec<_> = poles.into_iter().map(point).zip(weights).collect();
                let spline = Spline::new(degree, knots, &control).map_err(|e| e.to_string())?;
                let drawn = Curve::Spline(spline);
                vec![curve(match backward {
                    true => drawn.reversed(),
                    false => drawn,
                })]
            }
            Self::Through { points, closed } => {
                let points: Vec<Point> = points.into_iter().map(point).collect();
                let splines = interpolate(&points, [None; 2], closed);
                let splines = splines.ok_or("fewer than two of its points are different")?;
                (splines.into_iter())
                    .map(|spline| curve(Curve::Spline(spline)))
                    .collect()
            }
        })
    }
}

/// The part of wires, whose ends within `join` of each other are one, and the largest distance of its lines and arcs from the curves
/// that they are fitted to within `tol`, and from `places`.
#[pyfunction]
pub(crate) fn _of_wires(
    py: Python<'_>,
    wires: &Bound<'_, PyAny>,
    places: Vec<At>,
    join: f64,
    tol: f64,
    name: String,
) -> PyResult<(Part, f64)> {
    let wires: Vec<Wire> = pythonize::depythonize(wires).map_err(error)?;
    let mut drawing = Drawing::default();
    for wire in wires {
        let mut path = Path::from(Point::new(wire.start.0, wire.start.1));
        path.closed = true;
        for (i, edge) in wire.edges.into_iter().enumerate() {
            let pieces = edge.pieces();
            let wrong = |e| error(format_args!("edge {i} of {}: {e}", wire.name));
            path.pieces.extend(pieces.map_err(wrong)?);
        }
        let origin = Origin {
            kind: wire.name.into(),
            ..Origin::default()
        };
        drawing.entities.push(Entity { origin, path });
    }
    let settings = Settings {
        join: Some(join),
        fit: Some(tol),
        one_part: Some(name),
        ..Settings::default()
    };
    let outlines = work::run(py, move |_| {
        Ok(drawing.outlines(&settings).map_err(|e| match e {
            DrawingError::Entities(_) => (
                e.to_string(),
                "every wire is closed, and it neither crosses nor touches itself or another",
            ),
            DrawingError::File { .. } => (e.to_string(), "check the coordinates"),
        }))
    })?;
    let outlines = outlines.map_err(|(what, help)| with_help(what, help))?;
    if outlines.duplicates + outlines.merged > 0 {
        return Err(with_help(
            "two edges lie on each other",
            "every edge belongs to one wire: unite the faces that have an edge in common",
        ));
    }
    let Ok([part]) = <[_; 1]>::try_from(outlines.parts) else {
        return Err(error("the wires enclose nothing"));
    };
    let off = |&(x, y): &At| {
        let at = Point::new(x, y);
        let all = part.edges().map(|edge| edge.distance(at));
        all.fold(f64::INFINITY, f64::min)
    };
    let off = places
        .iter()
        .map(off)
        .fold(outlines.fitted.deviation, f64::max);
    Ok((Part { part }, off))
}
