//! Intervals of orientations.

use core::f64::consts::{FRAC_PI_2, TAU};

use cspace::Rotation;

use super::tolerance::BEYOND;

/// The orientations of a contact: `width` radians from `lo`, modulo a turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    lo: f64,
    width: f64,
}

/// An interval of less than half a turn on which conditions are polynomials in tan((θ − middle) / 2).
#[derive(Debug, Clone, Copy)]
pub(super) struct Interval {
    middle: f64,
    /// The rotation by the middle.
    pub(super) turn: Rotation,
    /// Tangent of a quarter of the width.
    pub(super) tangent: f64,
}

impl Interval {
    fn new(lo: f64, hi: f64) -> Self {
        let middle = 0.5 * (lo + hi);
        Self {
            middle,
            turn: Rotation::by(middle),
            tangent: (0.25 * (hi - lo)).tan(),
        }
    }

    /// The orientation at a place s in [−1, 1].
    pub(super) fn theta(&self, s: f64) -> f64 {
        self.middle + 2.0 * (self.tangent * s).atan()
    }
}

impl Span {
    /// A little beyond both ends.
    pub(super) fn new(lo: f64, width: f64) -> Self {
        let lo = lo - BEYOND;
        Self {
            lo: lo - TAU * (lo / TAU).floor(),
            width: (width + 2.0 * BEYOND).min(TAU),
        }
    }

    pub(super) fn contains(&self, theta: f64) -> bool {
        let above = theta - self.lo;
        above - TAU * (above / TAU).floor() <= self.width
    }

    /// Intersection of two spans: none, one or two spans.
    pub(super) fn common(&self, other: &Self) -> [Option<Self>; 2] {
        let mut found = [None; 2];
        let mut free = found.iter_mut();
        for turn in [-TAU, 0.0, TAU] {
            let lo = self.lo.max(other.lo + turn);
            let hi = (self.lo + self.width).min(other.lo + turn + other.width);
            // Two full turns have one in common, found thrice.
            let new = hi > lo && (turn == 0.0 || self.width < TAU || other.width < TAU);
            if new && let Some(place) = free.next() {
                *place = Some(Self { lo, width: hi - lo });
            }
        }
        found
    }

    /// Calls `take` with intervals of at most half a turn that make it up.
    pub(super) fn intervals(&self, mut take: impl FnMut(&Interval)) {
        let pieces = (self.width / (2.0 * FRAC_PI_2)).ceil().max(1.0);
        let step = self.width / pieces;
        for k in 0..pieces as u32 {
            let lo = self.lo + f64::from(k) * step;
            take(&Interval::new(lo, lo + step));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_spans_are_found_around_the_turn() {
        let common = |a: Span, b: Span| {
            let widths = a.common(&b).into_iter().flatten().map(|s| s.width);
            widths.collect::<Vec<_>>()
        };
        let span = Span::new;
        assert!(common(span(0.1, 1.0), span(2.0, 1.0)).is_empty());
        let one = common(span(6.0, 1.0), span(0.2, 1.0));
        assert!(one.len() == 1 && (one[0] - (7.0 - TAU - 0.2)).abs() < 1e-5);
        // Both ends of a wide span reach into another.
        let two = common(span(0.5, 6.0), span(6.0, 1.0));
        assert!(two.len() == 2, "{two:?}");
        assert!((two.iter().sum::<f64>() - (0.5 + (7.0 - TAU - 0.5))).abs() < 1e-5);
        assert_eq!(common(span(1.0, TAU), span(4.0, TAU)).len(), 1);
    }

    #[test]
    fn places_are_orientations() {
        let span = Span::new(1.0, 4.0);
        let mut ends = Vec::new();
        span.intervals(|i| ends.extend([i.theta(-1.0), i.theta(1.0)]));
        assert_eq!(ends.len(), 4);
        assert!((ends[0] - 1.0).abs() < 1e-5 && (ends[3] - 5.0).abs() < 1e-5);
        assert!((ends[1] - ends[2]).abs() < 1e-12);
    }
}
