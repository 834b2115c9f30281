//! Where two contact curves of one slice cross.

use crate::feature::tolerance::SAME_CARRIER;
use crate::geometry::{Point, Vector};

use super::curve::{Curve, CurveShape};
use super::flat_arc::FlatArc;

/// A crossing of the carriers of two contact curves f and g.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Crossing {
    pub(crate) point: Point,
    /// Whether travel along f enters the blocked side of g there (then g leaves that of f).
    pub(crate) enters: bool,
}

/// Number of named roots a pair of carriers can have.
pub(crate) fn roots(f: &Curve, g: &Curve) -> u8 {
    match (f.shape, g.shape) {
        (CurveShape::Line { .. }, CurveShape::Line { .. }) => 1,
        _ => 2,
    }
}

/// The crossing with the given name, wherever it lies on the carriers.
///
/// Line–line has one. On line–circle root 0 comes first along the line. On circle–circle root 0 lies right of the
/// line from the centre of f to that of g, root 1 left. With a flat arc, at root 0 f leaves the blocked side of
/// g, at root 1 it enters.
pub(crate) fn crossing(f: &Curve, g: &Curve, root: u8) -> Option<Crossing> {
    match (f.shape, g.shape) {
        (CurveShape::Line { normal: m }, CurveShape::Line { normal: n }) => line_line(f, m, g, n),
        (CurveShape::Line { normal }, CurveShape::Circle { center, radius, .. }) => {
            let (point, later) = line_circle(f, normal, center, radius, root)?;
            // The line enters the disc first and leaves it later; blocked is inside for a positive radius.
            Some(Crossing {
                point,
                enters: later != (radius > 0.0),
            })
        }
        (CurveShape::Circle { center, radius, .. }, CurveShape::Line { normal }) => {
            let (point, later) = line_circle(g, normal, center, radius, root)?;
            Some(Crossing {
                point,
                enters: later == (radius > 0.0),
            })
        }
        (
            CurveShape::Circle {
                center: c1,
                radius: r1,
                ..
            },
            CurveShape::Circle {
                center: c2,
                radius: r2,
                ..
            },
        ) => circle_circle(c1, r1, c2, r2, root),
        (CurveShape::FlatArc(arc), _) => flat_arc_other(&arc, g, root, root == 1),
        (_, CurveShape::FlatArc(arc)) => flat_arc_other(&arc, f, root, root == 0),
    }
}

fn flat_arc_other(arc: &FlatArc<f64>, other: &Curve, root: u8, entered: bool) -> Option<Crossing> {
    let equation = other.carrier().equation(arc.through);
    let point = arc.crossed(&equation, entered)?;
    Some(Crossing {
        point,
        enters: root == 1,
    })
}

fn line_line(f: &Curve, m: Vector, g: &Curve, n: Vector) -> Option<Crossing> {
    // Along f the depth below g changes by n·left(m); f enters where that is negative.
    let slope = n.dot(m.left());
    // Parallel lines do not cross, whatever rounding makes of them.
    if slope.abs() <= SAME_CARRIER {
        return None;
    }
    // From the end of f that is nearer to g, so that a crossing near an end is accurate.
    let (h0, h1) = (n.dot(f.start - g.start), n.dot(f.end - g.start));
    let point = if h0.abs() < h1.abs() {
        f.start + m.left() * (-h0 / slope)
    } else {
        f.end + m.left() * (-h1 / slope)
    };
    Some(Crossing {
        point,
        enters: slope < 0.0,
    })
}

/// The point, and whether it is the later one along the line.
fn line_circle(
    line: &Curve,
    normal: Vector,
    center: Point,
    radius: f64,
    root: u8,
) -> Option<(Point, bool)> {
    let offset = normal.dot(center - line.start);
    let r = radius.abs();
    let square = (r - offset) * (r + offset);
    if square <= 0.0 {
        return None;
    }
    let foot = center + normal * (-offset);
    let half = square.sqrt();
    let later = root == 1;
    let s = if later { half } else { -half };
    Some((foot + normal.left() * s, later))
}

fn circle_circle(c1: Point, r1: f64, c2: Point, r2: f64, root: u8) -> Option<Crossing> {
    let v = c2 - c1;
    let (a1, a2) = (r1.abs(), r2.abs());
    let square = v.length_squared();
    let d = square.sqrt();
    if d == 0.0 {
        return None;
    }
    // 4 d² h² = ((a₁ + a₂)² − d²)(d² − (a₁ − a₂)²), factored against cancellation.
    let product = (a1 + a2 - d) * (a1 + a2 + d) * (d - (a1 - a2)) * (d + (a1 - a2));
    if product <= 0.0 {
        return None;
    }
    let along = (square + (a1 - a2) * (a1 + a2)) / (2.0 * square);
    let across = product.sqrt() / (2.0 * square);
    let left = root == 1;
    let across = if left { across } else { -across };
    let point = c1 + v * along + v.left() * across;
    // Counter-clockwise, circle 1 enters disc 2 on the right and leaves it on the left.
    let into_disc = left != (r1 > 0.0);
    Some(Crossing {
        point,
        enters: into_disc == (r2 > 0.0),
    })
}

#[cfg(test)]
mod tests;
