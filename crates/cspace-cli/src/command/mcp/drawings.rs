//! Models of drawings.

use std::path::{Path, PathBuf};

use cspace_api::import::{Imported, Question};
use cspace_api::{Answer, Error};
use cspace_drawing::{Drawing, Source};
use cspace_model::model;
use serde::Deserialize;

use super::folder::Folder;
use super::host::Caller;
use crate::drawing::failed;
use crate::failure::Failure;
use crate::output;

/// Arguments beside those of the question.
#[derive(Debug, Deserialize)]
pub(super) struct Drawn {
    drawings: Vec<String>,
    #[serde(default)]
    layer: Vec<String>,
    output: Option<String>,
}

/// Imports drawings: the answer, and the model's text where it is not written to a file.
pub(super) fn import(
    drawn: &Drawn,
    question: Question,
    folder: &Folder,
    host: &Caller,
) -> Result<(Answer<Imported>, Option<String>), Error> {
    let output = drawn
        .output
        .as_deref()
        .map(|path| folder.output(path))
        .transpose()?;
    let source = Source {
        layers: drawn.layer.clone(),
        ..Source::default()
    };
    let read = |path: &String| -> Result<(PathBuf, Drawing), Error> {
        let file = folder.file(path)?;
        let drawing = cspace_drawing::read(&file, &source)
            .map_err(|e| Failure::into_error(failed(Path::new(path), &e)))?;
        Ok((PathBuf::from(path), drawing))
    };
    let drawings = drawn
        .drawings
        .iter()
        .map(read)
        .collect::<Result<Vec<_>, _>>()?;
    let Some(first) = drawings.first() else {
        return Err(Error::new("`drawings` names no file").help("give the path of a drawing"));
    };
    let question = Question {
        name: cspace_api::scene::model_name(&first.0),
        ..question
    };
    let answer = question.ask(&drawings, host).map_err(|refusal| {
        for problem in &refusal.problems {
            host.hear(format!("problem: {problem}"));
        }
        refusal.error
    })?;
    let mechanism = &answer.content.mechanism;
    let Some(path) = output else {
        let text = model::to_toml(mechanism);
        return Ok((answer, Some(text)));
    };
    let text = match output::ends_in(&path, "json") {
        true => model::to_json(mechanism),
        false => model::to_toml(mechanism),
    };
    output::write(Some(&path), text.as_bytes()).map_err(Failure::into_error)?;
    Ok((answer, None))
}
