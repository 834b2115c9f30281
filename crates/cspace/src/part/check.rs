//! Checks of a loop's numbers: count, magnitude, and distances of vertices.

use super::tolerance::{
    FLAT_BULGE, FULL_BULGE, MAX_COORDINATE, MAX_OFFSET, MAX_VERTICES, MIN_SIZE, RESOLUTION,
};
use super::{Bounds, Edge, PartError, Vertex};

/// Sets bulges that are negligible to 0, and rejects loops whose numbers do not give edges.
///
/// # Errors
/// No loops, too many or too few vertices, numbers that are not finite or too large.
pub(super) fn check_numbers(loops: &mut [Vec<Vertex>]) -> Result<(), PartError> {
    if loops.is_empty() {
        return Err(PartError::Empty);
    }
    let count = loops.iter().map(Vec::len).sum();
    if count > MAX_VERTICES {
        return Err(PartError::TooManyVertices { count });
    }
    for (loop_index, vertices) in loops.iter_mut().enumerate() {
        for (vertex_index, vertex) in vertices.iter_mut().enumerate() {
            check_vertex(vertex, loop_index, vertex_index)?;
            if vertex.bulge.abs() <= FLAT_BULGE {
                vertex.bulge = 0.0;
            }
        }
        let count = vertices.len();
        if count < 2 || (count == 2 && vertices.iter().all(|v| v.bulge == 0.0)) {
            return Err(PartError::TooFewVertices { loop_index, count });
        }
    }
    Ok(())
}

fn check_vertex(v: &Vertex, loop_index: usize, vertex_index: usize) -> Result<(), PartError> {
    if !v.point().is_finite() {
        return Err(PartError::BadCoordinate {
            loop_index,
            vertex_index,
        });
    }
    if v.x.abs().max(v.y.abs()) > MAX_COORDINATE {
        return Err(PartError::CoordinateTooLarge {
            loop_index,
            vertex_index,
        });
    }
    // Written so that NaN is rejected too.
    if v.bulge.abs() <= FULL_BULGE {
        Ok(())
    } else {
        Err(PartError::BadBulge {
            loop_index,
            vertex_index,
            bulge: v.bulge,
        })
    }
}

/// The box of all edges, when neighbouring vertices are apart and the box is neither too small,
/// too large nor too far away.
///
/// # Errors
/// Coincident neighbours; a part too large, too small or too far from the origin.
pub(super) fn check_extent(loops: &[Vec<Vertex>]) -> Result<Bounds, PartError> {
    let mut bounds = Bounds::EMPTY;
    for (loop_index, vertices) in loops.iter().enumerate() {
        for edge in edges(vertices) {
            if edge.start == edge.end {
                return Err(coincident(vertices, loop_index, edge.index));
            }
            let reach = edge.bounds();
            let corners = [reach.min.x, reach.min.y, reach.max.x, reach.max.y];
            if corners.iter().any(|c| c.abs() > MAX_COORDINATE) {
                return Err(PartError::CoordinateTooLarge {
                    loop_index,
                    vertex_index: edge.index,
                });
            }
            bounds = bounds.union(reach);
        }
    }
    let size = bounds.diagonal();
    if size < MIN_SIZE {
        return Err(PartError::TooSmall { size });
    }
    for (loop_index, vertices) in loops.iter().enumerate() {
        for edge in edges(vertices) {
            if edge.start.distance(edge.end) <= RESOLUTION * size {
                return Err(coincident(vertices, loop_index, edge.index));
            }
        }
    }
    let center = bounds.center();
    let distance = center.x.abs().max(center.y.abs());
    if distance > MAX_OFFSET * size {
        return Err(PartError::TooFar { size, distance });
    }
    Ok(bounds)
}

fn edges(vertices: &[Vertex]) -> impl Iterator<Item = Edge> + '_ {
    let next = vertices.iter().cycle().skip(1);
    vertices
        .iter()
        .zip(next)
        .enumerate()
        .map(|(index, (here, next))| Edge {
            start: here.point(),
            end: next.point(),
            bulge: here.bulge,
            index,
        })
}

fn coincident(vertices: &[Vertex], loop_index: usize, vertex_index: usize) -> PartError {
    PartError::CoincidentVertices {
        loop_index,
        vertex_index,
        next_index: (vertex_index + 1) % vertices.len(),
    }
}
