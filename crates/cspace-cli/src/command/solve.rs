//! `cspace solve`.

use std::fmt::{self, Write};
use std::path::PathBuf;

use clap::Args;
use cspace_api::solve::{Question, Solutions};
use cspace_api::{Outcome as _, Subject};
use cspace_design::Span;
use cspace_model::model::Parameter;

use crate::args::{ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::wording::{degrees, length};

const HELP: &str = "\
Examples:
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 \\
      --so-that \"clear of the face = 0.04\"
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 \\
      --so-that \"clear of the face >= 0.04\"
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 --vary root=43:45 \\
      --so-that \"clear of the face = 0.04\"

Values are exact to some 12 digits of the range, which --json has all of. Of one
parameter all that were found are printed; between two of the N values at which
is measured, one is missed if the measure comes near only there and goes away
again. Angles are given in radians, unless they have a unit.
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
    let parameters = match &subject {
        Subject::Model(file) => &file.model.parameters[..],
        Subject::Saved { .. } => &[],
    };
    super::tell(&args.result, &answer, |text, found| {
        // Why there is none stands behind the word.
        match &found.none {
            Some(reason) => writeln!(text, "{}: {reason}", answer.outcome.word())?,
            None => writeln!(text, "{}", answer.outcome.word())?,
        }
        describe(text, &args.question.vary, parameters, found)
    })
}

fn describe(
    text: &mut String,
    spans: &[Span],
    parameters: &[Parameter],
    found: &Solutions,
) -> fmt::Result {
    let number = |name: &str, x: f64| {
        let parameter = parameters.iter().find(|p| p.name == name);
        match parameter.is_some_and(|p| p.is_angle) {
            true => degrees(x),
            false => length(x),
        }
    };
    for values in &found.solutions {
        let named = spans.iter().filter_map(|span| {
            let value = values.get(&span.parameter)?;
            let value = number(&span.parameter, *value);
            Some(format!("{} = {value}", span.parameter))
        });
        writeln!(text, "  {}", named.collect::<Vec<_>>().join(", "))?;
    }
    let ranges = found.ranges.iter().map(|range| ("it is so", range));
    let undecided = (found.undecided.iter()).map(|range| ("it could not be decided", range));
    for (is, &[lo, hi]) in ranges.chain(undecided) {
        let name = &spans[0].parameter;
        let at = match lo == hi {
            true => format!("at {}", number(name, lo)),
            false => format!("from {} to {}", number(name, lo), number(name, hi)),
        };
        writeln!(text, "  {is} with {name} {at}")?;
    }
    Ok(())
}
