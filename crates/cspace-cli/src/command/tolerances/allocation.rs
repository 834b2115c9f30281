//! Tolerances that are allocated, in words and as JSON.

use std::fmt::{Display, Write};

use cspace_design::{Allocation, Criterion, Unallocated, Variations};
use cspace_model::Mechanism;
use serde::Serialize;
use serde_json::{Map, Value as Json, json};

use super::answer::{Row, rows};
use super::text;
use crate::failure::Failure;

/// The answer of `cspace tolerances --allocate --format json`.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    /// "worst", or the yield that is required.
    criterion: Json,
    parameters: Map<String, Json>,
    /// Costs of the given and of the allocated tolerances.
    cost: [f64; 2],
    /// The requirements under the allocated tolerances.
    requirements: Vec<Row>,
}

pub(super) fn failure(file: &dyn Display, error: Unallocated) -> Failure {
    let help = match &error {
        Unallocated::Interrupted => return Failure::new(error),
        Unallocated::NoLimits => {
            "give a measure that is a number limits = [0, 0.5]; yes and no are not allocated"
        }
        Unallocated::NotMet(_) => "see what it is with cspace check",
        Unallocated::NoYield(_) => "see what fails with cspace tolerances --samples 10000",
    };
    Failure::new(format_args!("{file}: {error}")).help(help)
}

pub(super) fn answer(criterion: Criterion, costs: &[f64], found: &Allocation) -> Answer {
    let list = found.variations.list.iter().enumerate();
    let parameter = |(i, v): (usize, &cspace_design::Variation)| {
        let zone = found.variations.zone_of(i);
        let given = match zone {
            Some(zone) => json!({ "position": 2.0 * zone.radius }),
            None => json!({ "minus": -v.deviations[0], "plus": v.deviations[1] }),
        };
        let mut entry = Map::new();
        entry.insert("factor".into(), found.factors[i].into());
        entry.insert("cost".into(), costs[i].into());
        entry.insert("matters".into(), found.matters[i].into());
        if let Json::Object(given) = given {
            entry.extend(given);
        }
        (v.parameter.name.clone(), Json::Object(entry))
    };
    Answer {
        criterion: match criterion {
            Criterion::Worst => "worst".into(),
            Criterion::Yield(share) => share.into(),
        },
        parameters: list.map(parameter).collect(),
        cost: found.cost,
        requirements: rows(&found.variations, &found.tolerances),
    }
}

pub(super) fn text(
    criterion: Criterion,
    (given, costs): (&Variations, &[f64]),
    found: &Allocation,
    (model, unit): (&Mechanism, &str),
) -> String {
    let mut text = match criterion {
        Criterion::Worst => {
            "tolerances at which every part meets the limits, at the least cost\n".to_owned()
        }
        Criterion::Yield(share) => {
            format!(
                "tolerances at which {} % of the parts meet each limit, at the least cost\n",
                100.0 * share
            )
        }
    };
    let list = &found.variations.list;
    let names = list.iter().map(|v| v.parameter.name.chars().count());
    let wide = names.max().unwrap_or(0).max("parameter".len());
    // Writing to text does not fail.
    let _ = writeln!(
        text,
        "  {:wide$}  {:>20}  {:>20}  {:>8}  {:>8}",
        "parameter", "given", "allocated", "factor", "cost"
    );
    for (i, v) in list.iter().enumerate() {
        let name = &v.parameter.name;
        let (from, to) = (
            text::tolerance(given, i),
            text::tolerance(&found.variations, i),
        );
        let _ = if found.matters[i] {
            let (factor, cost) = (found.factors[i], costs[i] / found.factors[i]);
            writeln!(
                text,
                "  {name:wide$}  {from:>20}  {to:>20}  {factor:>8.4}  {cost:>8.4}"
            )
        } else {
            writeln!(
                text,
                "  {name:wide$}  {from:>20}  {to:>20}  it does not matter"
            )
        };
    }
    let [before, after] = found.cost;
    let _ = writeln!(
        text,
        "  cost {before:.4} as given, {after:.4} as allocated\n"
    );
    text += &text::described(model, &found.variations, &found.tolerances, unit);
    text
}
