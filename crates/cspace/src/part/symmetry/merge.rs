//! Merges edges that lie on one line or circle, so that an outline has as few vertices as possible.

use crate::part::{Edge, Loop, Part, Vertex};

use super::mapping::SYMMETRIC;

/// The part without the vertices at which two edges lie on one line or one circle, if it has such vertices.
///
/// Whole circles keep two vertices. `None` also if the result is not a part, which rounding can bring about.
pub(super) fn merged(part: &Part) -> Option<Part> {
    let tolerance = SYMMETRIC * part.size();
    let mut fewer = false;
    let loops = part
        .loops()
        .iter()
        .map(|l| {
            let merged = merge(l, tolerance);
            fewer |= merged.len() < l.vertices().len();
            merged
        })
        .collect();
    fewer.then(|| part.redrawn(loops).ok()).flatten()
}

/// A loop in order of travel, with edges that continue each other merged.
fn merge(l: &Loop, tolerance: f64) -> Vec<Vertex> {
    let edges: Vec<Edge> = l.edges().collect();
    let n = edges.len();
    let continues = |i: usize| {
        let (a, b) = (&edges[i], &edges[(i + 1) % n]);
        continues(a, b, tolerance)
    };
    // Begins after a vertex that is kept; a loop without such a vertex is a circle and is left unchanged.
    let Some(last) = (0..n).find(|&i| !continues(i)) else {
        return edges.iter().map(vertex).collect();
    };
    let mut merged: Vec<(Edge, f64)> = Vec::new();
    for step in 1..=n {
        let i = (last + step) % n;
        let edge = edges[i];
        match merged.last_mut() {
            Some((before, sweep)) if step > 1 && continues((i + n - 1) % n) => {
                before.end = edge.end;
                *sweep += edge.sweep();
            }
            _ => merged.push((edge, edge.sweep())),
        }
    }
    merged
        .into_iter()
        .map(|(e, sweep)| Vertex::new(e.start.x, e.start.y, (0.25 * sweep).tan()))
        .collect()
}

fn vertex(e: &Edge) -> Vertex {
    Vertex::new(e.start.x, e.start.y, e.bulge)
}

/// Whether the second edge continues the first one, on its line or circle.
fn continues(a: &Edge, b: &Edge, tolerance: f64) -> bool {
    let (d, e) = (a.end_direction(), b.start_direction());
    let length = (a.end - a.start).length() + (b.end - b.start).length();
    if d.dot(e) <= 0.0 || d.cross(e).abs() * length > tolerance {
        return false;
    }
    match (a.is_line(), b.is_line()) {
        (true, true) => true,
        (false, false) => {
            a.bulge.signum() == b.bulge.signum()
                && a.center().distance(b.center()) <= tolerance
                && (a.radius() - b.radius()).abs() <= tolerance
        }
        _ => false,
    }
}
