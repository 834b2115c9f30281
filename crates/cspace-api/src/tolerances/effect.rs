//! The effect of tolerances on one requirement.

use std::collections::BTreeMap;

use cspace_design::{
    ChangeKind, Extreme as Found, MonteCarlo, Structural, Tolerances, Value, Variations,
};
use schemars::JsonSchema;
use serde::Serialize;

use crate::outcome::outcomes;

outcomes! {
    /// How a requirement fares within the tolerances.
    Outcome {
        /// It is met within all of them.
        Holds = "holds" is Yes,
        /// It is not met within some of them.
        Fails = "fails" is No,
        /// The parts overlap within some of them where it is measured.
        Jams = "jams" is No,
        /// It is not met as drawn.
        NotMet = "not-met" is No,
        /// It only measures, and has no value as drawn.
        NoValue = "no-value" is Open,
        /// The computation was interrupted: what needs more than derivatives as drawn is not known.
        Interrupted = "interrupted" is Open,
    }
}

impl Outcome {
    /// How a requirement fares.
    pub fn of(found: &Tolerances) -> Self {
        let factor = found.margin.factor;
        let happens = found.structure.iter().find(|c| Some(c.share) == factor);
        match factor {
            _ if found.interrupted => Self::Interrupted,
            Some(0.0) => Self::NotMet,
            Some(factor) if factor < 1.0 => match happens.map(|c| c.kind) {
                Some(ChangeKind::Jam) => Self::Jams,
                _ => Self::Fails,
            },
            _ if found.nominal.measured.is_err() && found.nominal.requirement.target.is_none() => {
                Self::NoValue
            }
            _ => Self::Holds,
        }
    }
}

/// The effect of the tolerances on a requirement.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Effect {
    /// The name of the requirement.
    pub requirement: String,
    /// The kind of the quantity.
    pub measure: &'static str,
    /// The value as drawn, in the model's unit, radians or seconds, or true or false; null where it has none.
    pub nominal: Option<Value>,
    /// Why it has no value as drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// The smallest and the largest value that is allowed; left out where there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limits: Option<[f64; 2]>,
    /// The truth that is required; left out where none is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub equals: Option<bool>,
    /// The pairs of features, of the fixed and of the moving part, that determine the value as drawn.
    pub touching: Vec<[String; 2]>,
    /// Influence of each parameter with a tolerance on the value, by its name.
    pub sensitivities: BTreeMap<String, Sensitivity>,
    /// The linear worst cases; null of yes and no.
    pub linear: Option<[f64; 2]>,
    /// The root of the sum of squares to both sides of the value in the middle of the tolerances; null of yes and no.
    pub rss: Option<[f64; 2]>,
    /// The smallest and the largest value; null of yes and no.
    pub exact: Option<Extremes>,
    /// Changes of what touches, the first first.
    pub structure: Vec<Change>,
    /// The factor on all tolerances at which something fails; null if nothing does up to 16.
    pub margin: Option<f64>,
    /// How it came out.
    pub outcome: Outcome,
    /// The failure at that factor, in words.
    pub fails: String,
    /// True where the computation was interrupted: extremes, structure, margin and samples are not known then; left out otherwise.
    #[serde(skip_serializing_if = "core::ops::Not::not")]
    pub interrupted: bool,
    /// Results of samples by chance, if they are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub monte_carlo: Option<Samples>,
}

/// The influence of a parameter on a value.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Sensitivity {
    /// The derivative of the value by the parameter; for larger values of the parameter where that differs.
    pub derivative: f64,
    /// The derivative for smaller values of the parameter, where that differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub below: Option<f64>,
    /// Its share of the linear worst case, from 0 to 1.
    pub worst_share: f64,
    /// Its share of the variance, from 0 to 1.
    pub variance_share: f64,
}

/// The smallest and the largest value within the tolerances.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Extremes {
    /// The smallest value.
    pub lo: Extreme,
    /// The largest value.
    pub hi: Extreme,
}

/// The smallest or the largest value within the tolerances.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Extreme {
    /// The value; null where there is none.
    pub value: Option<f64>,
    /// Why there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// The values of the parameters there, by their names.
    pub at: BTreeMap<String, f64>,
    /// Whether it is proved that nothing within the tolerances is beyond it.
    pub certified: bool,
    /// How much farther it might be at most, where it is not proved and that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// True where the value jumps at the place and comes as near to this as one likes; left out otherwise.
    #[serde(skip_serializing_if = "core::ops::Not::not")]
    pub jumps: bool,
}

