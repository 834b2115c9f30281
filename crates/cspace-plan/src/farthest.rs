//! How far a part reaches in a direction.

use cspace::{Edge, Part, Point, Vector};

/// max p · d over the points of a part.
pub(crate) fn farthest(part: &Part, direction: Vector) -> f64 {
    // With the direction as the x axis the box says it.
    let turned = |p: Point| {
        let v = p.to_vector();
        Point::new(v.dot(direction), v.dot(direction.left()))
    };
    (part.edges())
        .map(|edge| {
            let turned = Edge {
                start: turned(edge.start),
                end: turned(edge.end),
                ..edge
            };
            turned.bounds().max.x
        })
        .fold(f64::NEG_INFINITY, f64::max)
}
