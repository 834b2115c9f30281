//! Minimum of a function of one number by branch and bound, and bisection for a change of sign.

use core::cmp::Reverse;
use std::collections::BinaryHeap;

/// Absolute accuracy of a minimum (the function's unit, about 7.3e-12): the accuracy of contacts.
const ACCURACY: f64 = 1.0 / (1u64 << 37) as f64;
/// Relative accuracy of a minimum: above the rounding of large values.
const SHARE: f64 = 1e-12;
/// Length below which intervals are not halved (radians, or lengths of a pair's frame, about 5.7e-14): over a shorter one, distances change
/// by less than [`ACCURACY`], and a value hidden by rounding, as where a curve begins, is not revealed by halving.
pub(crate) const NARROWEST: f64 = 1.0 / (1u64 << 44) as f64;

/// A non-negative function, with bounds over intervals.
pub(crate) trait Bounded {
    /// Value of the function.
    fn at(&self, t: f64) -> f64;

    /// A lower bound of the function in the interior of the interval; ∞ if its minimum is at an end.
    fn below(&self, lo: f64, hi: f64) -> f64;
}

/// Halves an interval so that `is_below` stays true at its lower end and false at its upper one, until it is no wider than `narrowest` or
/// no number lies between its ends.
pub(crate) fn halved(
    (mut lo, mut hi): (f64, f64),
    narrowest: f64,
    is_below: impl Fn(f64) -> bool,
) -> (f64, f64) {
    loop {
        let mid = 0.5 * (lo + hi);
        // Also if one of them is NaN.
        if !(hi - lo > narrowest && lo < mid && mid < hi) {
            return (lo, hi);
        }
        if is_below(mid) {
            lo = mid;
        } else {
            hi = mid;
        }
    }
}

/// The minimum over an interval and its place; `None` if it is not below `known`.
///
/// The part of the interval with the lowest bound is halved, until no part can have a value lower than the smallest one found by
/// [`ACCURACY`] and [`SHARE`] of it.
pub(crate) fn least(f: &impl Bounded, (lo, hi): (f64, f64), known: f64) -> Option<(f64, f64)> {
    let mut best = (lo, known);
    let look = |t: f64, best: &mut (f64, f64)| {
        let value = f.at(t);
        if value < best.1 {
            *best = (t, value);
        }
    };
    look(lo, &mut best);
    look(hi, &mut best);
    // Non-negative numbers have the order of their bits.
    let mut parts = vec![(lo, hi)];
    let mut waiting = BinaryHeap::from([Reverse((0, 0))]);
    while let Some(Reverse((bits, number))) = waiting.pop() {
        let enough = best.1 * (1.0 - SHARE) - ACCURACY;
        if f64::from_bits(bits) >= enough {
            break;
        }
        let (lo, hi): (f64, f64) = parts[number];
        let mid = 0.5 * (lo + hi);
        if hi - lo <= NARROWEST || mid <= lo || mid >= hi {
            continue;
        }
        look(mid, &mut best);
        for part in [(lo, mid), (mid, hi)] {
            let below = f.below(part.0, part.1).max(0.0);
            if below < best.1 {
                waiting.push(Reverse((below.to_bits(), parts.len())));
                parts.push(part);
            }
        }
    }
    (best.1 < known).then_some(best)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::{Ball, Dual, Real};
    use super::*;

    /// 2 + cos 5t + cos(a t), which has several minima.
    struct Waves(f64);

    impl Waves {
        fn over(&self, t: Ball) -> Dual<1, Ball> {
            let t = Dual::variable(t, 0);
            let wave = |rate: f64| (t * Dual::constant(rate)).sin_cos().1;
            Dual::constant(2.0) + wave(5.0) + wave(self.0)
        }
    }

    impl Bounded for Waves {
        fn at(&self, t: f64) -> f64 {
            2.0 + (5.0 * t).cos() + (self.0 * t).cos()
        }

        fn below(&self, lo: f64, hi: f64) -> f64 {
            let over = self.over(Ball::between(lo, hi));
            if over.slope[0].sign() != 0 {
                return f64::INFINITY;
            }
            over.value.mid - over.value.radius
        }
    }

    #[test]
    fn no_sample_is_lower() {
        for rate in [0.3, 1.7, 4.0, 4.9] {
            let f = Waves(rate);
            let (lo, hi) = (-0.7, 9.1);
            let (t, value) = least(&f, (lo, hi), f64::INFINITY).unwrap();
            assert!((lo..=hi).contains(&t) && f.at(t) == value);
            let n = 20_000;
            let sampled = (0..=n)
                .map(|i| f.at(lo + (hi - lo) * f64::from(i) / f64::from(n)))
                .fold(f64::INFINITY, f64::min);
            assert!(value <= sampled + ACCURACY + 2.0 * SHARE, "{rate}");
            assert!(value > sampled - 1e-4, "{rate}");
            assert_eq!(least(&f, (lo, hi), value), None);
        }
    }

    /// t² + 1, for which there is no bound close to 0, where floating-point numbers are dense.
    struct Hidden(core::cell::Cell<u32>);

    impl Bounded for Hidden {
        fn at(&self, t: f64) -> f64 {
            t * t + 1.0
        }

        fn below(&self, lo: f64, hi: f64) -> f64 {
            self.0.set(self.0.get() + 1);
            if lo < 1e-13 && hi > -1e-13 { 0.0 } else { 1.0 }
        }
    }

    #[test]
    fn what_is_hidden_by_rounding_is_not_halved_without_end() {
        let hidden = Hidden(core::cell::Cell::new(0));
        let (t, value) = least(&hidden, (-2e-13, 3.0), f64::INFINITY).unwrap();
        assert!(t.abs() < 1e-6 && value == 1.0);
        assert!(hidden.0.get() < 200, "{}", hidden.0.get());
    }
}
