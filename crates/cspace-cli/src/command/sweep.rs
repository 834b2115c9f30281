//! `cspace sweep`.

use std::path::Path;
use std::time::{Duration, Instant};

use cspace_design::{Change, Row, Sweep, Value, Varied};
use cspace_draw::{Curve, CurveStrip, CurvesPicture, Scene};
use cspace_io::model::Target;
use cspace_io::{Model, shown};

use crate::args::{SweepArgs, TableFormat, Vary};
use crate::failure::Failure;
use crate::input;
use crate::interrupt::{catch_interrupts, is_interrupted, watched};
use crate::output;
use crate::picture::{self, Plane};
use crate::progress::Steps;
use crate::subject::set_threads;
use crate::wording::count;

/// The most rows.
const MOST: usize = 10_000_000;

/// The largest file of rows that is read, in bytes.
const LARGEST: u64 = 1 << 28;

/// What is varied, with the values of each row.
struct Table {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

pub(crate) fn run(args: &SweepArgs) -> Result<(), Failure> {
    let output = args.output.as_deref();
    output::check(output)?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (template, model) = input::template(&args.file, &args.values)?;
    let table = match &args.rows {
        Some(file) => rows_of(file)?,
        None => grid(&args.vary)?,
    };
    let varied = varied(&table.names, &model, args)?;
    let measures = measures(&model, args)?;
    if let Some(name) = measures.iter().find(|m| table.names.contains(m)) {
        return Err(Failure::input(format_args!(
            "{} is both a requirement and what is varied: the table would have two such columns",
            shown::quoted(name)
        ))
        .help("give the requirement another name"));
    }
    let sweep = Sweep::new(&template, &args.values.set, &varied, &measures);
    let is_json = (args.output.as_deref().and_then(Path::extension))
        .is_some_and(|e| e.eq_ignore_ascii_case("json"));
    let format = args.format.unwrap_or(if is_json {
        TableFormat::Json
    } else {
        TableFormat::Csv
    });
    let line = args.vary.last().map_or(1, |v| v.count);
    if let Some(format) = picture::format(output) {
        if args.format.is_some() {
            return Err(Failure::input(
                "--format is about tables, and the name after -o that of a picture",
            )
            .help("leave --format out"));
        }
        let drawn = drawn(args, &model, &sweep, &table, line)?;
        return picture::write(output, format, &drawn);
    }
    args.picture.refuse()?;
    let extension = output.and_then(Path::extension);
    if let Some(other) = extension.map(|e| e.to_string_lossy().to_ascii_lowercase())
        && matches!(
            other.as_str(),
            "gif" | "jpg" | "jpeg" | "bmp" | "tif" | "tiff" | "webp" | "html"
        )
    {
        return Err(
            Failure::input(format_args!("-o: no files in .{other} are written"))
                .help("pictures are written in .svg, .png and .pdf, tables in .csv and .json"),
        );
    }
    if args.changes {
        return changes(&sweep, &table, line, format, output);
    }
    let done = watched(|| all(&sweep, &table.rows));
    let bytes = match format {
        TableFormat::Csv => csv_of(&table, &measures, &done)?,
        TableFormat::Json => json_of(&table, &measures, &done)?,
    };
    output::write(output, &bytes)?;
    if done.len() < table.rows.len() {
        return Err(Failure::work(format_args!(
            "interrupted: {} of {} are done and written",
            done.len(),
            count(table.rows.len(), "row", "rows")
        )));
    }
    Ok(())
}

/// A picture of the rows: a strip for each measure over what is varied last, with a curve for each combination of the others.
fn drawn(
    args: &SweepArgs,
    model: &Model,
    sweep: &Sweep<'_>,
    table: &Table,
    line: usize,
) -> Result<Scene, Failure> {
    /// More curves in one strip cannot be told apart.
    const MOST: usize = 12;
    let Some(across) = args.vary.last() else {
        return Err(
            Failure::input("a picture needs --vary, and the rows are those of a file")
                .help("write CSV or JSON, or give --vary NAME=LO:HI:N"),
        );
    };
    let lines: Vec<&[Vec<f64>]> = table.rows.chunks(line.max(1)).collect();
    if lines.len() > MOST {
        return Err(Failure::input(format_args!(
            "a picture has a curve for each combination of all but the last --vary, and these are {}",
            lines.len()
        ))
        .help(format_args!("vary at most {MOST} combinations, or write CSV")));
    }
    let done = watched(|| all(sweep, &table.rows));
    if done.len() < table.rows.len() {
        return Err(Failure::work("interrupted: a picture needs all rows"));
    }
    let mut marks = Vec::new();
    if args.changes {
        for rows in &lines {
            let found = watched(|| sweep.changes(rows));
            marks.extend(found.iter().filter_map(|c| c.values.last().copied()));
        }
    }
    let unit = model.mechanism.unit.as_deref();
    let strips = sweep.measures().iter().enumerate().map(|(m, name)| {
        let requirement = model.requirements.iter().find(|r| r.name == *name);
        let is_angle = requirement.is_some_and(|r| r.is_angle);
        let curves = lines
            .iter()
            .zip(done.chunks(line.max(1)))
            .map(|(rows, done)| {
                let others = rows[0].iter().zip(&table.names).take(table.names.len() - 1);
                let label: Vec<String> = others
                    .map(|(x, name)| format!("{name} = {}", shown::number(*x)))
                    .collect();
                let value = |row: &Row| match row.measured[m] {
                    Ok(Value::Number(x)) => Some(x),
                    Ok(Value::Truth(b)) => Some(f64::from(u8::from(b))),
                    Err(_) => None,
                };
                let at = rows.iter().map(|r| r.last().copied().unwrap_or_default());
                Curve {
                    label: label.join(", "),
                    points: at.zip(done.iter().map(value)).collect(),
                }
            });
        let is_truth = requirement.is_some_and(|r| r.quantity.is_truth());
        CurveStrip {
            label: match unit {
                _ if is_angle => format!("{name}, deg"),
                _ if is_truth => format!("{name} (1 is yes)"),
                Some(unit) => format!("{name}, {unit}"),
                None => name.clone(),
            },
            is_angle,
            limits: match requirement.and_then(|r| r.target) {
                Some(Target::Limits(lo, hi)) => Some((lo, hi)),
                _ => None,
            },
            seen: is_truth.then_some((-0.1, 1.1)),
            curves: curves.collect(),
        }
    });
    let picture = CurvesPicture {
        across: if across.is_angle {
            format!("{}, deg", across.name)
        } else {
            across.name.clone()
        },
        is_angle: across.is_angle,
        strips: strips.collect(),
        marks,
    };
    let options = args
        .picture
        .options(Plane::Positions, model.mechanism.name.clone(), unit)?;
    Ok(cspace_draw::curves(&picture, &options))
}

/// Writes where something changes along lines of so many rows.
fn changes(
    sweep: &Sweep<'_>,
    table: &Table,
    line: usize,
    format: TableFormat,
    output: Option<&Path>,
) -> Result<(), Failure> {
    let steps = Steps::new(table.rows.len());
    let mut found: Vec<Change> = Vec::new();
    let is_whole = watched(|| {
        for rows in table.rows.chunks(line.max(1)) {
            if is_interrupted() {
                return false;
            }
            found.extend(steps.steps(rows.len() as u64, || sweep.changes(rows)));
        }
        true
    });
    let words = ["measure", "before", "after"];
    let bytes = match format {
        TableFormat::Csv => {
            let mut writer = csv::Writer::from_writer(Vec::new());
            let failed = |e: csv::Error| Failure::work(e);
            let header = table.names.iter().map(String::as_str).chain(words);
            writer.write_record(header).map_err(failed)?;
            for c in &found {
                let values = c.values.iter().map(|x| format!("{x:?}"));
                let told = [&c.measure, &c.before, &c.after].map(String::clone);
                writer.write_record(values.chain(told)).map_err(failed)?;
            }
            writer
                .into_inner()
                .map_err(|e| Failure::work(e.to_string()))?
        }
        TableFormat::Json => {
            let object = |c: &Change| {
                let values = table.names.iter().zip(&c.values);
                let mut object: serde_json::Map<String, serde_json::Value> = values
                    .map(|(name, x)| (name.clone(), (*x).into()))
                    .collect();
                let told = [&c.measure, &c.before, &c.after].map(String::clone);
                for (word, text) in words.into_iter().zip(told) {
                    object.insert(word.to_owned(), text.into());
                }
                object
            };
            super::json(&found.iter().map(object).collect::<Vec<_>>())?
        }
    };
    output::write(output, &bytes)?;
    if is_whole {
        Ok(())
    } else {
        Err(Failure::work(
            "interrupted: the changes that were found are written",
        ))
    }
}

/// Every combination of values, the last of them changing first.
fn grid(vary: &[Vary]) -> Result<Table, Failure> {
    if vary.is_empty() {
        return Err(Failure::input("nothing is varied")
            .help("give --vary NAME=LO:HI:N, or --rows FILE.csv"));
    }
    let total = vary.iter().try_fold(1_usize, |n, v| n.checked_mul(v.count));
    let Some(total) = total.filter(|n| *n <= MOST) else {
        return Err(Failure::input(format_args!("more than {MOST} rows"))
            .help("give smaller numbers of values"));
    };
    let value = |v: &Vary, i: usize| match v.count {
        1 => v.lo,
        n if i == n - 1 => v.hi,
        n => v.lo + (v.hi - v.lo) * (i as f64 / (n - 1) as f64),
    };
    let row = |k: usize| {
        let mut rest = k;
        let mut values: Vec<f64> = (vary.iter().rev())
            .map(|v| {
                let i = rest % v.count;
                rest /= v.count;
                value(v, i)
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
fn rows_of(file: &Path) -> Result<Table, Failure> {
    let help = "give CSV with names of parameters in its first line and numbers below";
    let bytes = input::bytes(file, LARGEST, help)?;
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let wrong =
        |what: String| Failure::input(format_args!("{}: {what}", file.display())).help(help);
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
                .or_else(|| cspace_io::parse_angle(text));
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

fn varied(names: &[String], model: &Model, args: &SweepArgs) -> Result<Vec<Varied>, Failure> {
    let mut all = Vec::with_capacity(names.len());
    for (i, name) in names.iter().enumerate() {
        let Some(varied) = Varied::named(name, model) else {
            return Err(Failure::input(format_args!(
                "{}: there is no parameter or coordinate {}",
                args.file.display(),
                shown::quoted(name)
            ))
            .help(super::parameters_of(model)));
        };
        if names[..i].contains(name) {
            return Err(super::varied_twice(name));
        }
        all.push(varied);
    }
    Ok(all)
}

/// The requirements that are measured.
fn measures(model: &Model, args: &SweepArgs) -> Result<Vec<String>, Failure> {
    let known: Vec<String> = model.requirements.iter().map(|r| r.name.clone()).collect();
    if known.is_empty() {
        return Err(Failure::input(format_args!(
            "{}: the model has no requirements",
            args.file.display()
        ))
        .help("say what is measured in [[requirement]] tables: see docs/design.md"));
    }
    if let Some(unknown) = args.measure.iter().find(|m| !known.contains(m)) {
        return Err(Failure::input(format_args!(
            "--measure {}: the model has no such requirement",
            shown::quoted(unknown)
        ))
        .help(super::requirements_of(model)));
    }
    Ok(if args.measure.is_empty() {
        known
    } else {
        args.measure.clone()
    })
}

/// The rows in order, until an interrupt.
fn all(sweep: &Sweep<'_>, rows: &[Vec<f64>]) -> Vec<Row> {
    /// Rows are done together that take about so long: an interrupt waits for them.
    const TOGETHER: Duration = Duration::from_millis(50);
    let steps = Steps::new(rows.len());
    let mut done = Vec::with_capacity(rows.len());
    let mut together = rayon::current_num_threads();
    while done.len() < rows.len() && !is_interrupted() {
        let next = &rows[done.len()..rows.len().min(done.len() + together)];
        let begin = Instant::now();
        done.extend(steps.steps(next.len() as u64, || sweep.rows(next)));
        if begin.elapsed() < TOGETHER {
            together *= 2;
        } else if begin.elapsed() > 2 * TOGETHER {
            together = (together / 2).max(1);
        }
    }
    done
}

/// What could not be measured, and why.
fn failure(measures: &[String], row: &Row) -> String {
    let mut reasons: Vec<String> = Vec::new();
    for (name, measured) in measures.iter().zip(&row.measured) {
        if let Err(reason) = measured {
            reasons.push(format!("{name}: {reason}"));
        }
    }
    reasons.join("; ")
}

fn csv_of(table: &Table, measures: &[String], done: &[Row]) -> Result<Vec<u8>, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failed = |e: csv::Error| Failure::work(e);
    let header = table.names.iter().chain(measures).map(String::as_str);
    writer
        .write_record(header.chain(["failure"]))
        .map_err(failed)?;
    for (values, row) in table.rows.iter().zip(done) {
        let values = values.iter().map(|x| format!("{x:?}"));
        let measured = row.measured.iter().map(|m| match m {
            Ok(Value::Number(x)) => format!("{x:?}"),
            Ok(Value::Truth(b)) => b.to_string(),
            Err(_) => String::new(),
        });
        let fields = values.chain(measured).chain([failure(measures, row)]);
        writer.write_record(fields).map_err(failed)?;
    }
    writer
        .into_inner()
        .map_err(|e| Failure::work(e.to_string()))
}

fn json_of(table: &Table, measures: &[String], done: &[Row]) -> Result<Vec<u8>, Failure> {
    let rows = table.rows.iter().zip(done).map(|(values, row)| {
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
        serde_json::Value::Object(object)
    });
    super::json(&rows.collect::<Vec<_>>())
}
