//! Consecutive edges: they share a vertex and must not meet elsewhere.

use crate::geometry::{Point, Vector};

use super::meeting::{Meeting, by_curvature, facing};
use super::outline::Outline;
use super::tolerance::RESOLUTION;
use super::{Edge, PartError};

/// Rejects vertices at which the boundary turns back, and edges that meet the next one again.
///
/// # Errors
/// A spike, a touch or a crossing, of the first vertex that has one.
pub(super) fn check_corners(outline: &Outline) -> Result<(), PartError> {
    for arriving in &outline.edges {
        let leaving = &outline.edges[outline.after(arriving.index)];
        if is_spike(arriving, leaving, outline.tolerance()) {
            let (loop_index, vertex_index) = outline.name(leaving.index);
            return Err(PartError::Spike {
                loop_index,
                vertex_index,
            });
        }
        if let Some(meeting) = second_meeting(outline, arriving, leaving) {
            return Err(outline.refuse(arriving.index, leaving.index, meeting));
        }
    }
    Ok(())
}

/// Whether two consecutive edges leave their common vertex in one direction, or nearly so and cross again before they are apart.
fn is_spike(arriving: &Edge, leaving: &Edge, tolerance: f64) -> bool {
    let back = arriving.reversed();
    let (out, on) = (back.start_direction(), leaving.start_direction());
    out.dot(on) > 0.0
        && (out.cross(on).abs() <= RESOLUTION
            || second_crossing(&back, leaving).is_some_and(|way| way.length() <= tolerance))
}

/// Place where two consecutive edges meet away from the vertices they share.
///
/// Near a shared vertex their distance grows with their angle; elsewhere they are nearest at the far end of one of them or at a common
/// normal, and cross at most once.
fn second_meeting(outline: &Outline, arriving: &Edge, leaving: &Edge) -> Option<Meeting> {
    let tolerance = outline.tolerance();
    let back = arriving.reversed();
    if back.is_line()
        && leaving.is_line()
        && (back.end - back.start).dot(leaving.end - leaving.start) <= 0.0
    {
        return None; // At a right or blunt corner of two lines the vertex is nearest.
    }
    let closed = outline.after(leaving.index) == arriving.index;
    let is_shared = |p: Point| {
        p.distance(leaving.start) <= tolerance || (closed && p.distance(leaving.end) <= tolerance)
    };
    if !closed {
        if leaving.distance(back.end) <= tolerance {
            return Some(Meeting::Touching(back.end));
        }
        if back.distance(leaving.end) <= tolerance {
            return Some(Meeting::Touching(leaving.end));
        }
    }
    let (rounder, flatter) = by_curvature(&back, leaving);
    let near = facing(rounder, flatter)
        .into_iter()
        .flatten()
        .map(|u| rounder.at(u))
        .find(|&p| !is_shared(p) && flatter.distance(p) <= tolerance);
    if let Some(p) = near {
        return Some(Meeting::Touching(p));
    }
    second_crossing(&back, leaving)
        .map(|way| leaving.start + way)
        .filter(|&p| !is_shared(p))
        .map(Meeting::Crossing)
}

/// Vector to the second crossing of two edges that start at one point, if there is one.
///
/// From that point, the lines or circles are κ p² / 2 = n · p, with left normals n and curvatures
/// κ at the start. So both lie on the line through it along the left normal of κ′ n − κ n′ =: m,
/// at 2 (n × n′) / m² times that.
fn second_crossing(a: &Edge, b: &Edge) -> Option<Vector> {
    let (n, l) = (a.start_direction().left(), b.start_direction().left());
    let (k, j) = (a.curvature(), b.curvature());
    let m = n * j - l * k;
    let square = m.length_squared();
    // Two lines, or one circle within the resolution: the computed place would be determined by rounding.
    let same = RESOLUTION * (k.abs() + j.abs());
    if square <= same * same {
        return None;
    }
    let way = m.left() * (2.0 * n.cross(l) / square);
    (a.covers_way(way) && b.covers_way(way)).then_some(way)
}
