//! Distances of samples from the pieces fitted to them.

use cspace::{Point, Vertex};

use super::fitted::Fitted;
use super::run::Run;

/// Smallest and largest distance of the pieces from the samples, to the left of the direction of travel. `None` if a
/// number is not finite.
pub(super) fn range(
    run: &Run,
    joints: &[usize],
    vertices: &[Vertex],
    end: Point,
) -> Option<[f64; 2]> {
    let n = vertices.len();
    let piece = |i: usize| {
        let next = vertices.get(i + 1).map_or(end, |v| v.point());
        (vertices[i].point(), next, vertices[i].bulge)
    };
    let mut range = [0.0_f64; 2];
    for (i, between) in joints.windows(2).enumerate() {
        // Joints have moved along the curve: a sample may be nearest to the piece before or after its own.
        let near = if run.is_closed {
            [(i + n - 1) % n, i, (i + 1) % n]
        } else {
            [i.saturating_sub(1), i, (i + 1).min(n - 1)]
        };
        for k in between[0]..=between[1] {
            let (at, normal) = (run.point(k), run.normal(k));
            let nearest = (near.iter())
                .map(|&i| nearest_on(piece(i), at))
                .min_by(|a, b| a.distance(at).total_cmp(&b.distance(at)))?;
            let away = nearest - at;
            let distance = away.length();
            if !distance.is_finite() {
                return None;
            }
            let signed = distance.copysign(away.dot(normal));
            range = [range[0].min(signed), range[1].max(signed)];
        }
    }
    Some(range)
}

/// Largest distance of the pieces fitted to a run from other samples of the same curve, in the same order: each is
/// compared with a piece near the one before.
pub(crate) fn of_others(others: &Run, run: &Run, fitted: &Fitted) -> Option<f64> {
    let n = fitted.vertices.len();
    let piece = |i: usize| {
        let next = fitted.vertices.get(i + 1).map_or(fitted.end, |v| v.point());
        (fitted.vertices[i].point(), next, fitted.vertices[i].bulge)
    };
    // The pieces near a sample change slowly: a window moves on with the samples.
    let step = |i: usize, by: isize| -> usize {
        let moved = i as isize + by;
        if run.is_closed {
            moved.rem_euclid(n as isize) as usize
        } else {
            moved.clamp(0, n as isize - 1) as usize
        }
    };
    let first = others.points.first()?;
    let mut at = (0..n).min_by(|&a, &b| {
        let apart = |i: usize| nearest_on(piece(i), *first).distance(*first);
        apart(a).total_cmp(&apart(b))
    })?;
    let mut worst = 0.0_f64;
    for p in &others.points {
        let (nearest, apart) = (-1..=2)
            .map(|by| step(at, by))
            .map(|i| (i, nearest_on(piece(i), *p).distance(*p)))
            .min_by(|a, b| a.1.total_cmp(&b.1))?;
        at = nearest;
        worst = worst.max(apart);
    }
    worst.is_finite().then_some(worst)
}

/// The point of a line or an arc that is nearest to a point.
pub(super) fn nearest_on((p, q, bulge): (Point, Point, f64), at: Point) -> Point {
    let chord = q - p;
    if bulge == 0.0 {
        let s = (at - p).dot(chord) / chord.length_squared();
        return p + chord * s.clamp(0.0, 1.0);
    }
    let center = p.midpoint(q) + chord.left() * ((1.0 - bulge) * (1.0 + bulge) / (4.0 * bulge));
    let radius = chord.length() * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
    let out = (at - center).unit();
    // An arc is the part of its circle on the right of the chord if it turns left, and the other way round.
    let on = center + out * radius;
    let is_on = chord.cross(on - p) * bulge.signum() <= 0.0;
    if is_on {
        on
    } else if at.distance(p) < at.distance(q) {
        p
    } else {
        q
    }
}
