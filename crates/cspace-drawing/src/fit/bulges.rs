//! The arcs between two points that pass other points within a distance.

use cspace::Point;

use super::run::Run;

/// Arcs sweep at most 225 degrees: this is tan(225°/4). A circle needs two.
const MOST: f64 = 1.496_605_762_665_489;

/// The bulge of the arc from p to q through a point: tan(φ / 2), where φ is the angle by which the way p, point, q turns.
pub(super) fn bulge_through(p: Point, at: Point, q: Point) -> f64 {
    let (a, b) = (at - p, q - at);
    let (cross, dot) = (a.cross(b), a.dot(b));
    let lengths = (a.length_squared() * b.length_squared()).sqrt();
    let below = lengths + dot;
    if below > 0.0 {
        cross / below
    } else {
        cross.signum() * f64::INFINITY
    }
}

/// The bulges of the arcs between two samples that pass all samples between within the band of this half width; none if
/// there are none. All arcs between two points are nested, so that each sample allows an interval.
pub(super) fn allowed(run: &Run, from: usize, to: usize, width: f64) -> Option<(f64, f64)> {
    let (p, q) = (run.joint(from), run.joint(to));
    let (mut lo, mut hi) = (-MOST, MOST);
    let middle = run.band.middle();
    for i in from + 1..to {
        let (at, normal) = (run.point(i), run.normal(i));
        // Arcs to the left of the way have the lower bulges.
        let low = bulge_through(p, at + normal * (middle + width), q);
        let high = bulge_through(p, at + normal * (middle - width), q);
        if low > high {
            // Next to an end, the band has the end in it: any arc passes there.
            continue;
        }
        (lo, hi) = (lo.max(low), hi.min(high));
        if lo > hi {
            return None;
        }
    }
    Some((lo, hi))
}
