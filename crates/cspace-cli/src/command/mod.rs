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
pub(crate) mod mcp;
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
use std::path::{Path, PathBuf};

use cspace_api::{Answer, Content, Done, Outcome as _};
use serde::Serialize;

use crate::args::{Format, ResultArgs};
use crate::failure::Failure;
use crate::output;

/// Prints the answer to a question, as JSON or as text, and writes it to the file of JSON that is asked for beside it. Where it says no, or
/// leaves the question open, that is a failure without a message.
fn tell<T: Content>(
    result: &ResultArgs,
    answer: &Answer<T>,
    text: impl FnOnce(&mut String, &T) -> fmt::Result,
) -> Result<(), Failure> {
    let output = result.output.as_deref();
    if output.is_some_and(|path| output::ends_in(path, "json")) {
        output::write(output, &json(answer)?)?;
    }
    tell_in(result.format(), answer, text)
}

/// Prints the answer to a question, as [`tell`] does.
fn tell_in<T: Content>(
    format: Format,
    answer: &Answer<T>,
    text: impl FnOnce(&mut String, &T) -> fmt::Result,
) -> Result<(), Failure> {
    let printed = match format {
        Format::Json => json(answer)?,
        Format::Text => {
            let mut printed = String::new();
            text(&mut printed, &answer.content).map_err(Failure::new)?;
            printed.into_bytes()
        }
    };
    output::write(None, &printed)?;
    Failure::of(answer.outcome.is())
}

/// Runs a command whose answer is the file that it writes: as JSON, its name. The command gives the unit of length of what it writes.
pub(crate) fn writing<T: Content<Outcome = Done>>(
    result: &ResultArgs,
    answer: impl FnOnce(PathBuf) -> T,
    run: impl FnOnce() -> Result<Option<String>, Failure>,
) -> Result<(), Failure> {
    if result.format() == Format::Text {
        return run().map(|_| ());
    }
    let output = result.output.as_deref();
    let Some(written) = output.filter(|path| *path != Path::new(output::STANDARD)) else {
        return Err(Failure::new(format_args!(
            "--json: what `{}` writes is no JSON, and goes to standard output",
            T::COMMAND
        ))
        .help("name a file: -o OUT"));
    };
    let unit = run()?;
    let answer = Answer::new(unit.as_deref(), Done::Done, answer(written.to_owned()));
    output::write(None, &json(&answer)?)
}

/// Indented JSON with a line break at the end.
fn json(value: &impl Serialize) -> Result<Vec<u8>, Failure> {
    let mut bytes = serde_json::to_vec_pretty(value).map_err(Failure::new)?;
    bytes.push(b'\n');
    Ok(bytes)
}
