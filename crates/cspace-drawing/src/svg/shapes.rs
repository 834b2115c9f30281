//! SVG's basic shapes as paths.

use core::f64::consts::{FRAC_PI_2, TAU};

use cspace::{Point, Vector};
use roxmltree::Node;
use svgtypes::PointsParser;

use super::length::View;
use super::path::{close, paths};
use crate::curve::{Curve, EllipseArc};
use crate::drawing::{Path, Piece};

/// The paths of a shape; none if the element is no shape.
///
/// # Errors
/// Describes the error in the element's attributes.
pub(super) fn shape(
    node: Node<'_, '_>,
    view: View,
    is_filled: bool,
) -> Option<Result<Vec<Path>, String>> {
    Some(match node.tag_name().name() {
        "path" => paths(node.attribute("d").unwrap_or_default(), is_filled),
        "rect" => rectangle(node, view),
        "circle" => circle(node, view),
        "ellipse" => ellipse(node, view),
        "line" => line(node, view),
        "polygon" => Ok(polyline(node, true)),
        "polyline" => Ok(polyline(node, is_filled)),
        _ => return None,
    })
}

/// A length that an attribute gives, or 0.
fn number(node: Node<'_, '_>, view: View, name: &str) -> Result<f64, String> {
    Ok(view.length(node, name)?.unwrap_or(0.0))
}

fn circle(node: Node<'_, '_>, view: View) -> Result<Vec<Path>, String> {
    let center = Point::new(number(node, view, "cx")?, number(node, view, "cy")?);
    let radius = number(node, view, "r")?;
    Ok(if radius > 0.0 {
        vec![Path::circle(center, radius)]
    } else {
        Vec::new()
    })
}

fn ellipse(node: Node<'_, '_>, view: View) -> Result<Vec<Path>, String> {
    let center = Point::new(number(node, view, "cx")?, number(node, view, "cy")?);
    let (rx, ry) = radii(node, view)?;
    if !(rx > 0.0 && ry > 0.0) {
        return Ok(Vec::new());
    }
    if rx == ry {
        return Ok(vec![Path::circle(center, rx)]);
    }
    let arc = EllipseArc {
        center,
        u: Vector::new(rx, 0.0),
        v: Vector::new(0.0, ry),
        from: 0.0,
        to: TAU,
    };
    let curve = Curve::Ellipse(arc);
    let mut path = Path::from(curve.start());
    path.pieces.push(Piece::Curve(Box::new(curve)));
    path.closed = true;
    Ok(vec![path])
}

/// Radii of a rectangle's corners; if only one is given, it is used for both.
fn radii(node: Node<'_, '_>, view: View) -> Result<(f64, f64), String> {
    Ok(match (view.length(node, "rx")?, view.length(node, "ry")?) {
        (Some(rx), Some(ry)) => (rx, ry),
        (Some(r), None) | (None, Some(r)) => (r, r),
        (None, None) => (0.0, 0.0),
    })
}

fn line(node: Node<'_, '_>, view: View) -> Result<Vec<Path>, String> {
    let mut path = Path::from(Point::new(
        number(node, view, "x1")?,
        number(node, view, "y1")?,
    ));
    path.edge_to(
        Point::new(number(node, view, "x2")?, number(node, view, "y2")?),
        0.0,
    );
    Ok(vec![path])
}

fn polyline(node: Node<'_, '_>, closes: bool) -> Vec<Path> {
    let mut points = (PointsParser::from(node.attribute("points").unwrap_or_default()))
        .map(|(x, y)| Point::new(x, y));
    let Some(first) = points.next() else {
        return Vec::new();
    };
    let mut path = Path::from(first);
    for point in points {
        path.edge_to(point, 0.0);
    }
    close(&mut path, closes);
    vec![path]
}

/// A rectangle, its corners rounded by quarters of circles or ellipses.
fn rectangle(node: Node<'_, '_>, view: View) -> Result<Vec<Path>, String> {
    let (x, y) = (number(node, view, "x")?, number(node, view, "y")?);
    let (width, height) = (number(node, view, "width")?, number(node, view, "height")?);
    if !(width > 0.0 && height > 0.0) {
        return Ok(Vec::new());
    }
    let (rx, ry) = radii(node, view)?;
    let (rx, ry) = (rx.clamp(0.0, width / 2.0), ry.clamp(0.0, height / 2.0));
    let (right, bottom) = (x + width, y + height);
    if rx == 0.0 || ry == 0.0 {
        let mut path = Path::from(Point::new(x, y));
        for corner in [(right, y), (right, bottom), (x, bottom), (x, y)] {
            path.edge_to(corner.into(), 0.0);
        }
        path.closed = true;
        return Ok(vec![path]);
    }
    // The ends of the sides, and the centres of the corners, around.
    let sides = [
        ((x + rx, y), (right - rx, y), (right - rx, y + ry)),
        (
            (right, y + ry),
            (right, bottom - ry),
            (right - rx, bottom - ry),
        ),
        (
            (right - rx, bottom),
            (x + rx, bottom),
            (x + rx, bottom - ry),
        ),
        ((x, bottom - ry), (x, y + ry), (x + rx, y + ry)),
    ];
    let mut path = Path::from(sides[0].0.into());
    for (i, (start, end, center)) in sides.into_iter().enumerate() {
        if Point::from(start) != Point::from(end) {
            path.edge_to(end.into(), 0.0);
        }
        let next: Point = sides[(i + 1) % 4].0.into();
        if rx == ry {
            path.edge_to(next, core::f64::consts::FRAC_PI_8.tan());
        } else {
            let from = FRAC_PI_2 * (i as f64 - 1.0);
            path.pieces
                .push(Piece::Curve(Box::new(Curve::Ellipse(EllipseArc {
                    center: center.into(),
                    u: Vector::new(rx, 0.0),
                    v: Vector::new(0.0, ry),
                    from,
                    to: from + FRAC_PI_2,
                }))));
        }
    }
    path.closed = true;
    Ok(vec![path])
}
