//! Answers to calls of tools.

use std::path::PathBuf;
use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use cspace_api::error::Failed;
use cspace_api::{Error, Given, Named, Question, Subject};
use cspace_draw::{PictureFormat, PictureOptions};
use cspace_model::model::{Setting, Template};
use cspace_model::{Document, Host as Reader, saved};
use serde::Serialize;
use serde_json::{Map, Value};

use super::drawings::import;
use super::folder::Folder;
use super::host::Caller;
use super::reference;
use super::short::short;
use super::tools::{kind_of, tools};
use crate::command::draw::{Shown, scene};
use crate::failure::Failure;

/// A piece of what a tool says.
pub(super) enum Said {
    Text(String),
    /// A PNG in base 64.
    Picture(String),
}

/// Answers a call of a tool, or says why there is no answer.
///
/// # Errors
/// The second is the text of the error, as `--json` prints it.
pub(super) fn call(
    tool: &str,
    arguments: Map<String, Value>,
    folder: &Folder,
    host: &Caller,
) -> Result<Vec<Said>, Vec<Said>> {
    let said = checked(tool, &arguments).and_then(|()| answer(tool, arguments, folder, host));
    let notes = host.notes().into_iter().map(Said::Text);
    match said {
        Ok(mut said) => {
            said.extend(notes);
            Ok(said)
        }
        Err(error) => {
            let text = serde_json::to_string(&Failed { error: &error }).unwrap_or_default();
            Err(core::iter::once(Said::Text(text)).chain(notes).collect())
        }
    }
}

/// Refuses arguments that a tool does not have: they are misspelt.
fn checked(tool: &str, arguments: &Map<String, Value>) -> Result<(), Error> {
    let all = tools();
    let Some(found) = all.iter().find(|t| t.name == tool) else {
        let names: Vec<&str> = all.iter().map(|t| t.name).collect();
        return Err(Error::new(format_args!("there is no tool {tool:?}"))
            .help(format_args!("the tools are {}", names.join(", "))));
    };
    let known = found.takes.get("properties").and_then(Value::as_object);
    let known: Vec<&str> = known
        .into_iter()
        .flatten()
        .map(|(key, _)| key.as_str())
        .collect();
    match arguments.keys().find(|key| !known.contains(&key.as_str())) {
        None => Ok(()),
        Some(key) => Err(Error::new(format_args!("{tool} has no argument {key:?}"))
            .help(format_args!("its arguments are {}", known.join(", ")))),
    }
}

fn answer(
    tool: &str,
    mut arguments: Map<String, Value>,
    folder: &Folder,
    host: &Caller,
) -> Result<Vec<Said>, Error> {
    let in_detail = arguments.remove("detail") == Some(Value::Bool(true));
    match tool {
        "reference" => {
            let topic = arguments.get("topic").and_then(Value::as_str);
            Ok(vec![Said::Text(reference::section(topic)?)])
        }
        "import_drawing" => {
            let drawn = read(tool, &arguments)?;
            let (answer, text) = import(&drawn, read(tool, &arguments)?, folder, host)?;
            let text = text.map(|text| match text.len() <= LONGEST_MODEL || in_detail {
                true => text,
                false => format!(
                    "# the model has {} bytes: give `output` to write it to a file, or `detail`: true",
                    text.len()
                ),
            });
            let told = told(&answer, in_detail)?;
            Ok(core::iter::once(told).chain(text.map(Said::Text)).collect())
        }
        _ => {
            let subject = subject(&mut arguments, folder, host)?;
            match kind_of(tool) {
                None => picture(&subject, &arguments, host).map(|picture| vec![picture]),
                Some(kind) => {
                    arguments.insert("question".to_owned(), kind.into());
                    let question: Question = read(tool, &arguments)?;
                    let answer = question.ask(&subject, host)?;
                    Ok(vec![told(&answer, in_detail)?])
                }
            }
        }
    }
}

/// The longest text of a model that is told unasked, in bytes.
const LONGEST_MODEL: usize = 4000;

