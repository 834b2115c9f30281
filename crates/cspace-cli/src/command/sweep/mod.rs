//! `cspace sweep`.

mod picture;
mod table;

use std::path::PathBuf;

use clap::Args;
use cspace_api::Answer;
use cspace_api::sweep::{Outcome, Question, Rows};

use crate::args::{ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::{Failure, note};
use crate::output;
use crate::picture::PictureArgs;
use crate::wording::count;

use table::{Kept, csv_of, kept, read};

const HELP: &str = "\
Examples:
  cspace sweep models/ratchet_pawl.toml --vary tip=49.9:50.1:5
  cspace sweep models/ratchet_pawl.toml --vary tip=49:50:5 --vary root=43:45:3
  cspace sweep models/ratchet_pawl.toml --rows sizes.csv -o measured.csv

A column for each name and each measure, and the column failure: an empty field
has its reason there. Angles are in radians. -o OUT.csv or .json writes the
table as well, -o OUT.svg, .png or .pdf a curve over what is varied last.
Ctrl-C ends it and keeps the rows that are done.
";

/// Arguments of `cspace sweep`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct SweepArgs {
    /// A model (.toml, .json)
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    #[command(flatten)]
    pub(crate) question: Question,
    /// Rows of values in place of --vary: CSV with names in its first line
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["vary", "changes"])]
    pub(crate) rows: Option<PathBuf>,
    /// Keep the rows that the table OUT.csv of an interrupted sweep has, and compute those that it lacks; the model and the other
    /// arguments must be the same
    #[arg(long, conflicts_with = "changes")]
    pub(crate) resume: bool,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

pub(crate) fn run(args: &SweepArgs) -> Result<(), Failure> {
    let output = (args.result).artefact(&["csv", "json", "svg", "png", "pdf"])?;
    let format = crate::picture::format(output);
    if format.is_none() {
        args.picture.refuse()?;
    }
    output::check(output)?;
    let subject = ask::read_again(&args.file, &args.values, args.threads)?;
    let host = Terminal::default();
    let question = Question {
        rows: args.rows.as_deref().map(read).transpose()?,
        ..args.question.clone()
    };
    let table = question.table(&subject, &host)?;
    if format.is_some() {
        picture::check(args, &table)?;
    }
    let kept = match output {
        _ if !args.resume => Kept::default(),
        Some(path) if output::ends_in(path, "csv") => kept(path, &table)?,
        _ => {
            return Err(
                Failure::new("--resume goes on with a table in CSV").help("name it: -o OUT.csv")
            );
        }
    };
    // A picture has the values of all rows, also where changes are asked for.
    let rows = match question.changes && format.is_none() {
        true => None,
        false => Some(table.rows(&subject, &host, &kept.cells())?),
    };
    let changes = match question.changes {
        true => Some(table.changes(&subject, &host)?),
        false => None,
    };
    if let (Some(format), Some(rows)) = (format, &rows) {
        let changes = changes.as_ref().map(|answer| &answer.content);
        let scene = picture::drawn(args, &subject, &table, (rows, changes))?;
        crate::picture::write(output, format, &scene)?;
    }
    let total = table.values.rows.len();
    match (changes, rows) {
        (Some(changes), _) => {
            written(args, &changes, &Kept::default())?;
            match changes.outcome {
                Outcome::Done | Outcome::None => Ok(()),
                Outcome::Interrupted => Err(Failure::new(
                    "interrupted: the changes that were found are written",
                )),
            }
        }
        (None, Some(rows)) => {
            written(args, &rows, &kept)?;
            match rows.outcome {
                Outcome::Done | Outcome::None => Ok(()),
                Outcome::Interrupted => Err(interrupted(args, rows.content.rows.len(), total)),
            }
        }
        (None, None) => Ok(()),
    }
}

/// The failure of a table of which so many rows are done.
fn interrupted(args: &SweepArgs, done: usize, total: usize) -> Failure {
    let failure = Failure::new(format_args!(
        "interrupted: {done} of {} are done",
        count(total, "row", "rows")
    ));
    match args.result.output.as_deref() {
        Some(path) if output::ends_in(path, "csv") => failure.help(format_args!(
            "they are in {}: go on with --resume",
            path.display()
        )),
        _ => failure.help("with -o OUT.csv they are kept, and --resume goes on"),
    }
}

/// Prints a table, and writes it to the file that is asked for beside it.
fn written(args: &SweepArgs, answer: &Answer<Rows>, kept: &Kept) -> Result<(), Failure> {
    let csv = csv_of(kept, &answer.content)?;
    let output = args.result.output.as_deref();
    if let Some(path) = output.filter(|path| output::ends_in(path, "csv")) {
        output::write(Some(path), &csv)?;
    }
    let printed = super::tell(&args.result, answer, |text, _| {
        text.push_str(&String::from_utf8_lossy(&csv));
        Ok(())
    });
    // Where it is interrupted the failure says so.
    match answer.outcome {
        // Of changes the question itself gives the reason.
        Outcome::None if !args.question.changes => {
            note("no row has a value: the column failure has the reasons");
            printed
        }
        Outcome::Done | Outcome::None => printed,
        Outcome::Interrupted => Ok(()),
    }
}
