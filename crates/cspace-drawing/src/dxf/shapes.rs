//! Entities of one shape: lines, arcs, circles, ellipses; and where a block is inserted.

use core::f64::consts::{PI, TAU};

use cspace::{Point, Vector};

use super::error::Result;
use super::item::{Insert, What};
use super::names::Names;
use super::record::{Record, faced, heights_differ, not_flat, tilted};
use crate::affine::Affine;
use crate::curve::{Curve, EllipseArc};
use crate::drawing::{Path, Piece};

pub(super) fn line(record: &Record<'_, '_>) -> Result<What> {
    let ((from, z0), (to, z1)) = (record.point(10)?, record.point(11)?);
    if heights_differ([z0, z1]) {
        return Ok(not_flat(from));
    }
    let mut path = Path::from(from);
    path.edge_to(to, 0.0);
    Ok(What::Path(path))
}

fn radius(record: &Record<'_, '_>, at: Point) -> Result<core::result::Result<f64, What>> {
    let radius = record.real(40)?.unwrap_or(0.0);
    Ok(if radius > 0.0 {
        Ok(radius)
    } else if radius == 0.0 {
        Err(What::Ignored("its radius is 0: it is a point"))
    } else {
        Err(What::problem(
            Some(at),
            format!("its radius is {radius:?}"),
            "remove it, or give it a radius",
        ))
    })
}

pub(super) fn circle(record: &Record<'_, '_>) -> Result<What> {
    let center = record.point(10)?.0;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(center));
    };
    Ok(match radius(record, center)? {
        Ok(radius) => faced(Path::circle(center, radius), behind),
        Err(problem) => problem,
    })
}

pub(super) fn arc(record: &Record<'_, '_>) -> Result<What> {
    let center = record.point(10)?.0;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(center));
    };
    let radius = match radius(record, center)? {
        Ok(radius) => radius,
        Err(problem) => return Ok(problem),
    };
    let [from, to] = [50, 51].map(|c| record.real(c));
    let (from, to) = (from?.unwrap_or(0.0), to?.unwrap_or(360.0));
    let sweep = sweep(to - from, 360.0);
    if sweep == 360.0 {
        return Ok(faced(Path::circle(center, radius), behind));
    }
    let mut path = Path::from(center + direction(from) * radius);
    path.edge_to(
        center + direction(to) * radius,
        (sweep.to_radians() / 4.0).tan(),
    );
    Ok(faced(path, behind))
}

/// The direction of an angle in degrees; that of a right angle to the last bit.
pub(super) fn direction(degrees: f64) -> Vector {
    let turned = degrees.rem_euclid(360.0);
    let quarter = (turned / 90.0).round();
    let (sin, cos) = (turned - 90.0 * quarter).to_radians().sin_cos();
    match quarter as u8 % 4 {
        0 => Vector::new(cos, sin),
        1 => Vector::new(-sin, cos),
        2 => Vector::new(-cos, -sin),
        _ => Vector::new(sin, -cos),
    }
}

pub(super) fn ellipse(record: &Record<'_, '_>) -> Result<What> {
    let (center, _) = record.point(10)?;
    let (major, z) = record.point(11)?;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(center));
    };
    if heights_differ([0.0, z]) {
        return Ok(not_flat(center));
    }
    let u = major.to_vector();
    let ratio = record.real(40)?.unwrap_or(1.0);
    let v = if behind { u.right() } else { u.left() } * ratio;
    if u.cross(v) == 0.0 {
        return Ok(What::problem(
            Some(center),
            "an axis of it has no length",
            "remove it, or draw it as a line",
        ));
    }
    let [from, to] = [41, 42].map(|c| record.real(c));
    let (from, to) = (from?.unwrap_or(0.0), to?.unwrap_or(TAU));
    Ok(What::Path(ellipse_path(&EllipseArc {
        center,
        u,
        v,
        from,
        to: from + sweep(to - from, TAU),
    })))
}

/// The sweep, more than none and at most a turn; a whole turn where the angles say that but for their rounding.
fn sweep(angle: f64, turn: f64) -> f64 {
    /// Rounding of angles, in turns: no sweep is that small.
    const NONE: f64 = 1e-10;
    /// An arc that is shorter than a turn by less than this share counts as a full turn: closer ends would not
    /// determine the circle.
    const LESS: f64 = 1e-8;
    /// An arc that is longer than a turn by less than this share counts as a full turn: 2π written with five digits.
    /// Arcs end within a turn of their start.
    const MORE: f64 = 3e-6;
    let sweep = angle.rem_euclid(turn);
    let is_over = angle > turn && angle - turn < MORE * turn;
    if sweep < NONE * turn || turn - sweep < LESS * turn || is_over {
        turn
    } else {
        sweep
    }
}

/// An arc of an ellipse as a path; circles as the arcs they are.
pub(super) fn ellipse_path(arc: &EllipseArc) -> Path {
    let curve = Curve::Ellipse(*arc);
    let is_whole = (arc.to - arc.from).abs() >= TAU;
    if is_whole {
        let half = EllipseArc {
            to: arc.from + PI,
            ..*arc
        };
        if half.bulge().is_some() {
            return Path::circle(arc.center, arc.u.length());
        }
    }
    let mut path = Path::from(curve.start());
    path.closed = is_whole;
    match arc.bulge() {
        Some(bulge) => path.edge_to(curve.end(), bulge),
        None => path.pieces.push(Piece::Curve(Box::new(curve))),
    }
    path
}

pub(super) fn insert<'a>(record: &Record<'_, 'a>, names: &mut Names<'a>) -> Result<What> {
    let at = record.point(10)?.0;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(at));
    };
    let [sx, sy] = [41, 42].map(|c| record.real(c));
    let (sx, sy) = (sx?.unwrap_or(1.0), sy?.unwrap_or(1.0));
    let x = direction(record.real(50)?.unwrap_or(0.0));
    let front = if behind {
        Affine::MIRROR_X
    } else {
        Affine::IDENTITY
    };
    let map = front.after(&Affine {
        x: x * sx,
        y: x.left() * sy,
        origin: at,
    });
    if !map.is_usable() {
        return Ok(What::problem(
            Some(at),
            "its scale is zero or beyond computing",
            "give the block a scale of ordinary size",
        ));
    }
    let count = |code| -> Result<u32> {
        let count = record.integer(code)?.unwrap_or(1).max(1);
        Ok(u32::try_from(count).unwrap_or(u32::MAX))
    };
    let [columns, rows] = [44, 45].map(|c| record.real(c));
    Ok(What::Insert(Box::new(Insert {
        block: names.get(record.text(2)),
        map,
        steps: [
            front.vector(x * columns?.unwrap_or(0.0)),
            front.vector(x.left() * rows?.unwrap_or(0.0)),
        ],
        counts: [count(70)?, count(71)?],
    })))
}
