//! Records of motions, as `cspace simulate` writes them.

use std::path::Path;

use cspace::AxisMotion;
use cspace_model::{Mechanism, shown};
use cspace_plan::clash::Sample;
use serde_json::Value;

use crate::failure::Failure;
use crate::input;
use crate::output;

/// The largest record read, in bytes: some million samples.
const LARGEST: u64 = 1 << 27;

/// A record that is wrong.
pub(super) fn wrong(file: &Path, what: &str, help: &str) -> Failure {
    Failure::new(format_args!("{}: {what}", file.display())).help(help)
}

/// An answer of `cspace simulate`, or of `cspace plan` or `cspace disassemble` where these are wanted too, as JSON about the parts of a model.
pub(super) fn json(file: &Path, model: &Mechanism, with_ways: bool) -> Result<Value, Failure> {
    let (commands, help) = match with_ways {
        true => (
            "`plan`, `disassemble` or `simulate`",
            "give what `cspace plan`, `cspace disassemble` or `cspace simulate` writes with -o OUT.json",
        ),
        false => (
            "`simulate`",
            "give what `cspace simulate` writes with -o OUT.json",
        ),
    };
    let bytes = input::bytes(file, LARGEST, help)?;
    let record: Value = serde_json::from_slice(&bytes)
        .map_err(|e| wrong(file, &format!("it is no JSON: {e}"), help))?;
    let plan = &record["pairs"][0];
    let is_plan = plan["verdict"].is_string() && plan["path"].is_array();
    let in_tree = &record["tree"]["parts"];
    let is_assembly = record["steps"].is_array() && in_tree.is_array();
    let is_motion = record["status"].is_string() && record["samples"].is_array();
    if !(is_motion || (is_plan || is_assembly) && with_ways) {
        return Err(wrong(file, &format!("it is no answer of {commands}"), help));
    }
    let parts = [&record["parts"], in_tree].map(|list| list.as_array());
    let parts = parts.into_iter().flatten().flatten();
    for name in parts.filter_map(Value::as_str) {
        known(file, model, name)?;
    }
    Ok(record)
}

/// The part of a name.
fn known(file: &Path, model: &Mechanism, name: &str) -> Result<usize, Failure> {
    model.part_index(name).ok_or_else(|| {
        let name = shown::quoted(name);
        let what = format!("it moves a part {name}, which the model does not have");
        wrong(file, &what, "give a record of the same model")
    })
}

/// How many coordinates a part has.
fn freedom(model: &Mechanism, part: usize) -> usize {
    match model.parts[part].axis.map(|axis| axis.motion) {
        None => 3,
        Some(AxisMotion::Fixed) => 0,
        Some(_) => 1,
    }
}

/// The samples of a record in CSV or JSON, by the extension. Parts that are not in it stay as they are drawn.
pub(super) fn samples(file: &Path, model: &Mechanism) -> Result<Vec<Sample>, Failure> {
    let samples = if output::ends_in(file, "csv") {
        of_csv(file, model)
    } else {
        of_json(file, model)
    }?;
    let is_early = |pair: &[Sample]| pair[1].time < pair[0].time;
    if let Some(k) = samples.windows(2).position(is_early) {
        let what = format!("sample {} is earlier than the one before it", k + 1);
        return Err(wrong(file, &what, "give the samples in order of time"));
    }
    if samples.is_empty() {
        let what = "there is no sample";
        return Err(wrong(file, what, "simulate again with a shorter --every"));
    }
    Ok(samples)
}

fn of_json(file: &Path, model: &Mechanism) -> Result<Vec<Sample>, Failure> {
    let record = json(file, model, false)?;
    let help = "give what `cspace simulate` writes with -o OUT.json, of the same model";
    let none = Vec::new();
    let rows = record["samples"].as_array().unwrap_or(&none);
    let mut samples = Vec::with_capacity(rows.len());
    for (number, row) in rows.iter().enumerate() {
        let bad = |what: &str| wrong(file, &format!("sample {number}: {what}"), help);
        let time = row["t"].as_f64().ok_or_else(|| bad("t is no number"))?;
        let mut parts = vec![[0.0; 3]; model.parts.len()];
        for (i, place) in parts.iter_mut().enumerate() {
            let name = model.parts[i].part.name();
            let Some(value) = row.get(name) else { continue };
            let one = value.as_f64().map(|u| vec![u]);
            let list = |v: &Value| v.as_array()?.iter().map(Value::as_f64).collect();
            let numbers: Option<Vec<f64>> = one.or_else(|| list(value));
            let numbers = numbers.filter(|n| n.len() == freedom(model, i));
            let numbers = numbers.ok_or_else(|| {
                let name = shown::quoted(name);
                bad(&format!("part {name} does not move as in the model"))
            })?;
            place[..numbers.len()].copy_from_slice(&numbers);
        }
        samples.push(Sample { time, parts });
    }
    Ok(samples)
}

fn of_csv(file: &Path, model: &Mechanism) -> Result<Vec<Sample>, Failure> {
    let help = "give what `cspace simulate` writes with -o OUT.csv, of the same model";
    let bytes = input::bytes(file, LARGEST, help)?;
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_reader(bytes);
    let bad = |e: csv::Error| wrong(file, &e.to_string(), help);
    let header = reader.headers().map_err(bad)?.clone();
    if header.get(0) != Some("t") {
        return Err(wrong(file, "the first column is not t", help));
    }
    // Which coordinate of which part a column has; rates and forces are not looked at.
    let mut columns: Vec<Option<(usize, usize)>> = vec![None];
    for name in header.iter().skip(1) {
        let coordinate = name.rsplit_once('.').and_then(|(part, coordinate)| {
            let (k, of) = match coordinate {
                "u" | "x" => (0, if coordinate == "u" { 1 } else { 3 }),
                "y" => (1, 3),
                "theta" => (2, 3),
                _ => return None,
            };
            Some((part, k, of))
        });
        columns.push(match coordinate {
            None => None,
            Some((part, k, of)) => {
                let i = known(file, model, part)?;
                if freedom(model, i) != of {
                    let name = shown::quoted(part);
                    let what = format!("part {name} does not move as in the model");
                    return Err(wrong(file, &what, help));
                }
                Some((i, k))
            }
        });
    }
    let mut samples = Vec::new();
    for (row, record) in reader.records().enumerate() {
        let record = record.map_err(bad)?;
        let number = |text: &str| {
            let found = text.parse::<f64>().ok().filter(|x| x.is_finite());
            let text = shown::quoted(text);
            found.ok_or_else(|| wrong(file, &format!("sample {row}: {text} is no number"), help))
        };
        let mut sample = Sample {
            time: number(&record[0])?,
            parts: vec![[0.0; 3]; model.parts.len()],
        };
        for (text, column) in record.iter().zip(&columns) {
            if let Some((i, k)) = *column {
                sample.parts[i][k] = number(text)?;
            }
        }
        samples.push(sample);
    }
    Ok(samples)
}
