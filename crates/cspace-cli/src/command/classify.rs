//! `cspace classify`.

use std::path::Path;

use clap::Args;
use cspace::Classification;
use cspace_api::classify::{Cell, Column, Given, Question, Row};

use crate::args::Common;
use crate::ask;
use crate::command::rows::{self, read};
use crate::failure::Failure;
use crate::input;
use crate::output;

const HELP: &str = "\
Examples:
  printf 'x,y,theta\\n42,56,0\\n' | cspace classify models/ratchet_pawl.toml
  cspace classify latch.toml --columns class,region,distance < rows.csv
  cspace classify latch.toml --columns touching --touch 0.1 < rows.csv

The first row names the columns, in any order: x, y and theta, or, for a pair
with fixed axes, u and v, the motions of the fixed and of the moving part. With
--general such a pair too is asked by x, y and theta, not by u and v. Other
columns are repeated and not looked at. Angles are radians, or have a unit such
as 18deg, and are at most 1e6 rad from 0. The answer repeats the columns and
adds those of --columns, which the input may not have:

  class     free: the interiors of the parts do not meet; blocked: they do;
            contact: within the resolution of the boundary between the two
  region    the number of the free region: 0 for `outside`, 1 for `pocket 1`;
            empty where not free
  distance  how far the moving part moves to the nearest contact: a length at
            that orientation, or, on fixed axes, along or about its axis; 0 in
            contact, empty where blocked or nothing is met
  touching  features no farther apart than --touch, FIXED|MOVING, several
            joined by ;

FILE may be a saved contact space, so that many lists are classified without
computing it again.";

/// Arguments of `cspace classify`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ClassifyArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) question: Question,
}

/// As of a saved space.
const MOST_BYTES: u64 = 1 << 30;

/// Where the rows are read from.
const SOURCE: &str = "standard input";

pub(crate) fn run(args: &ClassifyArgs) -> Result<(), Failure> {
    let common = &args.common;
    let output = common.result.artefact(&["csv", "json"])?;
    if common.file == Path::new(output::STANDARD) {
        let failure = Failure::new("the model and the rows both come from standard input");
        return Err(failure.help("give the model as a file, and the rows on standard input"));
    }
    let (subject, host) = ask::open(common)?;
    let columns = &args.question.columns;
    let mut question = args.question.clone();
    question.source = Some(SOURCE.to_owned());
    let pair = subject.one_pair(&question.which, &host)?;
    let help = "divide the rows, and classify one part after the other";
    let bytes = input::stdin(MOST_BYTES, help)?;
    question.check(&host)?;
    let format = common.result.format();
    let rows = read((SOURCE, &bytes), &pair, format, columns)?;
    question.rows = given(&rows);
    let answer = question.ask(&pair)?;
    let found = answer.content.pairs.iter().flat_map(|p| &p.content.rows);
    let csv = as_csv(&rows, columns, found)?;
    if let Some(path) = output.filter(|path| output::ends_in(path, "csv")) {
        output::write(Some(path), &csv)?;
    }
    super::tell(&common.result, &answer, |text, _| {
        // Rows of text are text.
        text.push_str(&String::from_utf8_lossy(&csv));
        Ok(())
    })
}

/// The rows, with their columns as they are repeated.
fn given(rows: &rows::Rows) -> Vec<Given> {
    let columns = |record: &csv::StringRecord| {
        let names = rows.header.iter().map(str::to_owned);
        names.zip(record.iter().map(Cell::from)).collect()
    };
    (rows.configurations.iter().zip(&rows.records))
        .map(|(&at, record)| Given {
            at,
            columns: columns(record),
            line: record.position().map(csv::Position::line),
        })
        .collect()
}

fn as_csv<'a>(
    rows: &rows::Rows,
    columns: &[Column],
    found: impl Iterator<Item = &'a Row>,
) -> Result<Vec<u8>, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header = rows.header.clone();
    header.extend(columns.iter().map(|c| c.name()));
    writer.write_record(&header).map_err(Failure::new)?;
    for (record, row) in rows.records.iter().zip(found) {
        let mut record = record.clone();
        record.extend(columns.iter().map(|&column| cell(row, column)));
        writer.write_record(&record).map_err(Failure::new)?;
    }
    writer.into_inner().map_err(Failure::new)
}

/// A column of a row as in a table; empty where there is none.
fn cell(row: &Row, column: Column) -> String {
    let cell = match column {
        Column::Class => row.class.map(|class| match class {
            Classification::Free => "free".to_owned(),
            Classification::Blocked => "blocked".to_owned(),
            Classification::Contact => "contact".to_owned(),
        }),
        Column::Region => row.region.flatten().map(|region| region.to_string()),
        Column::Distance => row.distance.flatten().map(|distance| distance.to_string()),
        Column::Touching => row.touching.as_ref().map(|pairs| {
            let pairs: Vec<String> = pairs.iter().map(|p| p.join("|")).collect();
            pairs.join(";")
        }),
    };
    cell.unwrap_or_default()
}
