//! The commands.

pub(crate) mod assembly;
pub(crate) mod check;
pub(crate) mod clash;
pub(crate) mod classify;
pub(crate) mod completions;
pub(crate) mod compute;
pub(crate) mod contacts;
pub(crate) mod draw;
pub(crate) mod escape;
pub(crate) mod export;
pub(crate) mod import;
pub(crate) mod info;
pub(crate) mod man;
pub(crate) mod modes;
pub(crate) mod motion;
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

use cspace_io::Model;
use cspace_io::shown::quoted;
use cspace_mechanism::Mechanism;
use serde::Serialize;

use crate::failure::{Failure, note};

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
    Failure::input(format_args!("{} is varied twice", quoted(name))).help("name it once")
}

/// Indented JSON with a line break at the end.
fn json(value: &impl Serialize) -> Result<Vec<u8>, Failure> {
    let mut bytes = serde_json::to_vec_pretty(value).map_err(Failure::work)?;
    bytes.push(b'\n');
    Ok(bytes)
}
