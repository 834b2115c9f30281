//! The orientations at which the crossings of two contact curves can come and go.
//!
//! Two contact curves change their number of crossings only when an end of one passes over the carrier of the other,
//! or when they become tangent. Put a spiral u + R w into the equation of a line or of a circle, or a centre into a
//! condition of tangency: each is α cos θ + β sin θ + γ = 0, with R w = w cos θ + left(w) sin θ.

use crate::geometry::{Point, Vector};
use crate::number::Trig;

use super::function::Spiral;
use super::sheet::{SharedEnds, Sheet, SheetKind};

/// Calls `take` with every condition of the pair.
pub(crate) fn conditions(f: &Sheet, g: &Sheet, shared: &SharedEnds, mut take: impl FnMut(Trig)) {
    let [f_end_shared, f_start_shared] = shared.corners.map(|c| c.is_some());
    if !f_start_shared {
        take(on_carrier(&f.start, g));
    }
    if !f_end_shared {
        take(on_carrier(&f.end, g));
    }
    // The end of f that is shared is the start of g, and the other way round.
    if !f_end_shared {
        take(on_carrier(&g.start, f));
    }
    if !f_start_shared {
        take(on_carrier(&g.end, f));
    }
    match (f.is_circle(), g.is_circle()) {
        (false, false) => {}
        (false, true) => line_tangent(f, g, &mut take),
        (true, false) => line_tangent(g, f, &mut take),
        (true, true) => {
            let (r, s) = (f.radius.abs(), g.radius.abs());
            take(centers_apart(f, g, r + s));
            take(centers_apart(f, g, r - s));
        }
    }
}

/// The spiral on the line or circle.
fn on_carrier(spiral: &Spiral, sheet: &Sheet) -> Trig {
    if sheet.is_circle() {
        let c = sheet.center();
        return apart(spiral.u - c.u, spiral.w - c.w, sheet.radius);
    }
    height(spiral, sheet, 0.0)
}

/// n·(p − start) − offset for a spiral p and a line.
fn height(spiral: &Spiral, line: &Sheet, offset: f64) -> Trig {
    let (u, w) = (spiral.u - line.start.u, spiral.w - line.start.w);
    let n = line.normal;
    let scale = size(spiral) + size(&line.start) + offset.abs();
    if line.kind == SheetKind::RoundLine {
        // R n · (u + R w) = n·w + (R n)·u.
        Trig {
            alpha: n.dot(u),
            beta: n.left().dot(u),
            gamma: n.dot(w) - offset,
            scale,
        }
    } else {
        Trig {
            alpha: n.dot(w),
            beta: n.dot(w.left()),
            gamma: n.dot(u) - offset,
            scale,
        }
    }
}

/// |u + R w|² − distance².
fn apart(u: Vector, w: Vector, distance: f64) -> Trig {
    let (a, b) = (u.length_squared(), w.length_squared());
    // u and w are differences of vectors of the pair's frame, of length 4 at most.
    let scale = 4.0 * (a.sqrt() + b.sqrt() + distance.abs());
    Trig {
        alpha: 2.0 * u.dot(w),
        beta: 2.0 * u.dot(w.left()),
        gamma: a + b - distance * distance,
        scale,
    }
}

fn line_tangent(line: &Sheet, circle: &Sheet, take: &mut impl FnMut(Trig)) {
    take(height(&circle.center(), line, circle.radius));
    take(height(&circle.center(), line, -circle.radius));
}

fn centers_apart(f: &Sheet, g: &Sheet, distance: f64) -> Trig {
    let (c, d) = (f.center(), g.center());
    apart(c.u - d.u, c.w - d.w, distance)
}

fn size(spiral: &Spiral) -> f64 {
    (spiral.u - Point::ORIGIN).length() + spiral.w.length()
}
