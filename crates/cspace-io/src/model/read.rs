//! From files and text to models.

use std::path::Path;

use super::error::ModelError;
use super::mechanism::{Model, every_two};
use super::node::Node;
use super::parts::read_parts;
use super::relations::{read_joints, read_pairs};
use super::table::{Result, Table};

/// The largest file read, in bytes.
const LARGEST_FILE: u64 = 256 << 20;

impl Model {
    /// Reads a model file: `.toml`, or the same structure as `.json`.
    ///
    /// # Errors
    /// If the file cannot be read or is no model; the error names the part, loop, vertex or line.
    pub fn read(path: impl AsRef<Path>) -> core::result::Result<Self, ModelError> {
        let path = path.as_ref();
        let file = path.display().to_string();
        let error = |message: String| ModelError::new("", message).in_file(&file);
        let extension = path
            .extension()
            .and_then(|e| e.to_str())
            .unwrap_or_default()
            .to_ascii_lowercase();
        if !matches!(extension.as_str(), "toml" | "json") {
            return Err(error(format!(
                "the extension {extension:?} is not that of a model file"
            ))
            .with_help("model files end in .toml or .json"));
        }
        let meta = std::fs::metadata(path)
            .map_err(|e| error(format!("it cannot be read: {e}")).with_help("check the path"))?;
        if meta.is_dir() {
            return Err(error("it is a folder".to_owned()).with_help("give a model file"));
        }
        if meta.len() > LARGEST_FILE {
            return Err(error(format!(
                "it has {} bytes, more than the {LARGEST_FILE} that are read",
                meta.len()
            ))
            .with_help("split the model into several files"));
        }
        let bytes = std::fs::read(path).map_err(|e| {
            error(format!("it cannot be read: {e}")).with_help("check that you may read it")
        })?;
        let text = String::from_utf8(bytes).map_err(|e| {
            error(format!(
                "it is not text: byte {} is no UTF-8",
                e.utf8_error().valid_up_to()
            ))
            .with_help("model files are TOML or JSON text in UTF-8")
        })?;
        let mut model = if extension == "json" {
            Self::from_json(&text, &file)
        } else {
            Self::from_toml(&text, &file)
        }?;
        if model.name.is_empty() {
            model.name = path
                .file_stem()
                .map(|s| s.to_string_lossy().into_owned())
                .unwrap_or_default();
        }
        Ok(model)
    }

    /// Reads a model from TOML text; `file` is what errors call it.
    ///
    /// # Errors
    /// If the text is no model; the error names the part, loop, vertex or line.
    pub fn from_toml(text: &str, file: &str) -> core::result::Result<Self, ModelError> {
        let tree: Node = toml::from_str(text).map_err(|e| {
            let place = e
                .span()
                .map_or_else(String::new, |span| line_and_column(text, span.start));
            let help = "the file is no TOML; see the message for what was expected";
            ModelError::new(place, e.message().to_owned())
                .with_help(help)
                .in_file(file)
        })?;
        from_tree(&tree).map_err(|e| e.in_file(file))
    }

    /// Reads a model from JSON text; `file` is what errors call it.
    ///
    /// # Errors
    /// If the text is no model; the error names the part, loop, vertex or line.
    pub fn from_json(text: &str, file: &str) -> core::result::Result<Self, ModelError> {
        let tree: Node = serde_json::from_str(text).map_err(|e| {
            let place = format!("line {}, column {}", e.line(), e.column());
            ModelError::new(place, format!("the file is no JSON: {e}"))
                .with_help("see the message for what was expected")
                .in_file(file)
        })?;
        from_tree(&tree).map_err(|e| e.in_file(file))
    }
}

fn line_and_column(text: &str, offset: usize) -> String {
    let before = &text[..offset.min(text.len())];
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
    format!("line {line}, column {column}")
}

fn from_tree(tree: &Node) -> Result<Model> {
    let table = Table::new(tree, "", &["name", "unit", "part", "joint", "pair"])?;
    let parts = table.list("part")?.unwrap_or_default();
    if parts.is_empty() {
        return Err(ModelError::new("", "the model has no parts")
            .with_help("describe each part in a [[part]] table"));
    }
    let parts = read_parts(parts)?;
    let joints = read_joints(table.list("joint")?.unwrap_or_default(), &parts)?;
    let pairs = match table.list("pair")? {
        None | Some([]) => every_two(parts.len()).collect(),
        Some(pairs) => read_pairs(pairs, &parts)?,
    };
    Ok(Model {
        name: table.text("name")?.unwrap_or_default().to_owned(),
        unit: table.text("unit")?.map(str::to_owned),
        parts,
        joints,
        pairs,
    })
}
