//! The smallest and the largest value of a requirement within tolerances, found by climbing.

use super::study::{Failure, Point, Study};

/// Values nearer to each other than this, relative to them, are one.
pub(super) const ONE: f64 = 1e-10;

/// Effects of a parameter smaller than this, relative to those of the others, are rounding.
const ROUNDING: f64 = 1e-11;

/// Largest number of parameters of which all corners are tried.
const ALL_CORNERS: usize = 8;

/// Likewise of a quantity that needs a configuration space at every point.
const FEW_CORNERS: usize = 4;

/// An extreme, and where it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Extreme {
    /// The value; or why there is none at the place.
    pub value: Result<f64, String>,
    /// The deviations from the parameters' values, in the order of the variations.
    pub at: Vec<f64>,
    /// Whether it is proved that nothing within the tolerances is beyond it.
    pub certified: bool,
    /// How much farther it might be at most, where that is known and it is not certified.
    pub gap: Option<f64>,
    /// Whether the value jumps at the place, where a contact that comes first beside it is just missed: it comes as near to this as one likes.
    pub jumps: bool,
}

impl Extreme {
    /// There is none, for a reason at some deviations.
    pub(super) const fn none(reason: String, at: Vec<f64>) -> Self {
        Self {
            value: Err(reason),
            at,
            certified: false,
            gap: None,
            jumps: false,
        }
    }
}

/// A point that was climbed to.
#[derive(Debug, Clone)]
pub(super) struct Summit {
    pub(super) at: Vec<f64>,
    pub(super) point: Point,
    pub(super) value: f64,
}

