//! Parts from a file's tree of values.

use std::collections::HashMap;

use cspace::{Axis, Part, PartError, Point, Vector};
use cspace_drawing::OffsetError;

use super::drawings::{Setting, read_drawing, source};
use super::keys::{Key, Keys, Kind, Kinds, joined};
use super::names::with_names;
use super::outline::{no_part, read_outline};
use super::placement::at_place;
use super::profile::at_profile;
use super::scope::Result;
use super::table::Table;
use super::union::{Entries, UNION};
use super::value::Value;
use crate::mechanism::{MechanismError, PartEntry};
use crate::shown::quoted;

/// How layers are written.
const LAYERS: &str =
    "layers = [ { z = [0, 4], loops = [...] }, { z = [4, 10], dxf = \"pinion.dxf\" } ]";

/// How outlines are written.
const LOOPS: &str = "loops = [ [[x, y, bulge], [x, y], ...], ... ]";

/// Number of keys of an outline, and of a part.
const OF_OUTLINE: usize = 18;
const OF_PART: usize = OF_OUTLINE + 14;

#[rustfmt::skip]
const OUTLINE_KEYS: [Key; OF_OUTLINE] = [
        Key::new("loops", "loops", "The outline: closed loops, in either direction. Material is what an odd number of them enclose.").like(LOOPS),
        Key::new("union", "outlines", "In place of `loops`: outlines that may overlap, each a list of loops. Material is what any of them encloses, each by an odd number of its own loops.").like(UNION),
        Key::new("dxf", "dxf", "A DXF file that shows the outline, relative to the model's file."),
        Key::new("svg", "svg", "An SVG file that shows the outline, relative to the model's file."),
        Key::new("points", "csv", "A CSV file of points around the part, relative to the model's file: the columns x and y."),
        Key::new("layer", "texts", "The layer, or layers, of the DXF file that show the outline. Default: all that are drawn."),
        Key::new("id", "texts", "The id, or ids, of the SVG elements that show the outline. Default: the whole drawing."),
        Key::new("linetype", "texts", "The line type, or types, of the DXF file that show the outline. Default: all but those of centre lines, hidden edges and the like."),
        Key::new("color", "texts", "The colour, or colours, in which the outline is drawn: a name such as red, #ff0000, or a number of AutoCAD's palette as a text. Default: all."),
        Key::new("without_sheet", "bool", "Whether a rectangle around everything, such as the sheet of material, is left out. Default: false."),
        Key::new("hatches", "bool", "Whether the outlines of the DXF file's hatches are taken too. Default: false."),
        Key::new("pick", "points", "A point in each of the drawing's faces that the part is made of, in the model's unit. Default: all closed outlines."),
        Key::new("trace", "bool", "Whether lines and arcs are fitted to loops of 64 edges and more, as traces of something smooth. Default: false."),
        Key::new("scale", "positive", "A factor for all lengths of the drawing. Default: from the drawing's unit to the model's; 1 where one of them names none."),
        Key::new("join", "positive", "Ends of the drawing nearer than this are one. Default: 1e-5 of the drawing's size."),
        Key::new("fit", "positive", "How far lines and arcs may be from the curves or points that they are fitted to. Default: 1e-4 of the drawing's size."),
        Key::new("place", "place", "Where the outline is put: mirrored, then turned about its origin, then moved. What else is given of the part is given as it is then. Default: as drawn."),
        Key::new("z", "heights", "Its lowest and its highest place. Features of two parts meet where these overlap by more than nothing. Default: at every height."),
];

#[rustfmt::skip]
const PART_KEYS: [Key; OF_PART - OF_OUTLINE] = [
        Key::new("name", "part_name", "The part's name, unlike that of any other part.").needed("name = \"pawl\""),
        Key::new("layers", "layers", "In place of one outline: outlines at different heights, each with the keys that an outline has. Loops are numbered through all of them.").like(LAYERS),
        Key::new("names", "names", "What features are called in all output, by what is printed without a name: { \"line 3 of loop 0\" = \"tip\" }."),
        Key::new("motion", "motion", "How the part moves relative to the ground. Default: { type = \"planar\" }, freely."),
        Key::new("symmetry", "count", "How many times a turn about its own centre maps the outline to itself. Found anyway; refused when it is not true."),
        Key::new("offset", "number", "How far the outline is moved out of the material, all around; below 0 into it. Default: 0."),
        Key::new("split", "bool", "Whether the offset may divide the part. Default: false."),
        Key::new("profile", "profiles", "How far the outline may be off along its normals, either way (a number is a tolerance, an expression a deviation); or edges by their names."),
        Key::new("mass", "positive", "The mass in kg. Default: none; the part has no inertia."),
        Key::new("density", "positive", "The mass per area, kg/unit², in place of `mass`."),
        Key::new("inertia", "positive", "The moment of inertia about the centre of mass, kg·unit². Default: from the outline."),
        Key::new("center_of_mass", "point", "In the part's frame. Default: the centroid of the outline."),
        Key::new("start", "start", "Where the part is at the start: [x, y, theta], or one number for a part that turns or slides. Default: at zero motion."),
        Key::new("rate", "rate", "How fast the part moves at the start, per second: [vx, vy, omega], or one number for a part that turns or slides. Default: it rests."),
];

