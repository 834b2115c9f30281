//! Which tolerances meet all limits at the least cost.
//!
//! Halving a tolerance doubles what it costs: tolerances fᵢ times those given cost Σ cᵢ/fᵢ. To first order a requirement's worst cases are sums
//! Σ aᵢ fᵢ, and the deviations that a share of parts stays within are such a sum and the root of a sum of squares (bᵢ fᵢ)²: convex functions of the
//! factors, of degree 1. The factors of least cost within limits on such functions h follow from cᵢ/fᵢ² = Σ λ ∂h/∂fᵢ. What is exact then scales all
//! of them alike: the margin of the worst case, or the yield of samples.

use cspace::Progress;
use cspace_model::Model;
use cspace_model::model::{Setting, Template};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use statrs::distribution::{ContinuousCDF, Normal};

use super::{Analysis, Linear, ToleranceOptions, Tolerances, Variations};
use crate::check::Interrupted;

/// Criterion that the tolerances must meet.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(from = "CriterionForm", into = "CriterionForm")]
#[schemars(with = "CriterionForm")]
pub enum Criterion {
    /// Every part within the tolerances meets all limits.
    Worst,
    /// This share of the parts meets each limit.
    Yield(f64),
}

/// A criterion as it is written: the word `worst`, or a share.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
enum CriterionForm {
    /// Every part within the tolerances meets all limits.
    Word(Worst),
    /// This share of the parts meets each limit.
    Share(f64),
}

/// The word for the criterion that every part meets.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
enum Worst {
    /// Every part within the tolerances meets all limits.
    Worst,
}

impl From<Criterion> for CriterionForm {
    fn from(criterion: Criterion) -> Self {
        match criterion {
            Criterion::Worst => Self::Word(Worst::Worst),
            Criterion::Yield(share) => Self::Share(share),
        }
    }
}

impl From<CriterionForm> for Criterion {
    fn from(form: CriterionForm) -> Self {
        match form {
            CriterionForm::Word(Worst::Worst) => Self::Worst,
            CriterionForm::Share(share) => Self::Yield(share),
        }
    }
}

/// Tolerances that meet a criterion.
#[derive(Debug, Clone)]
pub struct Allocation {
    /// The factor on the tolerance of each parameter that the model gives.
    pub factors: Vec<f64>,
    /// Whether a parameter has an influence on what is required: others keep their tolerances.
    pub matters: Vec<bool>,
    /// The variations with the tolerances allocated.
    pub variations: Variations,
    /// Cost of the tolerances that the model gives, and of those allocated.
    pub cost: [f64; 2],
    /// Effects of the tolerances allocated.
    pub tolerances: Vec<Tolerances>,
}

/// Why no tolerances are allocated.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unallocated {
    /// The computation was interrupted.
    #[error("{Interrupted}")]
    Interrupted,
    /// Nothing limits the tolerances.
    #[error("no number with limits depends on a parameter with a tolerance above 0")]
    NoLimits,
    /// A requirement is not met without any tolerances.
    #[error("requirement `{0}` is not met as drawn: change the dimensions first")]
    NotMet(String),
    /// No tolerances achieve the yield.
    #[error("requirement `{0}` fails at the smallest tolerances tried")]
    NoYield(String),
}

impl From<Interrupted> for Unallocated {
    fn from(_: Interrupted) -> Self {
        Self::Interrupted
    }
}

/// Tolerances are widened by at most this.
const WIDEST: f64 = 10.0;

/// A limit on a function of the factors: Σ aᵢ fᵢ + √Σ (bᵢ fᵢ)² ≤ most.
struct Limit {
    a: Vec<f64>,
    b: Vec<f64>,
    most: f64,
}

impl Limit {
    fn value(&self, f: &[f64]) -> f64 {
        let sum: f64 = self.a.iter().zip(f).map(|(a, f)| a * f).sum();
        sum + self.root(f)
    }

    fn root(&self, f: &[f64]) -> f64 {
        let squares = self.b.iter().zip(f).map(|(b, f)| (b * f).powi(2));
        squares.sum::<f64>().sqrt()
    }

