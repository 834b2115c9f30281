//! Distances of samples from the pieces fitted to them.

use core::f64::consts::TAU;

use cspace::part::Edge;
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
        Edge::between(vertices[i].point(), next, vertices[i].bulge)
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
                .map(|&i| piece(i).nearest(at))
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
        Edge::between(fitted.vertices[i].point(), next, fitted.vertices[i].bulge)
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
        let apart = |i: usize| piece(i).distance(*first);
        apart(a).total_cmp(&apart(b))
    })?;
    let mut worst = 0.0_f64;
    for p in &others.points {
        let (nearest, apart) = (-1..=2)
            .map(|by| step(at, by))
            .map(|i| (i, piece(i).distance(*p)))
            .min_by(|a, b| a.1.total_cmp(&b.1))?;
        at = nearest;
        worst = worst.max(apart);
    }
    worst.is_finite().then_some(worst)
}

/// How far each edge of a closed outline is from the pieces fitted to it, which go around with it, and these from it. `None` if there are
/// no pieces, or a number is not finite.
///
/// An edge that goes along several pieces is divided where it is nearest to their joints. What goes along one piece is farthest from it at
/// an end, or where both have one direction.
pub(crate) fn of_edges(edges: &[Edge], vertices: &[Vertex]) -> Option<Vec<f64>> {
    let n = vertices.len();
    let piece = |i: usize| {
        let (from, to) = (vertices[i % n], vertices[(i + 1) % n]);
        Edge::between(from.point(), to.point(), from.bulge)
    };
    let away = |i: usize, at: Point| piece(i).distance(at);
    let first = edges.first()?.start;
    let mut here = (0..n).min_by(|&a, &b| away(a, first).total_cmp(&away(b, first)))?;
    let mut all = Vec::with_capacity(edges.len());
    for edge in edges {
        let mut last = here;
        while last < here + n && away(last + 1, edge.end) < away(last, edge.end) {
            last += 1;
        }
        let (mut worst, mut from) = (0.0_f64, 0.0_f64);
        for i in here..=last {
            let to = match i == last {
                true => 1.0,
                false => share(edge, piece(i).end).clamp(from, 1.0),
            };
            let alike = alike(edge, &piece(i)).into_iter().flatten();
            let inside = alike.filter(|s| (from..=to).contains(s));
            for s in [from, to].into_iter().chain(inside) {
                worst = worst.max(away(i, edge.at(s)));
            }
            from = to;
        }
        if !worst.is_finite() {
            return None;
        }
        all.push(worst);
        here = last % n;
    }
    Some(all)
}

/// Where along an edge a point is, or its foot: 0 at the start, 1 at the end.
fn share(edge: &Edge, at: Point) -> f64 {
    if edge.is_line() {
        let chord = edge.end - edge.start;
        return (at - edge.start).dot(chord) / chord.length_squared();
    }
    let (center, sweep) = (edge.center(), edge.sweep());
    let [a, b] = [edge.start, at].map(|p| p - center);
    // From the middle of the arc, so that what is a little outside is no whole turn away.
    let turned = a.cross(b).atan2(a.dot(b)) - 0.5 * sweep;
    let turned = turned - TAU * (turned / TAU).round();
    0.5 + turned / sweep
}

/// Where along an edge it may have the direction of a piece.
fn alike(edge: &Edge, piece: &Edge) -> [Option<f64>; 2] {
    match (edge.is_line(), piece.is_line()) {
        (true, true) => [None, None],
        (true, false) => [Some(share(edge, piece.center())), None],
        (false, _) => {
            let across = match piece.is_line() {
                true => (piece.end - piece.start).left(),
                false => edge.center() - piece.center(),
            };
            [across, -across].map(|way| Some(share(edge, edge.center() + way)))
        }
    }
}
