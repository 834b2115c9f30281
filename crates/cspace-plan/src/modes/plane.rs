//! Plane of two of the three coordinates: bands of free gaps, or all free if there is no such pair.

use core::f64::consts::TAU;
use core::ops::Range;

use cspace::fixed_axes::{PlaneBand, PlaneGap, SweptPlane};

use crate::modes::extent::Extent;
use crate::modes::graph::{Graph, Span};

/// A plane, swept along x.
#[derive(Debug)]
pub(crate) struct Plane {
    swept: Option<SweptPlane>,
    pub(crate) bands: Vec<PlaneBand>,
    pub(crate) x: Extent,
    pub(crate) y: Extent,
}

/// Interval of y in which one gap is connected with another, or with itself in the next band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Opening {
    pub(crate) from: usize,
    pub(crate) to: usize,
    /// The stretch, where `from` is.
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Turns by which `to` has to be moved to be adjacent to `from`.
    pub(crate) turns: i32,
}

impl Plane {
    /// Plane of a computed pair.
    pub(crate) fn of(swept: SweptPlane) -> Self {
        let openings = swept.smallest_openings();
        let extent = |((lo, hi), circle): ((f64, f64), bool), opening: f64| Extent {
            lo,
            hi,
            circle,
            opening,
            narrowest: swept.narrowest_band() / openings.0 * opening,
        };
        Self {
            x: extent(swept.x(), openings.0),
            y: extent(swept.y(), openings.1),
            bands: swept.bands().collect(),
            swept: Some(swept),
        }
    }

    /// A plane that is free everywhere.
    pub(crate) fn free(x: Extent, y: Extent) -> Self {
        let (lo, hi) = (x.lo, x.hi);
        Self {
            swept: None,
            bands: vec![PlaneBand { lo, hi, gaps: 0..1 }],
            x,
            y,
        }
    }

    /// Copy with other extents of its coordinates.
    pub(crate) fn with(self, x: Extent, y: Extent) -> Self {
        Self { x, y, ..self }
    }

    /// Places at which the partition contradicts itself.
    pub(crate) fn conflicts(&self) -> usize {
        self.swept.as_ref().map_or(0, SweptPlane::conflicts)
    }

    /// The band that holds a value of x, or the nearest.
    pub(crate) fn band_at(&self, x: f64) -> usize {
        let after = self.bands.partition_point(|b| b.hi < x);
        after.min(self.bands.len() - 1)
    }

    /// The interval of y that a gap is; `None` of a full turn.
    pub(crate) fn span(&self, gap: usize) -> Option<Span<'_>> {
        let found = self.swept.as_ref().map(|s| s.gap(gap));
        let PlaneGap { lower, upper } = found.unwrap_or_default();
        if self.y.circle && (lower.is_none() || upper.is_none()) {
            return None;
        }
        let end = |curve, limit| match (&self.swept, curve) {
            (Some(swept), Some(curve)) => Graph::curve(swept, curve),
            _ => Graph::level(limit),
        };
        Some(Span {
            lower: end(lower, self.y.lo),
            upper: end(upper, self.y.hi),
        })
    }

    /// Interval of gap `gap` at x; a full turn from the minimum to the maximum y.
    pub(crate) fn interval(&self, gap: usize, x: f64) -> (f64, f64) {
        (self.span(gap)).map_or((self.y.lo, self.y.hi), |s| s.at(x))
    }

    fn walls(&self, bands: Range<usize>) -> Vec<(f64, f64)> {
        let Some(swept) = &self.swept else {
            return Vec::new();
        };
        bands.flat_map(|k| swept.walls(k)).collect()
    }

    /// Openings between the gaps of a band, at x, and those of another adjacent one, at its x. The space between the
    /// bands is passed if it is not closed by a contact that does not depend on y.
    pub(crate) fn openings(&self, from: (usize, f64), to: (usize, f64)) -> Vec<Opening> {
        let mut openings = Vec::new();
        if from.0 == to.0 && from.1 <= to.1 {
            for gap in self.bands[from.0].gaps.clone() {
                let (lo, hi) = self.interval(gap, 0.5 * (from.1 + to.1));
                self.add(&mut openings, (gap, gap, 0), (lo, hi), &[]);
            }
            return openings;
        }
        let walls = if from.0 < to.0 {
            self.walls(from.0..to.0)
        } else {
            let mut around = self.walls(from.0..self.bands.len());
            around.extend(self.walls(0..to.0));
            around
        };
        for a in self.bands[from.0].gaps.clone() {
            let (p, q) = self.interval(a, from.1);
            for b in self.bands[to.0].gaps.clone() {
                let (r, s) = self.interval(b, to.1);
                for turns in self.shifts((r, s), (p, q)) {
                    let by = TAU * f64::from(turns);
                    let shared = (p.max(r + by), q.min(s + by));
                    self.add(&mut openings, (a, b, turns), shared, &walls);
                }
            }
        }
        openings
    }

    /// Adds what walls leave open of a stretch.
    fn add(
        &self,
        openings: &mut Vec<Opening>,
        (from, to, turns): (usize, usize, i32),
        (lo, hi): (f64, f64),
        walls: &[(f64, f64)],
    ) {
        let mut closed: Vec<(f64, f64)> = Vec::new();
        for &wall in walls {
            for k in self.shifts(wall, (lo, hi)) {
                let by = TAU * f64::from(k);
                closed.push((wall.0 + by, wall.1 + by));
            }
        }
        closed.sort_by(|a, b| a.0.total_cmp(&b.0));
        closed.push((hi, hi));
        let mut at = lo;
        for (wall, beyond) in closed {
            let closed = 0.5 * self.y.opening;
            let (lo, hi) = (at + closed, wall.min(hi) - closed);
            if lo < hi {
                openings.push(Opening {
                    from,
                    to,
                    lo,
                    hi,
                    turns,
                });
            }
            at = at.max(beyond);
        }
    }

    /// The turns that bring an interval of y onto another, in part or whole: of a coordinate that is not a circle none.
    pub(crate) fn shifts(
        &self,
        (r, s): (f64, f64),
        (p, q): (f64, f64),
    ) -> core::ops::RangeInclusive<i32> {
        turns_onto(self.y.circle, (r, s), (p, q))
    }
}

/// The turns that bring an interval onto another, in part or whole: none if the coordinate is not a circle.
pub(crate) fn turns_onto(
    circle: bool,
    (r, s): (f64, f64),
    (p, q): (f64, f64),
) -> core::ops::RangeInclusive<i32> {
    if circle {
        ((p - s) / TAU).ceil() as i32..=((q - r) / TAU).floor() as i32
    } else {
        0..=0
    }
}
