//! The common normals of two pieces at a configuration.

use cspace::{Point, Vector};

use super::flat::Flat;
use super::flats::common_points;
use super::pose::Placed;
use super::shape::{Shape, beyond};

/// Where common normals meet the first and the second piece, in the frame of the assembly.
pub(super) fn normals(a: (&Placed, &Shape), b: (&Placed, &Shape)) -> Vec<(Point, Point)> {
    match (a.1, b.1) {
        (Shape::Circle { center: c, .. }, Shape::Circle { center: d, .. }) => {
            let way = b.0.point(*d).at - a.0.point(*c).at;
            let length = way.length();
            if length == 0.0 {
                return Vec::new();
            }
            let unit = way * (1.0 / length);
            let others = on(b, unit);
            on(a, unit)
                .into_iter()
                .flat_map(|p| others.iter().map(move |&q| (p, q)))
                .collect()
        }
        (Shape::Circle { .. }, Shape::Flat(flat)) => from_circle(a, (b.0, flat)).collect(),
        (Shape::Flat(flat), Shape::Circle { .. }) => {
            from_circle(b, (a.0, flat)).map(|(p, q)| (q, p)).collect()
        }
        (Shape::Flat(first), Shape::Flat(second)) => common_points((a.0, first), (b.0, second))
            .into_iter()
            .collect(),
    }
}

/// The points of a circle in a direction and against it, where they belong to it.
fn on((placed, shape): (&Placed, &Shape), direction: Vector) -> Vec<Point> {
    let Shape::Circle {
        center,
        radius,
        from,
        sweep,
    } = *shape
    else {
        return Vec::new();
    };
    let middle = placed.point(center).at;
    if radius == 0.0 {
        return vec![middle];
    }
    [direction, -direction]
        .into_iter()
        .filter(|d| beyond(from, sweep, d.angle() - placed.angle) == 0.0)
        .map(|d| middle + d * radius)
        .collect()
}

/// Points of a circle with those of a flat arc.
fn from_circle(
    circle: (&Placed, &Shape),
    (placed, flat): (&Placed, &Flat),
) -> impl Iterator<Item = (Point, Point)> {
    let center = match *circle.1 {
        Shape::Circle { center, .. } => center,
        Shape::Flat(flat) => flat.middle,
    };
    let seen = flat.seen(placed.back(circle.0.point(center).at));
    let foot = flat
        .has(seen.foot, 0.0)
        .then(|| placed.point(flat.point(seen.foot)).at);
    on(circle, placed.turn * seen.up)
        .into_iter()
        .filter_map(move |p| Some((p, foot?)))
}
