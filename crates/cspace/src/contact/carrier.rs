//! Carriers of contact curves at one orientation, and where two of them cross, in any arithmetic.
//!
//! All three are one oriented circle: a point, the normal there and a curvature, which is 0 for a line. Only a circle whose
//! centre is among the parts is written by centre and radius instead, for it may be as small as a point.

use crate::geometry::{Point, Vector};
use crate::number::Real;
use crate::number::plane::{dot, minus};

use super::flat_arc::{Equation, FlatArc};

/// A line through a point with a unit normal, a circle by its centre, or a flat arc.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Carrier<T> {
    Line { normal: (T, T), through: (T, T) },
    Circle { center: (T, T), radius: T },
    FlatArc(FlatArc<T>),
}

impl Carrier<f64> {
    /// How far a point is off it.
    pub(crate) fn off(&self, p: Point) -> f64 {
        match *self {
            Self::Line { normal, through } => {
                let v = p - Point::new(through.0, through.1);
                Vector::new(normal.0, normal.1).dot(v).abs()
            }
            Self::Circle { center, radius } => {
                let v = p - Point::new(center.0, center.1);
                (v.length() - radius.abs()).abs()
            }
            Self::FlatArc(arc) => arc.distance(p).abs(),
        }
    }
}

impl<T: Real> Carrier<T> {
    /// A line or flat arc as a flat arc, of curvature 0 if it is a line.
    pub(super) fn flat_arc(&self) -> Option<FlatArc<T>> {
        match *self {
            Self::Line { normal, through } => Some(FlatArc {
                through,
                normal,
                curvature: 0.0,
            }),
            Self::FlatArc(arc) => Some(arc),
            Self::Circle { .. } => None,
        }
    }

    /// Its equation for the way from a point; of a circle by centre and radius it is multiplied by the radius.
    pub(crate) fn equation(&self, from: (T, T)) -> Equation<T> {
        let real = T::constant;
        match *self {
            Self::Line { normal, through } => Equation {
                a: normal,
                k: 0.0,
                c: -dot(normal, minus(through, from)),
            },
            Self::FlatArc(arc) => {
                let e = minus(arc.through, from);
                let k = real(arc.curvature);
                Equation {
                    a: (arc.normal.0 - k * e.0, arc.normal.1 - k * e.1),
                    k: arc.curvature,
                    c: k * real(0.5) * dot(e, e) - dot(arc.normal, e),
                }
            }
            Self::Circle { center, radius } => {
                let e = minus(center, from);
                let side = radius.value().signum();
                let s = real(side);
                Equation {
                    a: (-(s * e.0), -(s * e.1)),
                    k: side,
                    c: s * real(0.5) * (dot(e, e) - radius * radius),
                }
            }
        }
    }
}

/// Where carrier g crosses carrier f, relative to f: for a line (length along it, unused), for a circle the vector
/// from its centre, for a flat arc its place (see [`FlatArc`], unused). The root is named as in `crossing`, with `swapped` telling
/// that f is the second of the two there.
#[inline]
pub(crate) fn place_on<T: Real>(f: &Carrier<T>, g: &Carrier<T>, root: u8, swapped: bool) -> (T, T) {
    let zero = T::constant(0.0);
    let signed = |x: T, positive: bool| if positive { x } else { -x };
    match (*f, *g) {
        (
            Carrier::Line {
                normal: m,
                through: o,
            },
            Carrier::Line {
                normal: n,
                through: q,
            },
        ) => {
            let along = (-m.1, m.0);
            (-dot(n, minus(o, q)) / dot(n, along), zero)
        }
        (
            Carrier::Line {
                normal: m,
                through: o,
            },
            Carrier::Circle { center, radius },
        ) => {
            let along = (-m.1, m.0);
            let v = minus(center, o);
            let offset = dot(m, v);
            let r = radius.abs();
            let half = ((r - offset) * (r + offset)).sqrt();
            (dot(along, v) + signed(half, root == 1), zero)
        }
        (
            Carrier::Circle { center, radius },
            Carrier::Line {
                normal: n,
                through: q,
            },
        ) => {
            let offset = dot(n, minus(center, q));
            let r = radius.abs();
            let half = signed(((r - offset) * (r + offset)).sqrt(), root == 1);
            let foot = (-(n.0 * offset), -(n.1 * offset));
            (foot.0 - n.1 * half, foot.1 + n.0 * half)
        }
        (
            Carrier::Circle {
                center: c1,
                radius: r1,
            },
            Carrier::Circle {
                center: c2,
                radius: r2,
            },
        ) => {
            let v = minus(c2, c1);
            let square = dot(v, v);
            let (a1, a2) = (r1.abs(), r2.abs());
            let (sum, difference) = (a1 + a2, a1 - a2);
            let product = (sum * sum - square) * (square - difference * difference);
            let twice = T::constant(2.0) * square;
            let along = (square + sum * difference) / twice;
            // Left of the way from the first centre to the second, as seen by the pair as named.
            let across = signed(product.sqrt() / twice, (root == 1) != swapped);
            (v.0 * along - v.1 * across, v.1 * along + v.0 * across)
        }
        (Carrier::FlatArc(_), _) | (_, Carrier::FlatArc(_)) => {
            place_of_flat_arc(f, g, (root == 1) != swapped)
        }
    }
}

