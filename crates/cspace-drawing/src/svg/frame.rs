//! View boxes: how the coordinates within the page, a nested `svg` or a symbol lie in what is around it.

use std::str::FromStr;

use cspace::{Point, Vector};
use roxmltree::Node;
use svgtypes::{Align, AspectRatio, ViewBox};

use super::length::{View, physical, user_units};
use crate::affine::Affine;
use crate::unit::Unit;

/// Map from the coordinates of the root's content to the drawing's, whose y axis points up; the unit of the page; and
/// the frame of its percentages. The origin is the lower left corner of the page; if its view box does not begin at 0,
/// 0, the author has chosen the origin, and it is kept.
pub(super) fn page(root: Node<'_, '_>) -> (Affine, Option<Unit>, View) {
    let length = |name| root.attribute(name).and_then(physical);
    let (width, height) = (length("width"), length("height"));
    let unit = width.or(height).and_then(|l| l.1);
    let view = root
        .attribute("viewBox")
        .and_then(|v| ViewBox::from_str(v).ok());
    // Both sides in the unit of the first.
    let side = |l: Option<(f64, Option<Unit>)>| {
        let (number, own) = l?;
        let factor = match (own, unit) {
            (Some(own), Some(unit)) => own.ratio(unit),
            _ => 1.0,
        };
        Some(number * factor)
    };
    let (width, height) = (side(width), side(height));
    let Some(view) = view.filter(|v| v.w > 0.0 && v.h > 0.0) else {
        // User units are pixels.
        let scale = match (unit, root.attribute("viewBox")) {
            (Some(unit), _) => Unit::Pixel.ratio(unit),
            _ => 1.0,
        };
        let top = height.unwrap_or(0.0);
        let map = Affine {
            x: Vector::new(scale, 0.0),
            y: Vector::new(0.0, -scale),
            origin: Point::new(0.0, top),
        };
        let user = |name| root.attribute(name).and_then(user_units);
        let frame = View {
            width: user("width"),
            height: user("height"),
        };
        return (map, unit, frame);
    };
    let [x, y] = scales(root, view, width, height);
    let map = Affine {
        x: Vector::new(x, 0.0),
        y: Vector::new(0.0, -y),
        origin: match (view.x, view.y) {
            (0.0, 0.0) => Point::new(0.0, view.h * y),
            _ => Point::ORIGIN,
        },
    };
    (map, unit, View::of(view))
}

/// Map of a nested frame, whose corner and sides are lengths in the surrounding frame: its view box is fitted into its
/// sides; and the frame of percentages in it. A symbol's sides are those of the element that uses it. A side that is
/// not given is that of the surrounding frame.
///
/// # Errors
/// If a side or a coordinate of the corner is not a length.
pub(super) fn frame(
    node: Node<'_, '_>,
    used_by: Option<Node<'_, '_>>,
    around: View,
) -> Result<(Affine, View), String> {
    let own = |name| around.length(node, name);
    let side = |name, whole: Option<f64>| -> Result<Option<f64>, String> {
        let by = match used_by {
            Some(by) => around.length(by, name)?,
            None => None,
        };
        Ok(by.or(own(name)?).or(whole))
    };
    let corner = match used_by {
        None => Vector::new(own("x")?.unwrap_or(0.0), own("y")?.unwrap_or(0.0)),
        Some(_) => Vector::ZERO,
    };
    let width = side("width", around.width)?;
    let height = side("height", around.height)?;
    let view = node
        .attribute("viewBox")
        .and_then(|v| ViewBox::from_str(v).ok());
    let Some(view) = view.filter(|v| v.w > 0.0 && v.h > 0.0) else {
        let map = Affine {
            origin: Point::ORIGIN + corner,
            ..Affine::IDENTITY
        };
        return Ok((map, View { width, height }));
    };
    let [x, y] = scales(node, view, width, height);
    let align = aspect(node).align;
    let rest = |side: Option<f64>, own: f64, share: f64| side.map_or(0.0, |s| (s - own) * share);
    let map = Affine {
        x: Vector::new(x, 0.0),
        y: Vector::new(0.0, y),
        origin: Point::new(
            corner.x + rest(width, view.w * x, across(align)) - view.x * x,
            corner.y + rest(height, view.h * y, down(align)) - view.y * y,
        ),
    };
    Ok((map, View::of(view)))
}

/// Rule by which a view box is fitted into the sides of its frame.
fn aspect(node: Node<'_, '_>) -> AspectRatio {
    let text = node.attribute("preserveAspectRatio");
    text.and_then(|t| AspectRatio::from_str(t).ok())
        .unwrap_or_default()
}

/// The scales along x and y of a view box in a frame of these sides: one for both, unless the frame asks for two.
fn scales(node: Node<'_, '_>, view: ViewBox, width: Option<f64>, height: Option<f64>) -> [f64; 2] {
    let is_scale = |s: &f64| *s > 0.0 && s.is_finite();
    let own = [width.map(|w| w / view.w), height.map(|h| h / view.h)].map(|s| s.filter(is_scale));
    let aspect = aspect(node);
    match own {
        [Some(x), Some(y)] if aspect.align == Align::None => [x, y],
        [Some(x), Some(y)] if aspect.slice => [x.max(y); 2],
        [Some(x), Some(y)] => [x.min(y); 2],
        [Some(s), None] | [None, Some(s)] => [s; 2],
        [None, None] => [1.0; 2],
    }
}

/// The share of the room beside a view box that is to its left.
fn across(align: Align) -> f64 {
    match align {
        Align::None | Align::XMinYMin | Align::XMinYMid | Align::XMinYMax => 0.0,
        Align::XMidYMin | Align::XMidYMid | Align::XMidYMax => 0.5,
        Align::XMaxYMin | Align::XMaxYMid | Align::XMaxYMax => 1.0,
    }
}

/// The share of the room beside a view box that is above it.
fn down(align: Align) -> f64 {
    match align {
        Align::None | Align::XMinYMin | Align::XMidYMin | Align::XMaxYMin => 0.0,
        Align::XMinYMid | Align::XMidYMid | Align::XMaxYMid => 0.5,
        Align::XMinYMax | Align::XMidYMax | Align::XMaxYMax => 1.0,
    }
}
