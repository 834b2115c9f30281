//! Outlines of parts that a model takes from drawings.

use std::path::Path;

use cspace::{Part, Point};
use cspace_drawing::{Color, Conversion, DrawingError, Pick, Settings, Source};

use super::error::ModelError;
use super::node::Node;
use super::scope::Result;
use super::table::Table;
use super::value::Value;
use crate::file::Host;
use crate::shown::quoted;

/// Access to the drawings that a model names, with the host for which they are read.
#[derive(Clone, Copy)]
pub(super) struct Files<'a> {
    /// The folder that the names of drawings are relative to.
    pub(super) folder: &'a Path,
    pub(super) host: &'a Host<'a>,
}

/// Settings of a model that hold for all of its parts.
pub(super) struct Setting<'a> {
    /// The drawings that it may name.
    pub(super) files: &'a Files<'a>,
    /// The label of the unit of length.
    pub(super) unit: Option<&'a str>,
    /// Notes for the reader of the model, each at its place.
    pub(super) notes: Vec<ModelError>,
}

/// Keys of a part that hold its outline.
const DRAWN_HERE: [&str; 2] = ["loops", "union"];

/// Keys of a part that name a file with its outline.
pub(super) const DRAWINGS: [&str; 3] = ["dxf", "svg", "points"];

/// Keys that go with drawings, and of what drawings.
pub(super) const OF_DRAWINGS: [(&str, &[&str]); 11] = [
    ("layer", &["dxf"]),
    ("id", &["svg"]),
    ("linetype", &["dxf"]),
    ("color", &["dxf", "svg"]),
    ("without_sheet", &["dxf", "svg"]),
    ("hatches", &["dxf"]),
    ("pick", &["dxf", "svg"]),
    ("trace", &["dxf", "svg"]),
    ("scale", &["dxf", "svg", "points"]),
    ("join", &["dxf", "svg"]),
    ("fit", &["dxf", "svg", "points"]),
];

