//! `cspace check`.

use std::fmt::{self, Write};
use std::path::Path;

use cspace_answers::check::{Row, Told};
use cspace_answers::{Answer, Is, Outcome};
use cspace_design::Sensitivity;
use cspace_model::model::Dimension;
use cspace_model::{Document, Model};

use crate::args::CheckArgs;
use crate::cache;
use crate::failure::Failure;
use crate::input;
use crate::interrupt::catch_interrupts;
use crate::progress::Bar;
use crate::subject::{placed_by_name, set_threads};
use crate::wording::{count, degrees, length};

pub(crate) fn run(args: &CheckArgs) -> Result<(), Failure> {
    args.result.artefact(&[])?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (path, mut model, template) = if args.sensitivities {
        let (template, model) = input::template(&args.file, &args.values)?;
        (args.file.clone(), Box::new(model), Some(template))
    } else {
        let (path, document) = input::document(&args.file, &args.values)?;
        let Document::Model(model) = document else {
            return Err(Failure::new(format_args!(
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
    let keeps = !args.cache.no_cache;
    let rows: Vec<Row> = match &template {
        None => bar
            .watch(|bar| cspace_design::check_by(&model, &cache::compute(keeps, bar), bar))
            .map_err(Failure::new)?
            .iter()
            .map(|c| Row::of(&model, c, None))
            .collect(),
        Some(template) => bar
            .watch(|bar| {
                let host = input::host(&args.values);
                let compute = cache::compute(keeps, bar);
                cspace_design::sensitivities_by(template, &host, &model, &compute, bar)
            })
            .map_err(Failure::new)?
            .into_iter()
            .map(|(c, by)| Row::of(&model, &c, Some(by)))
            .collect(),
    };
    let outcome = Outcome::worst(rows.iter().map(|row| row.outcome));
    let answer = Answer::new(
        "check",
        model.mechanism.unit.as_deref(),
        outcome,
        super::Requirements {
            requirements: &rows,
        },
    );
    let unit = (model.mechanism.unit.as_ref()).map_or(String::new(), |u| format!(" {u}"));
    super::print(&args.result, &answer, |text| {
        describe(text, &model, &rows, &unit)?;
        summary(text, &rows)
    })
}

/// How many of several requirements are not met, and not decided.
fn summary(text: &mut String, rows: &[Row]) -> fmt::Result {
    let of = |is: Is| rows.iter().filter(|row| row.outcome.is == is).count();
    let all = count(rows.len(), "requirement", "requirements");
    for (n, are) in [(of(Is::No), "not met"), (of(Is::Open), "without an answer")] {
        if n > 0 && rows.len() > 1 {
            write!(text, "\n{n} of {all} {are}\n")?;
        }
    }
    Ok(())
}

/// A model without requirements.
pub(super) fn no_requirements(file: &Path) -> Failure {
    let error = format_args!("{}: the model has no requirements", file.display());
    Failure::new(error)
        .help("add [[requirement]] tables with name, measure and limits: see docs/design.md")
}

/// Leaves the requirements of these names.
pub(super) fn chosen(model: &mut Model, names: &[String]) -> Result<(), Failure> {
    if let Some(unknown) = names
        .iter()
        .find(|n| model.requirements.iter().all(|r| r.name != **n))
    {
        return Err(Failure::new(format_args!(
            "--requirement {}: the model has no such requirement",
            cspace_model::shown::quoted(unknown)
        ))
        .help(super::requirements_of(model)));
    }
    model.requirements.retain(|r| names.contains(&r.name));
    Ok(())
}

fn describe(text: &mut String, model: &Model, rows: &[Row], unit: &str) -> fmt::Result {
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
        writeln!(text, "{}: {}", row.name, row.outcome.word)?;
        let value = match row.value {
            None => "none".to_owned(),
            Some(Told::Number(x)) => number(x),
            Some(Told::Truth(true)) => "yes".to_owned(),
            Some(Told::Truth(false)) => "no".to_owned(),
        };
        writeln!(text, "  {:10} {value}", row.measure)?;
        if let Some(gap) = row.gap {
            let what = "the parts fit exactly, and the moving one is smaller by it all around";
            writeln!(text, "  {:10} {gap:.1e}{unit}: {what}", "gap")?;
        }
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
            let a = placed_by_name(&model.mechanism, fixed, a);
            let b = placed_by_name(&model.mechanism, moving, b);
            writeln!(text, "  {:10} {a}, {b}", "touching")?;
        }
        if let Some(more) = row.touching.len().checked_sub(MOST).filter(|n| *n > 0) {
            writeln!(text, "  {:10} {more} more", "")?;
        }
    }
    Ok(())
}
