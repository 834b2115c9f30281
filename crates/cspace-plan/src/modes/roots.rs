//! Certain meetings of two monotone functions of the swept coordinate: intervals in which they may meet are bisected.

use cspace::{Ball, Real};

use crate::modes::graph::Graph;

/// Functions that differ by no more than this over an interval are equal in it, to rounding (radians or the model's
/// unit of length, as a share of 1 and the value).
const SAME: f64 = 1e-14;
/// Intervals that are looked at for one meeting of two functions. Beside a tangency and beside a vertical slope some are left of each
/// length, forty times halved; more are used up only by functions that coincide but for rounding.
const MOST_INTERVALS: usize = 1 << 14;

/// The place at which a function that is monotone changes its sign, if it does, to the last digits.
///
/// The bracket is divided where a straight line vanishes, moved a little towards the middle, and never more often than halving it
/// would need and once (Oliveira and Takahashi 2020, *an enhancement of the bisection method average performance preserving
/// minmax optimality*).
pub(crate) fn sign_change(f: impl Fn(f64) -> f64, (lo, hi): (f64, f64)) -> Option<f64> {
    /// Displacement towards the middle, as a share of the square of the bracket; if that is less than rounding, the
    /// last digits, so that the root is bracketed.
    const TOWARDS: f64 = 0.2;
    let (mut at_lo, mut at_hi) = (f(lo), f(hi));
    let is_above = at_lo > 0.0;
    if is_above == (at_hi > 0.0) {
        return None;
    }
    let width = hi - lo;
    let digits = 2.0 * f64::EPSILON * (lo.abs().max(hi.abs()) + f64::MIN_POSITIVE);
    let mut room = digits * ((width / (2.0 * digits)).log2().ceil().max(0.0) + 1.0).exp2();
    let (mut lo, mut hi) = (lo, hi);
    while hi - lo > 2.0 * digits {
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let line = (at_hi * lo - at_lo * hi) / (at_hi - at_lo);
        let by = (TOWARDS * 4.0 * half * half / width).max(digits);
        let aside = (line - mid).abs();
        let moved = if by <= aside { aside - by } else { 0.0 };
        // If the result is not a number, the middle is taken.
        let at = mid + moved.min((room - half).max(0.0)).copysign(line - mid);
        let at = if lo < at && at < hi { at } else { mid };
        if !(lo < at && at < hi) {
            break;
        }
        let value = f(at);
        if (value > 0.0) == is_above {
            (lo, at_lo) = (at, value);
        } else {
            (hi, at_hi) = (at, value);
        }
        room *= 0.5;
    }
    Some(0.5 * (lo + hi))
}

/// The composition f ∘ a of two monotone functions against a third, c.
pub(crate) struct Corner<'a> {
    /// f, of the values of a.
    pub(crate) outer: Graph<'a>,
    /// Offset added to values of a before they are put into f.
    pub(crate) shift: f64,
    pub(crate) inner: Graph<'a>,
    pub(crate) level: Graph<'a>,
}

/// The values at an end of an interval: of a, f ∘ a and c.
#[derive(Clone, Copy)]
struct At {
    s: f64,
    inner: f64,
    outer: f64,
    level: f64,
}

impl At {
    fn difference(&self) -> f64 {
        self.outer - self.level
    }
}

impl Corner<'_> {
    fn at(&self, s: f64) -> At {
        let inner = self.inner.at(s) + self.shift;
        At {
            s,
            inner,
            outer: self.outer.at(inner),
            level: self.level.at(s),
        }
    }

    /// Calls `found` with the values of s in an interval at which f(a(s)) and c(s) change their order. Where they may touch within
    /// `narrowest`, once; returns whether all intervals were decided.
    pub(crate) fn changes(
        &self,
        (lo, hi): (f64, f64),
        narrowest: f64,
        mut found: impl FnMut(f64),
    ) -> bool {
        let mut waiting = vec![(self.at(lo), self.at(hi))];
        let mut seen = 0;
        while let Some((a, b)) = waiting.pop() {
            seen += 1;
            if seen > MOST_INTERVALS {
                found(a.s);
                found(b.s);
                waiting.iter().for_each(|w| found(w.1.s));
                return false;
            }
            if apart((a.outer, b.outer), (a.level, b.level)) {
                continue;
            }
            let slopes = ((b.outer - a.outer), (b.level - a.level));
            let once = slopes.0 * slopes.1 <= 0.0;
            let by = if once {
                None
            } else {
                let over = (a.inner.min(b.inner), a.inner.max(b.inner));
                let interval = (a.s, b.s);
                let outer = self.outer.slope(over) * self.inner.slope(interval);
                Some(outer - self.level.slope(interval))
            };
            if by.is_none_or(|by: Ball| by.sign() != 0) {
                sign_change(|s| self.at(s).difference(), (a.s, b.s))
                    .into_iter()
                    .for_each(&mut found);
                continue;
            }
            let middle = self.at(0.5 * (a.s + b.s));
            let half = 0.5 * (b.s - a.s);
            let by = by.unwrap_or(Ball::constant(0.0));
            let swing = (by.mid.abs() + by.radius) * half;
            let same = SAME * (1.0 + middle.level.abs());
            let difference = middle.difference().abs();
            if difference > swing + same || difference + swing <= same {
                continue;
            }
            if half <= narrowest {
                found(middle.s);
                continue;
            }
            waiting.push((middle, b));
            waiting.push((a, middle));
        }
        true
    }
}

/// Whether two intervals, given by their ends in either order, are disjoint.
fn apart(a: (f64, f64), b: (f64, f64)) -> bool {
    a.0.max(a.1) < b.0.min(b.1) || b.0.max(b.1) < a.0.min(a.1)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use core::cell::Cell;

    #[test]
    fn changes_of_sign_are_found_in_few_steps() {
        let seen = Cell::new(0);
        let functions: [(&dyn Fn(f64) -> f64, f64); 5] = [
            (&|x| x * x - 2.0, 2f64.sqrt()),
            (&|x| (x - 0.3).cbrt(), 0.3),
            (&|x| 0.7 - x, 0.7),
            (&|x| (40.0 * (x - 1.1)).exp() - 1.0, 1.1),
            (&|x| if x < 1.0 { -1.0 } else { 1e9 }, 1.0),
        ];
        for (f, root) in functions {
            seen.set(0);
            let counted = |x: f64| {
                seen.set(seen.get() + 1);
                f(x)
            };
            let found = sign_change(counted, (0.0, 2.0)).unwrap();
            assert!((found - root).abs() < 3e-15, "{found} {root}");
            assert!(seen.get() < 58, "{root}: {}", seen.get());
        }
        seen.set(0);
        let smooth = |x: f64| {
            seen.set(seen.get() + 1);
            x.sin() - 0.5
        };
        sign_change(smooth, (0.0, 1.5)).unwrap();
        assert!(seen.get() < 14, "{}", seen.get());
        assert_eq!(sign_change(|x| x + 1.0, (0.0, 2.0)), None);
    }
}