impl Study<'_> {
    /// The largest value of sign times the requirement within the tolerances, and whether that is proved if it is asked for.
    pub(super) fn extreme(&self, sign: f64, is_to_prove: bool) -> (Extreme, Option<Summit>) {
        match self.summit(sign, 1.0) {
            Ok(summit) => {
                let (certified, gap) = if is_to_prove {
                    self.prove(&summit, sign, 1.0)
                } else {
                    (false, None)
                };
                let extreme = Extreme {
                    value: Ok(summit.value),
                    at: summit.at.clone(),
                    certified,
                    gap,
                    jumps: self.jumps(&summit.at, summit.value),
                };
                (extreme, Some(summit))
            }
            Err((failure, at)) => (Extreme::none(failure.reason, at), None),
        }
    }

    /// The corners of the tolerances by a factor from which climbing starts.
    pub(super) fn corners(&self, factor: f64) -> Vec<Vec<f64>> {
        /// Beyond this many parameters signs repeat.
        const BITS: usize = usize::BITS as usize;
        let n = self.variations.len();
        let most = if self.is_drawn() {
            ALL_CORNERS
        } else {
            FEW_CORNERS
        };
        let corner = |bits: usize| {
            let is_up = |k: usize| bits >> (k % BITS) & 1 == 1;
            let signs: Vec<f64> = (0..n).map(|k| if is_up(k) { 1.0 } else { -1.0 }).collect();
            self.variations.farthest(&signs, factor)
        };
        if n <= most {
            return (0..1 << n).map(corner).collect();
        }
        // All down, all up, and mixtures that differ.
        let mixed = [1, 2, 4, 8].map(|run| {
            let bits = (0..BITS).filter(|k| (k / run) % 2 == 0);
            bits.fold(0, |all, k| all | 1 << k)
        });
        let mixed = mixed.into_iter().flat_map(|m: usize| [m, !m]);
        [0, usize::MAX]
            .into_iter()
            .chain(mixed)
            .map(corner)
            .collect()
    }

    /// Climbs from a point to a local extreme of sign times the value, within tolerances by a factor; `None` where it has no value.
    pub(super) fn climb(&self, from: &[f64], sign: f64, factor: f64) -> Option<Summit> {
        const ROUNDS: usize = 24;
        let start = self.at(from);
        let value = *start.value.as_ref().ok()?;
        let mut best = Summit {
            at: from.to_vec(),
            point: start,
            value,
        };
        for _ in 0..ROUNDS {
            if !self.goes_on() {
                break;
            }
            let Some(slopes) = self.slopes(&best.at, &best.point) else {
                break;
            };
            let weights = slopes.iter().zip(&self.variations.list);
            let weights: Vec<f64> = weights.map(|(s, v)| (s * v.half()).abs()).collect();
            let least = ROUNDING * weights.iter().copied().fold(0.0, f64::max);
            let slopes = slopes.iter().zip(&weights);
            let slopes = slopes.map(|(s, weight)| if *weight > least { sign * s } else { 0.0 });
            let slopes: Vec<f64> = slopes.collect();
            let mut target = self.variations.farthest(&slopes, factor);
            for (k, s) in slopes.iter().enumerate() {
                if *s == 0.0 && self.variations.zone_of(k).is_none() {
                    target[k] = best.at[k];
                }
            }
            if target == best.at {
                break;
            }
            if !self.improve(&mut best, &target, sign)
                && !self.improve_each(&mut best, &target, sign)
            {
                break;
            }
        }
        Some(best)
    }

    /// Whether the value jumps at a point: a much smaller step changes it as much as a small one.
    pub(super) fn jumps(&self, at: &[f64], value: f64) -> bool {
        /// Steps as shares of half the tolerance.
        const STEPS: [f64; 2] = [1e-6, 1e-9];
        let list = self.variations.list.iter().enumerate();
        let mut inside = list.filter(|(k, v)| {
            let [lo, hi] = v.deviations;
            let beside = STEPS[0] * v.half();
            lo + beside < at[*k] && at[*k] < hi - beside
        });
        inside.any(|(k, v)| {
            [-1.0, 1.0].into_iter().any(|way| {
                let [large, small] = STEPS.map(|step| {
                    let mut moved = at.to_vec();
                    moved[k] += way * step * v.half();
                    let there = self.at(&moved).value;
                    there.map_or(f64::INFINITY, |there| (there - value).abs())
                });
                small > 0.5 * large && small > ONE * value.abs()
            })
        })
    }

    /// Takes a point if it is better.
    fn improve(&self, best: &mut Summit, at: &[f64], sign: f64) -> bool {
        let point = self.at(at);
        match point.value {
            Ok(value) if sign * (value - best.value) > 0.0 => {
                *best = Summit {
                    at: at.to_vec(),
                    point,
                    value,
                };
                true
            }
            _ => false,
        }
    }

    /// Moves one parameter, or point in a zone, after the other towards a target, as far as it pays.
    fn improve_each(&self, best: &mut Summit, target: &[f64], sign: f64) -> bool {
        let mut is_better = false;
        for k in 0..target.len() {
            let mut alone = best.at.clone();
            match self.variations.zone_of(k) {
                Some(zone) if zone.coordinates[0] == k => {
                    for i in zone.coordinates {
                        alone[i] = target[i];
                    }
                }
                Some(_) => continue,
                None => alone[k] = target[k],
            }
            if alone != best.at {
                is_better |=
                    self.improve(best, &alone, sign) || self.improve_between(best, &alone, sign);
            }
        }
        is_better
    }

    /// The best point between a point and another, by the golden section: where contacts take over from each other.
    fn improve_between(&self, best: &mut Summit, to: &[f64], sign: f64) -> bool {
        const STEPS: usize = 48;
        const GOLDEN: f64 = 0.618_033_988_749_894_8;
        let from = best.at.clone();
        let place = |s: f64| -> Vec<f64> {
            let both = from.iter().zip(to);
            both.map(|(a, b)| a + s * (b - a)).collect()
        };
        let value = |s: f64| {
            let found = self.at(&place(s)).value;
            found.map_or(f64::NEG_INFINITY, |v| sign * v)
        };
        let (mut lo, mut hi) = (0.0, 1.0);
        let (mut a, mut b) = (hi - GOLDEN * (hi - lo), lo + GOLDEN * (hi - lo));
        let (mut at_a, mut at_b) = (value(a), value(b));
        for _ in 0..STEPS {
            if at_a >= at_b {
                (hi, b, at_b) = (b, a, at_a);
                a = hi - GOLDEN * (hi - lo);
                at_a = value(a);
            } else {
                (lo, a, at_a) = (a, b, at_b);
                b = lo + GOLDEN * (hi - lo);
                at_b = value(b);
            }
        }
        let before = best.value;
        let is_better = self.improve(best, &place(0.5 * (lo + hi)), sign);
        is_better && sign * (best.value - before) > ONE * before.abs()
    }

    /// The largest value of sign times the requirement within the tolerances by a factor, by climbing from many points; or why it has none,
    /// and where, if it has none at any of them.
    pub(super) fn summit(&self, sign: f64, factor: f64) -> Result<Summit, (Failure, Vec<f64>)> {
        let zero = vec![0.0; self.variations.len()];
        let mut starts = vec![zero.clone()];
        starts.extend(self.corners(factor));
        let mut best: Option<Summit> = None;
        for start in starts.iter().take_while(|_| self.goes_on()) {
            let found = self.climb(start, sign, factor);
            let is_better = |f: &Summit| {
                let best = best.as_ref();
                best.is_none_or(|b| sign * (f.value - b.value) > ONE * b.value.abs())
            };
            if found.as_ref().is_some_and(is_better) {
                best = found;
            }
        }
        best.ok_or_else(|| {
            let none = Failure {
                kind: "no value",
                reason: "it has no value anywhere".to_owned(),
            };
            (self.at(&zero).value.err().unwrap_or(none), zero)
        })
    }
}
