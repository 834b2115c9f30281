//! `cspace solve`.

use std::fmt::Write;

use crate::legacy::{Answer as Framed, Outcome};
use cspace_design::{Solved, Span, Value};
use cspace_io::Model;
use cspace_io::model::Dimension;
use cspace_io::shown::{self, quoted};
use serde::Serialize;
use serde_json::Map;

use crate::args::SolveArgs;
use crate::ask::set_threads;
use crate::failure::Failure;
use crate::input;
use crate::interrupt::{catch_interrupts, is_interrupted};
use crate::progress::Bar;

/// The values that were found.
#[derive(Debug, Serialize)]
struct Answer {
    solutions: Vec<Map<String, serde_json::Value>>,
    /// The ranges of a single parameter in which the condition holds.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    ranges: Vec<[f64; 2]>,
    /// The ranges of a single parameter in which nothing is known.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    undecided: Vec<[f64; 2]>,
    /// Why there is no solution.
    none: Option<String>,
}

pub(crate) fn run(args: &SolveArgs) -> Result<(), Failure> {
    args.result.artefact(&[])?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (template, model) = input::template(&args.file, &args.values)?;
    check(args, &model)?;
    let spans: Vec<Span> = (args.vary.iter())
        .map(|v| Span {
            parameter: v.name.clone(),
            lo: v.lo,
            hi: v.hi,
        })
        .collect();
    let bar = Bar::new(model.mechanism.name.clone());
    let solved = bar.watch(|bar| {
        let (set, samples) = (&args.values.set, args.samples as usize);
        cspace_design::solve(&template, set, &spans, &args.so_that, samples, bar)
    });
    if is_interrupted() {
        return Err(Failure::new("the computation was interrupted"));
    }
    let found = answer(&spans, &solved);
    let outcome = match solved.solutions.is_empty() && solved.ranges.is_empty() {
        false => Outcome::yes("solved"),
        true if !solved.undecided.is_empty() => Outcome::open("undecided"),
        true => Outcome::no("none"),
    };
    let unit = model.mechanism.unit.as_deref();
    let framed = Framed::new("solve", unit, outcome, &found);
    super::print(&args.result, &framed, |text| {
        *text = described(&spans, &solved);
        Ok(())
    })
}

/// Refuses names that the model does not have, and values of another kind than the measure.
fn check(args: &SolveArgs, model: &Model) -> Result<(), Failure> {
    let file = args.file.display();
    for (i, v) in args.vary.iter().enumerate() {
        if model.parameters.iter().all(|p| p.name != v.name) {
            let error = format!("{file}: there is no parameter {}", quoted(&v.name));
            return Err(Failure::new(error).help(super::parameters_of(model)));
        }
        if args.vary[..i].iter().any(|w| w.name == v.name) {
            return Err(super::varied_twice(&v.name));
        }
    }
    let goal = &args.so_that;
    let Some(requirement) = model
        .requirements
        .iter()
        .find(|r| r.name == goal.requirement)
    else {
        let error = format!(
            "{file}: there is no requirement {}",
            quoted(&goal.requirement)
        );
        return Err(Failure::new(error).help(super::requirements_of(model)));
    };
    let yes_or_no = requirement.dimension == Dimension::Truth;
    if yes_or_no != matches!(goal.value, Value::Truth(_)) {
        let (is, give) = if yes_or_no {
            ("yes or no", "true or false")
        } else {
            ("a number", "a number such as 0.1 or 0.5deg")
        };
        return Err(Failure::new(format_args!(
            "--so-that: the measure {} is {is}",
            quoted(&goal.requirement)
        ))
        .help(format_args!("give {give}")));
    }
    Ok(())
}

fn answer(spans: &[Span], solved: &Solved) -> Answer {
    let named = |values: &Vec<f64>| {
        let pairs = spans.iter().zip(values);
        pairs
            .map(|(span, value)| (span.parameter.clone(), (*value).into()))
            .collect()
    };
    Answer {
        solutions: solved.solutions.iter().map(named).collect(),
        ranges: solved.ranges.iter().map(|&(lo, hi)| [lo, hi]).collect(),
        undecided: (solved.undecided.iter())
            .map(|&(lo, hi)| [lo, hi])
            .collect(),
        none: solved.none.clone(),
    }
}

fn described(spans: &[Span], solved: &Solved) -> String {
    let mut text = String::new();
    for values in &solved.solutions {
        let pairs = spans.iter().zip(values);
        let named: Vec<String> = pairs
            .map(|(span, value)| format!("{} = {}", span.parameter, shown::number(*value)))
            .collect();
        let _ = writeln!(text, "{}", named.join(", "));
    }
    let ranges = solved.ranges.iter().map(|range| ("it is so", range));
    let undecided = (solved.undecided.iter()).map(|range| ("it could not be decided", range));
    for (is, &(lo, hi)) in ranges.chain(undecided) {
        let name = &spans[0].parameter;
        let at = match lo == hi {
            true => format!("at {}", shown::number(lo)),
            false => format!("from {} to {}", shown::number(lo), shown::number(hi)),
        };
        let _ = writeln!(text, "  {is} with {name} {at}");
    }
    if let Some(reason) = &solved.none {
        let _ = writeln!(text, "none: {reason}");
    }
    text
}