pub(super) const PART: Keys = Keys::new(
    "a part is a table with keys such as name = \"pawl\" and loops = [ [[x, y, bulge], [x, y], ...], ... ]",
    &joined::<{ OF_PART - OF_OUTLINE }, OF_OUTLINE, OF_PART>(PART_KEYS, OUTLINE_KEYS),
);

/// A layer of a part: an outline with its heights.
pub(super) const LAYER: Keys = Keys::new(LAYERS, &OUTLINE_KEYS);

#[rustfmt::skip]
pub(super) const MOTION: Keys = Keys {
    kinds: Some(Kinds {
        what: "type of motion",
        key: "type",
        default: None,
        all: &[
            Kind { name: "planar", needs: &[], takes: &[] },
            Kind { name: "fixed", needs: &[], takes: &[] },
            Kind { name: "revolute", needs: &["center"], takes: &["range"] },
            Kind { name: "prismatic", needs: &["direction"], takes: &["range"] },
        ],
    }),
    ..Keys::new(
        "give it as motion = { type = \"planar\" }",
        &[
            Key::new("type", "kind", "planar: moves and turns freely. fixed: stands still. revolute: turns about a point. prismatic: slides in a direction.").needed("type = \"revolute\""),
            Key::new("center", "point", "Of a revolute motion: the point about which the part turns.").like("center = [0, 0]"),
            Key::new("direction", "point", "Of a prismatic motion: its direction. The length does not count, but may not be 0.").like("direction = [1, 0]"),
            Key::new("range", "two_numbers", "The smaller and the larger limit: angles of a revolute motion, lengths of a prismatic one. Default: no limits."),
        ],
    )
};

pub(super) fn read_parts(root: &Table<'_>, setting: &mut Setting<'_>) -> Result<Vec<PartEntry>> {
    let mut names: HashMap<String, usize> = HashMap::new();
    each_part(root, |i, table| {
        let part = read_part(table, setting)?;
        match names.insert(part.part.name().to_owned(), i) {
            Some(first) => {
                let message = format!("the name is already that of part {first}");
                Err((table.error("name", message)).with_help("give every part a name of its own"))
            }
            None => Ok(part),
        }
    })
}

