//! `cspace classify`.

use core::f64::consts::TAU;
use std::io::Read;

use cspace::{Classification, Configuration, ContactSpace, Rotation, Vector};
use cspace_io::Motion;
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
    configurations: Vec<Configuration>,
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
    let rows = read(&bytes, &pair)?;
    let space = pair.space()?;
    let classes = classify(&space, &rows.configurations)?;
    let bytes = match common.format {
        Format::Text => as_csv(&rows, &classes)?,
        Format::Json => as_json(&rows, &classes)?,
    };
    output::write(common.output.as_deref(), &bytes)
}

/// Classifies all rows; orientations, which were checked, are brought into the window by turns.
fn classify(
    space: &ContactSpace,
    configurations: &[Configuration],
) -> Result<Vec<Classification>, Failure> {
    let window = space.window();
    let all = configurations.par_iter().map(|&c| {
        if window.full_turn {
            return c;
        }
        let turned = c.theta + TAU * ((window.lo - c.theta) / TAU).ceil();
        // Rounding may leave it just below.
        Configuration::new(c.x, c.y, turned.clamp(window.lo, window.hi))
    });
    let classes: Option<Vec<Classification>> = if configurations.len() < MANY {
        all.map(|c| space.classify(c)).collect()
    } else {
        let classifier = space.classifier();
        all.map(|c| classifier.classify(c)).collect()
    };
    classes.ok_or_else(|| Failure::work("a row is outside the orientations of the pair"))
}

/// Reads all rows; nothing is computed before all of them are understood.
fn read(bytes: &[u8], pair: &Chosen<'_>) -> Result<Rows, Failure> {
    // A byte order mark is no part of the first name.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let header = reader.headers().map_err(|e| unreadable(&e))?.clone();
    let columns = columns(&header, pair)?;
    let window = pair.window();
    let mut records = Vec::new();
    let mut configurations = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| unreadable(&e))?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |at: usize, is_angle: bool| {
            let text = record.get(at).unwrap_or_default();
            let value = if is_angle {
                angle::parse(text).ok()
            } else {
                text.parse::<f64>().ok().filter(|x| x.is_finite())
            };
            value.ok_or_else(|| {
                Failure::input(format_args!(
                    "standard input, line {line}, column {}: {text:?} is no number",
                    header.get(at).unwrap_or_default()
                ))
                .help("give a finite number; angles are in radians")
            })
        };
        let c = match columns {
            Columns::Planar([x, y, theta]) => {
                Configuration::new(number(x, false)?, number(y, false)?, number(theta, true)?)
            }
            Columns::Axes([u, v]) => {
                let Some((fixed, moving)) = pair.motions() else {
                    return Err(Failure::work("the pair has no motions"));
                };
                let turns = |m: Motion| matches!(m, Motion::Revolute { .. });
                relative(
                    (fixed, number(u, turns(fixed))?),
                    (moving, number(v, turns(moving))?),
                )
            }
        };
        if let Some((lo, hi)) = window {
            let turned = c.theta + TAU * ((lo - c.theta) / TAU).ceil();
            if turned > hi {
                return Err(Failure::input(format_args!(
                    "standard input, line {line}: theta {} is outside the orientations from {lo} to {hi} of the pair {}",
                    c.theta,
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

fn columns(header: &csv::StringRecord, pair: &Chosen<'_>) -> Result<Columns, Failure> {
    let find = |name: &str| {
        let mut places = header.iter().enumerate().filter(|(_, h)| *h == name);
        match (places.next(), places.next()) {
            (Some((at, _)), None) => Ok(Some(at)),
            (None, _) => Ok(None),
            (Some(_), Some(_)) => Err(Failure::input(format_args!(
                "standard input, line 1: the column {name} is named twice"
            ))
            .help("name the columns x, y and theta, each once")),
        }
    };
    if let (Some(x), Some(y), Some(theta)) = (find("x")?, find("y")?, find("theta")?) {
        return Ok(Columns::Planar([x, y, theta]));
    }
    if let (Some(u), Some(v)) = (find("u")?, find("v")?) {
        let is_planar = |m: Motion| m == Motion::Planar;
        return match pair.motions() {
            Some((fixed, moving)) if !is_planar(fixed) && !is_planar(moving) => {
                Ok(Columns::Axes([u, v]))
            }
            _ => Err(Failure::input(format_args!(
                "standard input, line 1: columns u and v, but the pair {} is not known to move about fixed axes",
                pair.names()
            ))
            .help("give columns x, y and theta; or a model in which neither part is planar")),
        };
    }
    let found: Vec<&str> = header.iter().collect();
    Err(Failure::input(format_args!(
        "standard input, line 1: the columns are {:?}",
        found.join(",")
    ))
    .help(
        "let the first row name the columns x, y and theta (or u and v for a pair on fixed axes)",
    ))
}

/// The configuration of a moving part in the frame of a fixed part that has moved as well.
fn relative(fixed: (Motion, f64), moving: (Motion, f64)) -> Configuration {
    let (f, m) = (placed(fixed.0, fixed.1), placed(moving.0, moving.1));
    let back = Rotation::by(-f.theta);
    let p = back * (m.position() - f.position());
    Configuration::new(p.x, p.y, m.theta - f.theta)
}

/// Where a motion takes a part's frame, seen from the ground.
fn placed(motion: Motion, by: f64) -> Configuration {
    match motion {
        Motion::Fixed | Motion::Planar => Configuration::default(),
        Motion::Revolute { center, .. } => {
            let p = center + (-(Rotation::by(by) * center.to_vector()));
            Configuration::new(p.x, p.y, by)
        }
        Motion::Prismatic { direction, .. } => {
            let v: Vector = direction.unit() * by;
            Configuration::new(v.x, v.y, 0.0)
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
    write(&rows.header, "class").map_err(Failure::work)?;
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
            object.insert("class".to_owned(), serde_json::json!(class));
            object
        })
        .collect();
    super::json(&objects)
}
