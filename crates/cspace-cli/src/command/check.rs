//! `cspace check`.

use std::fmt::{self, Write};
use std::path::PathBuf;

use clap::Args;
use cspace_api::check::{Amount, Question, Requirement};
use cspace_api::{Is, Outcome as _, Subject};
use cspace_design::Sensitivity;
use cspace_model::Mechanism;
use cspace_model::model::Dimension;

use crate::args::{CacheArgs, ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::subject::{motions, placed_by_name};
use crate::wording::{count, degrees, length};

const HELP: &str = "\
Examples:
  cspace check models/ratchet_pawl.toml
  cspace check models/ratchet_pawl.toml --set tip=50.02
  cspace check models/ratchet_pawl.toml --json

Requirements are [[requirement]] tables of the model: what is measured, and what
it must be. Each is printed with its value, its limits, and what touches there.
The exit code is 1 if one is not met, and 2 if one is not decided or cannot be
measured.
";

/// Arguments of `cspace check`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct CheckArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    #[command(flatten)]
    pub(crate) question: Question,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) cache: CacheArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

pub(crate) fn run(args: &CheckArgs) -> Result<(), Failure> {
    args.result.artefact(&[])?;
    let read = match args.question.sensitivities {
        true => ask::read_again,
        false => ask::read,
    };
    let subject = read(&args.file, &args.values, args.threads)?;
    let answer = args.question.ask(&subject, &Terminal::new(args.cache))?;
    super::tell(&args.result, &answer, |text, found| {
        let Subject::Model(file) = &subject else {
            return Ok(());
        };
        let mechanism = &file.model.mechanism;
        let unit = subject.unit().map_or(String::new(), |u| format!(" {u}"));
        describe(text, mechanism, &found.requirements, &unit)?;
        summary(text, &found.requirements)
    })
}

/// How many of several requirements are not met, and not decided.
fn summary(text: &mut String, rows: &[Requirement]) -> fmt::Result {
    let of = |is: Is| rows.iter().filter(|row| row.outcome.is() == is).count();
    let all = count(rows.len(), "requirement", "requirements");
    for (n, are) in [(of(Is::No), "not met"), (of(Is::Open), "without an answer")] {
        if n > 0 && rows.len() > 1 {
            write!(text, "\n{n} of {all} {are}\n")?;
        }
    }
    Ok(())
}

fn describe(text: &mut String, model: &Mechanism, rows: &[Requirement], unit: &str) -> fmt::Result {
    /// More pairs of features are counted.
    const MOST: usize = 2;
    for (i, row) in rows.iter().enumerate() {
        if i > 0 {
            text.push('\n');
        }
        let number = |x: f64| match row.dimension {
            Dimension::Angle => degrees(x),
            Dimension::Time => format!("{} s", length(x)),
            Dimension::Number | Dimension::Truth => length(x),
            Dimension::Length => format!("{}{unit}", length(x)),
        };
        writeln!(text, "{}: {}", row.name, row.outcome.word())?;
        let value = match row.value {
            None => "none".to_owned(),
            Some(Amount::Number(x)) => number(x),
            Some(Amount::Truth(true)) => "yes".to_owned(),
            Some(Amount::Truth(false)) => "no".to_owned(),
        };
        writeln!(text, "  {:10} {value}", row.measure)?;
        if let Some(gap) = row.gap {
            let what = "the parts fit exactly, and the moving one is smaller by it all around";
            writeln!(text, "  {:10} {gap:.1e}{unit}: {what}", "gap")?;
        }
        if let Some(failure) = &row.failure {
            writeln!(text, "  {:10} {failure}", "because")?;
        }
        if let Some([lo, hi]) = row.limits {
            writeln!(text, "  {:10} {} to {}", "limits", number(lo), number(hi))?;
        }
        if let Some(wanted) = row.equals {
            writeln!(
                text,
                "  {:10} {}",
                "required",
                if wanted { "yes" } else { "no" }
            )?;
        }
        if let Some(margin) = row.margin {
            writeln!(text, "  {:10} {}", "margin", number(margin))?;
        }
        if let Some([lo, hi]) = row.range {
            let label = match row.measure {
                "backlash" => "over turn",
                "fits" => "between",
                _ => "free",
            };
            writeln!(text, "  {label:10} {} to {}", number(lo), number(hi))?;
        }
        // A position is a coordinate of its place.
        if let (Some(at), Some([fixed, moving])) = (row.at, &row.pair)
            && row.measure != "position"
        {
            let at = motions(model, [fixed, moving], at, unit);
            writeln!(text, "  {:10} {at}", "at")?;
        }
        let derivative = |x: f64| {
            // No zero is negative.
            let x = x + 0.0;
            let (x, unit) = if row.dimension == Dimension::Angle {
                (x.to_degrees(), " deg")
            } else {
                (x, "")
            };
            if x == 0.0 || x.abs() >= 1e-3 {
                format!("{x:.6}{unit}")
            } else {
                format!("{x:.4e}{unit}")
            }
        };
        for Sensitivity {
            parameter,
            derivative: found,
        } in &row.by
        {
            let is = match found {
                Err(reason) => format!("none: {reason}"),
                Ok([below, above]) if below == above => derivative(*above),
                Ok([below, above]) => {
                    let (below, above) = (derivative(*below), derivative(*above));
                    format!("{above}; {below} for smaller values")
                }
            };
            let name = format!("by {parameter}");
            writeln!(text, "  {name:10} {is}")?;
        }
        let parts = row.pair.iter().cycle();
        for ([a, b], [fixed, moving]) in row.touching.iter().take(MOST).zip(parts) {
            let a = placed_by_name(model, fixed, a);
            let b = placed_by_name(model, moving, b);
            writeln!(text, "  {:10} {a}, {b}", "touching")?;
        }
        if let Some(more) = row.touching.len().checked_sub(MOST).filter(|n| *n > 0) {
            writeln!(text, "  {:10} {more} more", "")?;
        }
    }
    Ok(())
}
