//! The commands.

pub(crate) mod check;
pub(crate) mod classify;
pub(crate) mod clearance;
pub(crate) mod completions;
pub(crate) mod compute;
pub(crate) mod disassemble;
pub(crate) mod draw;
pub(crate) mod export;
pub(crate) mod import;
pub(crate) mod info;
pub(crate) mod man;
pub(crate) mod modes;
pub(crate) mod new;
mod page;
pub(crate) mod plan;
pub(crate) mod play;
mod record;
mod regions;
mod rows;
mod several;
pub(crate) mod simulate;
pub(crate) mod slice;
pub(crate) mod solve;
pub(crate) mod sweep;
pub(crate) mod tolerances;
pub(crate) mod view;

use std::fmt;
use std::path::Path;

use cspace_answers::{Answer, Outcome};
use cspace_io::Model;
use cspace_io::shown::quoted;
use cspace_mechanism::Mechanism;
use serde::Serialize;

use crate::args::{Format, ResultArgs};
use crate::failure::{Failure, note};
use crate::output;

/// Says of an answer about parts as drawn that some of them start elsewhere.
fn tell_starts(model: &Mechanism) {
    let starts = model.parts.iter().zip(&model.dynamics.parts);
    let names: Vec<String> = starts
        .filter(|(_, dynamics)| dynamics.start.is_some())
        .map(|(part, _)| quoted(part.part.name()))
        .collect();
    if let [first, rest @ ..] = &names[..] {
        let more = match rest.len() {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        note(format_args!(
            "parts are where they are drawn, and not where motions start: {first}{more} has a `start`"
        ));
    }
}

/// The help for an unknown parameter: the names of the model's parameters.
fn parameters_of(model: &Model) -> String {
    let known: Vec<&str> = model.parameters.iter().map(|p| p.name.as_str()).collect();
    match known.is_empty() {
        true => "the model has no parameters: add them under [parameter]".to_owned(),
        false => format!("its parameters are {}", known.join(", ")),
    }
}

/// The help for an unknown requirement: the names of the model's requirements.
fn requirements_of(model: &Model) -> String {
    let known: Vec<&str> = model.requirements.iter().map(|r| r.name.as_str()).collect();
    match known.is_empty() {
        true => "say what is measured in [[requirement]] tables: see docs/design.md".to_owned(),
        false => format!("its requirements are {}", known.join(", ")),
    }
}

/// A name that is varied and was varied before.
fn varied_twice(name: &str) -> Failure {
    Failure::new(format_args!("{} is varied twice", quoted(name))).help("name it once")
}

/// Prints an answer, as JSON or as text, and writes it to the file of JSON that is asked for beside it. Where it says no, or leaves the
/// question open, that is a failure without a message.
fn print<T: Serialize>(
    result: &ResultArgs,
    answer: &Answer<T>,
    text: impl FnOnce(&mut String) -> fmt::Result,
) -> Result<(), Failure> {
    let output = result.output.as_deref();
    if let Some(path) = output.filter(|path| ends_in(path, "json")) {
        output::write(Some(path), &json(answer)?)?;
    }
    let bytes = match result.format() {
        Format::Json => json(answer)?,
        Format::Text => {
            let mut written = String::new();
            text(&mut written).map_err(Failure::new)?;
            written.into_bytes()
        }
    };
    output::write(None, &bytes)?;
    Failure::of(answer.outcome)
}

/// The file that a command wrote.
#[derive(Serialize)]
struct Written<'a> {
    written: &'a Path,
}

/// Runs a command whose answer is the file that it writes: as JSON, its name.
pub(crate) fn writing(
    command: &'static str,
    result: &ResultArgs,
    run: impl FnOnce() -> Result<(), Failure>,
) -> Result<(), Failure> {
    if result.format() == Format::Text {
        return run();
    }
    let output = result.output.as_deref();
    let Some(written) = output.filter(|path| *path != Path::new(output::STANDARD)) else {
        return Err(Failure::new(format_args!(
            "--json: what `{command}` writes is no JSON, and goes to standard output"
        ))
        .help("name a file: -o OUT"));
    };
    run()?;
    let answer = Answer::new(command, None, Outcome::DONE, Written { written });
    output::write(None, &json(&answer)?)
}

/// Whether the name of a file ends in an extension.
fn ends_in(path: &Path, extension: &str) -> bool {
    output::extension(path).is_some_and(|e| e.eq_ignore_ascii_case(extension))
}

/// Indented JSON with a line break at the end.
fn json(value: &impl Serialize) -> Result<Vec<u8>, Failure> {
    let mut bytes = serde_json::to_vec_pretty(value).map_err(Failure::new)?;
    bytes.push(b'\n');
    Ok(bytes)
}