/// The same if one of the two is a flat arc; f enters the blocked side of g there, or leaves it.
#[cold]
#[inline(never)]
fn place_of_flat_arc<T: Real>(f: &Carrier<T>, g: &Carrier<T>, enters: bool) -> (T, T) {
    let zero = T::constant(0.0);
    match (*f, f.flat_arc(), *g) {
        (_, Some(arc), _) => (arc.crossing(&g.equation(arc.through), enters), zero),
        (Carrier::Circle { center, .. }, None, Carrier::FlatArc(arc)) => {
            // Where f enters the blocked side of g, g leaves that of f.
            let d = arc.way(arc.crossing(&f.equation(arc.through), !enters));
            let from = minus(arc.through, center);
            (from.0 + d.0, from.1 + d.1)
        }
        _ => (zero, zero),
    }
}

/// Rounding error of a place, in the pair's frame; to be divided by the sine of the angle of crossing.
pub(crate) const PLACE_ERROR: f64 = 1e-14;

/// How far rounding may have moved the place at which g crosses f, given as [`place_on`] gives it.
///
/// The sharper the crossing, the better it is known. Towards a tangency of curves that bend apart, the error grows like
/// the square root of the rounding at most; where two carriers become one, it has no bound.
pub(crate) fn place_error(f: &Carrier<f64>, g: &Carrier<f64>, place: (f64, f64)) -> f64 {
    let vector = |v: (f64, f64)| Vector::new(v.0, v.1);
    let point = |p: (f64, f64)| Point::new(p.0, p.1);
    // The place may be off the circle if there is no crossing, or none that rounding leaves.
    let (normal, at, off) = match *f {
        Carrier::Line { normal, through } => {
            let n = vector(normal);
            (n, point(through) + n.left() * place.0, 0.0)
        }
        Carrier::FlatArc(arc) => {
            let p = arc.point(place.0);
            (arc.normal_at(p), p, 0.0)
        }
        Carrier::Circle { center, radius } => {
            let v = vector(place);
            let length = v.length();
            let off = (length - radius.abs()).abs();
            (v * (radius.signum() / length), point(center) + v, off)
        }
    };
    let other = match *g {
        Carrier::Line { normal, .. } => vector(normal),
        Carrier::Circle { center, radius } => (at - point(center)) * (1.0 / radius),
        Carrier::FlatArc(arc) => arc.normal_at(at),
    };
    let curvature = |c: &Carrier<f64>| match *c {
        Carrier::Line { .. } => 0.0,
        Carrier::Circle { radius, .. } => 1.0 / radius,
        Carrier::FlatArc(arc) => arc.curvature,
    };
    // Seen from one side of the common tangent.
    let bend = (curvature(f) - curvature(g) * normal.dot(other).signum()).abs();
    let error = off
        + PLACE_ERROR
            / normal
                .cross(other)
                .abs()
                .max((0.5 * PLACE_ERROR * bend).sqrt());
    if error.is_nan() { f64::INFINITY } else { error }
}

#[cfg(test)]
mod tests;
