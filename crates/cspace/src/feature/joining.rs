//! Joints between consecutive edges of a loop: smooth, or a convex or concave corner; and the place of the corner after growth.

use core::f64::consts::PI;

use super::framed_edge::FramedEdge;
use super::tolerance::{MITRE, MOVED_PART, NEGLIGIBLE, SMOOTH, STRAIGHT};
use crate::geometry::{Point, Rotation, Vector};
use crate::number::Dd;

/// Kind of joint between two consecutive edges.
pub(super) enum Corner {
    /// Tangent, by the drawing or up to rounding; the point of tangency may be `beside` the vertex.
    Smooth {
        beside: bool,
    },
    Convex {
        turn: f64,
    },
    Concave {
        turn: f64,
    },
}

/// Angle by which travel turns to the left from one edge to the next.
fn turn(before: &FramedEdge, after: &FramedEdge) -> f64 {
    let (d1, d2) = (before.end_direction, after.start_direction);
    d1.cross(d2).to_f64().atan2(d1.dot(d2).to_f64())
}

/// Puts lines that follow each other smoothly on one line, from the start of the first to the end of the last: their contacts are then
/// contacts of one line in double-double, however short the edges are.
pub(super) fn straightened(edges: &mut [FramedEdge]) {
    let n = edges.len();
    let goes_on: Vec<bool> = (0..n)
        .map(|i| {
            let (before, after) = (&edges[i], &edges[(i + 1) % n]);
            before.arc.is_none()
                && after.arc.is_none()
                && matches!(corner(before, after), Corner::Smooth { .. })
        })
        .collect();
    for first in 0..n {
        if goes_on[(first + n - 1) % n] {
            continue;
        }
        let count = (1..=n)
            .find(|k| !goes_on[(first + k - 1) % n])
            .unwrap_or_default();
        if count < 2 {
            continue;
        }
        let start = edges[first].edge.start;
        let direction = (edges[(first + count - 1) % n].edge.end - start).unit();
        for k in 0..count {
            let i = (first + k) % n;
            edges[i].start_direction = direction;
            edges[i].end_direction = direction;
            if k + 1 < count {
                let along = direction.dot(edges[i].edge.end - start);
                let joint = start + direction * along;
                edges[i].edge.end = joint;
                edges[(i + 1) % n].edge.start = joint;
            }
        }
    }
}

/// Kind of joint between two consecutive edges.
pub(super) fn corner(before: &FramedEdge, after: &FramedEdge) -> Corner {
    let turn = turn(before, after);
    let beside = run_alike(before, after, turn);
    if beside || turn.abs() < smooth(before, after) {
        return Corner::Smooth { beside };
    }
    // Where travel almost turns back, the material is between the edges or beside them. The perturbation, and an arc replaced by its chord,
    // may invert the sign; the drawing gives it correctly, because the angles of a part are not smaller than its resolution.
    let [back, on] = [before.drawn[1], after.drawn[0]];
    let turn = if turn.abs() > PI - SMOOTH {
        turn.abs().copysign(back.cross(on))
    } else {
        turn
    };
    if turn > 0.0 {
        Corner::Convex { turn }
    } else {
        Corner::Concave { turn }
    }
}

/// Angle below which two edges are joined smoothly: the resulting error is of second order, times the radius; for two lines it is of first
/// order, times their length.
fn smooth(before: &FramedEdge, after: &FramedEdge) -> f64 {
    if before.arc.is_none() && after.arc.is_none() {
        return 2.0 * STRAIGHT;
    }
    let radius = |p: &FramedEdge| match (p.near, p.arc) {
        (Some(_), Some((_, radius))) => radius.to_f64().abs(),
        _ => 1.0,
    };
    SMOOTH / radius(before).max(radius(after)).sqrt()
}

/// Whether two carriers that meet at a small angle may be replaced by a smooth joint at the place where they are parallel.
///
/// With curvatures that differ by κ, they are parallel at δ/κ from a corner that turns by δ, where their distance is δ²/2κ, and cross again
/// twice as far away. If that distance is below [`NEGLIGIBLE`] there is no corner: rounding would not separate one crossing from the
/// other.
fn run_alike(before: &FramedEdge, after: &FramedEdge, turn: f64) -> bool {
    let bend = (after.curvature() - before.curvature()).abs();
    let along = turn.abs() / bend;
    let shortest = before.rough.length().min(after.rough.length());
    0.5 * turn.abs() * along <= NEGLIGIBLE && along <= MOVED_PART * shortest
}

/// The place where two edges that meet smoothly are tangent, and the normal there: the line's, if there is one, or that of both arcs.
///
/// In a rounded drawing this place is `beside` the vertex; contact curves of both edges end there.
pub(super) fn tangency(
    before: &FramedEdge,
    after: &FramedEdge,
    beside: bool,
) -> (Point<Dd>, Vector<Dd>) {
    let vertex = before.edge.end;
    let (d1, d2) = (before.end_direction, after.start_direction);
    let on_line = |(center, radius): (Point<Dd>, Dd), direction: Vector<Dd>| {
        let normal = direction.right();
        if !beside {
            return (vertex, normal);
        }
        let at = center + normal * radius;
        let along = direction.dot(at - vertex);
        (vertex + direction * along, normal)
    };
    match (before.arc, after.arc) {
        (None, None) => (vertex, d1.right()),
        (None, Some(arc)) => on_line(arc, d1),
        (Some(arc), None) => on_line(arc, d2),
        (Some((c, r)), Some((d, s))) => {
            if !beside {
                return (vertex, d2.right());
            }
            // Normals that differ by a turn δ at the vertex agree δ / (κ₁ − κ₂) further on. The line of centres gives the same, but is
            // undefined where both arcs are of one circle.
            let further = turn(before, after) / (before.curvature() - after.curvature());
            let further = Rotation::by(Dd::from(before.curvature() * further));
            let normal = further * d1.right();
            match (before.near, after.near) {
                (None, _) => (c + normal * r, normal),
                // The smaller arc determines the place best; for large ones the normal hardly turns.
                (_, None) => (d + normal * s, normal),
                _ => (vertex, d2.right()),
            }
        }
    }
}

/// The corner of two edges that are both moved outward by `growth`: for lines, V + g (n₁ + n₂) / (1 + n₁·n₂); for arcs this is improved by
/// Newton's method.
pub(super) fn mitre(
    before: &FramedEdge,
    after: &FramedEdge,
    n1: Vector<Dd>,
    n2: Vector<Dd>,
    growth: f64,
) -> Point<Dd> {
    let point = before.edge.end;
    if growth == 0.0 {
        return point;
    }
    let reach = n1.dot(n2) + 1.0;
    // |n₁ + n₂|² = 2 (1 + n₁·n₂), so the mitre's length is g √(2 / reach).
    if 2.0 > MITRE * MITRE * reach.to_f64() {
        return point + n1.left() * Dd::from(growth * MITRE);
    }
    let mut apex = point + (n1 + n2) * (Dd::from(growth) / reach);
    if before.arc.is_none() && after.arc.is_none() {
        return apex;
    }
    /// Number of steps: the first place is right to second order; each step squares the error.
    const STEPS: usize = 2;
    for _ in 0..STEPS {
        let (h, m) = before.off(apex, n1, point, growth);
        let (k, n) = after.off(apex, n2, point, growth);
        let det = m.cross(n);
        let step = n.left() * h + m.right() * k;
        let step = step * (Dd::ONE / det);
        // The edges may continue each other almost smoothly.
        let far = step.length().to_f64();
        if far.is_nan() || far >= growth.abs() {
            break;
        }
        apex += step;
    }
    apex
}
