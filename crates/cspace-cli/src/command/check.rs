//! `cspace check`.

use std::fmt::{self, Write};
use std::path::Path;

use cspace::Coordinates;
use cspace_design::{Checked, Sensitivity, Value as Found};
use cspace_io::model::{Dimension, MotionQuantity, Quantity, Subject};
use cspace_io::{Document, Model};
use serde::Serialize;
use serde_json::{Map, Value};

use crate::args::{CheckArgs, Format};
use crate::failure::Failure;
use crate::input;
use crate::interrupt::catch_interrupts;
use crate::output;
use crate::progress::Bar;
use crate::subject::set_threads;
use crate::wording::{count, degrees, length};

/// A requirement, measured.
#[derive(Debug, Serialize)]
struct Row {
    name: String,
    /// The two parts that it is about, if it is about two.
    #[serde(skip_serializing_if = "Option::is_none")]
    pair: Option<[String; 2]>,
    /// The part that it is about, if it is about one.
    #[serde(skip_serializing_if = "Option::is_none")]
    part: Option<String>,
    measure: &'static str,
    /// In the model's unit or radians, or true or false; none where it has no value.
    value: Option<Told>,
    #[serde(skip_serializing_if = "Option::is_none")]
    limits: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    equals: Option<bool>,
    /// None of a requirement without limits.
    met: Option<bool>,
    margin: Option<f64>,
    /// The two ends of a play.
    #[serde(skip_serializing_if = "Option::is_none")]
    range: Option<[f64; 2]>,
    /// Where a position is measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<Coordinates>,
    touching: Vec<[String; 2]>,
    /// Why there is no value.
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<String>,
    /// The derivatives by parameters; where they differ for smaller and larger values, that for larger ones.
    #[serde(skip_serializing_if = "Option::is_none")]
    sensitivities: Option<Map<String, Value>>,
    /// The derivatives for smaller and for larger values, where they differ.
    #[serde(skip_serializing_if = "Map::is_empty")]
    one_sided: Map<String, Value>,
    #[serde(skip)]
    by: Vec<Sensitivity>,
    #[serde(skip)]
    dimension: Dimension,
}

#[derive(Debug, Clone, Copy, Serialize)]
#[serde(untagged)]
enum Told {
    Number(f64),
    Truth(bool),
}

pub(crate) fn run(args: &CheckArgs) -> Result<(), Failure> {
    args.result.check_answer()?;
    let output = args.result.output.as_deref();
    output::check(output)?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (path, mut model, template) = if args.sensitivities {
        let (template, model) = input::template(&args.file, &args.values)?;
        (args.file.clone(), Box::new(model), Some(template))
    } else {
        let (path, document) = input::document(&args.file, &args.values)?;
        let Document::Model(model) = document else {
            return Err(Failure::input(format_args!(
                "{}: the file is a saved contact space of two parts",
                path.display()
            ))
            .help("give the model file: requirements are the model's"));
        };
        (path, model, None)
    };
    if model.requirements.is_empty() {
        return Err(no_requirements(&path));
    }
    if !args.requirement.is_empty() {
        chosen(&mut model, &args.requirement)?;
    }
    let bar = Bar::new(model.mechanism.name.clone());
    let rows: Vec<Row> = match &template {
        None => bar
            .watch(|bar| cspace_design::check_with(&model, bar))
            .map_err(Failure::work)?
            .iter()
            .map(|c| row(&model, c, None))
            .collect(),
        Some(template) => bar
            .watch(|bar| {
                let host = input::host(&args.values);
                cspace_design::sensitivities(template, &host, &model, bar)
            })
            .map_err(Failure::work)?
            .into_iter()
            .map(|(c, by)| row(&model, &c, Some(by)))
            .collect(),
    };
    let answer = match args.result.format() {
        Format::Json => super::json(&rows)?,
        Format::Text => {
            let mut text = String::new();
            let unit = (model.mechanism.unit.as_ref()).map_or(String::new(), |u| format!(" {u}"));
            describe(&mut text, &rows, &unit).map_err(Failure::work)?;
            text.into_bytes()
        }
    };
    output::write(output, &answer)?;
    let unmet = rows.iter().filter(|r| r.met == Some(false)).count();
    let unmeasured = rows
        .iter()
        .filter(|r| r.met.is_none() && r.failure.is_some())
        .count();
    match (unmet, unmeasured) {
        (0, 0) => Ok(()),
        (0, n) => Err(Failure::work(format_args!(
            "{} cannot be measured",
            count(n, "requirement", "requirements")
        ))),
        (n, _) => Err(Failure::work(format_args!(
            "{} of {} not met",
            n,
            count(rows.len(), "requirement", "requirements")
        ))),
    }
}

/// A model without requirements.
pub(super) fn no_requirements(file: &Path) -> Failure {
    let error = format_args!("{}: the model has no requirements", file.display());
    Failure::input(error)
        .help("add [[requirement]] tables with name, measure and limits: see docs/design.md")
}

