//! `cspace classify`.

mod columns;

use core::f64::consts::TAU;
use std::path::Path;

use crate::ask;
use crate::legacy::{Answer as Framed, Outcome, PairAnswer};
use cspace::{Configuration, Coordinates, PairSpace, QueryError};
use cspace_classifier::Classifier;
use cspace_io::shown;
use rayon::prelude::*;
use serde_json::{Map, Value};

use crate::args::{ClassifyArgs, Column};
use crate::command::rows::{Rows, read};
use crate::failure::Failure;
use crate::input;
use crate::output;
use crate::subject::InWords;
use cspace_api::{Chosen, Subject};

use columns::Answer;

/// From so many rows on it pays to prepare the space for them: that takes about as long as so many rows without.
const MANY: usize = 4096;

/// As of a saved space.
const MOST_BYTES: u64 = 1 << 30;

pub(crate) fn run(args: &ClassifyArgs) -> Result<(), Failure> {
    let common = &args.common;
    let output = common.result.artefact(&["csv", "json"])?;
    if common.file == Path::new(output::STANDARD) {
        let failure = Failure::new("the model and the rows both come from standard input");
        return Err(failure.help("give the model as a file, and the rows on standard input"));
    }
    let (subject, host) = ask::open(common)?;
    let pair = subject.one_pair(&ask::which(common, args.window.window), &host)?;
    let help = "divide the rows, and classify one part after the other";
    let bytes = input::stdin(MOST_BYTES, help)?;
    let columns = columns(args)?;
    let rows = read(
        ("standard input", &bytes),
        &pair,
        common.result.format(),
        &columns,
    )?;
    let space = pair.space()?;
    let touch = args.touch.unwrap_or_else(|| space.resolution());
    let answers = answers(&pair, &space, &rows, &columns, touch)?;
    let csv = as_csv(&rows, &columns, &answers)?;
    if let Some(path) = output.filter(|path| output::ends_in(path, "csv")) {
        output::write(Some(path), &csv)?;
    }
    let answers = super::Rows {
        rows: objects(&rows, &columns, &answers),
    };
    let answers = vec![PairAnswer::of(&pair, Outcome::DONE, answers)];
    let answer = Framed::of_pairs("classify", pair.unit_label(), answers);
    super::print(&common.result, &answer, |text| {
        // Rows of text are text.
        text.push_str(&String::from_utf8_lossy(&csv));
        Ok(())
    })
}

/// The columns asked for, each once.
fn columns(args: &ClassifyArgs) -> Result<Vec<Column>, Failure> {
    let asked = &args.columns;
    if let Some(twice) = (1..asked.len()).find(|&i| asked[..i].contains(&asked[i])) {
        let name = asked[twice].name();
        return Err(
            Failure::new(format_args!("--columns: {name} is asked for twice"))
                .help("name every column once"),
        );
    }
    if args.touch.is_some() && !asked.contains(&Column::Touching) {
        return Err(
            Failure::new("--touch is about the column `touching`, which is not asked for")
                .help("add it, as in --columns class,touching"),
        );
    }
    Ok(asked.clone())
}

/// The values of the columns in all rows. Orientations, which were checked, are brought into the window by adding whole turns.
fn answers(
    pair: &Chosen<'_>,
    space: &PairSpace,
    rows: &Rows,
    columns: &[Column],
    touch: f64,
) -> Result<Vec<Vec<Answer>>, Failure> {
    let classifier = match space {
        PairSpace::Planar(space) if rows.configurations.len() >= MANY => {
            Some(Classifier::new(&**space))
        }
        _ => None,
    };
    let window = match space {
        PairSpace::Planar(space) => Some(space.window()).filter(|w| !w.full_turn),
        _ => None,
    };
    let turned = |at: Coordinates| match (window, at) {
        (Some(w), Coordinates::Planar(c)) => {
            let turned = c.theta + TAU * ((w.lo - c.theta) / TAU).ceil();
            // Rounding may leave it just below.
            Coordinates::Planar(Configuration::new(c.x, c.y, turned.clamp(w.lo, w.hi)))
        }
        _ => at,
    };
    let one = |at: &Coordinates| {
        let at = turned(*at);
        let class = match (at, &classifier) {
            (Coordinates::Planar(c), Some(classifier)) => {
                classifier.classify(c).ok_or(QueryError::Outside)
            }
            _ => space.classify(at),
        }?;
        (columns.iter())
            .map(|column| column.of(space, at, class, touch))
            .collect()
    };
    let found: Vec<Result<Vec<Answer>, QueryError>> =
        rows.configurations.par_iter().map(one).collect();
    (found.into_iter().enumerate())
        .map(|(i, answers)| {
            answers.map_err(|e| {
                if e == QueryError::Permanent {
                    return pair.unanswered("--columns", &e).into();
                }
                let line = rows.records[i].position().map_or(0, csv::Position::line);
                let why = beyond_range(pair, rows.configurations[i]).unwrap_or(e.to_string());
                Failure::new(format_args!("standard input, line {line}: {why}"))
                    .help("leave the row out, or widen the `range` of the motion in the model")
            })
        })
        .collect()
}

/// Which coordinate is beyond the range of its motion, if one is.
fn beyond_range(pair: &Chosen<'_>, at: Coordinates) -> Option<String> {
    let (Some(axes), Coordinates::Axes { u, v }) = (pair.axes(), at) else {
        return None;
    };
    [
        ("u", u, axes.0, pair.fixed()),
        ("v", v, axes.1, pair.moving()),
    ]
    .into_iter()
    .find_map(|(name, t, axis, part)| {
        let (lo, hi) = axis.range?;
        let beyond = !(lo..=hi).contains(&t);
        beyond.then(|| {
            let part = part.name();
            let [t, lo, hi] = [t, lo, hi].map(shown::number);
            format!("{name} {t} is outside the range from {lo} to {hi} of the motion of {part}")
        })
    })
}

fn as_csv(rows: &Rows, columns: &[Column], answers: &[Vec<Answer>]) -> Result<Vec<u8>, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header = rows.header.clone();
    header.extend(columns.iter().map(|c| c.name()));
    writer.write_record(&header).map_err(Failure::new)?;
    for (record, answers) in rows.records.iter().zip(answers) {
        let mut record = record.clone();
        record.extend(answers.iter().map(Answer::text));
        writer.write_record(&record).map_err(Failure::new)?;
    }
    writer.into_inner().map_err(Failure::new)
}

/// The columns of each row as given, numbers where they are numbers, and those of the answer.
fn objects(rows: &Rows, columns: &[Column], answers: &[Vec<Answer>]) -> Vec<Map<String, Value>> {
    let value = |text: &str| {
        text.parse::<f64>()
            .ok()
            .and_then(serde_json::Number::from_f64)
            .map_or_else(|| text.into(), Value::Number)
    };
    (rows.records.iter())
        .zip(answers)
        .map(|(record, answers)| {
            let given = rows.header.iter().map(str::to_owned);
            let told = columns.iter().map(|c| c.name().to_owned());
            given
                .zip(record.iter().map(value))
                .chain(told.zip(answers.iter().map(Answer::json)))
                .collect()
        })
        .collect()
}
