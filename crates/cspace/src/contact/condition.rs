//! Conditions for the orientations at which crossings of two contact curves appear and disappear.
//!
//! The number of crossings of two contact curves changes only where an end of one passes over the carrier of the other, or where they
//! become tangent. With a spiral u + R w put into the equation of a line or of a circle, or a centre into a condition of tangency, each
//! condition is α cos θ + β sin θ + γ = 0, where R w = w cos θ + left(w) sin θ.

use crate::geometry::Vector;
use crate::number::{Distances, Real, Trig};

use super::carrier::Carrier;
use super::locus::Locus;
use super::spiral::Spiral;

/// Calls `take` with each condition of two loci for whose number `asked` is true, and that number.
///
/// The centres of flat arcs are far away: such conditions need double-double. `corners` states whether the first curve ends where the other
/// starts, and starts where the other ends.
pub(crate) fn conditions<T: Real>(
    f: &Locus<T>,
    g: &Locus<T>,
    [end_shared, start_shared]: [bool; 2],
    asked: impl Fn(usize) -> bool,
    mut take: impl FnMut(usize, Trig<T>),
) {
    let mut number = 0;
    let mut ask = |condition: &dyn Fn() -> Trig<T>| {
        if asked(number) {
            take(number, condition());
        }
        number += 1;
    };
    for (shared, end, over) in [
        (start_shared, &f.start, &g.carrier),
        (end_shared, &f.end, &g.carrier),
        // The shared end of f is the start of g, and the shared start of f the end of g.
        (end_shared, &g.start, &f.carrier),
        (start_shared, &g.end, &f.carrier),
    ] {
        if !shared {
            ask(&|| match over.center() {
                Some(center) => apart(end, &center, over.radius),
                None => height(end, over, T::constant(0.0)),
            });
        }
    }
    let (f, g) = (&f.carrier, &g.carrier);
    match (f.center(), g.center()) {
        (None, None) => {}
        (None, Some(center)) => {
            for r in [g.radius, -g.radius] {
                ask(&|| height(&center, f, r));
            }
        }
        (Some(center), None) => {
            for r in [f.radius, -f.radius] {
                ask(&|| height(&center, g, r));
            }
        }
        (Some(c), Some(d)) => {
            let (r, s) = (f.radius.abs(), g.radius.abs());
            for distance in [r + s, r - s] {
                ask(&|| apart(&c, &d, distance));
            }
        }
    }
}

/// n·(p − through) − offset for a spiral p and a line, which may turn.
fn height<T: Real>(p: &Spiral<T>, line: &Carrier<T>, offset: T) -> Trig<T> {
    let (stays, turns) = line.seen(p);
    let beta = turns.cross(line.normal);
    Trig {
        alpha: line.normal.dot(turns),
        beta: if line.turns() { -beta } else { beta },
        gamma: line.normal.dot(stays) - offset,
        scale: size_of(p) + size_of(&line.through) + offset.value().abs(),
        distances: None,
    }
}

/// |u + R w|² − d² for the difference u + R w of two spirals and a distance d of any sign.
fn apart<T: Real>(p: &Spiral<T>, q: &Spiral<T>, distance: T) -> Trig<T> {
    let (u, w) = (p.u - q.u, p.w - q.w);
    let (two, d) = (T::constant(2.0), distance.value().abs());
    let parts = size_of(p) + size_of(q) + d;
    Trig {
        alpha: two * u.dot(w),
        beta: two * u.dot(w.left()),
        gamma: u.length_squared() + w.length_squared() - distance * distance,
        scale: (size(u) + size(w) + d) * parts,
        distances: Some(Distances {
            u,
            w,
            distance: distance.abs(),
            parts,
        }),
    }
}

/// Sum of the absolute values of a vector's coordinates, for the rounding of numbers computed from it.
fn size<T: Real>(v: Vector<T>) -> f64 {
    v.x.value().abs() + v.y.value().abs()
}

fn size_of<T: Real>(p: &Spiral<T>) -> f64 {
    size(p.u.to_vector()) + size(p.w)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
