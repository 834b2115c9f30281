//! One answer for each of several files.

use std::path::PathBuf;

use crate::legacy::{Answer as Framed, Outcome};
use serde::Serialize;
use serde_json::{Value, json};

use crate::args::{Common, Format};
use crate::failure::Failure;
use crate::output;

/// The answer for one file.
pub(super) enum Answer {
    Text(String),
    Json(Vec<u8>),
}

/// The answers for several files, or why there is none, each with the name of its file.
#[derive(Serialize)]
struct Files {
    files: Vec<Value>,
}

/// Answers for the file of `common` and for more, one after the other. For several files, each text is headed by its file, and JSON is
/// one list of answers or errors that name theirs. A file without an answer does not hold back the others; the worst failure determines the
/// exit code.
pub(super) fn run(
    command: &'static str,
    common: &Common,
    more: &[PathBuf],
    answer: impl Fn(&Common) -> Result<Answer, Failure>,
) -> Result<(), Failure> {
    common.result.artefact(&[])?;
    if more.is_empty() {
        let bytes = match answer(common)? {
            Answer::Text(text) => text.into_bytes(),
            Answer::Json(bytes) => bytes,
        };
        return output::write(None, &bytes);
    }
    let (mut text, mut files) = (String::new(), Vec::new());
    let mut worst: Option<Failure> = None;
    for file in [&common.file].into_iter().chain(more) {
        let name = file.display().to_string();
        let one = Common {
            file: file.clone(),
            ..common.clone()
        };
        match answer(&one) {
            Ok(Answer::Text(of_file)) => {
                let between = if text.is_empty() { "" } else { "\n" };
                let name = cspace_io::shown::text(&name);
                text += &format!("{between}== {name}\n{of_file}");
            }
            Ok(Answer::Json(bytes)) => {
                let mut framed: Value = serde_json::from_slice(&bytes).map_err(Failure::new)?;
                framed["file"] = json!(name);
                files.push(framed);
            }
            Err(failure) => {
                failure.print_beside();
                files.push(json!({ "file": name, "error": failure.error() }));
                let is_worse = worst.as_ref().is_none_or(|w| failure.is_worse_than(w));
                if is_worse {
                    worst = Some(failure);
                }
            }
        }
    }
    let bytes = match common.result.format() {
        Format::Text => text.into_bytes(),
        Format::Json => {
            let outcome = match worst {
                None => Outcome::DONE,
                Some(_) => Outcome::open("failed"),
            };
            super::json(&Framed::new(command, None, outcome, Files { files }))?
        }
    };
    output::write(None, &bytes)?;
    worst.map_or(Ok(()), |failure| Err(failure.said()))
}
