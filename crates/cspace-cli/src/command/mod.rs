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

use crate::legacy::{Answer, Outcome};
use cspace_api::{Answer as Answered, Content, Is, Outcome as _};
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

/// Prints the answer to a question, as JSON or as text, and writes it to the file of JSON that is asked for beside it. Where it says no, or
/// leaves the question open, that is a failure without a message.
fn tell<T: Content>(
    result: &ResultArgs,
    answer: &Answered<T>,
    text: impl FnOnce(&mut String, &T) -> fmt::Result,
) -> Result<(), Failure> {
    print_as(result, answer, answer.outcome.is(), |written| {
        text(written, &answer.content)
    })
}

/// Prints the answer to a question of a command that writes no file of it.
fn tell_in<T: Content>(
    format: Format,
    answer: &Answered<T>,
    text: impl FnOnce(&mut String, &T) -> fmt::Result,
) -> Result<(), Failure> {
    match format {
        Format::Json => output::write(None, &json(answer)?)?,
        Format::Text => {
            let mut printed = String::new();
            text(&mut printed, &answer.content).map_err(Failure::new)?;
            output::write(None, printed.as_bytes())?;
        }
    }
    Failure::of(answer.outcome.is())
}

/// Prints an answer, as JSON or as text, and writes it to the file of JSON that is asked for beside it. Where it says no, or leaves the
/// question open, that is a failure without a message.
fn print<T: Serialize>(
    result: &ResultArgs,
    answer: &Answer<T>,
    text: impl FnOnce(&mut String) -> fmt::Result,
) -> Result<(), Failure> {
    print_as(result, answer, answer.outcome.is, text)
}

fn print_as(
    result: &ResultArgs,
    answer: &impl Serialize,
    is: Is,
    text: impl FnOnce(&mut String) -> fmt::Result,
) -> Result<(), Failure> {
    let output = result.output.as_deref();
    let file = output.filter(|path| output::ends_in(path, "json"));
    let is_json = result.format() == Format::Json;
    let written = match is_json || file.is_some() {
        true => json(answer)?,
        false => Vec::new(),
    };
    if file.is_some() {
        output::write(file, &written)?;
    }
    if is_json {
        output::write(None, &written)?;
    } else {
        let mut printed = String::new();
        text(&mut printed).map_err(Failure::new)?;
        output::write(None, printed.as_bytes())?;
    }
    Failure::of(is)
}

/// The rows of a table.
#[derive(Serialize)]
struct Rows<T> {
    rows: T,
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

/// Indented JSON with a line break at the end.
fn json(value: &impl Serialize) -> Result<Vec<u8>, Failure> {
    let mut bytes = serde_json::to_vec_pretty(value).map_err(Failure::new)?;
    bytes.push(b'\n');
    Ok(bytes)
}
