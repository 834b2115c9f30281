//! Two parts over a motion that is known at every time: the smallest gap, or where they first touch.
//!
//! By branch and bound over time. Over an interval the two are taken to move at constant rates, from where they are at its start to where they
//! are at its end; no point of them is farther from there than the motion bends, which falls with the square of the interval. The gap of the
//! motion at constant rates is bounded by that of [`legs`](crate::legs). So around a smallest gap there are a few intervals of each length.

use crate::legs::Coords;

use super::answer::{Clash, State};
use super::pair::Pair;

/// The motion of two parts.
pub trait Course {
    /// Times in order, from the first to the last of the motion, at which it is looked at first; between two of them it is smooth.
    fn times(&self) -> Vec<f64>;
    /// Where the two parts are.
    fn at(&mut self, time: f64) -> Option<[Coords; 2]>;
    /// The motion between two times, no time of [`times`](Self::times) within; none where the interval is too long for bounds.
    fn between(&mut self, from: f64, to: f64) -> Option<Leg>;
}

/// A motion of constant rates in place of a curved one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leg {
    /// Where the two parts are at the start.
    pub from: [Coords; 2],
    /// Where they are at the end.
    pub to: [Coords; 2],
    /// No point of one part is, as seen from the other, farther than this from where it is at constant rates.
    pub off: f64,
}

/// State of two parts over a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// The state; of parts that are clear the smallest gap, its time and features; of others the first touch.
    pub clash: Clash,
    /// Where the two parts are then.
    pub at: [Coords; 2],
    /// No time has a smaller gap than this; 0 of parts that touch or overlap.
    pub least: f64,
}

/// A gap is proved to be the smallest to this share of the parts' size; after so many intervals to ten times as much.
const EXACT: f64 = 1e-12;
const INTERVALS: u32 = 4_000;
const COARSER: f64 = 10.0;
/// Intervals are halved down to this share of the motion.
const NARROWEST: f64 = 1e-13;
/// So many pairs of discs and pieces are looked at, for each edge of the parts and at least, before an interval is halved.
const EACH: usize = 16;
const LEAST: usize = 2_000;
/// Steps by which an interval around a smallest gap shrinks to the square root of rounding.
const GOLDEN_STEPS: usize = 44;

struct Over<'p, 'a, 'c> {
    pair: &'p Pair<'a>,
    course: &'c mut dyn Course,
    times: Vec<f64>,
    effort: u32,
    narrowest: f64,
}

/// State of the two parts over a course; none if they are clear by `within` or more all along.
pub(super) fn passage(pair: &Pair<'_>, course: &mut dyn Course, within: f64) -> Option<Passage> {
    let times = course.times();
    let (first, last) = (*times.first()?, *times.last()?);
    let edges: usize = (pair.bodies.iter()).map(|b| b.part().edges().count()).sum();
    Over {
        pair,
        course,
        times,
        effort: u32::try_from(LEAST + EACH * edges).unwrap_or(u32::MAX),
        narrowest: NARROWEST * (last - first),
    }
    .look(within)
}

