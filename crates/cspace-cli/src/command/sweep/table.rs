//! The table of a sweep as CSV.

use std::path::Path;

use cspace_api::sweep::{Cell, Rows, Table, Values};
use cspace_model::shown;

use crate::failure::Failure;
use crate::input;

/// The largest file of rows that is read, in bytes.
const LARGEST: u64 = 1 << 28;

/// The values in a file.
pub(super) fn read(file: &Path) -> Result<Values, Failure> {
    let help = "give CSV with names of parameters in its first line and numbers below";
    let bytes = input::bytes(file, LARGEST, help)?;
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let wrong = |what: String| Failure::new(format_args!("{}: {what}", file.display())).help(help);
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let header = reader.headers().map_err(|e| wrong(e.to_string()))?.clone();
    let names: Vec<String> = header.iter().map(str::to_owned).collect();
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| wrong(e.to_string()))?;
        let line = record.position().map_or(0, csv::Position::line);
        let values = record.iter().zip(&names).map(|(text, name)| {
            let number = text
                .parse::<f64>()
                .ok()
                .or_else(|| cspace_model::parse_angle(text));
            number.filter(|x| x.is_finite()).ok_or_else(|| {
                wrong(format!(
                    "line {line}, column {name}: {} is no number",
                    shown::quoted(text)
                ))
            })
        });
        rows.push(values.collect::<Result<Vec<f64>, Failure>>()?);
    }
    Ok(Values { names, rows })
}

/// A table as CSV, of which the first lines are kept.
pub(super) fn csv_of(kept: &Kept, found: &Rows) -> Result<Vec<u8>, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failed = |e: csv::Error| Failure::new(e);
    writer.write_record(&*found.columns).map_err(failed)?;
    for record in &kept.0 {
        writer.write_record(record).map_err(failed)?;
    }
    for row in found.rows.iter().skip(kept.0.len()) {
        let fields = row.cells.iter().map(|cell| match cell {
            Cell::None => String::new(),
            Cell::Number(x) => format!("{x:?}"),
            Cell::Truth(is) => is.to_string(),
            Cell::Text(text) => text.clone(),
        });
        writer.write_record(fields).map_err(failed)?;
    }
    writer.into_inner().map_err(|e| Failure::new(e.to_string()))
}

/// The lines of an earlier table, `path`, of the same columns and values, as they are: those of the first rows.
pub(super) fn kept(path: &Path, table: &Table) -> Result<Kept, Failure> {
    let wrong = |why: String| {
        Failure::new(format_args!("{}: {why}", path.display())).help(
            "leave --resume out to compute all rows, or give the arguments of the earlier sweep",
        )
    };
    if !path.exists() {
        return Ok(Kept::default());
    }
    // It is written again in the end, so that it is no input that has to be kept.
    let unreadable = |e: std::io::Error| wrong(format!("it cannot be read: {e}"));
    if std::fs::metadata(path).map_err(unreadable)?.len() > LARGEST {
        return Err(wrong(format!("it has more than {LARGEST} bytes")));
    }
    let mut bytes = std::fs::read(path).map_err(unreadable)?;
    // What is after the last end of a line is not whole: it is computed again.
    bytes.truncate(
        bytes
            .iter()
            .rposition(|b| *b == b'\n')
            .map_or(0, |last| last + 1),
    );
    let mut kept = Kept::default();
    if bytes.is_empty() {
        return Ok(kept);
    }
    let mut reader = csv::Reader::from_reader(&bytes[..]);
    let header = reader.headers().map_err(|e| wrong(e.to_string()))?;
    if !header.iter().eq(table.columns()) {
        return Err(wrong("its columns are those of another sweep".to_owned()));
    }
    for record in reader.records() {
        let record = record.map_err(|e| wrong(e.to_string()))?;
        let line = record.position().map_or(0, csv::Position::line);
        let Some(values) = table.values.rows.get(kept.0.len()) else {
            return Err(wrong(format!("line {line} is more than the sweep has")));
        };
        let number = |text: &str| text.parse::<f64>().ok();
        if !(values.iter().zip(record.iter())).all(|(x, text)| number(text) == Some(*x)) {
            return Err(wrong(format!(
                "line {line} has other values than the sweep"
            )));
        }
        let mut measured = (record.iter().skip(values.len())).take(table.measures.len());
        let is_value = |text: &str| {
            text.is_empty() || number(text).is_some() || matches!(text, "true" | "false")
        };
        if !measured.all(is_value) {
            return Err(wrong(format!("line {line} has something that is no value")));
        }
        kept.0.push(record);
    }
    Ok(kept)
}

/// Lines of a table that need not be computed again.
#[derive(Debug, Default)]
pub(super) struct Kept(Vec<csv::StringRecord>);

impl Kept {
    /// The values of the lines.
    pub(super) fn cells(&self) -> Vec<Vec<Cell>> {
        let cell = |text: &str| match text {
            "" => Cell::None,
            "true" => Cell::Truth(true),
            "false" => Cell::Truth(false),
            text => match text.parse::<f64>() {
                Ok(x) => Cell::Number(x),
                Err(_) => Cell::Text(text.to_owned()),
            },
        };
        let row = |record: &csv::StringRecord| record.iter().map(cell).collect();
        self.0.iter().map(row).collect()
    }
}
