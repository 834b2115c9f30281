//! Loops that make a part, and loops that are rejected.

mod moments;
mod outline;
mod random;
mod validation;

use cspace::Vertex;

/// The loop traversed in the other direction.
fn backwards(vertices: &[Vertex]) -> Vec<Vertex> {
    let n = vertices.len();
    (0..n)
        .map(|i| {
            let (from, to) = (vertices[n - 1 - i], vertices[(2 * n - 2 - i) % n]);
            Vertex::new(from.x, from.y, -to.bulge)
        })
        .collect()
}