/// A change of what touches, or of whether there is a value.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Change {
    /// Its kind.
    pub kind: ChangeKind,
    /// The state after it, in words.
    pub what: String,
    /// Features of the fixed and of the moving part.
    pub features: Vec<[String; 2]>,
    /// The values of the parameters at which it first happens, by their names.
    pub at: BTreeMap<String, f64>,
    /// How many times the tolerances that is.
    pub share: f64,
}

/// Results of samples by chance.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Samples {
    /// The number of samples.
    pub samples: u64,
    /// The share that meets the requirement; without limits, that has a value.
    pub r#yield: f64,
    /// The standard error of that share.
    pub error: f64,
    /// The share below the limits.
    pub below: f64,
    /// The share above the limits.
    pub above: f64,
    /// The shares without a value, by kind.
    pub failures: BTreeMap<String, f64>,
    /// The mean of the values.
    pub mean: Option<f64>,
    /// Their standard deviation.
    pub sigma: Option<f64>,
    /// Their skewness.
    pub skewness: Option<f64>,
    /// Their excess kurtosis.
    pub kurtosis: Option<f64>,
    /// The smallest and the largest value.
    pub range: Option<[f64; 2]>,
    /// How the values are distributed.
    pub histogram: Histogram,
    /// The share of samples that needed a configuration space of their own.
    pub computed: f64,
}

/// Bars of equal width.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Histogram {
    /// The edges of the bars.
    pub edges: Vec<f64>,
    /// How many values are in each bar.
    pub counts: Vec<u64>,
}

/// The values of the parameters at deviations from them.
fn values(variations: &Variations, deviations: &[f64]) -> BTreeMap<String, f64> {
    let all = variations.list.iter().zip(deviations);
    all.map(|(v, by)| (v.parameter.name.clone(), v.parameter.value + by))
        .collect()
}

/// The effects of tolerances that were analysed.
pub fn effects(variations: &Variations, found: &[Tolerances]) -> Vec<Effect> {
    found.iter().map(|t| Effect::of(variations, t)).collect()
}

impl Effect {
    fn of(variations: &Variations, of: &Tolerances) -> Self {
        let requirement = &of.nominal.requirement;
        let measured = of.nominal.measured.as_ref();
        let linear = of.linear.as_ref();
        let sensitivities = linear.iter().flat_map(|l| &l.parameters).map(|p| {
            let [below, above] = p.derivative;
            let sensitivity = Sensitivity {
                derivative: above,
                below: (below != above).then_some(below),
                worst_share: p.worst_share,
                variance_share: p.variance_share,
            };
            (p.parameter.clone(), sensitivity)
        });
        let change = |change: &Structural| Change {
            kind: change.kind,
            what: change.what.clone(),
            features: change.features.clone(),
            at: values(variations, &change.at),
            share: change.share,
        };
        Self {
            requirement: requirement.name.clone(),
            measure: requirement.subject.name(),
            nominal: measured.ok().map(|m| m.value),
            failure: measured.err().map(ToString::to_string),
            limits: requirement.limits(),
            equals: requirement.equals(),
            touching: of.nominal.touching.clone(),
            sensitivities: sensitivities.collect(),
            linear: linear.map(|l| l.worst),
            rss: linear.map(|l| l.rss),
            exact: (of.exact.as_ref()).map(|[lo, hi]| Extremes {
                lo: Extreme::of(variations, lo),
                hi: Extreme::of(variations, hi),
            }),
            structure: of.structure.iter().map(change).collect(),
            margin: of.margin.factor,
            outcome: Outcome::of(of),
            fails: of.margin.what.clone(),
            interrupted: of.interrupted,
            monte_carlo: of.monte_carlo.as_ref().map(Samples::of),
        }
    }
}

impl Extreme {
    pub(super) fn of(variations: &Variations, of: &Found) -> Self {
        Self {
            value: of.value.as_ref().ok().copied(),
            failure: of.value.as_ref().err().cloned(),
            at: values(variations, &of.at),
            certified: of.certified,
            gap: of.gap,
            jumps: of.jumps,
        }
    }
}

impl Samples {
    fn of(of: &MonteCarlo) -> Self {
        let [mean, sigma, skewness, kurtosis] = of.moments.map(|m| m.is_finite().then_some(m));
        let (edges, counts) = of.histogram.clone();
        Self {
            samples: of.samples,
            r#yield: of.met,
            error: of.error,
            below: of.outside[0],
            above: of.outside[1],
            failures: of.failures.clone(),
            mean,
            sigma,
            skewness,
            kurtosis,
            range: of.range[0].is_finite().then_some(of.range),
            histogram: Histogram { edges, counts },
            computed: of.computed,
        }
    }
}
