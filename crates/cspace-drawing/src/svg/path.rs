//! The path of SVG's `d`.

use core::f64::consts::{PI, TAU};

use cspace::{Point, Vector};
use svgtypes::{PathParser, PathSegment};

use crate::curve::{Curve, EllipseArc, Spline};
use crate::drawing::{Path, Piece};

/// Subpaths of path data. A subpath that is not closed is closed by a line where the path is filled.
///
/// # Errors
/// Describes the error in the data.
pub(super) fn paths(data: &str, is_filled: bool) -> Result<Vec<Path>, String> {
    let mut pen = Pen::default();
    for segment in PathParser::from(data) {
        pen.draw(segment.map_err(|e| e.to_string())?)?;
    }
    pen.finish();
    let mut paths = pen.done;
    for path in &mut paths {
        close(path, is_filled);
    }
    Ok(paths)
}

/// Closes a path with a line where it is filled and not closed.
pub(super) fn close(path: &mut Path, is_filled: bool) {
    if path.end() == path.start {
        path.closed = true;
    } else if is_filled && !path.closed && path.pieces.len() > 1 {
        path.edge_to(path.start, 0.0);
        path.closed = true;
    }
}

#[derive(Default)]
struct Pen {
    done: Vec<Path>,
    open: Option<Path>,
    start: Point,
    at: Point,
    /// Control point that a smooth curve reflects, and the degree of its curve.
    control: Option<(usize, Point)>,
}

impl Pen {
    fn finish(&mut self) {
        self.done
            .extend(self.open.take().filter(|p| !p.pieces.is_empty()));
    }

    /// Open path; if there is none, it is begun at the pen.
    fn path(&mut self) -> &mut Path {
        let at = self.at;
        self.open.get_or_insert_with(|| Path::from(at))
    }

    fn line(&mut self, to: Point) {
        self.path().edge_to(to, 0.0);
        self.at = to;
    }

    fn bezier(&mut self, control: &[Point]) {
        let mut all = vec![self.at];
        all.extend(control);
        let to = all[all.len() - 1];
        let curve = Curve::Spline(Spline::bezier(&all));
        self.path().pieces.push(Piece::Curve(Box::new(curve)));
        self.at = to;
    }

    /// The control point that continues a curve of the same degree smoothly.
    fn reflected(&self, degree: usize) -> Point {
        match self.control {
            Some((of, control)) if of == degree => self.at + (self.at - control),
            _ => self.at,
        }
    }

    fn draw(&mut self, segment: PathSegment) -> Result<(), String> {
        let at = self.at;
        let place = |abs: bool, x: f64, y: f64| {
            if abs {
                Point::new(x, y)
            } else {
                Point::new(at.x + x, at.y + y)
            }
        };
        let mut control = None;
        match segment {
            PathSegment::MoveTo { abs, x, y } => {
                self.finish();
                self.at = place(abs, x, y);
                self.start = self.at;
            }
            PathSegment::LineTo { abs, x, y } => self.line(place(abs, x, y)),
            PathSegment::HorizontalLineTo { abs, x } => {
                let y = if abs { at.y } else { 0.0 };
                self.line(place(abs, x, y));
            }
            PathSegment::VerticalLineTo { abs, y } => {
                let x = if abs { at.x } else { 0.0 };
                self.line(place(abs, x, y));
            }
            PathSegment::CurveTo {
                abs,
                x1,
                y1,
                x2,
                y2,
                x,
                y,
            } => {
                let (p, q, to) = (place(abs, x1, y1), place(abs, x2, y2), place(abs, x, y));
                self.bezier(&[p, q, to]);
                control = Some((3, q));
            }
            PathSegment::SmoothCurveTo { abs, x2, y2, x, y } => {
                let (p, q, to) = (self.reflected(3), place(abs, x2, y2), place(abs, x, y));
                self.bezier(&[p, q, to]);
                control = Some((3, q));
            }
            PathSegment::Quadratic { abs, x1, y1, x, y } => {
                let (p, to) = (place(abs, x1, y1), place(abs, x, y));
                self.bezier(&[p, to]);
                control = Some((2, p));
            }
            PathSegment::SmoothQuadratic { abs, x, y } => {
                let (p, to) = (self.reflected(2), place(abs, x, y));
                self.bezier(&[p, to]);
                control = Some((2, p));
            }
            PathSegment::EllipticalArc {
                abs,
                rx,
                ry,
                x_axis_rotation,
                large_arc,
                sweep,
                x,
                y,
            } => {
                let to = place(abs, x, y);
                let piece = arc(at, to, [rx, ry], x_axis_rotation, large_arc, sweep);
                if let Some(piece) = piece {
                    self.path().pieces.push(piece);
                }
                self.at = to;
            }
            PathSegment::ClosePath { .. } => {
                let start = self.start;
                if self.at != start {
                    self.line(start);
                }
                if let Some(path) = &mut self.open {
                    path.closed = true;
                }
                self.finish();
                self.at = start;
            }
        }
        self.control = control;
        if self.at.is_finite() {
            Ok(())
        } else {
            Err("a coordinate is beyond computing".to_owned())
        }
    }
}

/// An arc by its ends, as the appendix of SVG on elliptical arcs has it: radii too small are enlarged, of length zero they
/// make a line. None between equal ends.
fn arc(
    from: Point,
    to: Point,
    radii: [f64; 2],
    rotation: f64,
    large: bool,
    sweep: bool,
) -> Option<Piece> {
    if from == to {
        return None;
    }
    let [rx, ry] = radii.map(f64::abs);
    if rx == 0.0 || ry == 0.0 {
        return Some(Piece::Edge { to, bulge: 0.0 });
    }
    let turn = if sweep { 1.0 } else { -1.0 };
    if rx == ry {
        let sine = (from.distance(to) / (2.0 * rx)).min(1.0);
        let short = 2.0 * sine.asin();
        let angle = if large { TAU - short } else { short };
        return Some(Piece::Edge {
            to,
            bulge: turn * (angle / 4.0).tan(),
        });
    }
    // In coordinates in which the ellipse is the unit circle.
    let (sin, cos) = rotation.to_radians().sin_cos();
    let flat = |v: Vector| Vector::new((cos * v.x + sin * v.y) / rx, (cos * v.y - sin * v.x) / ry);
    let chord = flat(to - from);
    let grown = (chord.length() / 2.0).max(1.0);
    let (rx, ry) = (rx * grown, ry * grown);
    let flat = |v: Vector| flat(v) * (1.0 / grown);
    let chord = flat(to - from);
    let half = chord.length() / 2.0;
    let away = (1.0 - half * half).max(0.0).sqrt();
    let side = if large == sweep { -1.0 } else { 1.0 };
    let center = chord * 0.5 + chord.left().unit() * (side * away);
    let start = (-center).angle();
    let end = (chord - center).angle();
    let angle = (turn * (end - start)).rem_euclid(TAU);
    // A half is a half, whatever the rounding.
    let angle = if half >= 1.0 { PI } else { angle };
    let u = Vector::new(cos, sin) * rx;
    let v = Vector::new(-sin, cos) * ry;
    Some(Piece::Curve(Box::new(Curve::Ellipse(EllipseArc {
        center: from
            + Vector::new(
                u.x * center.x + v.x * center.y,
                u.y * center.x + v.y * center.y,
            ),
        u,
        v,
        from: start,
        to: start + turn * angle,
    }))))
}
