//! `cspace import`.

mod faces;
mod offsets;
mod report;

use std::collections::hash_map::Entry;
use std::collections::{HashMap, HashSet};
use std::path::Path;

use crate::legacy::{Answer, Outcome};
use cspace::Part;
use cspace_drawing::{Drawing, DrawingError, FitSide, Outlines, Problem, Settings};
use cspace_io::model;
use cspace_mechanism::{Mechanism, PartEntry};

use crate::args::{DrawingArgs, Format, ImportArgs, Side};
use crate::drawing;
use crate::failure::{self, Failure};
use crate::output;
use crate::traces::{self, OTHER, quoted};
use faces::Choice;

pub(crate) fn run(args: &ImportArgs) -> Result<(), Failure> {
    let output = args.output.as_deref();
    if let Some(path) = output {
        check_name(path)?;
    }
    output::check(output)?;
    let drawings = args.drawings.iter().map(AsRef::as_ref);
    drawing::check_options(&args.drawing, drawings.clone())?;
    drawing::check_option("--by-layer", "dxf", args.by_layer, drawings)?;
    let drawings = (args.drawings.iter())
        .map(|path| drawing::read(&args.drawing, path))
        .collect::<Result<Vec<Drawing>, _>>()?;
    let unit = drawing::of_model(&args.drawing, &drawings)?;
    let mut imported = Vec::new();
    for (path, drawing) in args.drawings.iter().zip(drawings) {
        let scale = drawing::factor(&args.drawing, path, &drawing, unit.as_deref());
        let mut outlines = outlines(args, path, &drawing, scale)?;
        let is_sheet = |i: &cspace_drawing::Ignored| i.reason == cspace_drawing::SHEET;
        if args.drawing.without_sheet && !outlines.ignored.iter().any(is_sheet) {
            failure::note(format_args!(
                "{}: --without-sheet leaves nothing out: no upright rectangle is around everything",
                path.display()
            ));
        }
        if let Some(closed) = outlines.gaps_closed() {
            failure::note(format_args!("{}: {closed}", path.display()));
        }
        if let Some(note) = outlines.short_pieces(&drawing::settings(&args.drawing, scale)) {
            failure::warning(
                format_args!("{}: {note}", path.display()),
                format_args!(
                    "if they matter, give a smaller --join, such as --join {:.0e}",
                    0.1 * outlines.largest_removed
                ),
            );
        }
        if let Some(by) = args.offset {
            offsets::apply(args, path, &mut outlines, by)?;
        }
        imported.push(outlines);
    }
    let count: usize = imported.iter().map(|o| o.parts.len()).sum();
    if count > model::MOST_PARTS {
        return Err(Failure::new(format_args!(
            "{count} outlines make as many parts, more than {}",
            model::MOST_PARTS
        ))
        .help("read some layers alone with --layer, or make one part of all with --part NAME"));
    }
    let mechanism = Mechanism {
        name: cspace_scene::model_name(&args.drawings[0]),
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
    for (path, sheet) in (args.drawings.iter().zip(&imported))
        .filter_map(|(path, o)| Some((path, o.sheet.as_ref()?)))
    {
        failure::warning(
            format_args!(
                "{}: {sheet} is a rectangle around everything, and what is in it becomes its holes",
                path.display()
            ),
            format_args!("if it is the sheet, leave it out with --without-sheet"),
        );
    }
    for problem in imported.iter().filter_map(|o| o.crossing.as_ref()) {
        failure::note(format_args!(
            "parts overlap as they are drawn: {problem}; if they are one part, or holes, mend the drawing"
        ));
    }
    if !args.trace {
        let files = args.drawings.iter().map(|d| quoted(d));
        let files = files.collect::<Vec<_>>().join(" ");
        let options = drawing::options(&DrawingArgs {
            fit: None,
            ..args.drawing.clone()
        });
        traces::tell(&mechanism, |fit| {
            format!("cspace import {files}{options} --trace --fit {fit} -o {OTHER}")
        });
    }
    let report = report::Report::new(&mechanism, &imported);
    let answer = Answer::new("import", mechanism.unit.as_deref(), Outcome::DONE, &report);
    let bytes = match args.form.format() {
        Format::Text => report.text(&args.drawings, &imported).into_bytes(),
        Format::Json => super::json(&answer)?,
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
    Err(Failure::new(format_args!(
        "{}: a model is written as TOML or JSON",
        path.display()
    ))
    .help("give a name that ends in .toml or .json after -o"))
}

/// The parts of one drawing. Everything that cannot be used is told.
fn outlines(
    args: &ImportArgs,
    path: &Path,
    drawn: &Drawing,
    scale: f64,
) -> Result<Outlines, Failure> {
    let settings = Settings {
        side: match args.fit_side {
            Side::Both => FitSide::Both,
            Side::Outside => FitSide::Outside,
            Side::Inside => FitSide::Inside,
        },
        partial: args.partial,
        one_part: args.part.clone(),
        by_layer: args.by_layer,
        trace: args.trace,
        picks: args.pick.clone(),
        ..drawing::settings(&args.drawing, scale)
    };
    let file = path.display();
    let reading = (drawn.reading(&settings))
        .map_err(|e| Failure::new(format_args!("{file}: {e}")).help(e.help()))?;
    reading.outlines().map_err(|error| {
        let choice = Choice::of(args, drawn, &reading);
        let problems = match &error {
            DrawingError::Entities(problems) if problems.len() > 1 => problems,
            error => {
                choice.print(&file);
                return Failure::new(format_args!("{file}: {error}"))
                    .help(choice.help(error.help()));
            }
        };
        {
            /// Maximum number of kinds of problems that are listed.
            const MOST: usize = 20;
            let kinds = alike(problems);
            for (problem, more) in kinds.iter().take(MOST) {
                let more = match more {
                    0 => String::new(),
                    n => format!("; and {n} more of this kind"),
                };
                Failure::new(format_args!("{file}: {problem}{more}"))
                    .help(&problem.help)
                    .print();
            }
            let rest = match kinds.len().saturating_sub(MOST) {
                0 => String::new(),
                more => format!(", {more} of which are not shown"),
            };
            choice.print(&file);
            Failure::new(format_args!(
                "{file}: {} things cannot be used{rest}",
                problems.len()
            ))
            .help(choice.help("mend the drawing"))
        }
    })
}

/// Problems; those that concern one entity alone once for each type and reason, with how many more there are of the kind.
fn alike(problems: &[Problem]) -> Vec<(&Problem, usize)> {
    let mut kinds: Vec<(&Problem, usize)> = Vec::new();
    let mut places: HashMap<(&str, &str), usize> = HashMap::new();
    for problem in problems {
        if problem.to.is_some() || !problem.with.is_empty() {
            kinds.push((problem, 0));
            continue;
        }
        match places.entry((&problem.origin.kind, &problem.reason)) {
            Entry::Occupied(at) => kinds[*at.get()].1 += 1,
            Entry::Vacant(at) => {
                at.insert(kinds.len());
                kinds.push((problem, 0));
            }
        }
    }
    kinds
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
    Part::new(name, loops).map_err(Failure::new)
}
