//! Rows of configurations as they are given.

use core::f64::consts::TAU;
use std::collections::BTreeSet;

use cspace::{Configuration, Coordinates, PairClass};
use cspace_model::shown;

use crate::args::Format;
use crate::failure::Failure;
use cspace_api::Chosen;
use cspace_api::classify::Column;
use cspace_api::given;

/// Where the coordinates of a row stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Columns {
    Planar([usize; 3]),
    Axes([usize; 2]),
}

/// The rows as given, and the configurations they mean.
pub(crate) struct Rows {
    pub(crate) header: csv::StringRecord,
    pub(crate) records: Vec<csv::StringRecord>,
    pub(crate) configurations: Vec<Coordinates>,
}

/// Reads all rows; nothing is computed before all of them are understood.
///
/// `source` is what the rows are read from, for messages.
pub(crate) fn read(
    (source, bytes): (&str, &[u8]),
    pair: &Chosen<'_>,
    format: Format,
    answers: &[Column],
) -> Result<Rows, Failure> {
    // A byte order mark is no part of the first name.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        // Rows of other lengths are handled below: blank rows are skipped, others are rejected.
        .flexible(true)
        .from_reader(bytes);
    let header = reader
        .headers()
        .map_err(|e| unreadable(source, &e))?
        .clone();
    no_answers(source, &header, answers)?;
    if format == Format::Json {
        named_once(source, &header)?;
    }
    let columns = columns(source, &header, pair)?;
    let window = pair.window();
    let turns = pair.turns();
    let mut records = Vec::new();
    let mut configurations = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| unreadable(source, &e))?;
        if record.iter().all(str::is_empty) && record.len() == 1 {
            continue;
        }
        let line = record.position().map_or(0, csv::Position::line);
        if record.len() != header.len() {
            return Err(unequal(source, line, record.len(), header.len()));
        }
        let number = |at: usize, is_angle: bool| {
            let text = record.get(at).unwrap_or_default();
            let value = if is_angle {
                given::angle(text)
            } else {
                let number = text.parse::<f64>().ok().filter(|x| x.is_finite());
                number.ok_or_else(|| format!("{} is no number", shown::quoted(text)))
            };
            value.map_err(|why| {
                Failure::new(format_args!(
                    "{source}, line {line}, column {}: {why}",
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
                return Err(Failure::new(format_args!(
                    "{source}, line {line}: theta {} is outside the orientations from {} to {} of the pair {}",
                    shown::number(c.theta),
                    shown::number(lo),
                    shown::number(hi),
                    pair.names()
                ))
                .help("leave the row out, or choose other orientations with --window LO,HI"));
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

fn unreadable(source: &str, error: &csv::Error) -> Failure {
    let line = error.position().map_or(0, csv::Position::line);
    let message = match error.kind() {
        csv::ErrorKind::Utf8 { .. } => "the text is not UTF-8".to_owned(),
        _ => error.to_string(),
    };
    Failure::new(format_args!("{source}, line {line}: {message}")).help(ONE_IN_A_ROW)
}

fn unequal(source: &str, line: u64, found: usize, named: usize) -> Failure {
    Failure::new(format_args!(
        "{source}, line {line}: {found} values, where the first row names {named} columns"
    ))
    .help(ONE_IN_A_ROW)
}

const ONE_IN_A_ROW: &str = "give one configuration in each row, values separated by commas";

/// Rejects input with a column that the answer adds: the answer would have two columns of one name.
fn no_answers(source: &str, header: &csv::StringRecord, answers: &[Column]) -> Result<(), Failure> {
    let twice = answers
        .iter()
        .find(|a| header.iter().any(|name| name == a.name()));
    if let Some(answer) = twice {
        return Err(Failure::new(format_args!(
            "{source}, line 1: there is a column `{}`, which the answer adds",
            answer.name()
        ))
        .help("leave the column out, or give it another name"));
    }
    Ok(())
}

fn named_twice(source: &str, name: &str) -> Failure {
    Failure::new(format_args!(
        "{source}, line 1: the column {} is named twice",
        shown::cut(name)
    ))
    .help("name every column once")
}

/// An object has a key once: of columns of one name all but the last would be lost.
fn named_once(source: &str, header: &csv::StringRecord) -> Result<(), Failure> {
    let mut names = BTreeSet::new();
    match header.iter().find(|name| !names.insert(*name)) {
        Some(name) => Err(named_twice(source, name)),
        None => Ok(()),
    }
}

fn columns(
    source: &str,
    header: &csv::StringRecord,
    pair: &Chosen<'_>,
) -> Result<Columns, Failure> {
    let find = |name: &str| {
        let mut places = header.iter().enumerate().filter(|(_, h)| *h == name);
        match (places.next(), places.next()) {
            (Some((at, _)), None) => Ok(Some(at)),
            (None, _) => Ok(None),
            (Some(_), Some(_)) => Err(named_twice(source, name)),
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
            let failure = Failure::new(format_args!(
                "{source}, line 1: the columns are {}, and a configuration of the {class} pair {}{method} is {wanted}",
                shown::quoted(&found.join(",")),
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
