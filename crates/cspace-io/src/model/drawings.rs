//! Outlines of parts that a model takes from drawings.

use std::path::Path;

use cspace::Part;
use cspace_drawing::{DrawingError, Settings, Source, Unit};

use super::error::ModelError;
use super::node::Node;
use super::table::{Result, Table};
use crate::file::Guard;
use crate::shown::quoted;

/// Where drawings are that a model names, and which of them may be opened.
#[derive(Clone, Copy)]
pub(crate) struct Files<'a> {
    /// The folder that the names of drawings are relative to.
    pub(super) folder: &'a Path,
    pub(super) guard: Guard<'a>,
}

impl<'a> Files<'a> {
    /// Drawings relative to the folder of a file.
    pub(crate) fn beside(file: &'a str, guard: Guard<'a>) -> Self {
        Self {
            folder: Path::new(file).parent().unwrap_or(Path::new("")),
            guard,
        }
    }
}

/// What a model says for all of its parts.
pub(super) struct Setting<'a> {
    /// The drawings that it may name.
    pub(super) files: &'a Files<'a>,
    /// The label of the unit of length.
    pub(super) unit: Option<&'a str>,
}

/// The key that names a drawing; none of a part with loops. A part has one outline, and keys that go with it.
pub(super) fn source(table: &Table<'_>) -> Result<Option<&'static str>> {
    let given: Vec<&'static str> = ["loops", "dxf", "svg", "points"]
        .into_iter()
        .filter(|key| table.get(key).is_some())
        .collect();
    if let [first, second, ..] = given[..] {
        let message = format!("both `{first}` and `{second}` are given");
        let error = ModelError::new(&table.place.key(second).itself(), message);
        return Err(error.with_help(format!(
            "a part has one outline: keep `{first}` or `{second}`, and remove the other"
        )));
    }
    let source = given.first().copied().filter(|key| *key != "loops");
    let drawings: &[(&str, &[&str])] = &[
        ("layer", &["dxf"]),
        ("id", &["svg"]),
        ("scale", &["dxf", "svg", "points"]),
        ("join", &["dxf", "svg"]),
        ("fit", &["dxf", "svg", "points"]),
    ];
    for (key, of) in drawings {
        if table.get(key).is_some() && !source.is_some_and(|s| of.contains(&s)) {
            let message = format!("`{key}` is given without a drawing that it is of");
            let error = ModelError::new(&table.place.key(key).itself(), message);
            return Err(error.with_help(format!("it goes with {}: remove `{key}`", words(of))));
        }
    }
    Ok(source)
}

/// `dxf`, `svg` and `points`
fn words(keys: &[&str]) -> String {
    let quoted: Vec<String> = keys.iter().map(|w| format!("`{w}`")).collect();
    match quoted.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, rest)) => format!("{} and {last}", rest.join(", ")),
        None => String::new(),
    }
}

/// The part that the drawing shows which the value of a key names.
pub(super) fn read_drawing(
    table: &Table<'_>,
    name: &str,
    key: &str,
    setting: &Setting<'_>,
) -> Result<Part> {
    let file = table.text(key)?.unwrap_or_default();
    let expected = if key == "points" { "csv" } else { key };
    let path = setting.files.folder.join(file);
    let extension = path.extension().unwrap_or_default();
    if !extension.eq_ignore_ascii_case(expected) {
        let message = format!("the name {} does not end in .{expected}", quoted(file));
        let help = format!("give the name of the file, such as {key} = \"part.{expected}\"");
        return Err(table.error(key, message).with_help(help));
    }
    let source = Source {
        layers: layers(table)?,
        id: table.text("id")?.map(str::to_owned),
    };
    (setting.files.guard)(&path).map_err(|refused| {
        table
            .error(key, format!("{}: {}", path.display(), refused.message))
            .with_help(refused.help)
    })?;
    let wrong = |e: &DrawingError| {
        table
            .error(key, format!("{}: {e}", path.display()))
            .with_help(e.help())
    };
    let drawing = cspace_drawing::read(&path, &source).map_err(|e| wrong(&e))?;
    let scale = table.number("scale")?;
    if let (None, Some(own), Some(label)) = (scale, drawing.unit, setting.unit) {
        check_unit(table, key, own, label)?;
    }
    let settings = Settings {
        scale: scale.unwrap_or(1.0),
        join: table.number("join")?,
        fit: table.number("fit")?,
        one_part: Some(name.to_owned()),
        ..Settings::default()
    };
    let outlines = drawing.outlines(&settings).map_err(|e| wrong(&e))?;
    (outlines.parts.into_iter().next())
        .ok_or_else(|| table.error(key, "the drawing has no outline"))
}

/// One layer, or several.
fn layers(table: &Table<'_>) -> Result<Vec<String>> {
    match table.get("layer") {
        Some(Node::List(list)) => (list.iter())
            .map(|node| match node {
                Node::Text(layer) => Ok(layer.to_string()),
                other => {
                    let message =
                        format!("{} where the name of a layer is expected", other.describe());
                    Err(table
                        .error("layer", message)
                        .with_help("give it as layer = [\"outline\", \"holes\"]"))
                }
            })
            .collect(),
        _ => Ok(table
            .text("layer")?
            .map(str::to_owned)
            .into_iter()
            .collect()),
    }
}

/// A drawing in one unit and a model in another need a factor.
fn check_unit(table: &Table<'_>, key: &str, own: Unit, label: &str) -> Result<()> {
    match Unit::of_label(label) {
        Some(unit) if unit != own => {
            let factor = own.millimetres() / unit.millimetres();
            let message = format!("the drawing is in {}, the model in {label}", own.label());
            Err(table.error(key, message).with_help(format!(
                "give scale = {factor:?}, or scale = 1.0 to take the numbers as they are"
            )))
        }
        _ => Ok(()),
    }
}
