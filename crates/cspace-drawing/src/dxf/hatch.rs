//! The boundaries of hatches: polylines, or edges end to end.

use core::f64::consts::TAU;

use cspace::{Point, Vector};

use super::error::Result;
use super::groups::Group;
use super::item::What;
use super::polyline;
use super::record::{Record, tilted};
use super::shapes::{direction, ellipse_path};
use super::spline;
use crate::affine::Affine;
use crate::curve::EllipseArc;
use crate::drawing::{Path, Piece};

/// Outlines of HATCH, without the boxes of texts that it leaves out.
pub(super) fn hatch(record: &Record<'_, '_>) -> Result<What> {
    const TEXT_BOX: i64 = 8;
    let (first, _) = record.point(10)?;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(first));
    };
    let mut paths = Vec::new();
    for boundary in boundaries(record.groups) {
        let flags = boundary[0].integer()?;
        if flags & TEXT_BOX != 0 {
            continue;
        }
        match outline(boundary, flags)? {
            Ok(found) => paths.extend(found),
            Err(problem) => return Ok(problem),
        }
    }
    if behind {
        paths = paths.iter().map(|p| p.mapped(&Affine::MIRROR_X)).collect();
    }
    Ok(if paths.is_empty() {
        What::Ignored("a fill without an outline")
    } else {
        What::Hatch(paths)
    })
}

/// The groups of each boundary, from its flags on.
fn boundaries<'g, 'a>(groups: &'g [Group<'a>]) -> impl Iterator<Item = &'g [Group<'a>]> {
    let begin = groups
        .iter()
        .position(|g| g.code == 91)
        .unwrap_or(groups.len());
    let groups = &groups[begin..];
    // The style and the pattern come next.
    let end = groups.iter().position(|g| matches!(g.code, 75 | 76 | 98));
    let groups = &groups[..end.unwrap_or(groups.len())];
    groups
        .chunk_by(|_, next| next.code != 92)
        .filter(|b| b[0].code == 92)
}

type Outline = core::result::Result<Vec<Path>, What>;

fn outline(boundary: &[Group<'_>], flags: i64) -> Result<Outline> {
    const POLYLINE: i64 = 2;
    if flags & POLYLINE != 0 {
        let vertices = polyline::vertices(boundary)?;
        return Ok(Ok(polyline::path(&vertices, true).into_iter().collect()));
    }
    let mut edges: Vec<Path> = Vec::new();
    for edge in boundary.chunk_by(|_, next| next.code != 72).skip(1) {
        match drawn(edge)? {
            What::Path(path) => edges.push(path),
            What::Ignored(_) => {}
            problem => return Ok(Err(problem)),
        }
    }
    Ok(Ok(chained(edges)))
}

/// An edge as a path.
fn drawn(groups: &[Group<'_>]) -> Result<What> {
    const LINE: i64 = 1;
    const ARC: i64 = 2;
    const ELLIPSE: i64 = 3;
    const SPLINE: i64 = 4;
    let record = Record::new(groups);
    let (at, _) = record.point(10)?;
    Ok(match groups[0].integer()? {
        LINE => {
            let mut path = Path::from(at);
            path.edge_to(record.point(11)?.0, 0.0);
            What::Path(path)
        }
        ARC => {
            let radius = record.real(40)?.unwrap_or(0.0);
            let Sweep { from, angle } = sweep(&record)?;
            if radius <= 0.0 || angle == 0.0 {
                return Ok(What::Ignored("it has no length"));
            }
            if angle.abs() == 360.0 {
                return Ok(What::Path(Path::circle(at, radius)));
            }
            let mut path = Path::from(at + direction(from) * radius);
            let end = at + direction(from + angle) * radius;
            path.edge_to(end, (angle.to_radians() / 4.0).tan());
            What::Path(path)
        }
        ELLIPSE => {
            let u = record.point(11)?.0.to_vector();
            let v = u.left() * record.real(40)?.unwrap_or(1.0);
            let Sweep { from, angle } = sweep(&record)?;
            if u.cross(v) == 0.0 || angle == 0.0 {
                return Ok(What::Ignored("it has no length"));
            }
            let ratio = v.length() / u.length();
            let start = parameter(from, ratio);
            let end = if angle.abs() == 360.0 {
                start + TAU.copysign(angle)
            } else {
                let turn = (parameter(from + angle, ratio) - start) * angle.signum();
                start + turn.rem_euclid(TAU) * angle.signum()
            };
            What::Path(ellipse_path(&EllipseArc {
                center: at,
                u,
                v,
                from: start,
                to: end,
            }))
        }
        SPLINE => spline::of_hatch(groups)?,
        _ => What::problem(
            Some(at),
            "its boundary has an edge of an unknown kind",
            "draw its outline with lines and arcs, or leave out --hatches",
        ),
    })
}

/// Start angle and sweep of an arc, in degrees, positive counter-clockwise.
struct Sweep {
    from: f64,
    angle: f64,
}

/// Reads the sweep of an arc. Clockwise arcs are stored with the angles of their mirror image.
fn sweep(record: &Record<'_, '_>) -> Result<Sweep> {
    let [from, to] = [50, 51].map(|c| record.real(c));
    let (from, to) = (from?.unwrap_or(0.0), to?.unwrap_or(360.0));
    let turn = if record.integer(73)?.unwrap_or(1) != 0 {
        1.0
    } else {
        -1.0
    };
    let is_whole = (to - from).abs() >= 360.0 * (1.0 - ROUND);
    let angle = if is_whole {
        360.0
    } else {
        (to - from).rem_euclid(360.0)
    };
    Ok(Sweep {
        from: from * turn,
        angle: angle * turn,
    })
}

/// The parameter of the point of an ellipse in a direction from its centre, given in degrees from its first axis.
fn parameter(degrees: f64, ratio: f64) -> f64 {
    let towards = direction(degrees);
    Vector::new(towards.x * ratio, towards.y).angle()
}

/// Edges end to end as one closed path, if they are; as they come if not.
fn chained(edges: Vec<Path>) -> Vec<Path> {
    let closed = |p: &Path| p.closed;
    let Some(first) = edges.first().filter(|_| !edges.iter().any(closed)) else {
        return edges;
    };
    let size = (edges.iter())
        .map(|e| {
            e.end()
                .distance(first.start)
                .max(e.start.distance(first.start))
        })
        .fold(0.0, f64::max);
    let meets = |a: Point, b: Point| a.distance(b) <= ROUND * size;
    let around = edges.iter().skip(1).chain([first]);
    if !edges
        .iter()
        .zip(around)
        .all(|(a, b)| meets(a.end(), b.start))
    {
        return edges;
    }
    let mut whole = Path::from(first.start);
    let pieces = edges.iter().flat_map(|e| &e.pieces).cloned();
    whole.pieces = pieces.collect();
    if let Some(Piece::Edge { to, .. }) = whole.pieces.last_mut() {
        *to = whole.start;
    }
    whole.closed = true;
    vec![whole]
}

/// Rounding of ends and angles in files, as a share of the boundary's size and of a turn.
const ROUND: f64 = 1e-6;