impl Over<'_, '_, '_> {
    fn look(&mut self, within: f64) -> Option<Passage> {
        let times = self.times.clone();
        let mut best: Option<(f64, f64)> = None;
        for (i, &time) in times.iter().enumerate() {
            let at = self.course.at(time)?;
            match self.pair.there(at, f64::INFINITY)? {
                clear if clear.state == State::Clear => {
                    let gap = clear.gap.unwrap_or(f64::INFINITY);
                    if best.is_none_or(|b| gap < b.1) {
                        best = Some((time, gap));
                    }
                }
                met if i == 0 => return self.met_at_the_start(met, at),
                _ => return self.first_touch(time),
            }
        }
        let near = times.iter().position(|&t| Some(t) == best.map(|b| b.0))?;
        let about = [
            times[near.saturating_sub(1)],
            times[(near + 1).min(times.len() - 1)],
        ];
        let best = self.lowest(about, best?);
        self.prove(best, within)
    }

    /// Parts that overlap or touch at the start.
    fn met_at_the_start(&mut self, met: Clash, at: [Coords; 2]) -> Option<Passage> {
        let first = *self.times.first()?;
        let met = Clash {
            time: Some(first),
            ..met
        };
        if met.state == State::Touching {
            for time in self.times.clone() {
                let there = self.course.at(time)?;
                if let Some(deep) = self.pair.there(there, self.pair.touch)
                    && deep.state == State::Overlap
                {
                    return Some(Passage {
                        clash: Clash {
                            time: Some(time),
                            ..deep
                        },
                        at: there,
                        least: 0.0,
                    });
                }
            }
        }
        Some(Passage {
            clash: met,
            at,
            least: 0.0,
        })
    }

    /// The smallest gap, given one that is reached, or the first touch if there is one.
    fn prove(&mut self, mut best: (f64, f64), within: f64) -> Option<Passage> {
        let size = self.pair.bodies[0].size().max(self.pair.bodies[1].size());
        let at = self.course.at(best.0)?;
        if self.pair.there(at, f64::INFINITY)?.state != State::Clear {
            return self.first_touch(best.0);
        }
        let mut exact = EXACT * size;
        let mut proved = f64::INFINITY;
        let mut count = 0;
        let mut stack: Vec<[f64; 2]> = (self.times.windows(2)).map(|w| [w[0], w[1]]).collect();
        stack.reverse();
        while let Some([lo, hi]) = stack.pop() {
            count += 1;
            if count % INTERVALS == 0 {
                exact *= COARSER;
            }
            let limit = (best.1 - exact).min(within).max(self.pair.touch);
            if self.is_apart([lo, hi], limit) {
                proved = proved.min(limit);
                continue;
            }
            let middle = 0.5 * (lo + hi);
            let at = self.course.at(middle)?;
            let gap = match self.pair.there(at, best.1) {
                None => f64::INFINITY,
                Some(there) if there.state == State::Clear => there.gap.unwrap_or(f64::INFINITY),
                Some(_) => return self.first_touch(middle),
            };
            if gap < best.1 {
                best = self.lowest([lo, hi], (middle, gap));
                let at = self.course.at(best.0)?;
                if self.pair.there(at, f64::INFINITY)?.state != State::Clear {
                    return self.first_touch(best.0);
                }
            }
            if hi - lo <= self.narrowest {
                proved = 0.0;
                continue;
            }
            stack.extend([[middle, hi], [lo, middle]]);
        }
        if best.1 >= within {
            return None;
        }
        let at = self.course.at(best.0)?;
        let there = self.pair.there(at, f64::INFINITY)?;
        Some(Passage {
            clash: Clash {
                time: Some(best.0),
                ..there
            },
            at,
            least: proved.min(best.1),
        })
    }

    /// Whether the parts are farther apart than a limit over an interval, as far as it is found at little cost.
    fn is_apart(&mut self, [lo, hi]: [f64; 2], limit: f64) -> bool {
        let leg = self.course.between(lo, hi);
        leg.is_some_and(|leg| {
            leg.off.is_finite()
                && (self.pair.between(leg.from, leg.to)).is_apart(limit + leg.off, self.effort)
        })
    }

    /// A local minimum of the gap in an interval, by golden section, not above one that is reached there.
    fn lowest(&mut self, [mut lo, mut hi]: [f64; 2], mut best: (f64, f64)) -> (f64, f64) {
        const GOLDEN: f64 = 0.618_033_988_749_895;
        let mut gap = |t: f64| -> f64 {
            let Some(at) = self.course.at(t) else {
                return f64::INFINITY;
            };
            let found = self.pair.between(at, at).distance_below(f64::INFINITY);
            if found.distance < best.1 {
                best = (t, found.distance);
            }
            found.distance
        };
        let (mut a, mut b) = (hi - GOLDEN * (hi - lo), lo + GOLDEN * (hi - lo));
        let (mut at_a, mut at_b) = (gap(a), gap(b));
        for _ in 0..GOLDEN_STEPS {
            if at_a <= at_b {
                (hi, b, at_b) = (b, a, at_a);
                a = hi - GOLDEN * (hi - lo);
                at_a = gap(a);
            } else {
                (lo, a, at_a) = (a, b, at_b);
                b = lo + GOLDEN * (hi - lo);
                at_b = gap(b);
            }
        }
        best
    }

    /// Where parts first touch that are apart at the start, and are not at a time.
    fn first_touch(&mut self, met: f64) -> Option<Passage> {
        let mut stack: Vec<[f64; 2]> = (self.times.windows(2))
            .filter(|w| w[0] < met)
            .map(|w| [w[0], w[1].min(met)])
            .collect();
        stack.reverse();
        let mut touch = met;
        while let Some([lo, hi]) = stack.pop() {
            if self.is_apart([lo, hi], self.pair.touch) {
                continue;
            }
            if hi - lo <= self.narrowest {
                touch = hi;
                break;
            }
            let middle = 0.5 * (lo + hi);
            stack.extend([[middle, hi], [lo, middle]]);
        }
        let at = self.course.at(touch)?;
        let between = self.pair.between(at, at);
        let (features, points) = between.nearest().unzip();
        let state = match self.overlaps_after(touch) {
            true => State::Overlap,
            false => State::Touching,
        };
        Some(Passage {
            clash: Clash {
                gap: (state == State::Touching).then_some(0.0),
                features,
                points,
                time: Some(touch),
                ..self.pair.clash(state)
            },
            at,
            least: 0.0,
        })
    }

    /// Whether the parts overlap at a time after they touch: at one of the first times, or shortly after.
    fn overlaps_after(&mut self, touch: f64) -> bool {
        let (Some(&first), Some(&last)) = (self.times.first(), self.times.last()) else {
            return false;
        };
        let mut after: Vec<f64> = self.times.iter().copied().filter(|&t| t >= touch).collect();
        let mut by = last - first;
        while by > self.narrowest {
            after.push(touch + by);
            by *= 0.5;
        }
        after.into_iter().filter(|&t| t <= last).any(|t| {
            let at = self.course.at(t);
            let there = at.and_then(|at| self.pair.there(at, self.pair.touch));
            there.is_some_and(|c| c.state == State::Overlap)
        })
    }
}