    fn slope(&self, f: &[f64], i: usize) -> f64 {
        let root = self.root(f);
        let curved = if root > 0.0 {
            self.b[i] * self.b[i] * f[i] / root
        } else {
            0.0
        };
        self.a[i] + curved
    }
}

/// The limits of a requirement, to first order: none without limits or derivatives.
fn limits(of: &Tolerances, criterion: Criterion) -> Vec<Limit> {
    let (Some([lo, hi]), Some(linear)) = (of.nominal.requirement.limits(), &of.linear) else {
        return Vec::new();
    };
    let Linear {
        parameters,
        nominal,
        ..
    } = linear;
    let sides = [(1.0, 1, hi - nominal), (-1.0, 0, nominal - lo)];
    let none = vec![0.0; parameters.len()];
    let limit = |(sign, end, most): (f64, usize, f64)| match criterion {
        Criterion::Worst => Limit {
            a: parameters.iter().map(|p| sign * p.ends[end]).collect(),
            b: none.clone(),
            most,
        },
        Criterion::Yield(share) => {
            let z = Normal::standard().inverse_cdf(0.5 * (1.0 + share));
            Limit {
                a: parameters.iter().map(|p| sign * p.shift).collect(),
                b: parameters.iter().map(|p| z * p.sigma).collect(),
                most,
            }
        }
    };
    sides
        .map(limit)
        .into_iter()
        .filter(|l| l.most.is_finite())
        .collect()
}

/// The factors of least cost, of which groups are the same. Each step gives every limit a price that grows where it is passed.
fn cheapest(limits: &[Limit], costs: &[f64]) -> Vec<f64> {
    const STEPS: usize = 4000;
    let n = costs.len();
    let mut f = vec![1.0; n];
    let mut prices = vec![1.0; limits.len()];
    for _ in 0..STEPS {
        for (price, limit) in prices.iter_mut().zip(limits) {
            let used = limit.value(&f) / limit.most;
            *price = (*price * used.max(0.0)).max(f64::MIN_POSITIVE);
        }
        let next = (0..n).map(|i| {
            let price = prices
                .iter()
                .zip(limits)
                .map(|(p, l)| p / l.most * l.slope(&f, i));
            let price: f64 = price.sum();
            if price > 0.0 {
                // Half the way, in proportion, so that prices settle.
                ((costs[i] / price).sqrt().min(WIDEST) * f[i]).sqrt()
            } else {
                WIDEST
            }
        });
        f = next.collect();
    }
    // Within all limits, to the last bit but rounding.
    let used = limits
        .iter()
        .map(|l| l.value(&f) / l.most)
        .fold(0.0, f64::max);
    f.iter().map(|x| (x / used).min(WIDEST)).collect()
}

