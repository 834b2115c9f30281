//! How far curves and gaps extend along x and y.
//!
//! Every place of a contact curve is touched or blocked, so the outermost one bounds free space: what is free reaches as
//! far as all curves do.

use crate::contact::CurveShape;
use crate::geometry::{Point, Vector};
use crate::part::Bounds;

use super::cut::Live;

/// The box of some points.
fn of(points: impl IntoIterator<Item = Point>) -> Bounds {
    let with = |all: Bounds, p: Point| all.union(Bounds::of(p, p));
    points.into_iter().fold(Bounds::EMPTY, with)
}

/// No more than a curve extends: exact but for the height of a flat arc.
pub(super) fn of_curve(live: &Live) -> Bounds {
    match live.curve.shape {
        CurveShape::FlatArc(_) => Bounds::of(live.curve.start, live.curve.end),
        _ => live.bounds,
    }
}

/// No less than a gap extends.
pub(super) fn of_gap(live: &Live, gap: usize) -> Bounds {
    if live.cuts.is_empty() {
        return live.bounds;
    }
    let (from, to) = live.gap_range(gap);
    let ends = Bounds::of(live.curve.point(from), live.curve.point(to));
    match live.curve.shape {
        CurveShape::Line { .. } => ends,
        CurveShape::FlatArc(_) => live.bounds,
        CurveShape::Circle { center, radius, .. } => {
            let r = radius.abs();
            let axes = [(r, 0.0), (-r, 0.0), (0.0, r), (0.0, -r)];
            let extremes = axes.map(|(x, y)| center + Vector::new(x, y));
            let within = |p: &Point| (from..=to).contains(&live.curve.position(*p));
            ends.union(of(extremes.into_iter().filter(within)))
        }
    }
}

/// Whether a box reaches as far as another on every side, but for a distance.
pub(super) fn reaches(inner: Bounds, outer: Bounds, slack: f64) -> bool {
    inner.min.x <= outer.min.x + slack
        && inner.min.y <= outer.min.y + slack
        && inner.max.x >= outer.max.x - slack
        && inner.max.y >= outer.max.y - slack
}
