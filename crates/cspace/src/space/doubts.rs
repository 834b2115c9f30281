//! Doubtful orientations, at which the patches alone do not decide, as intervals.

use core::f64::consts::{PI, TAU};

use crate::feature::tolerance::NARROWEST_BAND;

use super::options::Window;

/// Reduces intervals to a window and unites them: for a full turn to [−π, π] by whole turns, otherwise by cutting them at the window's
/// ends.
pub(crate) fn in_window(
    intervals: impl IntoIterator<Item = (f64, f64)>,
    window: Window,
) -> Vec<(f64, f64)> {
    let mut all = Vec::new();
    for (lo, hi) in intervals {
        // Margin for the rounding of turns and of copies by symmetry.
        let (lo, hi) = (lo - NARROWEST_BAND, hi + NARROWEST_BAND);
        if !window.full_turn {
            all.push((lo.max(window.lo), hi.min(window.hi)));
        } else if hi - lo >= TAU {
            all.push((-PI, PI));
        } else {
            let turns = TAU * ((lo + PI) / TAU).floor();
            let (lo, hi) = (lo - turns, hi - turns);
            all.push((lo, hi.min(PI)));
            if hi > PI {
                all.push((-PI, hi - TAU));
            }
        }
    }
    all.retain(|&(lo, hi)| lo <= hi);
    union(all)
}

/// Disjoint intervals of orientation, radians, in ascending order; for a full turn in [−π, π].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Doubts<'a> {
    pub(super) intervals: &'a [(f64, f64)],
    pub(super) full_turn: bool,
}

impl Doubts<'_> {
    /// Whether an orientation is in one of the intervals.
    pub(crate) fn hold(&self, theta: f64) -> bool {
        self.hold_among(theta, 0..self.intervals.len())
    }

    /// Whether an orientation is in one of the intervals whose indices are in `near`.
    #[inline]
    pub(crate) fn hold_among(&self, theta: f64, near: core::ops::Range<usize>) -> bool {
        let Some(near) = self.intervals.get(near).filter(|near| !near.is_empty()) else {
            return false;
        };
        let t = if self.full_turn && !(-PI..=PI).contains(&theta) {
            (theta - TAU * ((theta + PI) / TAU).floor()).clamp(-PI, PI)
        } else {
            theta
        };
        let next = near.partition_point(|i| i.1 < t);
        near.get(next).is_some_and(|i| i.0 <= t)
    }
}

/// Union of intervals of orientation as disjoint intervals, in ascending order.
pub(crate) fn union(mut intervals: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    intervals.sort_by(|a, b| a.0.total_cmp(&b.0));
    intervals.dedup_by(|b, a| {
        let follows = b.0 <= a.1;
        if follows {
            a.1 = a.1.max(b.1);
        }
        follows
    });
    intervals
}

#[cfg(test)]
mod tests {
    use super::*;

    const TURN: Window = Window {
        lo: -1.0,
        hi: -1.0 + TAU,
        full_turn: true,
    };

    #[test]
    fn intervals_are_joined_and_brought_home() {
        let intervals = in_window([(0.5, 0.7), (TAU + 0.6, TAU + 0.8), (3.0, 3.3)], TURN);
        let doubts = Doubts {
            intervals: &intervals,
            full_turn: TURN.full_turn,
        };
        let expected = [(-PI, 3.3 - TAU), (0.5, 0.8), (3.0, PI)];
        assert_eq!(intervals.len(), expected.len());
        for (found, expected) in intervals.iter().zip(expected) {
            let off = (found.0 - expected.0).abs() + (found.1 - expected.1).abs();
            assert!(off < 4.0 * NARROWEST_BAND, "{found:?} {expected:?}");
        }
        for turns in [-2.0, 0.0, 5.0] {
            let at = |theta: f64| doubts.hold(theta + turns * TAU);
            assert!(at(0.75) && at(3.2) && at(-3.0) && at(PI), "{turns}");
            assert!(!at(0.9) && !at(0.4) && !at(-2.9), "{turns}");
        }
    }

    #[test]
    fn a_window_keeps_its_own() {
        let window = Window {
            lo: 4.0,
            hi: 5.0,
            full_turn: false,
        };
        let intervals = in_window([(3.0, 3.5), (3.9, 4.1), (4.9, 6.0)], window);
        let doubts = Doubts {
            intervals: &intervals,
            full_turn: window.full_turn,
        };
        assert_eq!(intervals.len(), 2);
        assert!(doubts.hold(4.05) && doubts.hold(4.0) && doubts.hold(5.0));
        assert!(!doubts.hold(4.5) && !doubts.hold(4.05 - TAU));
    }

    #[test]
    fn all_of_a_turn_is_all() {
        assert_eq!(in_window([(0.0, TAU)], TURN), [(-PI, PI)]);
        assert!(in_window([], TURN).is_empty());
    }
}
