//! A cell of free space: where it is along each coordinate.

use core::f64::consts::TAU;

use crate::modes::column::Column;
use crate::modes::section::Place;

/// Cell of a column over a layer. Its values are the original ones, not narrowed by the smallest openings.
pub(crate) struct Shape<'a> {
    pub(crate) column: Column<'a>,
    pub(crate) place: Place,
    pub(crate) s: (f64, f64),
}

/// Number of golden-section steps for a maximum: to 2·10⁻¹² of the interval's width.
const DIVISIONS: u32 = 56;
/// Distance from an end, as a share of the interval, at which it is checked whether a function rises from there on:
/// about 1.5·10⁻¹¹.
const BESIDE: f64 = 1.0 / (1u64 << 36) as f64;

/// The maximum over an interval of a function that rises up to there and falls from there on.
fn maximum(f: impl Fn(f64) -> f64, (mut lo, mut hi): (f64, f64)) -> f64 {
    const SECTION: f64 = 0.618_033_988_749_894_9;
    let (at_lo, at_hi) = (f(lo), f(hi));
    let mut best = at_lo.max(at_hi);
    let beside = BESIDE * (hi - lo);
    if f(lo + beside) <= at_lo || f(hi - beside) <= at_hi {
        return best;
    }
    let mut left = hi - SECTION * (hi - lo);
    let mut right = lo + SECTION * (hi - lo);
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..DIVISIONS {
        if at_left.max(at_right) <= best && at_left == at_right {
            break;
        }
        best = best.max(at_left).max(at_right);
        if at_left > at_right {
            hi = right;
            (right, at_right) = (left, at_left);
            left = hi - SECTION * (hi - lo);
            at_left = f(left);
        } else {
            lo = left;
            (left, at_left) = (right, at_right);
            right = lo + SECTION * (hi - lo);
            at_right = f(right);
        }
    }
    best
}

impl Shape<'_> {
    /// Range of p at a value of s.
    pub(crate) fn p(&self, s: f64) -> (f64, f64) {
        let p = self.column.p.map(|p| p.at(s));
        let q = self.column.q.map(|q| q.at(s));
        self.column.plane.about(self.place, p, q)
    }

    /// Range of q at values of s and p of the cell.
    pub(crate) fn q_at(&self, s: f64, p: f64) -> (f64, f64) {
        let (lo, hi) = self.q_between(s, p);
        (lo, hi.max(lo))
    }

    /// Range of q at any values of s and p; empty if the first number is larger.
    fn q_between(&self, s: f64, p: f64) -> (f64, f64) {
        let q = self.column.q.map(|q| q.at(s));
        match (q, self.gap(p)) {
            (Some(q), Some(gap)) => (q.0.max(gap.0), q.1.min(gap.1)),
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => (self.column.plane.y.lo, self.column.plane.y.hi),
        }
    }

    /// The gap of the plane of p and q at a value of p.
    fn gap(&self, p: f64) -> Option<(f64, f64)> {
        let x = p - TAU * f64::from(self.place.p_turns);
        let span = self.column.plane.span(self.place.gap as usize);
        span.map(|g| g.turned(self.place.q_turns).at(x))
    }

    /// Range of q at a value of p over some values of s, at the ends of which it may be empty: ends are monotone, so
    /// where the range first becomes non-empty it begins at an end of the gap.
    pub(crate) fn q_along(&self, (from, to): (f64, f64), p: f64) -> (f64, f64) {
        let (a, b) = (self.q_between(from, p), self.q_between(to, p));
        let (lo, hi) = (a.0.min(b.0), a.1.max(b.1));
        match self.gap(p) {
            Some(gap) => (lo.max(gap.0), hi.min(gap.1)),
            None => (lo, hi),
        }
    }

    /// Range of q at a value of s: ends of gaps are monotone, so they are extreme at the ends of p.
    pub(crate) fn q(&self, s: f64) -> (f64, f64) {
        let (from, to) = self.p(s);
        let (a, b) = (self.q_at(s, from), self.q_at(s, to));
        (a.0.min(b.0), a.1.max(b.1))
    }

    /// Minimum and maximum p. Ends are the minimum or maximum of monotone functions: they rise and then fall, or fall
    /// and then rise.
    pub(crate) fn p_range(&self) -> (f64, f64) {
        self.range(|s| self.p(s))
    }

    /// Minimum and maximum q.
    pub(crate) fn q_range(&self) -> (f64, f64) {
        self.range(|s| self.q(s))
    }

    fn range(&self, at: impl Fn(f64) -> (f64, f64)) -> (f64, f64) {
        (-maximum(|s| -at(s).0, self.s), maximum(|s| at(s).1, self.s))
    }

    /// Lower and upper bounds of all p and all q, computed together.
    pub(crate) fn hulls(&self) -> [(f64, f64); 2] {
        let plane = self.column.plane;
        let band = &plane.bands[self.place.band as usize];
        let by = TAU * f64::from(self.place.p_turns);
        let mut p = (band.lo + by, band.hi + by);
        if let Some(own) = self.column.p.map(|p| p.hull(self.s)) {
            p = (p.0.max(own.0), p.1.min(own.1));
        }
        let gap = plane.span(self.place.gap as usize);
        let gap = gap.map(|g| g.turned(self.place.q_turns).hull((band.lo, band.hi)));
        let own = self.column.q.map(|q| q.hull(self.s));
        let q = match (own, gap) {
            (Some(a), Some(b)) => (a.0.max(b.0), a.1.min(b.1)),
            (Some(one), None) | (None, Some(one)) => one,
            (None, None) => (plane.y.lo, plane.y.hi),
        };
        [p, q]
    }
}