/// Allocates tolerances to the parameters of a model so that its requirements with limits meet a criterion at the least cost: of the factors f on the
/// tolerances that the model gives, Σ c/f, with a cost c for each variation.
///
/// # Errors
/// If nothing limits the tolerances, a requirement is not met as drawn, or the progress ends the computation.
pub fn allocate(
    template: &Template,
    set: &[Setting],
    model: &Model,
    options: &ToleranceOptions,
    (criterion, costs): (Criterion, &[f64]),
    progress: &dyn Progress,
) -> Result<Allocation, Unallocated> {
    let given = Variations::of(model);
    let samples = match criterion {
        Criterion::Worst => options.samples,
        // As many that a hundred fail.
        Criterion::Yield(share) if options.samples == 0 => (100.0 / (1.0 - share)).min(1e6) as u64,
        Criterion::Yield(_) => options.samples,
    };
    let unsampled = ToleranceOptions {
        samples: 0,
        ..options.clone()
    };
    let analysis = Analysis {
        proves: false,
        ..Analysis::new(template, set, model, &unsampled, progress)?
    };
    let first = analysis.of(&given)?;
    if let Some(not_met) = first.iter().find(|t| t.margin.factor == Some(0.0)) {
        return Err(Unallocated::NotMet(
            not_met.nominal.requirement.name.clone(),
        ));
    }
    let limits: Vec<Limit> = first.iter().flat_map(|t| limits(t, criterion)).collect();
    let moves = |i: usize| limits.iter().any(|l| l.a[i] != 0.0 || l.b[i] != 0.0);
    // Both coordinates of a point have one zone.
    let matters: Vec<bool> = (0..given.len())
        .map(|i| match given.zone_of(i) {
            Some(zone) => zone.coordinates.into_iter().any(moves),
            None => moves(i),
        })
        .collect();
    if !matters.contains(&true) {
        return Err(Unallocated::NoLimits);
    }
    let groups = Groups::of(&given, &matters);
    let grouped: Vec<Limit> = limits.iter().map(|l| groups.limit(l)).collect();
    let cheapest = groups.factors(&cheapest(&grouped, &groups.costs(costs)), given.len());
    let scaled = |by: f64| -> Vec<f64> {
        let both = cheapest.iter().zip(&matters);
        both.map(|(f, matters)| if *matters { (f * by).min(WIDEST) } else { 1.0 })
            .collect()
    };
    let rounded = |by: f64| -> Vec<f64> {
        let round = |(i, f): (usize, &f64)| match matters[i] {
            true => given.rounded(i, *f),
            false => 1.0,
        };
        scaled(by).iter().enumerate().map(round).collect()
    };
    let by = match criterion {
        Criterion::Worst => {
            let found = analysis.of(&given.by(&scaled(1.0)))?;
            let margins = found.iter().filter_map(|t| t.margin.factor);
            margins.fold(f64::INFINITY, f64::min)
        }
        Criterion::Yield(share) => {
            analysis.largest_with(&given, &scaled, (share, samples), true)?
        }
    };
    let mut factors = rounded(by);
    let mut variations = given.by(&factors);
    let options = ToleranceOptions {
        samples,
        ..options.clone()
    };
    let analysis = Analysis {
        options: &options,
        proves: true,
        ..analysis
    };
    let mut tolerances = analysis.of(&variations)?;
    if let Criterion::Yield(share) = criterion
        && !tolerances.iter().all(|of| has_yield(of, share))
    {
        // Some samples that were taken to meet it do not.
        factors = rounded(analysis.largest_with(&given, &scaled, (share, samples), false)?);
        variations = given.by(&factors);
        tolerances = analysis.of(&variations)?;
    }
    let cost = |f: &dyn Fn(usize) -> f64| groups.cost(costs, f);
    Ok(Allocation {
        cost: [cost(&|_| 1.0), cost(&|i| factors[i])],
        factors,
        matters,
        variations,
        tolerances,
    })
}

/// Whether a share of the samples meets a requirement, if anything is required.
fn has_yield(of: &Tolerances, share: f64) -> bool {
    let is_required = of.nominal.requirement.target.is_some();
    let sampled = of.monte_carlo.as_ref();
    !is_required || sampled.is_none_or(|found| found.met >= share)
}

impl Analysis<'_> {
    /// The largest factor at which a share of so many samples meets each requirement. Deviations grow with the factor, so that most samples
    /// that meet it at two factors do so between them, and are not looked at there again if they are taken to be monotone.
    fn largest_with(
        &self,
        given: &Variations,
        scaled: &dyn Fn(f64) -> Vec<f64>,
        (share, samples): (f64, u64),
        is_monotone: bool,
    ) -> Result<f64, Unallocated> {
        /// The factor is found to this, relative to it: samples know it no better.
        const RESOLUTION: f64 = 1e-3;
        const SMALLEST: f64 = 1e-3;
        let required = self.model.requirements.iter();
        let required = required.filter(|r| r.target.is_some());
        let mut looked_at: Vec<_> = required.map(|r| (r, Met::none(samples))).collect();
        let mut fails = |by: f64| -> Result<Option<String>, Interrupted> {
            let variations = given.by(&scaled(by));
            for (requirement, met) in &mut looked_at {
                let mut study = self.study(&variations, requirement);
                study.know();
                if !is_monotone {
                    *met = Met::none(samples);
                }
                let found = study.meets(samples, self.options.seed, |i| met.at(i, by));
                let found = found.ok_or(Interrupted)?;
                met.learn(by, &found);
                let count = found.iter().filter(|is| **is).count();
                if (count as f64 / samples as f64) < share {
                    return Ok(Some(requirement.name.clone()));
                }
            }
            Ok(None)
        };
        let (mut lo, mut hi) = (1.0, 1.0);
        while let Some(name) = fails(lo)? {
            (lo, hi) = (0.5 * lo, lo);
            if lo < SMALLEST {
                return Err(Unallocated::NoYield(name));
            }
        }
        while lo == hi && hi < WIDEST {
            if fails(2.0 * hi)?.is_some() {
                hi *= 2.0;
            } else {
                (lo, hi) = (2.0 * hi, 2.0 * hi);
            }
        }
        while hi - lo > RESOLUTION * hi {
            let middle = 0.5 * (lo + hi);
            if fails(middle)?.is_some() {
                hi = middle;
            } else {
                lo = middle;
            }
        }
        Ok(lo)
    }
}