/// Arguments as data of a type.
fn read<T: serde::de::DeserializeOwned>(
    tool: &str,
    arguments: &Map<String, Value>,
) -> Result<T, Error> {
    serde_json::from_value(Value::Object(arguments.clone())).map_err(|e| {
        Error::new(format_args!("{tool}: {e}"))
            .help("give the arguments as the schema of the tool says")
    })
}

/// An answer as text.
fn told(answer: &impl Serialize, in_detail: bool) -> Result<Said, Error> {
    let value = serde_json::to_value(answer).map_err(Error::new)?;
    Ok(Said::Text(match in_detail {
        true => value.to_string(),
        false => short(&value),
    }))
}

/// The model that is asked about, as text or by its path, with the values that its parameters are given.
fn subject(
    arguments: &mut Map<String, Value>,
    folder: &Folder,
    host: &Caller,
) -> Result<Subject, Error> {
    let Some(Value::String(model)) = arguments.remove("model") else {
        return Err(Error::new("`model` is missing").help(
            "give the text of a model, or the path of a model file; the tool `reference` says how one is written",
        ));
    };
    let set = settings(arguments.remove("set"))?;
    let is_text = model.contains('\n') || model.trim_start().starts_with(['{', '[']);
    let guard = |path: &std::path::Path| folder.guard(path);
    let note = |text: &str| host.hear(format!("note: {text}"));
    let reader = Reader {
        guard: &guard,
        note: &note,
        set: &set,
    };
    let (path, template) = match is_text {
        true => {
            let name = match model.trim_start().starts_with('{') {
                true => "model.json",
                false => "model.toml",
            };
            (
                PathBuf::from(name),
                Template::from_text(model, folder.beside(name))?,
            )
        }
        false => {
            let file = folder.file(&model)?;
            (PathBuf::from(model), Template::read(file, &reader)?)
        }
    };
    if saved::is_saved(template.text()) {
        let file = path.display().to_string();
        let read = cspace_model::read_from_hosted(template.text().as_bytes(), &file, &reader)?;
        return Ok(Subject::of(path, read, None, set));
    }
    let document = Document::Model(Box::new(template.model(&reader)?));
    Ok(Subject::of(path, document, Some(Arc::new(template)), set))
}

/// Values of parameters.
fn settings(given: Option<Value>) -> Result<Vec<Setting>, Error> {
    let wrong = || {
        Error::new("`set` is no object of numbers and texts")
            .help("give it as { \"pin\": 6.2, \"tilt\": \"18deg\" }")
    };
    let given = match given {
        None | Some(Value::Null) => Map::new(),
        Some(Value::Object(given)) => given,
        Some(_) => return Err(wrong()),
    };
    let setting = |(name, value): (String, Value)| {
        let value = match value {
            Value::String(text) => text,
            Value::Number(number) => number.to_string(),
            _ => return Err(wrong()),
        };
        Ok(Setting { name, value })
    };
    given.into_iter().map(setting).collect()
}

/// A picture of a model, or of a pair at a configuration.
fn picture(
    subject: &Subject,
    arguments: &Map<String, Value>,
    host: &Caller,
) -> Result<Said, Error> {
    /// Dots: an assistant sees no more of a picture.
    const SIZE: (f64, f64) = (800.0, 600.0);
    let named: Named = read("draw", arguments)?;
    let at = arguments.get("at").cloned().unwrap_or_default();
    let at: Option<Given> = serde_json::from_value(at)
        .map_err(|_| Error::new("`at` is no configuration").help("give it as \"10,0,18deg\""))?;
    let sheet = |title| {
        Ok(PictureOptions {
            size: Some(SIZE),
            title,
            unit: subject.unit().map(str::to_owned),
            ..PictureOptions::default()
        })
    };
    let height = arguments.get("height").and_then(Value::as_f64);
    let shown = Shown {
        named: &named,
        at: at.as_ref(),
        height,
    };
    let scene = scene(subject, host, shown, sheet).map_err(Failure::into_error)?;
    let bytes = PictureFormat::Png.write(&scene).map_err(Error::new)?;
    Ok(Said::Picture(STANDARD.encode(bytes)))
}
