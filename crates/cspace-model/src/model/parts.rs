//! Parts from a file's tree of values.

use std::collections::HashMap;

use cspace::{Axis, Part, Point, Vector};

use super::drawings::{Setting, read_drawing, source};
use super::error::ModelError;
use super::names::with_names;
use super::node::Node;
use super::outline::read_outline;
use super::part_dynamics::{self, read_part_dynamics};
use super::place::Place;
use super::profile::{self, at_profile};
use super::suggest::nearest;
use super::table::{Result, Table};
use crate::mechanism::{MechanismError, PartDynamics, PartEntry};
use crate::shown::quoted;

/// Help text on how outlines are written.
const LOOPS: &str = "loops = [ [[x, y, bulge], [x, y], ...], ... ]";

pub(super) fn read_parts(
    place: &Place,
    nodes: &[Node],
    setting: &mut Setting<'_>,
) -> Result<(Vec<PartEntry>, Vec<PartDynamics>)> {
    let mut parts: Vec<PartEntry> = Vec::new();
    let mut dynamics: Vec<PartDynamics> = Vec::new();
    let mut names: HashMap<String, usize> = HashMap::new();
    for (i, node) in nodes.iter().enumerate() {
        let words = match name_of(node) {
            Some(name) => format!("part {i} {}", quoted(name)),
            None => format!("part {i}"),
        };
        let place = place.item(i).called(words);
        let (entry, moves) = read_part(&place, node, setting)?;
        if let Some(first) = names.insert(entry.part.name().to_owned(), i) {
            let message = format!("the name is already that of part {first}");
            return Err(ModelError::new(&place.key("name"), message)
                .with_help("give every part a name of its own"));
        }
        parts.push(entry);
        dynamics.push(moves);
    }
    Ok((parts, dynamics))
}

/// The name of a part, before it is known to be one.
fn name_of(node: &Node) -> Option<&str> {
    match node {
        Node::Table(entries) => match entries.get("name") {
            Some(Node::Text(name)) => Some(name),
            _ => None,
        },
        _ => None,
    }
}

fn read_part(
    place: &Place,
    node: &Node,
    setting: &mut Setting<'_>,
) -> Result<(PartEntry, PartDynamics)> {
    const KEYS: [&str; 21] = [
        "name",
        "loops",
        "dxf",
        "svg",
        "points",
        "names",
        "motion",
        "symmetry",
        "layer",
        "id",
        "linetype",
        "color",
        "without_sheet",
        "hatches",
        "pick",
        "trace",
        "scale",
        "join",
        "offset",
        "split",
        profile::KEY,
    ];
    // It is too like others to be suggested.
    const OTHERS: [&str; 1] = ["fit"];
    let help = format!("a part is a table with keys such as name = \"pawl\" and {LOOPS}");
    let keys: Vec<&str> = (KEYS.iter().chain(&part_dynamics::KEYS).copied()).collect();
    let table = Table::with_others(node, place.clone(), &keys, &OTHERS, &help)?;
    let name = table
        .text("name")?
        .ok_or_else(|| table.missing("name", "name = \"pawl\""))?;
    if name.trim().is_empty() {
        let error = table.error("name", "the name is empty");
        return Err(error.with_help("give every part a name, such as name = \"pawl\""));
    }
    let mut part = match source(&table)? {
        Some(key) => read_drawing(&table, name, key, setting)?,
        None => {
            let help = format!("give it as {LOOPS}");
            let nodes = table
                .list("loops", &help)?
                .ok_or_else(|| table.missing("loops", LOOPS))?;
            read_outline(name, &place.key("loops"), nodes)?
        }
    };
    part = at_offset(&table, part, setting)?;
    if let Some(names) = table.get("names") {
        part = with_names(part, &place.key("names"), names)?;
    }
    if let Some(node) = table.get(profile::KEY) {
        part = at_profile(part, &place.key(profile::KEY), node)?;
    }
    let axis = match table.get("motion") {
        Some(m) => read_motion(place.key("motion").further("motion"), m)?,
        None => None,
    };
    let entry = PartEntry {
        part,
        axis,
        symmetry: table.count("symmetry")?,
    };
    check_symmetry(&table, &entry)?;
    let dynamics = read_part_dynamics(&table, axis)?;
    Ok((entry, dynamics))
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
    let made = cspace_drawing::offset(&part, by, split)
        .map_err(|e| table.error("offset", e.to_string()).with_help(e.help()))?;
    for change in made.changes {
        let note = format!("with the offset, {change}");
        setting.notes.push(table.error("offset", note));
    }
    Ok(made.part)
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
fn read_motion(place: Place, node: &Node) -> Result<Option<Axis>> {
    const KINDS: [&str; 4] = ["fixed", "revolute", "prismatic", "planar"];
    const HELP: &str = "give it as motion = { type = \"planar\" }";
    // Keys that belong to one type only are not suggested; the type refuses those of others.
    const OTHERS: [&str; 3] = ["center", "direction", "range"];
    let keys: &[&str] = match kind_of(node) {
        Some("revolute") => &["type", "center", "range"],
        Some("prismatic") => &["type", "direction", "range"],
        _ => &["type"],
    };
    let table = Table::with_others(node, place.clone(), keys, &OTHERS, HELP)?;
    let kind = table
        .text("type")?
        .ok_or_else(|| table.missing("type", "type = \"revolute\""))?;
    let only = |keys: &[&str]| Table::new(node, place.clone(), keys, HELP);
    match kind {
        "fixed" => only(&["type"]).map(|_| Some(Axis::FIXED)),
        "planar" => only(&["type"]).map(|_| None),
        "revolute" => {
            let table = only(&["type", "center", "range"])?;
            let (x, y) = table
                .point("center")?
                .ok_or_else(|| table.missing("center", "center = [0, 0]"))?;
            Ok(Some(Axis {
                range: table.interval("range", true)?,
                ..Axis::revolute(Point::new(x, y))
            }))
        }
        "prismatic" => {
            let table = only(&["type", "direction", "range"])?;
            Ok(Some(Axis {
                range: table.interval("range", false)?,
                ..Axis::prismatic(direction(&table)?)
            }))
        }
        other => {
            let error = table.error("type", format!("unknown type of motion {}", quoted(other)));
            Err(error.with_help(match nearest(other, KINDS) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => "the types are fixed, revolute, prismatic and planar".to_owned(),
            }))
        }
    }
}

/// The type that a table names, before it is known to be one.
pub(super) fn kind_of(node: &Node) -> Option<&str> {
    match node {
        Node::Table(entries) => match entries.get("type") {
            Some(Node::Text(kind)) => Some(kind),
            _ => None,
        },
        _ => None,
    }
}

/// A direction, which must have a length.
pub(super) fn direction(table: &Table<'_>) -> Result<Vector> {
    let (x, y) = table
        .point("direction")?
        .ok_or_else(|| table.missing("direction", "direction = [1, 0]"))?;
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
