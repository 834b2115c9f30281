//! `cspace solve`.

use std::fmt::{self, Write};
use std::path::PathBuf;

use clap::Args;
use cspace_api::solve::{Question, Solutions};
use cspace_design::Span;
use cspace_model::shown::number;

use crate::args::{ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;

const HELP: &str = "\
Examples:
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 \\
      --so-that \"clear of the face = 0.04\"
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 \\
      --so-that \"clear of the face >= 0.04\"
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 --vary root=43:45 \\
      --so-that \"clear of the face = 0.04\"

Values are exact to some 12 digits of the range. Of one parameter all that were
found are printed; between two of the N values at which is measured, one is
missed if the measure comes near only there and goes away again. Angles are in
radians, unless they have a unit.
";

/// Arguments of `cspace solve`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct SolveArgs {
    /// A model (.toml, .json)
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    #[command(flatten)]
    pub(crate) question: Question,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

pub(crate) fn run(args: &SolveArgs) -> Result<(), Failure> {
    args.result.artefact(&[])?;
    let subject = ask::read_again(&args.file, &args.values, args.threads)?;
    let answer = args.question.ask(&subject, &Terminal::default())?;
    super::tell(&args.result, &answer, |text, found| {
        describe(text, &args.question.vary, found)
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
