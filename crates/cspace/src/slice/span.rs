//! How far curves and gaps extend along x and y.
//!
//! Every place of a contact curve is touched or blocked, so the outermost one bounds free space: what is free reaches as
//! far as all curves do.

use crate::contact::CurveShape;
use crate::geometry::{Point, Vector};

use super::cut::Live;

/// The least and the greatest x and y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    lo: Point,
    hi: Point,
}

impl Span {
    pub(super) const NOTHING: Self = Self {
        lo: Point::new(f64::INFINITY, f64::INFINITY),
        hi: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    fn of(points: impl IntoIterator<Item = Point>) -> Self {
        let with = |s: Self, p: Point| s.and(Self { lo: p, hi: p });
        points.into_iter().fold(Self::NOTHING, with)
    }

    pub(super) fn and(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self {
            lo: Point::new(a.lo.x.min(b.lo.x), a.lo.y.min(b.lo.y)),
            hi: Point::new(a.hi.x.max(b.hi.x), a.hi.y.max(b.hi.y)),
        }
    }

    /// No more than a curve extends: exact but for the height of a large arc.
    pub(super) fn of_curve(live: &Live) -> Self {
        match live.curve.shape {
            CurveShape::FlatArc(_) => Self::of([live.curve.start, live.curve.end]),
            _ => Self {
                lo: live.lo,
                hi: live.hi,
            },
        }
    }

    /// No less than a gap extends.
    pub(super) fn of_gap(live: &Live, gap: usize) -> Self {
        let whole = Self {
            lo: live.lo,
            hi: live.hi,
        };
        if live.cuts.is_empty() {
            return whole;
        }
        let (from, to) = live.gap_range(gap);
        let ends = Self::of([live.curve.point(from), live.curve.point(to)]);
        match live.curve.shape {
            CurveShape::Line { .. } => ends,
            CurveShape::FlatArc(_) => whole,
            CurveShape::Circle { center, radius, .. } => {
                let r = radius.abs();
                let axes = [(r, 0.0), (-r, 0.0), (0.0, r), (0.0, -r)];
                let extremes = axes.map(|(x, y)| center + Vector::new(x, y));
                let within = |p: &Point| (from..=to).contains(&live.curve.position(*p));
                ends.and(Self::of(extremes.into_iter().filter(within)))
            }
        }
    }

    /// Whether it reaches as far as another on every side, but for a distance.
    pub(super) fn reaches(&self, other: &Self, slack: f64) -> bool {
        self.lo.x <= other.lo.x + slack
            && self.lo.y <= other.lo.y + slack
            && self.hi.x >= other.hi.x - slack
            && self.hi.y >= other.hi.y - slack
    }
}
