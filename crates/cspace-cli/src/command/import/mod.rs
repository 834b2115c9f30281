//! `cspace import`.

mod report;

use std::collections::HashSet;
use std::path::Path;

use cspace::{Mechanism, Part, PartEntry};
use cspace_drawing::{DrawingError, FitSide, Outlines, Settings, Source, Unit};
use cspace_io::{model, shown};

use crate::args::{Format, ImportArgs, Side};
use crate::failure::{self, Failure};
use crate::input;
use crate::output;

pub(crate) fn run(args: &ImportArgs) -> Result<(), Failure> {
    let output = args.output.as_deref();
    if let Some(path) = output {
        check_name(path)?;
    }
    output::check(output)?;
    let mut imported = Vec::new();
    for drawing in &args.drawings {
        imported.push(read(args, drawing)?);
    }
    let count: usize = imported.iter().map(|o| o.parts.len()).sum();
    if count > model::MOST_PARTS {
        return Err(Failure::input(format_args!(
            "{count} outlines make as many parts, more than {}",
            model::MOST_PARTS
        ))
        .help("read some layers alone with --layer, or make one part of all with --part NAME"));
    }
    let unit = unit(args, &imported)?;
    let mechanism = Mechanism {
        name: name(&args.drawings[0]),
        unit,
        parts: parts(&mut imported)?,
        ..Mechanism::default()
    };
    let mechanism = Mechanism {
        pairs: mechanism.every_two(),
        ..mechanism
    };
    if let Some(path) = output {
        let text = match is_json(path) {
            true => model::to_json(&mechanism),
            false => model::to_toml(&mechanism),
        };
        output::write(output, text.as_bytes())?;
        if path == Path::new(output::STANDARD) {
            return Ok(());
        }
    }
    for problem in imported.iter().filter_map(|o| o.crossing.as_ref()) {
        failure::note(format_args!(
            "parts overlap as they are drawn: {problem}; if they are one part, or holes, mend the drawing"
        ));
    }
    let report = report::Report::new(&mechanism, &imported);
    let bytes = match args.format {
        Format::Text => report.text(&args.drawings, &imported).into_bytes(),
        Format::Json => super::json(&report)?,
    };
    output::write(None, &bytes)
}

fn is_json(path: &Path) -> bool {
    (path.extension()).is_some_and(|e| e.eq_ignore_ascii_case("json"))
}

fn check_name(path: &Path) -> Result<(), Failure> {
    let is_toml = (path.extension()).is_some_and(|e| e.eq_ignore_ascii_case("toml"));
    let is_file = !std::fs::metadata(path).is_ok_and(|m| !m.is_file());
    if is_toml || is_json(path) || path == Path::new(output::STANDARD) || !is_file {
        return Ok(());
    }
    Err(Failure::input(format_args!(
        "{}: a model is written as TOML or JSON",
        path.display()
    ))
    .help("give a name that ends in .toml or .json after -o"))
}

/// The drawing's name without folder and extension, in characters that a model may have.
fn name(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    shown::text(&stem).into_owned()
}

/// The parts of one drawing. Everything that cannot be used is told.
fn read(args: &ImportArgs, path: &Path) -> Result<Outlines, Failure> {
    let source = Source {
        layers: args.layer.clone(),
        id: args.id.clone(),
    };
    let settings = Settings {
        scale: args.scale,
        join: args.join,
        fit: args.fit,
        side: match args.fit_side {
            Side::Both => FitSide::Both,
            Side::Outside => FitSide::Outside,
            Side::Inside => FitSide::Inside,
        },
        partial: args.partial,
        one_part: args.part.clone(),
    };
    let file = path.display();
    input::drawing(path, &source)?
        .and_then(|drawing| drawing.outlines(&settings))
        .map_err(|error| match &error {
            DrawingError::Entities(problems) if problems.len() > 1 => {
                /// More are not told one by one.
                const MOST: usize = 20;
                for problem in problems.iter().take(MOST) {
                    Failure::input(format_args!("{file}: {problem}"))
                        .help(&problem.help)
                        .print();
                }
                let rest = match problems.len().saturating_sub(MOST) {
                    0 => String::new(),
                    more => format!(", {more} of which are not shown"),
                };
                Failure::input(format_args!(
                    "{file}: {} things cannot be used{rest}",
                    problems.len()
                ))
                .help("mend the drawing, or leave them out with --partial")
            }
            error => Failure::input(format_args!("{file}: {error}")).help(error.help()),
        })
}

/// The unit that the model names: as asked for, or as all drawings say.
fn unit(args: &ImportArgs, imported: &[Outlines]) -> Result<Option<String>, Failure> {
    let mut named = imported.iter().filter_map(|o| o.unit);
    let first = named.next();
    if let Some(label) = &args.unit {
        let asked = Unit::of_label(label);
        if let (Some(own), Some(asked)) = (first, asked)
            && own != asked
            && args.scale == 1.0
        {
            failure::note(format_args!(
                "the drawing is in {}; its numbers are taken as {label}, without --scale {:?}",
                own.label(),
                own.millimetres() / asked.millimetres()
            ));
        }
        return Ok(Some(label.clone()));
    }
    if let (Some(first), Some(other)) = (first, named.find(|u| Some(*u) != first)) {
        return Err(Failure::input(format_args!(
            "one drawing is in {}, another in {}",
            first.label(),
            other.label()
        ))
        .help("import them one by one with --scale, or name the unit of all numbers with --unit"));
    }
    // What is scaled is no longer in the drawing's unit.
    Ok(first
        .filter(|_| args.scale == 1.0)
        .map(|u| u.label().to_owned()))
}

/// All parts; where two drawings call theirs the same, with the drawing's number.
fn parts(imported: &mut [Outlines]) -> Result<Vec<PartEntry>, Failure> {
    let mut taken: HashSet<String> = HashSet::new();
    let mut parts = Vec::new();
    for outlines in imported {
        for part in &mut outlines.parts {
            if !taken.insert(part.name().to_owned()) {
                *part = renamed(part, &taken)?;
                taken.insert(part.name().to_owned());
            }
            parts.push(PartEntry::planar(part.clone()));
        }
    }
    Ok(parts)
}

fn renamed(part: &Part, taken: &HashSet<String>) -> Result<Part, Failure> {
    let name = (2..)
        .map(|n| format!("{} {n}", part.name()))
        .find(|name| !taken.contains(name))
        .unwrap_or_default();
    let loops = (part.loops().iter())
        .map(|l| l.vertices().to_vec())
        .collect();
    Part::new(name, loops).map_err(Failure::work)
}
