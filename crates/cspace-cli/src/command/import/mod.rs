//! `cspace import`.

mod faces;
mod text;

use std::path::{Path, PathBuf};

use clap::Args;
use cspace_api::import::{Finding, Imported, Question, Refusal};
use cspace_drawing::Drawing;
use cspace_model::model;

use crate::args::{FormArgs, SourceArgs};
use crate::ask::Terminal;
use crate::drawing;
use crate::failure::{self, Failure};
use crate::output;
use crate::traces::{self, OTHER, quoted};

const HELP: &str = "\
Examples:
  cspace import plate.dxf -o plate.toml
  cspace import pawl.dxf wheel.svg --unit mm -o ratchet.toml
  cspace import gear.dxf --layer OUTLINE --layer HOLES --part gear -o gear.toml
  cspace import scan.csv --fit 0.02 -o profile.toml
  cspace import traced.dxf --trace --fit 0.02 -o gear.toml

Every outermost loop with the holes in it is a part, called as its block, its
layer or its file. Loose lines and arcs are joined where their ends meet, what
is drawn twice is taken once, splines, ellipses and points become tangent lines
and arcs. What was made, left out, joined and fitted is printed; what cannot be
used is an error that names it, or with --partial is left out and listed.
Without -o nothing is written. A model may name a drawing as well: dxf =
\"plate.dxf\" in place of loops. See docs/drawings.md.";

/// Arguments of `cspace import`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ImportArgs {
    /// Drawings: .dxf, .svg, or .csv with the columns x and y
    #[arg(value_name = "DRAWING", required = true)]
    pub(crate) drawings: Vec<PathBuf>,

    /// Write the model to this file, .toml or .json; whole or not at all
    #[arg(short, long, value_name = "MODEL")]
    pub(crate) output: Option<PathBuf>,

    /// How to print what was done
    #[command(flatten)]
    pub(crate) form: FormArgs,

    #[command(flatten)]
    pub(crate) source: SourceArgs,

    #[command(flatten)]
    pub(crate) question: Question,
}

pub(crate) fn run(args: &ImportArgs) -> Result<(), Failure> {
    let output = args.output.as_deref();
    if let Some(path) = output {
        check_name(path)?;
    }
    output::check(output)?;
    let paths = args.drawings.iter().map(AsRef::as_ref);
    drawing::check_options(&args.source, paths.clone())?;
    drawing::check_option("--by-layer", "dxf", args.question.by_layer, paths)?;
    let drawings = (args.drawings.iter())
        .map(|path| Ok((path.clone(), drawing::read(&args.source, path)?)))
        .collect::<Result<Vec<(PathBuf, Drawing)>, Failure>>()?;
    let question = Question {
        name: cspace_api::scene::model_name(&args.drawings[0]),
        ..args.question.clone()
    };
    let answer = question
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
    if args.question.trace {
        return;
    }
    let files = args.drawings.iter().map(|d| quoted(d));
    let files = files.collect::<Vec<_>>().join(" ");
    let finding = Finding {
        fit: None,
        ..args.question.finding.clone()
    };
    let options = drawing::options(&args.source, &finding);
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
