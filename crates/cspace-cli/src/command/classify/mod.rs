//! `cspace classify`.

mod rows;

use core::f64::consts::TAU;
use std::io::Read;
use std::path::Path;

use cspace::{Classification, Configuration, Coordinates, PairSpace, QueryError};
use cspace_io::shown;
use rayon::prelude::*;

use crate::args::{ClassifyArgs, Format};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, Subject};

use rows::{ANSWER, Rows, read};

/// From so many rows on it pays to prepare the space for them: that takes about as long as so many rows without.
const MANY: usize = 4096;

/// As of a saved space.
const MOST_BYTES: u64 = 1 << 30;

pub(crate) fn run(args: &ClassifyArgs) -> Result<(), Failure> {
    let common = &args.common;
    output::check_apart_from_stdin(common.result.output.as_deref())?;
    if common.file == Path::new(output::STANDARD) {
        let failure = Failure::input("the model and the rows both come from standard input");
        return Err(failure.help("give the model as a file, and the rows on standard input"));
    }
    let subject = Subject::open(common)?;
    let pair = subject.one_pair(common, args.window.theta)?;
    let mut bytes = Vec::new();
    std::io::stdin()
        .lock()
        .take(MOST_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(|e| Failure::input(format_args!("standard input: {e}")))?;
    if bytes.len() as u64 > MOST_BYTES {
        let failure = Failure::input("standard input: more than 1 GiB of rows");
        return Err(failure.help("divide them, and classify one part after the other"));
    }
    let rows = read(&bytes, &pair, common.result.format)?;
    let space = pair.space()?;
    let classes = classify(&pair, &space, &rows)?;
    let bytes = match common.result.format {
        Format::Text => as_csv(&rows, &classes)?,
        Format::Json => as_json(&rows, &classes)?,
    };
    output::write(common.result.output.as_deref(), &bytes)
}

/// Classifies all rows; orientations, which were checked, are brought into the window by turns.
fn classify(
    pair: &Chosen<'_>,
    space: &PairSpace,
    rows: &Rows,
) -> Result<Vec<Classification>, Failure> {
    let all = rows.configurations.par_iter();
    let classifier = match space {
        PairSpace::Planar(space) if rows.configurations.len() >= MANY => Some(space.classifier()),
        _ => None,
    };
    let window = match space {
        PairSpace::Planar(space) => Some(space.window()).filter(|w| !w.full_turn),
        _ => None,
    };
    let turned = |c: Configuration| match window {
        Some(w) => {
            let turned = c.theta + TAU * ((w.lo - c.theta) / TAU).ceil();
            // Rounding may leave it just below.
            Configuration::new(c.x, c.y, turned.clamp(w.lo, w.hi))
        }
        None => c,
    };
    let one = |at: &Coordinates| match (*at, &classifier) {
        (Coordinates::Planar(c), Some(classifier)) => {
            classifier.classify(turned(c)).ok_or(QueryError::Outside)
        }
        (Coordinates::Planar(c), None) => space.classify(Coordinates::Planar(turned(c))),
        (axes, _) => space.classify(axes),
    };
    let found: Vec<Result<Classification, QueryError>> = all.map(one).collect();
    (found.into_iter().enumerate())
        .map(|(i, class)| {
            class.map_err(|e| {
                let line = rows.records[i].position().map_or(0, csv::Position::line);
                let why = beyond_range(pair, rows.configurations[i]).unwrap_or(e.to_string());
                Failure::input(format_args!("standard input, line {line}: {why}"))
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

fn as_csv(rows: &Rows, classes: &[Classification]) -> Result<Vec<u8>, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut write = |record: &csv::StringRecord, last: &str| {
        let mut record = record.clone();
        record.push_field(last);
        writer.write_record(&record)
    };
    write(&rows.header, ANSWER).map_err(Failure::work)?;
    for (record, class) in rows.records.iter().zip(classes) {
        let word = match class {
            Classification::Free => "free",
            Classification::Blocked => "blocked",
            Classification::Contact => "contact",
        };
        write(record, word).map_err(Failure::work)?;
    }
    writer.into_inner().map_err(Failure::work)
}

/// An array of objects: the columns as given, numbers where they are numbers, and `class`.
fn as_json(rows: &Rows, classes: &[Classification]) -> Result<Vec<u8>, Failure> {
    let objects: Vec<serde_json::Map<String, serde_json::Value>> = rows
        .records
        .iter()
        .zip(classes)
        .map(|(record, class)| {
            let value = |text: &str| {
                text.parse::<f64>()
                    .ok()
                    .and_then(serde_json::Number::from_f64)
                    .map_or_else(|| text.into(), serde_json::Value::Number)
            };
            let mut object: serde_json::Map<_, _> = rows
                .header
                .iter()
                .map(str::to_owned)
                .zip(record.iter().map(value))
                .collect();
            object.insert(ANSWER.to_owned(), serde_json::json!(class));
            object
        })
        .collect();
    super::json(&objects)
}
