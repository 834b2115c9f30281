//! `cspace import`.

mod faces;
mod text;

use std::path::{Path, PathBuf};

use cspace_api::import::{Imported, Question, Refusal};
use cspace_drawing::{Drawing, FitSide};
use cspace_model::model;

use crate::args::{DrawingArgs, ImportArgs, Side};
use crate::ask::Terminal;
use crate::drawing;
use crate::failure::{self, Failure};
use crate::output;
use crate::traces::{self, OTHER, quoted};

pub(crate) fn run(args: &ImportArgs) -> Result<(), Failure> {
    let output = args.output.as_deref();
    if let Some(path) = output {
        check_name(path)?;
    }
    output::check(output)?;
    let paths = args.drawings.iter().map(AsRef::as_ref);
    drawing::check_options(&args.drawing, paths.clone())?;
    drawing::check_option("--by-layer", "dxf", args.by_layer, paths)?;
    let drawings = (args.drawings.iter())
        .map(|path| Ok((path.clone(), drawing::read(&args.drawing, path)?)))
        .collect::<Result<Vec<(PathBuf, Drawing)>, Failure>>()?;
    let answer = question(args)
        .ask(&drawings, &Terminal::default())
        .map_err(|refusal| refused(*refusal))?;
    let made = &answer.content;
    if let Some(path) = output {
        let text = match is_json(path) {
            true => model::to_json(&made.mechanism),
            false => model::to_toml(&made.mechanism),
        };
        output::write(output, text.as_bytes())?;
        if path == Path::new(output::STANDARD) {
            return Ok(());
        }
    }
    remark(args, made);
    super::tell_in(args.form.format(), &answer, |text, made| {
        text::describe(text, &args.drawings, made)
    })
}

fn question(args: &ImportArgs) -> Question {
    Question {
        name: cspace_api::scene::model_name(&args.drawings[0]),
        lengths: drawing::lengths(&args.drawing),
        join: args.drawing.join,
        fit: args.drawing.fit,
        fit_side: match args.fit_side {
            Side::Both => FitSide::Both,
            Side::Outside => FitSide::Outside,
            Side::Inside => FitSide::Inside,
        },
        trace: args.trace,
        without_sheet: args.drawing.without_sheet,
        offset: args.offset,
        split: args.split,
        part: args.part.clone(),
        by_layer: args.by_layer,
        partial: args.partial,
        pick: args.pick.clone(),
    }
}

/// The failure of a drawing that is refused, once all that is wrong with it is said.
fn refused(refusal: Refusal) -> Failure {
    for problem in &refusal.problems {
        Failure::from(problem.clone()).print_beside();
    }
    faces::print(&refusal);
    refusal.error.into()
}

/// Says what is most likely not meant of a model that is written.
fn remark(args: &ImportArgs, made: &Imported) {
    for (path, sheet) in (args.drawings.iter().zip(&made.outlines))
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
    for problem in made.outlines.iter().filter_map(|o| o.crossing.as_ref()) {
        failure::note(format_args!(
            "parts overlap as they are drawn: {problem}; if they are one part, or holes, mend the drawing"
        ));
    }
    if args.trace {
        return;
    }
    let files = args.drawings.iter().map(|d| quoted(d));
    let files = files.collect::<Vec<_>>().join(" ");
    let options = drawing::options(&DrawingArgs {
        fit: None,
        ..args.drawing.clone()
    });
    traces::tell(&made.mechanism, |fit| {
        format!("cspace import {files}{options} --trace --fit {fit} -o {OTHER}")
    });
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
