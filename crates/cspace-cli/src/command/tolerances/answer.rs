//! The analysis of tolerances as JSON.

use std::collections::BTreeMap;

use crate::legacy::Outcome;
use cspace_design::{ChangeKind, Extreme, MonteCarlo, Structural, Tolerances, Value, Variations};
use serde::Serialize;
use serde_json::{Map, Value as Json};

/// The effect of the tolerances on a requirement.
#[derive(Debug, Serialize)]
pub(crate) struct Row {
    requirement: String,
    measure: &'static str,
    /// In the model's unit or radians, or true or false; none where it has no value as drawn.
    nominal: Json,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    limits: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    equals: Option<bool>,
    /// The pairs of features, of the fixed and of the moving part, that determine the nominal value.
    touching: Vec<[String; 2]>,
    sensitivities: Map<String, Json>,
    linear: Option<[f64; 2]>,
    rss: Option<[f64; 2]>,
    exact: Option<Exact>,
    structure: Vec<Change>,
    /// The factor on all tolerances at which something fails; none if nothing does up to 16.
    margin: Option<f64>,
    /// How it came out.
    pub(super) outcome: Outcome,
    /// The condition that fails at that factor.
    fails: String,
    /// Whether the computation was interrupted: what needs more than derivatives as drawn is not known then.
    #[serde(skip_serializing_if = "core::ops::Not::not")]
    interrupted: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    monte_carlo: Option<Samples>,
}

#[derive(Debug, Serialize)]
struct Exact {
    lo: End,
    hi: End,
}

#[derive(Debug, Serialize)]
pub(super) struct End {
    value: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    /// The values of the parameters there.
    at: Map<String, Json>,
    certified: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    gap: Option<f64>,
    /// Whether the value jumps there, and comes as near to this as one likes.
    #[serde(skip_serializing_if = "core::ops::Not::not")]
    jumps: bool,
}

#[derive(Debug, Serialize)]
struct Change {
    kind: &'static str,
    what: String,
    features: Vec<[String; 2]>,
    at: Map<String, Json>,
    share: f64,
}

#[derive(Debug, Serialize)]
struct Samples {
    samples: u64,
    r#yield: f64,
    error: f64,
    below: f64,
    above: f64,
    failures: BTreeMap<String, f64>,
    mean: Option<f64>,
    sigma: Option<f64>,
    skewness: Option<f64>,
    kurtosis: Option<f64>,
    range: Option<[f64; 2]>,
    /// The edges of the bars, and how many values are in each.
    histogram: Histogram,
    /// The share of samples that needed a configuration space of their own.
    computed: f64,
}

#[derive(Debug, Serialize)]
struct Histogram {
    edges: Vec<f64>,
    counts: Vec<u64>,
}

/// The values of the parameters at deviations from them.
fn values(variations: &Variations, deviations: &[f64]) -> Map<String, Json> {
    let all = variations.list.iter().zip(deviations);
    all.map(|(v, by)| (v.parameter.name.clone(), (v.parameter.value + by).into()))
        .collect()
}

/// The answer of `cspace tolerances --format json`.
pub(crate) fn rows(variations: &Variations, found: &[Tolerances]) -> Vec<Row> {
    found.iter().map(|t| row(variations, t)).collect()
}

/// An extreme.
pub(super) fn end(variations: &Variations, of: &Extreme) -> End {
    End {
        value: of.value.as_ref().ok().copied(),
        failure: of.value.as_ref().err().cloned(),
        at: values(variations, &of.at),
        certified: of.certified,
        gap: of.gap,
        jumps: of.jumps,
    }
}

fn row(variations: &Variations, of: &Tolerances) -> Row {
    let requirement = &of.nominal.requirement;
    let linear = of.linear.as_ref();
    let sensitivities = linear.iter().flat_map(|l| &l.parameters).map(|p| {
        let mut entry = Map::new();
        let [below, above] = p.derivative;
        entry.insert("derivative".into(), above.into());
        if below != above {
            entry.insert("below".into(), below.into());
        }
        entry.insert("worst_share".into(), p.worst_share.into());
        entry.insert("variance_share".into(), p.variance_share.into());
        (p.parameter.clone(), Json::Object(entry))
    });
    let change = |c: &Structural| Change {
        kind: c.kind.name(),
        what: c.what.clone(),
        features: c.features.clone(),
        at: values(variations, &c.at),
        share: c.share,
    };
    Row {
        requirement: requirement.name.clone(),
        measure: requirement.subject.name(),
        nominal: match of.nominal.measured.as_ref().map(|m| m.value) {
            Ok(Value::Number(x)) => x.into(),
            Ok(Value::Truth(is)) => is.into(),
            Err(_) => Json::Null,
        },
        failure: of.nominal.measured.as_ref().err().map(ToString::to_string),
        limits: requirement.limits(),
        equals: requirement.equals(),
        touching: of.nominal.touching.clone(),
        sensitivities: sensitivities.collect(),
        linear: linear.map(|l| l.worst),
        rss: linear.map(|l| l.rss),
        exact: (of.exact.as_ref()).map(|[lo, hi]| Exact {
            lo: end(variations, lo),
            hi: end(variations, hi),
        }),
        structure: of.structure.iter().map(change).collect(),
        margin: of.margin.factor,
        outcome: outcome(of),
        fails: of.margin.what.clone(),
        interrupted: of.interrupted,
        monte_carlo: of.monte_carlo.as_ref().map(samples),
    }
}

/// How a requirement fares within the tolerances.
pub(super) fn outcome(of: &Tolerances) -> Outcome {
    let factor = of.margin.factor;
    let happens = of.structure.iter().find(|c| Some(c.share) == factor);
    match factor {
        _ if of.interrupted => Outcome::open("interrupted"),
        Some(0.0) => Outcome::no("not-met"),
        Some(factor) if factor < 1.0 => match happens.map(|c| c.kind) {
            Some(ChangeKind::Jam) => Outcome::no("jams"),
            _ => Outcome::no("fails"),
        },
        _ if of.nominal.measured.is_err() && of.nominal.requirement.target.is_none() => {
            Outcome::open("no-value")
        }
        _ => Outcome::yes("holds"),
    }
}

fn samples(of: &MonteCarlo) -> Samples {
    let [mean, sigma, skewness, kurtosis] = of.moments.map(|m| m.is_finite().then_some(m));
    let (edges, counts) = of.histogram.clone();
    Samples {
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
