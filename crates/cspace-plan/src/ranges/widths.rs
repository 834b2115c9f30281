//! The least and the largest distance of two curves over an interval.
//!
//! By branch and bound: over an interval each curve is monotone, so that the distance is bounded by their ends, and its slope is enclosed, so
//! that it is bounded by that at the middle and the slope times half of the interval. The second bound is as far off as the square of the
//! interval is long.

use cspace::fixed_axes::{PlaneCurve, SweptPlane};

/// So many intervals are looked at before extremes are known to less.
const EFFORT: usize = 200_000;
/// Then to so much less.
const COARSER: f64 = 10.0;

/// An extreme with its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Extreme {
    pub(super) x: f64,
    pub(super) width: f64,
}

/// The two curves beside a gap over its band.
pub(super) struct Between<'a> {
    pub(super) plane: &'a SweptPlane,
    pub(super) lower: PlaneCurve,
    pub(super) upper: PlaneCurve,
    pub(super) band: (f64, f64),
}

impl Between<'_> {
    fn width(&self, x: f64) -> f64 {
        self.plane.value(self.upper, x) - self.plane.value(self.lower, x)
    }

    /// A bound of the width from above over an interval, of `sign` times it.
    fn most(&self, (lo, hi): (f64, f64), sign: f64) -> f64 {
        let ends = |curve| [lo, hi].map(|x| sign * self.plane.value(curve, x));
        let ([a, b], [c, d]) = (ends(self.upper), ends(self.lower));
        let by_ends = a.max(b) - c.min(d);
        let slope = self.plane.slope(self.upper, (lo, hi)) - self.plane.slope(self.lower, (lo, hi));
        let steepest = slope.mid.abs() + slope.radius;
        let by_slope = sign * self.width(0.5 * (lo + hi)) + 0.5 * (hi - lo) * steepest;
        // Not a number where nothing is known of the slope.
        if by_slope < by_ends {
            by_slope
        } else {
            by_ends
        }
    }

    /// The largest of `sign` times the width over the band if it exceeds what is known, right to `exact`.
    pub(super) fn largest(&self, sign: f64, known: Option<Extreme>, exact: f64) -> Option<Extreme> {
        let at = |x: f64| Extreme {
            x,
            width: sign * self.width(x),
        };
        let (from, to) = self.band;
        let mut best = known;
        let take = |found: Extreme, best: &mut Option<Extreme>| {
            if best.is_none_or(|b| found.width > b.width) {
                *best = Some(found);
            }
        };
        for x in [from, to] {
            take(at(x), &mut best);
        }
        let mut stack = vec![(from, to)];
        let (mut exact, mut effort) = (exact, 0);
        while let Some((lo, hi)) = stack.pop() {
            effort += 1;
            if effort % EFFORT == 0 {
                exact *= COARSER;
            }
            let middle = 0.5 * (lo + hi);
            take(at(middle), &mut best);
            let enough = best.map_or(f64::NEG_INFINITY, |b| b.width) + exact;
            if lo < middle && middle < hi && self.most((lo, hi), sign) > enough {
                stack.extend([(lo, middle), (middle, hi)]);
            }
        }
        best
    }
}