/// Leaves the requirements of these names.
pub(super) fn chosen(model: &mut Model, names: &[String]) -> Result<(), Failure> {
    if let Some(unknown) = names
        .iter()
        .find(|n| model.requirements.iter().all(|r| r.name != **n))
    {
        return Err(Failure::input(format_args!(
            "--requirement {}: the model has no such requirement",
            cspace_io::shown::quoted(unknown)
        ))
        .help(super::requirements_of(model)));
    }
    model.requirements.retain(|r| names.contains(&r.name));
    Ok(())
}

fn row(model: &Model, checked: &Checked, by: Option<Vec<Sensitivity>>) -> Row {
    let derivatives = |one_sided: bool| -> Map<String, Value> {
        let of = |s: &Sensitivity| {
            let [below, above] = *s.derivative.as_ref().ok()?;
            let value = if one_sided {
                Value::from(vec![below, above])
            } else {
                above.into()
            };
            (!one_sided || below != above).then(|| (s.parameter.clone(), value))
        };
        by.iter().flatten().filter_map(of).collect()
    };
    let requirement = &checked.requirement;
    let name = |i: usize| model.mechanism.parts[i].part.name().to_owned();
    let measured = checked.measured.as_ref().ok();
    Row {
        name: requirement.name.clone(),
        pair: checked.parts.map(|parts| parts.map(name)),
        part: match requirement.subject {
            Subject::Motion(_, MotionQuantity::Stroke { part, .. }) => Some(name(part)),
            _ => None,
        },
        measure: requirement.subject.name(),
        value: measured.map(|m| match m.value {
            Found::Number(x) => Told::Number(x),
            Found::Truth(b) => Told::Truth(b),
        }),
        limits: requirement.limits(),
        equals: requirement.equals(),
        met: checked.is_met(),
        margin: checked.margin(),
        range: measured.and_then(|m| m.range).map(|(lo, hi)| [lo, hi]),
        at: match requirement.subject {
            Subject::Pair(_, Quantity::Position { .. }) => {
                measured.and_then(|m| m.stops.first()).map(|s| s.at)
            }
            _ => None,
        },
        touching: checked.touching.clone(),
        failure: checked.measured.as_ref().err().map(ToString::to_string),
        sensitivities: by.as_ref().map(|_| derivatives(false)),
        one_sided: derivatives(true),
        by: by.unwrap_or_default(),
        dimension: requirement.dimension,
    }
}

fn describe(text: &mut String, rows: &[Row], unit: &str) -> fmt::Result {
    /// More pairs of features are counted.
    const MOST: usize = 2;
    for (i, row) in rows.iter().enumerate() {
        if i > 0 {
            text.push('\n');
        }
        let number = |x: f64| match row.dimension {
            Dimension::Angle => degrees(x),
            Dimension::Time => format!("{} s", length(x)),
            Dimension::Number | Dimension::Truth => length(x),
            Dimension::Length => format!("{}{unit}", length(x)),
        };
        let is = match row.met {
            None => "",
            Some(true) => ": met",
            Some(false) => ": not met",
        };
        writeln!(text, "{}{is}", row.name)?;
        let value = match row.value {
            None => "none".to_owned(),
            Some(Told::Number(x)) => number(x),
            Some(Told::Truth(true)) => "yes".to_owned(),
            Some(Told::Truth(false)) => "no".to_owned(),
        };
        writeln!(text, "  {:10} {value}", row.measure)?;
        if let Some(failure) = &row.failure {
            writeln!(text, "  {:10} {failure}", "because")?;
        }
        if let Some([lo, hi]) = row.limits {
            writeln!(text, "  {:10} {} to {}", "limits", number(lo), number(hi))?;
        }
        if let Some(wanted) = row.equals {
            writeln!(
                text,
                "  {:10} {}",
                "required",
                if wanted { "yes" } else { "no" }
            )?;
        }
        if let Some(margin) = row.margin {
            writeln!(text, "  {:10} {}", "margin", number(margin))?;
        }
        if let Some([lo, hi]) = row.range {
            writeln!(text, "  {:10} {} to {}", "free", number(lo), number(hi))?;
        }
        let derivative = |x: f64| {
            // No zero is negative.
            let x = x + 0.0;
            let (x, unit) = if row.dimension == Dimension::Angle {
                (x.to_degrees(), " deg")
            } else {
                (x, "")
            };
            if x == 0.0 || x.abs() >= 1e-3 {
                format!("{x:.6}{unit}")
            } else {
                format!("{x:.4e}{unit}")
            }
        };
        for Sensitivity {
            parameter,
            derivative: found,
        } in &row.by
        {
            let is = match found {
                Err(reason) => format!("none: {reason}"),
                Ok([below, above]) if below == above => derivative(*above),
                Ok([below, above]) => {
                    let (below, above) = (derivative(*below), derivative(*above));
                    format!("{above}; {below} for smaller values")
                }
            };
            let name = format!("by {parameter}");
            writeln!(text, "  {name:10} {is}")?;
        }
        let parts = row.pair.iter().cycle();
        for ([a, b], [fixed, moving]) in row.touching.iter().take(MOST).zip(parts) {
            writeln!(text, "  {:10} {a} of {fixed}, {b} of {moving}", "touching")?;
        }
        if let Some(more) = row.touching.len().checked_sub(MOST).filter(|n| *n > 0) {
            writeln!(text, "  {:10} {more} more", "")?;
        }
    }
    Ok(())
}
