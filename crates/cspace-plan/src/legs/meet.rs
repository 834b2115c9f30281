//! Whether two pieces meet at a configuration.

use cspace::Vector;

use super::flat::Flat;
use super::flats::cross;
use super::pose::Placed;
use super::shape::{Shape, beyond};

/// Whether two pieces meet. Vertices are left to the edges beside them.
pub(super) fn meet(a: (&Placed, &Shape), b: (&Placed, &Shape)) -> bool {
    match (a.1, b.1) {
        (Shape::Flat(first), Shape::Flat(second)) => cross((a.0, first), (b.0, second)),
        (Shape::Circle { .. }, Shape::Flat(flat)) => circle_and_flat(a, (b.0, flat)),
        (Shape::Flat(flat), Shape::Circle { .. }) => circle_and_flat(b, (a.0, flat)),
        (Shape::Circle { .. }, Shape::Circle { .. }) => circles(a, b),
    }
}

fn is_on(placed: &Placed, shape: &Shape, direction: Vector) -> bool {
    match *shape {
        Shape::Circle { from, sweep, .. } => {
            beyond(from, sweep, direction.angle() - placed.angle) == 0.0
        }
        Shape::Flat(_) => false,
    }
}

fn circle_and_flat(circle: (&Placed, &Shape), (placed, flat): (&Placed, &Flat)) -> bool {
    let Shape::Circle { center, radius, .. } = *circle.1 else {
        return false;
    };
    if radius == 0.0 {
        return false;
    }
    // In the frame of the arc, whose circle is at y = k (x² + y²) / 2 beside its middle.
    let c = placed.back(circle.0.point(center).at);
    let seen = flat.seen(c);
    if seen.height.abs() >= radius {
        return false;
    }
    // Half the chord that the two circles share, of which the one has a tiny curvature: along its tangent at the foot.
    let k = flat.curvature;
    let (h, r) = (seen.height, radius);
    let lower = 0.5 * k * (r * r - h * h) / (1.0 - k * h);
    let beside = r * r - (h - lower).powi(2);
    if beside <= 0.0 {
        return false;
    }
    let tangent = -seen.up.left();
    [1.0, -1.0].into_iter().any(|side| {
        let p = c - seen.up * (h - lower) + tangent * (side * beside.sqrt());
        let on = flat.seen(p);
        flat.has(on.foot, 0.0) && is_on(circle.0, circle.1, placed.turn * (p - c))
    })
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
