//! When a coordinate that grows at a constant rate is within a range.

use core::f64::consts::TAU;

use super::tolerance::NEAR;

/// Intervals of time, all of one length, a period apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Visits {
    /// When the first begins that ends at 0 or later.
    first: f64,
    length: f64,
    /// Infinite if there is one only.
    period: f64,
}

impl Visits {
    /// When t + rate · time is in the range, or no farther than rounding from it, at times from 0 to `until`. `None` if
    /// never. On a circle values a turn apart are the same.
    pub(super) fn new(
        (t, rate): (f64, f64),
        (lo, hi): (f64, f64),
        circle: bool,
        until: f64,
    ) -> Option<Self> {
        let near = NEAR + 4.0 * f64::EPSILON * (t.abs() + rate.abs() * until);
        let (lo, hi) = (lo - near, hi + near);
        let always = Self {
            first: 0.0,
            length: f64::INFINITY,
            period: f64::INFINITY,
        };
        if circle && hi - lo >= TAU {
            return Some(always);
        }
        // How far t is above the lower end, less whole turns.
        let above = if circle {
            (t - lo).rem_euclid(TAU)
        } else {
            t - lo
        };
        let width = hi - lo;
        if rate == 0.0 {
            return (0.0..=width).contains(&above).then_some(always);
        }
        // What it takes to come to the end at which it comes in: it is there already, or comes to it, perhaps a turn on.
        let way = if rate > 0.0 { -above } else { above - width };
        let passed = way + width < 0.0;
        let way = match (circle, passed) {
            (true, true) => way + TAU,
            (false, true) => return None,
            _ => way,
        };
        let visits = Self {
            first: way / rate.abs(),
            length: width / rate.abs(),
            period: if circle {
                TAU / rate.abs()
            } else {
                f64::INFINITY
            },
        };
        (visits.first <= until).then_some(visits)
    }

    /// Calls `take` with every interval within [0, until] that is in a visit of both, in order, until it returns true.
    pub(super) fn shared(&self, other: &Self, until: f64, mut take: impl FnMut(f64, f64) -> bool) {
        let (mut mine, mut theirs) = (self.first, other.first);
        while mine <= until && theirs <= until {
            let lo = mine.max(theirs).max(0.0);
            let (my_end, their_end) = (mine + self.length, theirs + other.length);
            let hi = my_end.min(their_end).min(until);
            if lo <= hi && take(lo, hi) {
                return;
            }
            // The one that ends first goes on.
            let before = (mine, theirs);
            if my_end <= their_end {
                mine += self.period;
            } else {
                theirs += other.period;
            }
            if (mine, theirs) == before {
                // Turns are shorter than the rounding of time.
                return;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the definition, at many times.
    #[test]
    fn visits_are_when_the_coordinate_is_in_the_range() {
        let ranges = [(-1.0, 0.5), (2.0, 2.0), (-3.0, 3.2), (5.0, 6.5), (0.0, 6.4)];
        let mut inside = 0;
        for (t, rate) in [
            (0.3, 0.7),
            (-4.0, 2.3),
            (9.0, -1.7),
            (0.2, 0.0),
            (2.0, -0.01),
        ] {
            for range in ranges {
                for circle in [false, true] {
                    let until = 20.0;
                    let always = Visits::new((0.0, 0.0), (0.0, 0.0), false, until);
                    let mut found = Vec::new();
                    if let (Some(a), Some(b)) =
                        (Visits::new((t, rate), range, circle, until), always)
                    {
                        a.shared(&b, until, |lo, hi| {
                            found.push((lo, hi));
                            false
                        });
                    }
                    assert!(found.windows(2).all(|w| w[0].1 < w[1].0), "{found:?}");
                    for k in 0..2000 {
                        let time = until * f64::from(k) / 2000.0;
                        let at = t + rate * time;
                        let at = if circle {
                            range.0 + (at - range.0).rem_euclid(TAU)
                        } else {
                            at
                        };
                        let is = (range.0..=range.1).contains(&at);
                        let said = found.iter().any(|&(lo, hi)| (lo..=hi).contains(&time));
                        assert_eq!(said, is, "{t} {rate} {range:?} {circle} {time}");
                        inside += usize::from(is);
                    }
                }
            }
        }
        assert!(inside > 10_000, "{inside}");
    }
}