/// The key that names a drawing; none of a part whose outline is in the model. A part has one outline, and keys that go with it.
pub(super) fn source(table: &Table<'_>) -> Result<Option<&'static str>> {
    let given: Vec<&'static str> = (DRAWN_HERE.into_iter())
        .chain(DRAWINGS)
        .filter(|key| table.has(key))
        .collect();
    if let [first, second, ..] = given[..] {
        let message = format!("both `{first}` and `{second}` are given");
        let error = table.error_at_key(second, message);
        return Err(error.with_help(format!(
            "a part has one outline: keep `{first}` or `{second}`, and remove the other"
        )));
    }
    let source = given
        .first()
        .copied()
        .filter(|key| !DRAWN_HERE.contains(key));
    for (key, of) in OF_DRAWINGS {
        if table.has(key) && !source.is_some_and(|s| of.contains(&s)) {
            let message = format!("`{key}` is given without a drawing that it is of");
            let error = table.error_at_key(key, message);
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
    setting: &mut Setting<'_>,
) -> Result<Part> {
    let file = table.text(key)?.unwrap_or_default();
    let expected: &[&str] = match key {
        "points" => &["csv", "txt", "dat"],
        "dxf" => &["dxf"],
        _ => &["svg"],
    };
    let path = setting.files.folder.join(file);
    let extension = path.extension().unwrap_or_default();
    if !expected.iter().any(|e| extension.eq_ignore_ascii_case(e)) {
        let expected = expected[0];
        let message = format!("the name {} does not end in .{expected}", quoted(file));
        let help = format!("give the name of the file, such as {key} = \"part.{expected}\"");
        return Err(table.error(key, message).with_help(help));
    }
    let source = Source {
        layers: texts(table, "layer", "layer = [\"outline\", \"holes\"]")?,
        ids: texts(table, "id", "id = [\"body\", \"cover\"]")?,
        linetypes: texts(table, "linetype", "linetype = [\"CONTINUOUS\"]")?,
        colors: colors(table)?,
        hatches: table.flag("hatches")?,
    };
    (setting.files.host.guard)(&path).map_err(|refused| {
        table
            .error(key, format!("{}: {}", path.display(), refused.message))
            .with_help(refused.help)
    })?;
    let wrong = |e: &DrawingError| {
        table
            .error(key, format!("{}: {e}", path.display()))
            .with_help(match e {
                DrawingError::Entities(_) => format!(
                    "{}; or make the part of closed faces with pick = [[x, y]]: `cspace import {}` lists them",
                    e.help(),
                    quoted(file)
                ),
                DrawingError::File { .. } => e.help().to_owned(),
            })
    };
    let drawing = cspace_drawing::read(&path, &source).map_err(|e| wrong(&e))?;
    let scale = match table.number("scale")? {
        Some(scale) => scale,
        None => {
            let conversion = Conversion::new(drawing.unit, setting.unit);
            if let Some(note) = conversion.note("scale = 1") {
                setting.notes.push(table.error(key, note));
            }
            conversion.factor()
        }
    };
    let settings = Settings {
        scale,
        join: table.number("join")?,
        fit: table.number("fit")?,
        picks: picks(table)?,
        trace: table.flag("trace")?,
        without_sheet: table.flag("without_sheet")?,
        one_part: Some(name.to_owned()),
        ..Settings::default()
    };
    if settings.trace && !settings.picks.is_empty() {
        let help =
            "keep one of them: faces are made of what is drawn, not of what is fitted to traces";
        return Err(table
            .error("trace", "both `pick` and `trace` are given")
            .with_help(help));
    }
    let outlines = drawing.outlines(&settings).map_err(|e| wrong(&e))?;
    for note in [outlines.gaps_closed(), outlines.centre_lines()] {
        setting
            .notes
            .extend(note.map(|note| table.error(key, note)));
    }
    if let Some(note) = outlines.short_pieces(&settings) {
        let note = format!("{note}; if they matter, give a smaller `join`");
        setting.notes.push(table.error(key, note));
    }
    (outlines.parts.into_iter().next())
        .ok_or_else(|| table.error(key, "the drawing has no outline"))
}

/// The faces that the part is made of: a point in each.
fn picks(table: &Table<'_>) -> Result<Vec<Pick>> {
    let Some(value) = table.get("pick") else {
        return Ok(Vec::new());
    };
    let wrong = || {
        let help = "give a point in each face, such as pick = [[12.5, -3]]";
        table.wrong("pick", value.node, "a list of points [x, y]", help)
    };
    let points = value.items().filter(|points| !points.is_empty());
    let point = |point: Value<'_>| {
        let numbers = match point.items().as_deref() {
            Some([x, y]) => x.number()?.zip(y.number()?),
            _ => None,
        };
        let point = numbers.map(|(x, y)| Point::new(x, y));
        point.filter(|p| p.is_finite()).ok_or_else(wrong)
    };
    let points = points.ok_or_else(wrong)?.into_iter();
    let at = points.map(point).collect::<Result<_>>()?;
    Ok(vec![Pick { name: None, at }])
}

/// The texts of a key: one, or a list.
fn texts(table: &Table<'_>, key: &str, example: &str) -> Result<Vec<String>> {
    match table.get(key).map(|value| value.node) {
        Some(Node::List(list)) => (list.iter())
            .map(|node| match node {
                Node::Text(text) => Ok(text.to_string()),
                other => {
                    let message = format!("{} where a text is expected", other.describe());
                    let help = format!("give it as {example}");
                    Err(table.error(key, message).with_help(help))
                }
            })
            .collect(),
        _ => Ok(table.text(key)?.map(str::to_owned).into_iter().collect()),
    }
}

fn colors(table: &Table<'_>) -> Result<Vec<Color>> {
    let texts = texts(table, "color", "color = [\"red\", \"#0000ff\"]")?;
    let color = |text: String| {
        text.parse().map_err(|help| {
            let message = format!("{} is no colour", quoted(&text));
            table.error("color", message).with_help(help)
        })
    };
    texts.into_iter().map(color).collect()
}
