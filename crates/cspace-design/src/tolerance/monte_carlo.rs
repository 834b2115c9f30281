//! Yield by samples: each from the contacts that may come first anywhere in the tolerances, or by a configuration space where these are in doubt.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};

use cspace::parallel;
use cspace_model::model::{Dimension, Target};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::study::Study;

/// Samples that are drawn one after the other: blocks have numbers of their own, so that the number of threads does not matter.
const BLOCK: u64 = 1024;

/// Bars of a histogram.
const BARS: usize = 40;

/// Statistics of samples within tolerances.
#[derive(Debug, Clone, PartialEq)]
pub struct MonteCarlo {
    /// How many samples there are.
    pub samples: u64,
    /// The share that meets the requirement; without limits, the share that has a value.
    pub met: f64,
    /// The standard error of that share.
    pub error: f64,
    /// The shares below and above the limits.
    pub outside: [f64; 2],
    /// The shares that have no value, by kind.
    pub failures: BTreeMap<String, f64>,
    /// Mean, standard deviation, skewness and excess kurtosis of the values.
    pub moments: [f64; 4],
    /// The smallest and the largest value.
    pub range: [f64; 2],
    /// Edges of bars of equal width, and how many values are in each.
    pub histogram: (Vec<f64>, Vec<u64>),
    /// The share of samples for which a configuration space was computed.
    pub computed: f64,
}

impl Study<'_> {
    /// Samples deviations by chance; `None` if the progress ends the computation.
    pub(super) fn sample(&self, samples: u64, seed: u64) -> Option<MonteCarlo> {
        let requirement = self.requirement_of(self.nominal);
        let all = self.each(samples, seed, |_, deviations| {
            let point = self.at(deviations);
            let is_computed = point.hits.is_none();
            (point.value.map_err(|failure| failure.kind), is_computed)
        })?;
        let n = samples as f64;
        let values: Vec<f64> = all.iter().filter_map(|s| s.0.ok()).collect();
        let mut failures: BTreeMap<String, f64> = BTreeMap::new();
        for (sample, _) in &all {
            if let Err(kind) = sample {
                *failures.entry((*kind).to_owned()).or_default() += 1.0 / n;
            }
        }
        let count = |is: &dyn Fn(f64) -> bool| values.iter().filter(|v| is(**v)).count() as f64 / n;
        let (met, outside) = match requirement.target {
            Some(Target::Limits(lo, hi)) => (
                count(&|v| (lo..=hi).contains(&v)),
                [count(&|v| v < lo), count(&|v| v > hi)],
            ),
            Some(Target::Equals(wanted)) => (count(&|v| (v == 1.0) == wanted), [0.0; 2]),
            None if requirement.dimension == Dimension::Truth => (count(&|v| v == 1.0), [0.0; 2]),
            None => (count(&|_| true), [0.0; 2]),
        };
        Some(MonteCarlo {
            samples,
            met,
            error: (met * (1.0 - met) / n).sqrt(),
            outside,
            failures,
            moments: moments(&values),
            range: values
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], v| {
                    [lo.min(*v), hi.max(*v)]
                }),
            histogram: histogram(&values),
            computed: all.iter().filter(|s| s.1).count() as f64 / n,
        })
    }

    /// Which samples meet the requirement: what is `known` of one by its number is not measured again. `None` if the progress ends the
    /// computation.
    pub(super) fn meets(
        &self,
        samples: u64,
        seed: u64,
        known: impl Fn(usize) -> Option<bool> + Sync,
    ) -> Option<Vec<bool>> {
        let target = self.requirement_of(self.nominal).target;
        self.each(samples, seed, |i, deviations| {
            known(i).unwrap_or_else(|| match (self.at(deviations).value, target) {
                (Err(_), _) => false,
                (Ok(value), Some(Target::Limits(lo, hi))) => (lo..=hi).contains(&value),
                (Ok(value), Some(Target::Equals(wanted))) => (value == 1.0) == wanted,
                (Ok(_), None) => true,
            })
        })
    }

    /// Finds something of each sample, by its number and its deviations, which are the same on any number of threads. `None` if the progress
    /// ends the computation.
    fn each<T: Send>(
        &self,
        samples: u64,
        seed: u64,
        find: impl Fn(usize, &[f64]) -> T + Sync,
    ) -> Option<Vec<T>> {
        /// Blocks that are divided among threads at once.
        const TOGETHER: u64 = 64;
        let done = AtomicU64::new(0);
        let block = |&block: &u64| -> Option<Vec<T>> {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            random.set_stream(block);
            let numbers = block * BLOCK..samples.min((block + 1) * BLOCK);
            let one = |i: u64| {
                let deviations = self.variations.draw(&mut random);
                let found = self.goes_on().then(|| find(i as usize, &deviations));
                let done = done.fetch_add(1, Ordering::Relaxed) + 1;
                self.progress.pieces(done, samples);
                found
            };
            numbers.map(one).collect()
        };
        let blocks = samples.div_ceil(BLOCK);
        let mut all = Vec::new();
        for first in (0..blocks).step_by(TOGETHER as usize) {
            let together: Vec<u64> = (first..blocks.min(first + TOGETHER)).collect();
            for some in parallel::map(&together, 1, block) {
                all.extend(some?);
            }
        }
        self.progress.pieces(samples, samples);
        Some(all)
    }
}

fn moments(values: &[f64]) -> [f64; 4] {
    let n = values.len() as f64;
    if values.is_empty() {
        return [f64::NAN; 4];
    }
    // About the first, so that no digits are lost.
    let origin = values[0];
    let mean = values.iter().map(|v| v - origin).sum::<f64>() / n;
    let central = |power: i32| {
        values
            .iter()
            .map(|v| (v - origin - mean).powi(power))
            .sum::<f64>()
            / n
    };
    let variance = central(2);
    let sigma = (variance * n / (n - 1.0).max(1.0)).sqrt();
    let (skewness, kurtosis) = if variance > 0.0 {
        (
            central(3) / variance.powf(1.5),
            central(4) / (variance * variance) - 3.0,
        )
    } else {
        (0.0, 0.0)
    };
    [origin + mean, sigma, skewness, kurtosis]
}

fn histogram(values: &[f64]) -> (Vec<f64>, Vec<u64>) {
    let range = |[lo, hi]: [f64; 2], v: &f64| [lo.min(*v), hi.max(*v)];
    let [lo, hi] = values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], range);
    if values.is_empty() || lo == hi {
        return (Vec::new(), Vec::new());
    }
    let width = (hi - lo) / BARS as f64;
    let mut bars = vec![0_u64; BARS];
    for v in values {
        bars[(((v - lo) / width) as usize).min(BARS - 1)] += 1;
    }
    let edges = (0..=BARS).map(|i| lo + width * i as f64).collect();
    (edges, bars)
}
