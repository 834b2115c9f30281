//! `cspace solve`.

use std::fmt::{self, Write};

use cspace_api::solve::{Question, Solutions};
use cspace_design::Span;
use cspace_model::shown::number;

use crate::args::SolveArgs;
use crate::ask::{self, Terminal};
use crate::failure::Failure;

pub(crate) fn run(args: &SolveArgs) -> Result<(), Failure> {
    args.result.artefact(&[])?;
    let subject = ask::read_again(&args.file, &args.values, args.threads)?;
    let question = Question {
        vary: args.vary.clone(),
        so_that: args.so_that.clone(),
        samples: args.samples,
    };
    let answer = question.ask(&subject, &Terminal::default())?;
    super::tell(&args.result, &answer, |text, found| {
        describe(text, &question.vary, found)
    })
}

fn describe(text: &mut String, spans: &[Span], found: &Solutions) -> fmt::Result {
    for values in &found.solutions {
        let named = spans.iter().filter_map(|span| {
            let value = values.get(&span.parameter)?;
            Some(format!("{} = {}", span.parameter, number(*value)))
        });
        writeln!(text, "{}", named.collect::<Vec<_>>().join(", "))?;
    }
    let ranges = found.ranges.iter().map(|range| ("it is so", range));
    let undecided = (found.undecided.iter()).map(|range| ("it could not be decided", range));
    for (is, &[lo, hi]) in ranges.chain(undecided) {
        let name = &spans[0].parameter;
        let at = match lo == hi {
            true => format!("at {}", number(lo)),
            false => format!("from {} to {}", number(lo), number(hi)),
        };
        writeln!(text, "  {is} with {name} {at}")?;
    }
    if let Some(reason) = &found.none {
        writeln!(text, "none: {reason}")?;
    }
    Ok(())
}
