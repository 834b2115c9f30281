//! Reading files: models in TOML and JSON, and saved spaces.

mod bases;
pub(crate) mod edit;

use cspace::{Coordinates, PairSpace};
use cspace_model::{Mechanism, ModelError, SavedFile, model};

use crate::Finding;
use crate::draw::Bytes;

/// Begins an input that is a list of edits: no text begins with it, being no UTF-8.
const EDITS: u8 = 0xff;

/// Text is read as it is; after [`EDITS`] come edits of a shipped model or of a saved space.
pub(crate) fn run(data: &[u8]) -> Result<u64, Finding> {
    match data {
        [EDITS, edits @ ..] => read(&edit::edited(&mut Bytes::new(edits))),
        _ => read(&String::from_utf8_lossy(data)),
    }
}

/// Reads the text in every format: three answers.
fn read(text: &str) -> Result<u64, Finding> {
    let models = [
        ("toml", model::from_toml(text, "file.toml")),
        ("json", model::from_json(text, "file.json")),
    ];
    for (format, model) in models {
        match model {
            Ok(model) => written_and_read(&model)
                .map_err(|said| finding(&format!("the {format} model {said}"), text))?,
            Err(error) => {
                tells(&error, text).map_err(|said| finding(&said, text))?;
            }
        }
    }
    match SavedFile::from_json(text, "file.json") {
        Ok(file) => {
            saved_and_read(&file).map_err(|said| finding(&said, text))?;
            ask(&file.space).map_err(|said| finding(&said, text))?;
        }
        Err(error) => tells(&error, text).map_err(|said| finding(&said, text))?,
    }
    Ok(3)
}

fn finding(said: &str, text: &str) -> Finding {
    Finding::new(format!("{said}, of the text\n{text}"))
}

fn written_and_read(model: &Mechanism) -> Result<(), String> {
    let text = model::to_toml(model);
    let again = model::from_toml(&text, "again.toml")
        .map_err(|e| format!("is refused when it is written and read again: {e}"))?;
    if again != *model {
        return Err(format!("reads otherwise when it is written as\n{text}"));
    }
    if model::to_toml(&again) != text {
        return Err(format!("is written otherwise than before:\n{text}"));
    }
    Ok(())
}

fn saved_and_read(file: &SavedFile) -> Result<(), String> {
    let text = file.to_json();
    let again = SavedFile::from_json(&text, "again.json")
        .map_err(|e| format!("a space that was read is refused when it is saved: {e}"))?;
    if again.to_json() != text {
        return Err("a space is saved otherwise than it was read".into());
    }
    Ok(())
}

/// Checks that every space that was read answers queries, or returns an error.
fn ask(space: &PairSpace) -> Result<(), String> {
    for k in 0..8 {
        let (s, t) = (f64::from(k % 3) - 1.0, 0.7 * f64::from(k) - 2.0);
        let at = match space {
            PairSpace::FixedAxes(_) => Coordinates::Axes { u: s, v: t },
            PairSpace::Planar(_) | PairSpace::Lower(_) => {
                Coordinates::Planar(cspace::Configuration::new(s, 0.5 * t, t))
            }
        };
        if let Err(error) = space.classify(at)
            && error.to_string().is_empty()
        {
            return Err("a question is refused without a word".into());
        }
    }
    Ok(())
}

/// Checks that an error has a message on one line, about a place that is in the text.
fn tells(error: &ModelError, text: &str) -> Result<(), String> {
    let shown = error.to_string();
    if error.message().trim().is_empty() || shown.contains(char::is_control) {
        return Err(format!("the error {shown:?} is no line of text"));
    }
    if !shown.starts_with("file.") {
        return Err(format!("the error {shown:?} does not name the file"));
    }
    let lines = text.split('\n').count();
    match error.line() {
        Some(line) if line == 0 || line > lines => {
            Err(format!("the error {shown:?} names line {line} of {lines}"))
        }
        _ => Ok(()),
    }
}
