//! Splines, by control points or by the points they go through.

use cspace::{Point, Vector};

use super::error::Result;
use super::groups::Group;
use super::item::What;
use super::record::{Record, heights_differ, not_flat};
use crate::curve::{Curve, Spline, interpolate};
use crate::drawing::{Path, Piece};

pub(super) fn spline(record: &Record<'_, '_>) -> Result<What> {
    const CLOSED: i64 = 1;
    let (mut knots, mut weights) = (Vec::new(), Vec::new());
    let (mut control, mut through): (Vec<Point>, Vec<Point>) = (Vec::new(), Vec::new());
    let mut heights = Vec::new();
    let mut ends: [Option<Vector>; 2] = [None; 2];
    let (mut degree, mut flags) = (3, 0);
    for group in record.groups {
        match group.code {
            70 => flags = group.integer()?,
            71 => degree = group.integer()?,
            40 => knots.push(group.real()?),
            41 => weights.push(group.real()?),
            10 => control.push(Point::new(group.real()?, 0.0)),
            11 => through.push(Point::new(group.real()?, 0.0)),
            20 => set_y(control.last_mut(), group.real()?),
            21 => set_y(through.last_mut(), group.real()?),
            30 | 31 => heights.push(group.real()?),
            12 | 13 => ends[group.code as usize - 12] = Some(Vector::new(group.real()?, 0.0)),
            22 | 23 => {
                if let Some(end) = &mut ends[group.code as usize - 22] {
                    end.y = group.real()?;
                }
            }
            _ => {}
        }
    }
    let first = (control.first().or(through.first())).copied();
    if heights_differ(heights) {
        return Ok(not_flat(first.unwrap_or(Point::ORIGIN)));
    }
    let closed = flags & CLOSED != 0;
    if control.is_empty() {
        return Ok(match interpolate(&through, ends, closed) {
            Some(pieces) => What::Path(path_of(pieces)),
            None => What::Ignored("it has fewer than two different points"),
        });
    }
    weights.resize(control.len(), 1.0);
    let control: Vec<(Point, f64)> = control.into_iter().zip(weights).collect();
    let degree = usize::try_from(degree).unwrap_or(0);
    Ok(match Spline::new(degree, knots, &control) {
        Ok(spline) => What::Path(path_of(vec![spline])),
        Err(error) => What::problem(
            first,
            error.to_string(),
            "draw it again in the program that made it, or explode it to lines and arcs",
        ),
    })
}

/// A spline of a hatch's boundary, where degree and weights have other codes.
pub(super) fn of_hatch(groups: &[Group<'_>]) -> Result<What> {
    let groups: Vec<Group<'_>> = (groups.iter())
        .map(|group| Group {
            code: match group.code {
                94 => 71,
                42 => 41,
                code => code,
            },
            ..*group
        })
        .collect();
    spline(&Record::new(&groups))
}

fn set_y(point: Option<&mut Point>, y: f64) {
    if let Some(point) = point {
        point.y = y;
    }
}

fn path_of(splines: Vec<Spline>) -> Path {
    let mut path: Option<Path> = None;
    for spline in splines {
        let curve = Curve::Spline(spline);
        let path = path.get_or_insert_with(|| Path::from(curve.start()));
        path.pieces.push(Piece::Curve(Box::new(curve)));
    }
    let mut path = path.unwrap_or_else(|| Path::from(Point::ORIGIN));
    path.closed = path.start == path.end();
    path
}
