//! Polylines, of one entity or of many.

use cspace::Point;

use super::error::Result;
use super::groups::Group;
use super::item::What;
use super::record::{Record, faced, heights_differ, not_flat, tilted};
use crate::drawing::Path;

/// LWPOLYLINE: vertices with bulges, one after the other.
pub(super) fn light_polyline(record: &Record<'_, '_>) -> Result<What> {
    let flags = record.integer(70)?.unwrap_or(0);
    let vertices = vertices(record.groups)?;
    let first = vertices.first().map_or(Point::ORIGIN, |v| v.0);
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(first));
    };
    Ok(drawn(&vertices, flags & 1 != 0, behind))
}

/// Vertices with bulges, one after the other.
pub(super) fn vertices(groups: &[Group<'_>]) -> Result<Vec<(Point, f64)>> {
    let mut vertices: Vec<(Point, f64)> = Vec::new();
    for group in groups {
        match (group.code, vertices.last_mut()) {
            (10, _) => vertices.push((Point::new(group.real()?, 0.0), 0.0)),
            (20, Some(last)) => last.0.y = group.real()?,
            (42, Some(last)) => last.1 = group.real()?,
            _ => {}
        }
    }
    Ok(vertices)
}

/// Reads a POLYLINE, whose vertices are entities of their own.
pub(super) fn polyline(head: &Record<'_, '_>, vertices: &[Vec<Group<'_>>]) -> Result<What> {
    const CLOSED: i64 = 1;
    const IN_SPACE: i64 = 8;
    const MESHES: i64 = 16 | 64;
    /// Vertices of the frame of a spline, whose own vertices are there too.
    const FRAME: i64 = 16;
    let flags = head.integer(70)?.unwrap_or(0);
    if flags & MESHES != 0 {
        return Ok(What::problem(
            None,
            "it is a mesh of faces",
            "draw the outline with lines and arcs, or leave its layer out",
        ));
    }
    let mut drawn_vertices = Vec::with_capacity(vertices.len());
    let mut heights = Vec::new();
    for groups in vertices {
        let vertex = Record::new(groups);
        if vertex.integer(70)?.unwrap_or(0) & FRAME != 0 {
            continue;
        }
        let (at, z) = vertex.point(10)?;
        heights.push(z);
        drawn_vertices.push((at, vertex.real(42)?.unwrap_or(0.0)));
    }
    let first = drawn_vertices.first().map_or(Point::ORIGIN, |v| v.0);
    let is_closed = flags & CLOSED != 0;
    if flags & IN_SPACE != 0 {
        return Ok(if heights_differ(heights) {
            not_flat(first)
        } else {
            drawn(&drawn_vertices, is_closed, false)
        });
    }
    let Some(behind) = head.is_from_behind()? else {
        return Ok(tilted(first));
    };
    Ok(drawn(&drawn_vertices, is_closed, behind))
}

fn drawn(vertices: &[(Point, f64)], closed: bool, behind: bool) -> What {
    match path(vertices, closed) {
        Some(path) => faced(path, behind),
        None if vertices.is_empty() => What::Ignored("it has no vertices"),
        None => What::Ignored("it has one vertex"),
    }
}

/// The path through vertices; none through fewer than two.
pub(super) fn path(vertices: &[(Point, f64)], closed: bool) -> Option<Path> {
    let [(first, _), rest @ .., last] = vertices else {
        return None;
    };
    let mut path = Path::from(*first);
    path.pieces.reserve_exact(vertices.len());
    for (from, to) in vertices.iter().zip(rest.iter().chain([last])) {
        path.edge_to(to.0, from.1);
    }
    if closed {
        // Many programs repeat the first vertex in closed polylines.
        if last.0 != *first {
            path.edge_to(*first, last.1);
        }
        path.closed = true;
    }
    Some(path)
}
