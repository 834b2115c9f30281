//! A model, as JavaScript has it: its pairs are computed, also once its parts are edited.

use cspace::Silent;
use cspace_scene::{EditedPart, Opened};
use wasm_bindgen::prelude::*;

use crate::fault;

/// A model and those of its pairs that are shown.
#[wasm_bindgen]
pub struct Model {
    opened: Opened,
}

/// Seconds since any moment.
fn seconds() -> f64 {
    js_sys::Date::now() / 1e3
}

fn parts(json: &str) -> Result<Vec<EditedPart>, JsError> {
    serde_json::from_str(json).map_err(fault)
}

fn json(answer: &impl serde::Serialize) -> Result<String, JsError> {
    serde_json::to_string(answer).map_err(fault)
}

#[wasm_bindgen]
impl Model {
    /// The model that a scene says it was made of: the JSON of its `source`.
    #[wasm_bindgen(js_name = fromSource)]
    pub fn from_source(source: &str) -> Result<Model, JsError> {
        let source = serde_json::from_str(source).map_err(fault)?;
        let opened = Opened::from_source(&source).map_err(fault)?;
        Ok(Self { opened })
    }

    /// A model file: TOML or JSON, as the command reads it; `name` is the file's.
    pub fn read(text: &str, name: &str) -> Result<Model, JsError> {
        let model = cspace_io::read_from(text.as_bytes(), name).map_err(told)?;
        let opened = match model {
            cspace_io::Document::Model(model) => {
                let pairs = model.mechanism.pairs.clone();
                Opened::model(model.mechanism, pairs, false)
            }
            cspace_io::Document::Space(file) => Opened::saved(*file),
        };
        Ok(Self { opened })
    }

    /// The scene, without the spaces of its pairs, as JSON.
    pub fn scene(&self) -> Result<String, JsError> {
        json(&self.opened.scene())
    }

    /// A pair with its space, as JSON: a `ScenePair`.
    pub fn pair(&self, index: usize) -> Result<String, JsError> {
        let pair = self.opened.pair(index, &seconds, &Silent);
        json(&pair.ok_or_else(|| fault(format_args!("there is no pair {index}")))?)
    }

    /// A pair with its space after parts were edited, as JSON.
    pub fn edit(&self, pair: usize, edits: &str) -> Result<String, JsError> {
        let answer = self
            .opened
            .edited_pair(pair, &parts(edits)?, &seconds, &Silent);
        json(&answer.map_err(fault)?)
    }

    /// The model with edited parts, as TOML.
    pub fn toml(&self, edits: &str) -> Result<String, JsError> {
        self.opened.edited_model(&parts(edits)?).map_err(fault)
    }
}

/// An error of a model, and what to do.
fn told(error: cspace_io::ModelError) -> JsError {
    match error.help() {
        Some(help) => fault(format_args!("{error} ({help})")),
        None => fault(error),
    }
}
