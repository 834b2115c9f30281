//! Tolerances that are allocated, in words.

use std::fmt::Write;

use cspace_api::Subject;
use cspace_api::tolerances::allocation::{Allocation, Question};
use cspace_design::Criterion;

use super::TolerancesArgs;
use super::text;
use crate::ask::Terminal;
use crate::failure::Failure;

pub(super) fn run(
    args: &TolerancesArgs,
    allocation: &Question,
    subject: &Subject,
    host: &Terminal,
) -> Result<(), Failure> {
    let question = Question {
        requirement: args.analysis.requirement.clone(),
        cost: args.cost.iter().cloned().collect(),
        samples: args.analysis.samples,
        seed: args.analysis.seed,
        ..allocation.clone()
    };
    let answer = question.ask(subject, host)?;
    crate::command::tell(&args.result, &answer, |text, allocation| {
        let unit = subject.unit().map_or(String::new(), |u| format!(" {u}"));
        *text = described(allocation, &unit);
        Ok(())
    })
}

fn described(allocation: &Allocation, unit: &str) -> String {
    let Allocation {
        nominal,
        costs,
        found,
        ..
    } = allocation;
    let (model, given) = (&nominal.model.mechanism, &nominal.variations);
    let mut text = match allocation.criterion {
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
