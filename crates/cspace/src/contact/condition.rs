//! The orientations at which the crossings of two contact curves can come and go.
//!
//! Two contact curves change their number of crossings only when an end of one passes over the carrier of the other,
//! or when they become tangent. Put a spiral u + R w into the equation of a line or of a circle, or a centre into a
//! condition of tangency: each is α cos θ + β sin θ + γ = 0, with R w = w cos θ + left(w) sin θ.

use crate::geometry::{Point, Vector};
use crate::number::{Known, Real, Trig};

use super::shared::SharedEnds;
use super::sheet::{Sheet, SheetKind};
use super::spiral::Spiral;

/// Calls `take` with every condition of the pair.
pub(crate) fn conditions(f: &Sheet, g: &Sheet, shared: &SharedEnds, mut take: impl FnMut(Trig)) {
    let [f_end_shared, f_start_shared] = shared.corners.map(|c| c.is_some());
    let mut passing = |shared: bool, end, over| {
        if !shared {
            take(on_carrier(end, over));
        }
    };
    passing(f_start_shared, &f.start, g);
    passing(f_end_shared, &f.end, g);
    // The end of f that is shared is the start of g, and the other way round.
    passing(f_end_shared, &g.start, f);
    passing(f_start_shared, &g.end, f);
    match (f.is_circle(), g.is_circle()) {
        (false, false) => {}
        (false, true) => line_tangent(f, g, &mut take),
        (true, false) => line_tangent(g, f, &mut take),
        (true, true) => {
            let (r, s) = (f.radius.abs(), g.radius.abs());
            for distance in [r + s, r - s] {
                take(apart(&f.center(), &g.center(), distance.abs()));
            }
        }
    }
}

/// Error of a length computed from coordinates, in units of the sizes of these.
const LENGTH_ERROR: f64 = 4.0 * f64::EPSILON;

/// The spiral on the line or circle.
fn on_carrier(spiral: &Spiral, sheet: &Sheet) -> Trig {
    if sheet.is_circle() {
        return apart(spiral, &sheet.center(), sheet.radius.abs());
    }
    height(spiral, sheet, 0.0)
}

/// n·(p − start) − offset for a spiral p and a line.
fn height(spiral: &Spiral, line: &Sheet, offset: f64) -> Trig {
    let (stays, turns) = line.seen(spiral);
    let scale = size(spiral) + size(&line.start) + offset.abs();
    let line_turns = line.kind == SheetKind::RoundLine;
    let [alpha, beta, gamma] = height_coefficients(line.normal, stays, turns, offset, line_turns);
    let amplitude = turns.length();
    let known = |value| Known {
        value,
        error: LENGTH_ERROR * scale,
    };
    Trig {
        alpha,
        beta,
        gamma,
        scale,
        most: known(amplitude + gamma),
        least: known(amplitude - gamma),
    }
}

/// n·(u + R w) − d as α cos θ + β sin θ + γ, of a way of which one part stays and the other turns as seen from the line's
/// normal; the line itself may turn.
pub(super) fn height_coefficients<T: Real>(
    n: Vector<T>,
    stays: Vector<T>,
    turns: Vector<T>,
    offset: T,
    line_turns: bool,
) -> [T; 3] {
    let beta = turns.cross(n);
    let beta = if line_turns { -beta } else { beta };
    [n.dot(turns), beta, n.dot(stays) - offset]
}

/// |u + R w|² − d² as α cos θ + β sin θ + γ.
pub(super) fn apart_coefficients<T: Real>(u: Vector<T>, w: Vector<T>, distance: T) -> [T; 3] {
    let two = T::constant(2.0);
    [
        two * u.dot(w),
        two * u.dot(w.left()),
        u.length_squared() + w.length_squared() - distance * distance,
    ]
}

/// |u + R w|² − d² for the difference u + R w of two spirals and a distance d.
///
/// With a = |u| and b = |w| its largest value is (a + b)² − d² and its least (a − b)² − d², both products of lengths: the
/// angle of a triangle with the sides a, b and d, by its half.
fn apart(p: &Spiral, q: &Spiral, distance: f64) -> Trig {
    let (u, w) = (p.u - q.u, p.w - q.w);
    let (a, b) = (u.length(), w.length());
    // u and w are differences of vectors of the pair's frame, of length 4 at most.
    let scale = 4.0 * (a + b + distance);
    let error = LENGTH_ERROR * (size(p) + size(q) + distance);
    let product = |x: f64, y: f64| Known {
        value: x * y,
        error: error * (x.abs() + y.abs() + error),
    };
    let [alpha, beta, gamma] = apart_coefficients(u, w, distance);
    Trig {
        alpha,
        beta,
        gamma,
        scale,
        most: product(a + b - distance, a + b + distance),
        least: product(distance - (a - b), distance + (a - b)),
    }
}

fn line_tangent(line: &Sheet, circle: &Sheet, take: &mut impl FnMut(Trig)) {
    for distance in [circle.radius, -circle.radius] {
        take(height(&circle.center(), line, distance));
    }
}

fn size(spiral: &Spiral) -> f64 {
    (spiral.u - Point::ORIGIN).length() + spiral.w.length()
}

#[cfg(test)]
mod tests;
