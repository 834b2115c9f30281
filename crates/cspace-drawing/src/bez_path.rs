//! Drawings of paths of `kurbo`.

use std::sync::Arc;

use cspace::Point;
use kurbo::{BezPath, PathEl};

use crate::curve::{Curve, Spline};
use crate::drawing::{Drawing, Origin, Path, Piece};

/// The drawing of a path's subpaths, each closed as where the path is filled: lines as they are, and curves to which
/// [`outlines`](Drawing::outlines) fits arcs within [`Settings::fit`](crate::Settings::fit), whose report says how near they are.
///
/// ```
/// use cspace_drawing::{Drawing, Settings};
/// use kurbo::{Circle, Shape};
/// let path = Circle::new((0.0, 0.0), 5.0).to_path(1e-6);
/// let settings = Settings { fit: Some(1e-4), one_part: Some("disc".to_owned()), ..Settings::default() };
/// let outlines = Drawing::from(&path).outlines(&settings)?;
/// assert!((outlines.parts[0].area() - 25.0 * std::f64::consts::PI).abs() < 1e-4 * 10.0 * std::f64::consts::PI);
/// assert!(outlines.fitted.deviation <= 1e-4);
/// # Ok::<(), cspace_drawing::DrawingError>(())
/// ```
impl From<&BezPath> for Drawing {
    fn from(path: &BezPath) -> Self {
        let mut drawing = Self {
            name: "path".to_owned(),
            ..Self::default()
        };
        let mut open: Option<Path> = None;
        let mut finish = |path: Option<Path>| {
            let Some(mut path) = path.filter(|p| !p.pieces.is_empty()) else {
                return;
            };
            if path.end() != path.start {
                path.edge_to(path.start, 0.0);
            }
            path.closed = true;
            let kind = Arc::from("path");
            drawing.add(
                Origin {
                    kind,
                    ..Origin::default()
                },
                path,
            );
        };
        for element in path {
            if let PathEl::MoveTo(to) = element {
                finish(open.replace(Path::from(to.into())));
                continue;
            }
            // A path begins with a move: kurbo asserts it.
            let Some(on) = &mut open else { continue };
            let mut curve = |control: &[kurbo::Point]| {
                let all: Vec<Point> = core::iter::once(on.end())
                    .chain(control.iter().map(|&p| p.into()))
                    .collect();
                let curve = Curve::Spline(Spline::bezier(&all));
                on.pieces.push(Piece::Curve(Box::new(curve)));
            };
            match element {
                PathEl::LineTo(to) => on.edge_to(to.into(), 0.0),
                PathEl::QuadTo(p, to) => curve(&[p, to]),
                PathEl::CurveTo(p, q, to) => curve(&[p, q, to]),
                PathEl::ClosePath => {
                    let start = on.start;
                    // What follows without a move begins where the closed subpath began.
                    finish(open.replace(Path::from(start)));
                }
                PathEl::MoveTo(_) => {}
            }
        }
        finish(open);
        drawing
    }
}