/// The tables of the parts, read one by one by their numbers.
pub(super) fn each_part<T>(
    root: &Table<'_>,
    mut read: impl FnMut(usize, &Table<'_>) -> Result<T>,
) -> Result<Vec<T>> {
    root.each("part", |i, mut value| {
        if let Some(name) = value.text_of("name") {
            value = value.called(format!("part {i} {}", quoted(name)));
        }
        read(i, &Table::new(value, &PART)?)
    })
}

fn read_part(table: &Table<'_>, setting: &mut Setting<'_>) -> Result<PartEntry> {
    let name = table.needed("name", table.text("name")?)?;
    if name.trim().is_empty() {
        let error = table.error("name", "the name is empty");
        return Err(error.with_help("give every part a name, such as name = \"pawl\""));
    }
    let mut part = match table.get("layers") {
        Some(layers) => at_place(table, read_layers(table, name, &layers, setting)?)?,
        None => read_layer(table, name, setting)?,
    };
    part = at_offset(table, part, setting)?;
    if let Some(names) = table.get("names") {
        part = with_names(part, &names)?;
    }
    if let Some(profile) = table.get("profile") {
        part = at_profile(part, &profile)?;
    }
    let axis =
        (table.get("motion")).map_or(Ok(None), |motion| read_motion(motion.further("motion")))?;
    let entry = PartEntry {
        part,
        axis,
        symmetry: table.count("symmetry")?,
        members: Vec::new(),
    };
    check_symmetry(table, &entry)?;
    Ok(entry)
}

/// The part of one outline, at its heights.
fn read_layer(table: &Table<'_>, name: &str, setting: &mut Setting<'_>) -> Result<Part> {
    let part = match (source(table)?, table.get("union")) {
        (Some(key), _) => read_drawing(table, name, key, setting)?,
        (None, Some(union)) => Entries::read(&union)?.part(name)?,
        (None, None) => {
            let loops = table.nodes("loops", &format!("give it as {LOOPS}"))?;
            let loops = table.needed("loops", loops)?;
            read_outline(name, &table.place.key("loops"), loops, table.scope)?
        }
    };
    let part = at_place(table, part)?;
    let Some((lo, hi)) = table.interval("z", false)? else {
        return Ok(part);
    };
    let layers = (part.layers().iter()).map(|layer| (Some([lo, hi]), part.outline(layer)));
    Part::layered(name, layers).map_err(|e| no_part(&table.place.key("z"), e))
}

/// The part whose layers these are.
fn read_layers(
    table: &Table<'_>,
    name: &str,
    layers: &Value<'_>,
    setting: &mut Setting<'_>,
) -> Result<Part> {
    let beside = OUTLINE_KEYS.iter().map(|key| key.name);
    if let Some(key) = { beside }.find(|key| *key != "place" && table.has(key)) {
        let error = table.error_at_key(key, format!("`{key}` is given beside `layers`"));
        return Err(error.with_help(format!(
            "a part has one outline or layers: move `{key}` into a layer, or remove it"
        )));
    }
    let items = layers.items().filter(|items| !items.is_empty());
    let Some(items) = items else {
        let found = layers.node.describe();
        let error = layers.error(format!("{found} where a list of layers is expected"));
        return Err(error.with_help(format!("give it as {LAYERS}")));
    };
    let mut stack = Vec::with_capacity(items.len());
    for (i, item) in items.into_iter().enumerate() {
        let layer = Table::new(item.further(&format!("layer {i}")), &LAYER)?;
        let part = read_layer(&layer, name, setting)?;
        let layers = part.layers().iter();
        stack.extend(layers.map(|l| (l.z(), part.outline(l))));
    }
    Part::layered(name, stack).map_err(|e| no_part(&table.place.key("layers"), e))
}

/// Part at the distance given in the table. Changes of its topology are noted.
fn at_offset(table: &Table<'_>, part: Part, setting: &mut Setting<'_>) -> Result<Part> {
    let split = table.flag("split")?;
    let Some(by) = table.number("offset")? else {
        if split {
            let error = table.error("split", "`split` is given without an offset");
            return Err(error.with_help("it allows that an `offset` divides the part: remove it"));
        }
        return Ok(part);
    };
    let wrong = || table.error("offset", "nothing of the part is left");
    let mut notes = Vec::new();
    let off = part.by_layers(|layer| {
        let made = cspace_drawing::offset(layer, by, split).map_err(Unmade::Offset)?;
        notes.extend(made.changes);
        let layers = made.part.layers().iter();
        Ok(layers.flat_map(|l| made.part.outline(l)).collect())
    });
    let off = off.map_err(|e| match e {
        Unmade::Offset(e) => table.error("offset", e.to_string()).with_help(e.help()),
        Unmade::Part(e) => no_part(&table.place.key("offset"), e),
    })?;
    for change in notes {
        let note = format!("with the offset, {change}");
        setting.notes.push(table.error("offset", note));
    }
    off.ok_or_else(wrong)
}

/// Why there is no part at a distance.
enum Unmade {
    Offset(OffsetError),
    Part(PartError),
}

impl From<PartError> for Unmade {
    fn from(error: PartError) -> Self {
        Self::Part(error)
    }
}

/// Checks a declared symmetry: symmetry is found from the outline anyway, and a declaration must not contradict it.
fn check_symmetry(table: &Table<'_>, entry: &PartEntry) -> Result<()> {
    let Err(MechanismError::Symmetry {
        declared, largest, ..
    }) = entry.check(0)
    else {
        return Ok(());
    };
    let message = format!(
        "part {} is not {declared}-fold symmetric: turning it by 360/{declared} degrees about its centre does not map its outline to itself",
        quoted(entry.part.name())
    );
    let error = table.error("symmetry", message);
    Err(error.with_help(match largest {
        1 => "it has no rotational symmetry: remove `symmetry`".to_owned(),
        largest => format!(
            "the largest is {largest}-fold: give symmetry = {largest}, or remove it, for it is found anyway"
        ),
    }))
}

/// The axis of a motion; none of a part that moves freely.
fn read_motion(motion: Value<'_>) -> Result<Option<Axis>> {
    let table = Table::new(motion, &MOTION)?;
    let kind = table.kind()?;
    table.only_of(kind, "motion")?;
    let axis = match kind.name {
        "fixed" => Axis::FIXED,
        "planar" => return Ok(None),
        "revolute" => Axis::revolute(table.needed("center", table.point("center")?)?),
        _ => Axis::prismatic(direction(&table)?),
    };
    let range = table.interval("range", kind.name == "revolute")?;
    Ok(Some(Axis { range, ..axis }))
}

/// A direction, which must have a length.
pub(super) fn direction(table: &Table<'_>) -> Result<Vector> {
    let Point { x, y } = table.needed("direction", table.point("direction")?)?;
    if x == 0.0 && y == 0.0 {
        return Err(table
            .error("direction", "the direction is zero")
            .with_help("give a vector with a length, such as direction = [1, 0]"));
    }
    // A vector that is too short to differ from zero, or too long to be measured, is no direction either.
    let direction = Vector::new(x, y);
    let length = direction.unit().length();
    if !(0.5..2.0).contains(&length) {
        return Err(table
            .error(
                "direction",
                "the direction has no length that can be computed with",
            )
            .with_help("give a vector of ordinary length, such as direction = [1, 0]"));
    }
    Ok(direction)
}
