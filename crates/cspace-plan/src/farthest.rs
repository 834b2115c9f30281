//! How far a part reaches in a direction.

use cspace::{Part, Point, Vector};

/// max p · d over the points p of a part, for a direction d of unit length: how far the part reaches along d from the origin of its frame,
/// in the model's unit.
///
/// ```
/// use cspace::{Part, Vector};
/// let disc = Part::circle("disc", (3.0, 0.0), 2.0)?;
/// assert!((cspace_plan::farthest(&disc, Vector::new(1.0, 0.0)) - 5.0).abs() < 1e-12);
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn farthest(part: &Part, direction: Vector) -> f64 {
    // With the direction as the x axis the box says it.
    let turned = |p: Point| {
        let v = p.to_vector();
        Point::new(v.dot(direction), v.dot(direction.left()))
    };
    (part.edges())
        .map(|edge| edge.placed(turned).bounds().max.x)
        .fold(f64::NEG_INFINITY, f64::max)
}
