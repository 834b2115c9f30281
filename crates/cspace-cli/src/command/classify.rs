//! `cspace classify`.

use core::f64::consts::TAU;
use std::collections::BTreeSet;
use std::io::Read;

use cspace::{Classification, Configuration, Coordinates, PairClass, PairSpace, QueryError};
use cspace_io::shown;
use rayon::prelude::*;

use crate::angle;
use crate::args::{ClassifyArgs, Format};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, Subject};

/// From so many rows on it pays to prepare the space for them: that takes about as long as so many rows without.
const MANY: usize = 4096;

/// Where the coordinates of a row stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Columns {
    Planar([usize; 3]),
    Axes([usize; 2]),
}

/// The rows as given, and the configurations they mean.
struct Rows {
    header: csv::StringRecord,
    records: Vec<csv::StringRecord>,
    configurations: Vec<Coordinates>,
}

pub(crate) fn run(args: &ClassifyArgs) -> Result<(), Failure> {
    let common = &args.common;
    let subject = Subject::open(common)?;
    let pair = subject.one_pair(common, args.window.theta)?;
    let mut bytes = Vec::new();
    std::io::stdin()
        .lock()
        .read_to_end(&mut bytes)
        .map_err(|e| Failure::input(format_args!("standard input: {e}")))?;
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

/// Reads all rows; nothing is computed before all of them are understood.
fn read(bytes: &[u8], pair: &Chosen<'_>, format: Format) -> Result<Rows, Failure> {
    // A byte order mark is no part of the first name.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let header = reader.headers().map_err(|e| unreadable(&e))?.clone();
    no_answers(&header)?;
    if format == Format::Json {
        named_once(&header)?;
    }
    let columns = columns(&header, pair)?;
    let window = pair.window();
    let turns = pair.turns();
    let mut records = Vec::new();
    let mut configurations = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| unreadable(&e))?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |at: usize, is_angle: bool| {
            let text = record.get(at).unwrap_or_default();
            let value = if is_angle {
                angle::parse(text)
            } else {
                let number = text.parse::<f64>().ok().filter(|x| x.is_finite());
                number.ok_or_else(|| format!("{text:?} is no number"))
            };
            value.map_err(|why| {
                Failure::input(format_args!(
                    "standard input, line {line}, column {}: {why}",
                    header.get(at).unwrap_or_default()
                ))
                .help("give a finite number; angles are in radians, or have a unit such as 18deg")
            })
        };
        let c = match columns {
            Columns::Planar([x, y, theta]) => Coordinates::Planar(Configuration::new(
                number(x, false)?,
                number(y, false)?,
                number(theta, true)?,
            )),
            Columns::Axes([u, v]) => Coordinates::Axes {
                u: number(u, turns.0)?,
                v: number(v, turns.1)?,
            },
        };
        if let (Some((lo, hi)), Coordinates::Planar(c)) = (window, c) {
            let turned = c.theta + TAU * ((lo - c.theta) / TAU).ceil();
            if turned > hi {
                return Err(Failure::input(format_args!(
                    "standard input, line {line}: theta {} is outside the orientations from {} to {} of the pair {}",
                    shown::number(c.theta),
                    shown::number(lo),
                    shown::number(hi),
                    pair.names()
                ))
                .help("leave the row out, or choose other orientations with --theta LO,HI"));
            }
        }
        configurations.push(c);
        records.push(record);
    }
    Ok(Rows {
        header,
        records,
        configurations,
    })
}

fn unreadable(error: &csv::Error) -> Failure {
    let line = error.position().map_or(0, csv::Position::line);
    let message = match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!("{len} values, where the first row names {expected_len} columns"),
        csv::ErrorKind::Utf8 { .. } => "the text is not UTF-8".to_owned(),
        _ => error.to_string(),
    };
    Failure::input(format_args!("standard input, line {line}: {message}"))
        .help("give one configuration in each row, values separated by commas")
}

/// The column that the answer adds.
const ANSWER: &str = "class";

/// The answer would have the column twice, and nobody could tell which is which.
fn no_answers(header: &csv::StringRecord) -> Result<(), Failure> {
    if header.iter().any(|name| name == ANSWER) {
        return Err(Failure::input(format_args!(
            "standard input, line 1: there is a column `{ANSWER}`, which the answer adds"
        ))
        .help("leave the column out, or give it another name"));
    }
    Ok(())
}

fn named_twice(name: &str) -> Failure {
    Failure::input(format_args!(
        "standard input, line 1: the column {name} is named twice"
    ))
    .help("name every column once")
}

/// An object has a key once: of columns of one name all but the last would be lost.
fn named_once(header: &csv::StringRecord) -> Result<(), Failure> {
    let mut names = BTreeSet::new();
    match header.iter().find(|name| !names.insert(*name)) {
        Some(name) => Err(named_twice(name)),
        None => Ok(()),
    }
}

fn columns(header: &csv::StringRecord, pair: &Chosen<'_>) -> Result<Columns, Failure> {
    let find = |name: &str| {
        let mut places = header.iter().enumerate().filter(|(_, h)| *h == name);
        match (places.next(), places.next()) {
            (Some((at, _)), None) => Ok(Some(at)),
            (None, _) => Ok(None),
            (Some(_), Some(_)) => Err(named_twice(name)),
        }
    };
    let planar = (find("x")?, find("y")?, find("theta")?);
    let axes = (find("u")?, find("v")?);
    let by_axes = !pair.is_planar() && pair.class() == PairClass::FixedAxes;
    match (planar, axes) {
        ((Some(x), Some(y), Some(theta)), _) if !by_axes => Ok(Columns::Planar([x, y, theta])),
        (_, (Some(u), Some(v))) if by_axes => Ok(Columns::Axes([u, v])),
        _ => {
            let found: Vec<&str> = header.iter().collect();
            let wanted = if by_axes { "u and v" } else { "x, y and theta" };
            let class = pair.class();
            let has_axes = class == PairClass::FixedAxes;
            let method = if has_axes && !by_axes {
                " by the general method"
            } else {
                ""
            };
            let failure = Failure::input(format_args!(
                "standard input, line 1: the columns are {:?}, and a configuration of the {class} pair {}{method} is {wanted}",
                found.join(","),
                pair.names()
            ));
            Err(if by_axes {
                failure.help(
                    "let the first row name the columns u and v, the motions of both parts; or use --general for x, y and theta",
                )
            } else if has_axes {
                failure.help(
                    "let the first row name the columns x, y and theta; or leave out --general for u and v",
                )
            } else {
                failure.help(
                    "let the first row name the columns x, y and theta; u and v are for pairs with fixed axes",
                )
            })
        }
    }
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
