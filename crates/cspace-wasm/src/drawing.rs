//! A drawing, as JavaScript has it: its faces are shown, and picked ones become the parts of a model.

use cspace_api::scene::{OpenedDrawing, PickedPart};
use cspace_drawing::DrawingError;
use wasm_bindgen::prelude::*;

use crate::fault;

/// Drawing with its source.
#[wasm_bindgen]
pub struct Drawing {
    opened: OpenedDrawing,
}

#[wasm_bindgen]
impl Drawing {
    /// A drawing's file, DXF or SVG, as `cspace view FILE` reads it without further options; `name` is the file's.
    pub fn read(bytes: &[u8], name: &str) -> Result<Drawing, JsError> {
        let opened = OpenedDrawing::of_file(name, bytes.to_vec()).map_err(|e| told(name, &e))?;
        Ok(Self { opened })
    }

    /// Reads the drawing from the JSON of a scene's `source`.
    #[wasm_bindgen(js_name = fromSource)]
    pub fn from_source(source: &str) -> Result<Drawing, JsError> {
        let source: cspace_api::scene::DrawingSource =
            serde_json::from_str(source).map_err(fault)?;
        let file = source.file.clone();
        let opened = OpenedDrawing::from_source(source).map_err(|e| told(&file, &e))?;
        Ok(Self { opened })
    }

    /// The drawing and its faces as JSON: a `DrawingScene`.
    pub fn scene(&self) -> Result<String, JsError> {
        let scene = self.opened.scene();
        let scene = scene.map_err(|e| told(&self.opened.source.file, &e))?;
        serde_json::to_string(&scene).map_err(fault)
    }

    /// The model of picked faces as TOML, as `cspace import` writes it of the same picks. They are JSON: a list of parts, each with its
    /// `name` and `at`, a point `{x, y}` in each face.
    pub fn toml(&self, picked: &str) -> Result<String, JsError> {
        let picked: Vec<PickedPart> = serde_json::from_str(picked).map_err(fault)?;
        let text = self.opened.toml(&picked);
        text.map_err(|e| fault(format_args!("{e} ({})", e.help())))
    }
}

/// Error in a drawing, and advice, in the words of the command.
fn told(file: &str, error: &DrawingError) -> JsError {
    fault(format_args!("{file}: {error} ({})", error.help()))
}