/// The largest factor at which each sample meets a requirement, and the smallest at which it does not, of those at which it was looked at.
struct Met(Vec<[f64; 2]>);

impl Met {
    fn none(samples: u64) -> Self {
        Self(vec![[0.0, f64::INFINITY]; samples as usize])
    }

    /// Whether a sample meets the requirement at a factor, where that is known.
    fn at(&self, sample: usize, by: f64) -> Option<bool> {
        match self.0[sample] {
            [met, _] if by <= met => Some(true),
            [_, not] if by >= not => Some(false),
            _ => None,
        }
    }

    fn learn(&mut self, by: f64, found: &[bool]) {
        for ([met, not], is) in self.0.iter_mut().zip(found) {
            match is {
                true => *met = met.max(by),
                false => *not = not.min(by),
            }
        }
    }
}

/// Variations that have one factor: each alone, or both coordinates of a point in a zone; without those that do not matter.
struct Groups(Vec<Vec<usize>>);

impl Groups {
    fn of(variations: &Variations, matters: &[bool]) -> Self {
        let group = |i: usize| match variations.zone_of(i) {
            Some(zone) if zone.coordinates[0] == i => Some(zone.coordinates.to_vec()),
            Some(_) => None,
            None => Some(vec![i]),
        };
        Self(
            (0..matters.len())
                .filter(|i| matters[*i])
                .filter_map(group)
                .collect(),
        )
    }

    fn limit(&self, of: &Limit) -> Limit {
        let sum = |group: &Vec<usize>| group.iter().map(|i| of.a[*i]).sum();
        let root = |group: &Vec<usize>| {
            let squares = group.iter().map(|i| of.b[*i].powi(2));
            squares.sum::<f64>().sqrt()
        };
        Limit {
            a: self.0.iter().map(sum).collect(),
            b: self.0.iter().map(root).collect(),
            most: of.most,
        }
    }

    fn costs(&self, costs: &[f64]) -> Vec<f64> {
        self.0.iter().map(|group| costs[group[0]]).collect()
    }

    /// The factors of all variations, of which there are `count`, from those of the groups.
    fn factors(&self, of: &[f64], count: usize) -> Vec<f64> {
        let mut all = vec![1.0; count];
        for (group, factor) in self.0.iter().zip(of) {
            for &i in group {
                all[i] = *factor;
            }
        }
        all
    }

    fn cost(&self, costs: &[f64], factor: &dyn Fn(usize) -> f64) -> f64 {
        self.0
            .iter()
            .map(|group| costs[group[0]] / factor(group[0]))
            .sum()
    }
}

impl Variations {
    /// The factor rounded down so that the tolerance has three digits.
    fn rounded(&self, i: usize, factor: f64) -> f64 {
        let v = &self.list[i];
        let zone = self.zone_of(i);
        let width = zone.map_or_else(|| v.deviations[1].max(-v.deviations[0]), |z| 2.0 * z.radius);
        let tolerance = width * factor;
        if tolerance <= 0.0 {
            return factor;
        }
        let unit = 10.0_f64.powf(tolerance.log10().floor() - 2.0);
        // A last digit that is there but for rounding is kept.
        let rounded = (tolerance / unit * (1.0 + 1e-9)).floor() * unit;
        rounded.min(tolerance) / width
    }
}
