//! The table of a sweep: what is varied, and what is measured.

use std::path::Path;

use cspace_design::{Row, Value};
use cspace_model::shown;

use crate::args::Vary;
use crate::failure::Failure;
use crate::input;

/// The most rows.
const MOST: usize = 10_000_000;

/// The largest file of rows that is read, in bytes.
const LARGEST: u64 = 1 << 28;

/// The varied parameters and coordinates, with their values in each row.
pub(super) struct Table {
    pub(super) names: Vec<String>,
    pub(super) rows: Vec<Vec<f64>>,
}

/// Every combination of values, the last of them changing first.
pub(super) fn grid(vary: &[Vary]) -> Result<Table, Failure> {
    if vary.is_empty() {
        return Err(
            Failure::new("nothing is varied").help("give --vary NAME=LO:HI:N, or --rows FILE.csv")
        );
    }
    let total = vary.iter().try_fold(1_usize, |n, v| n.checked_mul(v.count));
    let Some(total) = total.filter(|n| *n <= MOST) else {
        return Err(Failure::new(format_args!("more than {MOST} rows"))
            .help("give smaller numbers of values"));
    };
    let row = |k: usize| {
        let mut rest = k;
        let mut values: Vec<f64> = (vary.iter().rev())
            .map(|v| {
                let i = rest % v.count;
                rest /= v.count;
                v.value(i)
            })
            .collect();
        values.reverse();
        values
    };
    Ok(Table {
        names: vary.iter().map(|v| v.name.clone()).collect(),
        rows: (0..total).map(row).collect(),
    })
}

/// The values in a file.
pub(super) fn read(file: &Path) -> Result<Table, Failure> {
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
    Ok(Table { names, rows })
}

/// The reasons for the measures that a row lacks.
fn failure(measures: &[String], row: &Row) -> String {
    let mut reasons: Vec<String> = Vec::new();
    for (name, measured) in measures.iter().zip(&row.measured) {
        if let Err(reason) = measured {
            reasons.push(format!("{name}: {reason}"));
        }
    }
    reasons.join("; ")
}

pub(super) fn csv_of(
    table: &Table,
    measures: &[String],
    (kept, done): (&Kept, &[Row]),
) -> Result<Vec<u8>, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failed = |e: csv::Error| Failure::new(e);
    writer
        .write_record(columns(table, measures))
        .map_err(failed)?;
    for record in &kept.0 {
        writer.write_record(record).map_err(failed)?;
    }
    for (values, row) in table.rows[kept.count()..].iter().zip(done) {
        let values = values.iter().map(|x| format!("{x:?}"));
        let measured = row.measured.iter().map(|m| match m {
            Ok(Value::Number(x)) => format!("{x:?}"),
            Ok(Value::Truth(b)) => b.to_string(),
            Err(_) => String::new(),
        });
        let fields = values.chain(measured).chain([failure(measures, row)]);
        writer.write_record(fields).map_err(failed)?;
    }
    writer.into_inner().map_err(|e| Failure::new(e.to_string()))
}

pub(super) fn objects(
    table: &Table,
    measures: &[String],
    (kept, done): (&Kept, &[Row]),
) -> Vec<serde_json::Map<String, serde_json::Value>> {
    let earlier = kept.0.iter().map(|record| {
        let value = |text: &str| match text {
            "" => serde_json::Value::Null,
            text => serde_json::from_str(text).unwrap_or_else(|_| text.into()),
        };
        let names = columns(table, measures).map(str::to_owned);
        let all = names.zip(record.iter().map(value));
        all.filter(|(name, value)| name != "failure" || !value.is_null())
            .collect()
    });
    let rows = (table.rows[kept.count()..].iter())
        .zip(done)
        .map(|(values, row)| {
            let mut object = serde_json::Map::new();
            for (name, x) in table.names.iter().zip(values) {
                object.insert(name.clone(), (*x).into());
            }
            for (name, measured) in measures.iter().zip(&row.measured) {
                let value = match measured {
                    Ok(Value::Number(x)) => (*x).into(),
                    Ok(Value::Truth(b)) => (*b).into(),
                    Err(_) => serde_json::Value::Null,
                };
                object.insert(name.clone(), value);
            }
            let failure = failure(measures, row);
            if !failure.is_empty() {
                object.insert("failure".to_owned(), failure.into());
            }
            object
        });
    earlier.chain(rows).collect()
}

/// The lines of an earlier table, `path`, of the same columns and values, as they are: those of the first rows.
pub(super) fn kept(path: &Path, table: &Table, measures: &[String]) -> Result<Kept, Failure> {
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
    if !header.iter().eq(columns(table, measures)) {
        return Err(wrong("its columns are those of another sweep".to_owned()));
    }
    for record in reader.records() {
        let record = record.map_err(|e| wrong(e.to_string()))?;
        let line = record.position().map_or(0, csv::Position::line);
        let Some(values) = table.rows.get(kept.count()) else {
            return Err(wrong(format!("line {line} is more than the sweep has")));
        };
        let number = |text: &str| text.parse::<f64>().ok();
        if !(values.iter().zip(record.iter())).all(|(x, text)| number(text) == Some(*x)) {
            return Err(wrong(format!(
                "line {line} has other values than the sweep"
            )));
        }
        let mut measured = record.iter().skip(values.len()).take(measures.len());
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
    pub(super) fn count(&self) -> usize {
        self.0.len()
    }
}

fn columns<'a>(table: &'a Table, measures: &'a [String]) -> impl Iterator<Item = &'a str> {
    let header = table.names.iter().chain(measures).map(String::as_str);
    header.chain(["failure"])
}
