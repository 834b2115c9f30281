//! Whether two pieces meet at a configuration.

use cspace::{Point, Vector};

use super::pose::Placed;
use super::shape::{Shape, beyond};

/// Whether two pieces meet. Vertices are left to the edges beside them.
pub(super) fn meet(a: (&Placed, &Shape), b: (&Placed, &Shape)) -> bool {
    match (a.1, b.1) {
        (Shape::Segment { .. }, Shape::Segment { .. }) => segments(a, b),
        (Shape::Circle { .. }, Shape::Segment { .. }) => circle_and_segment(a, b),
        (Shape::Segment { .. }, Shape::Circle { .. }) => circle_and_segment(b, a),
        (Shape::Circle { .. }, Shape::Circle { .. }) => circles(a, b),
    }
}

fn is_on(placed: &Placed, shape: &Shape, direction: Vector) -> bool {
    match *shape {
        Shape::Circle { from, sweep, .. } => {
            beyond(from, sweep, direction.angle() - placed.angle) == 0.0
        }
        Shape::Segment { .. } => false,
    }
}

fn segments(a: (&Placed, &Shape), b: (&Placed, &Shape)) -> bool {
    let ends = |(placed, shape): (&Placed, &Shape)| -> Option<[Point; 2]> {
        match *shape {
            Shape::Segment {
                start,
                along,
                length,
            } => Some([start, start + along * length].map(|p| placed.point(p).at)),
            Shape::Circle { .. } => None,
        }
    };
    let (Some([p, q]), Some([r, s])) = (ends(a), ends(b)) else {
        return false;
    };
    let side = |from: Point, to: Point, at: Point| (to - from).cross(at - from);
    side(p, q, r) * side(p, q, s) < 0.0 && side(r, s, p) * side(r, s, q) < 0.0
}

fn circle_and_segment(circle: (&Placed, &Shape), segment: (&Placed, &Shape)) -> bool {
    let (
        Shape::Circle { center, radius, .. },
        Shape::Segment {
            start,
            along,
            length,
        },
    ) = (*circle.1, *segment.1)
    else {
        return false;
    };
    let (c, s) = (circle.0.point(center).at, segment.0.point(start).at);
    let d = segment.0.turn * along;
    let foot = (c - s).dot(d);
    let height = (c - s).dot(d.left());
    let half = radius * radius - height * height;
    if radius == 0.0 || half <= 0.0 {
        return false;
    }
    [foot - half.sqrt(), foot + half.sqrt()]
        .into_iter()
        .filter(|t| (0.0..=length).contains(t))
        .any(|t| is_on(circle.0, circle.1, s + d * t - c))
}

fn circles(a: (&Placed, &Shape), b: (&Placed, &Shape)) -> bool {
    let (
        Shape::Circle {
            center: p,
            radius: r,
            ..
        },
        Shape::Circle {
            center: q,
            radius: s,
            ..
        },
    ) = (*a.1, *b.1)
    else {
        return false;
    };
    let (p, q) = (a.0.point(p).at, b.0.point(q).at);
    let way = q - p;
    let apart = way.length();
    if r == 0.0 || s == 0.0 || apart == 0.0 {
        return false;
    }
    // How far along the line of the centres the circles meet, and how far beside it.
    let along = 0.5 * (apart + (r - s) * (r + s) / apart);
    let beside = r * r - along * along;
    if beside <= 0.0 {
        return false;
    }
    let unit = way * (1.0 / apart);
    [1.0, -1.0].into_iter().any(|side| {
        let from_p = unit * along + unit.left() * (side * beside.sqrt());
        is_on(a.0, a.1, from_p) && is_on(b.0, b.1, from_p - way)
    })
}
