//! The section of free space at one value of the swept coordinate: the cells of a plane that lie in a rectangle.
//!
//! The rectangle is a free interval of p by one of q; the plane is that of the pair that the swept coordinate does not move.

use core::f64::consts::TAU;
use core::ops::RangeInclusive;

use crate::modes::plane::{Plane, turns_onto};
use crate::modes::roots::sign_change;

/// A gap of the plane (p, q), and in which turn of both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    pub(crate) band: u32,
    pub(crate) gap: u32,
    pub(crate) p_turns: i32,
    pub(crate) q_turns: i32,
}

/// An interval, or `None` for a full turn.
pub(crate) type Interval = Option<(f64, f64)>;

impl Plane {
    /// The bands that an interval of x comes over, with the turns that bring them there, in order; of a full turn all, in their own.
    pub(crate) fn bands_over(&self, x: Interval) -> Vec<(usize, i32)> {
        let Some((lo, hi)) = x else {
            return (0..self.bands.len()).map(|b| (b, 0)).collect();
        };
        let mut all = Vec::new();
        for turns in turns_onto(self.x.circle, (self.x.lo, self.x.hi), (lo, hi)) {
            let by = TAU * f64::from(turns);
            let first = self.bands.partition_point(|b| b.hi + by <= lo);
            let over = self.bands[first..]
                .iter()
                .take_while(|b| b.lo + by < hi)
                .count();
            all.extend((first..first + over).map(|b| (b, turns)));
        }
        all
    }

    /// The turns in which a gap, over its band, may be in an interval of y; of a full turn its own.
    pub(crate) fn turns_of(&self, band: usize, gap: usize, y: Interval) -> RangeInclusive<i32> {
        match (self.span(gap), y) {
            (Some(span), Some(y)) => {
                let over = (self.bands[band].lo, self.bands[band].hi);
                self.shifts(span.hull(over), y)
            }
            _ => 0..=0,
        }
    }

    /// Interval of p in which a gap lies in a rectangle; `None` if there is none.
    pub(crate) fn within(&self, at: Place, p: Interval, q: Interval) -> Option<(f64, f64)> {
        let by = TAU * f64::from(at.p_turns);
        let band = &self.bands[at.band as usize];
        let (mut lo, mut hi) = (band.lo, band.hi);
        if let Some((from, to)) = p {
            (lo, hi) = (lo.max(from - by), hi.min(to - by));
        }
        if lo >= hi || q.is_some_and(|(c, d)| c >= d) {
            return None;
        }
        if let (Some((c, d)), Some(span)) = (q, self.span(at.gap as usize)) {
            let span = span.turned(at.q_turns);
            restrict((&mut lo, &mut hi), |x| span.upper.at(x) - c)?;
            restrict((&mut lo, &mut hi), |x| d - span.lower.at(x))?;
        }
        (lo < hi).then_some((lo + by, hi + by))
    }

    /// As [`within`](Self::within); if the gap does not enter the rectangle, the place at which it is nearest to it.
    pub(crate) fn about(&self, at: Place, p: Interval, q: Interval) -> (f64, f64) {
        let by = TAU * f64::from(at.p_turns);
        let band = &self.bands[at.band as usize];
        let (mut lo, mut hi) = (band.lo, band.hi);
        if let Some((from, to)) = p {
            let bounds = (lo, hi);
            let into = |t: f64| (t - by).clamp(bounds.0, bounds.1);
            (lo, hi) = (into(from), into(to).max(into(from)));
        }
        if let (Some((c, d)), Some(span)) = (q, self.span(at.gap as usize)) {
            let span = span.turned(at.q_turns);
            let above = |x: f64| span.upper.at(x) - c;
            let below = |x: f64| d - span.lower.at(x);
            for f in [&above as &dyn Fn(f64) -> f64, &below] {
                if restrict((&mut lo, &mut hi), f).is_none() {
                    let nearest = if f(lo) > f(hi) { lo } else { hi };
                    (lo, hi) = (nearest, nearest);
                }
            }
        }
        (lo + by, hi + by)
    }
}

/// Restricts an interval to where a monotone function is positive; `None` where it is nowhere.
fn restrict((lo, hi): (&mut f64, &mut f64), f: impl Fn(f64) -> f64) -> Option<()> {
    match (f(*lo) > 0.0, f(*hi) > 0.0) {
        (true, true) => Some(()),
        (false, false) => None,
        (from_lo, _) => {
            let at = sign_change(f, (*lo, *hi))?;
            *(if from_lo { hi } else { lo }) = at;
            Some(())
        }
    }
}
