//! Parts from a file's tree of values.

use cspace::{Part, Point, Vector, Vertex};

use super::error::ModelError;
use super::mechanism::{Motion, PartEntry};
use super::node::{Node, quoted};
use super::suggest::nearest;
use super::table::{Result, Table, number};

/// Words for a part of the file.
pub(super) fn part_place(index: usize, name: Option<&str>) -> String {
    match name {
        Some(name) => format!("part {index} {}", quoted(name)),
        None => format!("part {index}"),
    }
}

pub(super) fn read_parts(nodes: &[Node]) -> Result<Vec<PartEntry>> {
    let mut parts: Vec<PartEntry> = Vec::new();
    for (i, node) in nodes.iter().enumerate() {
        let entry = read_part(i, node)?;
        let name = entry.part.name();
        if let Some(first) = parts.iter().position(|p| p.part.name() == name) {
            return Err(ModelError::new(
                part_place(i, Some(name)),
                format!("the name is already that of part {first}"),
            )
            .with_help("give every part a name of its own"));
        }
        parts.push(entry);
    }
    Ok(parts)
}

fn read_part(index: usize, node: &Node) -> Result<PartEntry> {
    const KEYS: [&str; 7] = ["name", "loops", "dxf", "svg", "layer", "motion", "symmetry"];
    let known = match node {
        Node::Table(entries) => match entries.get("name") {
            Some(Node::Text(name)) => Some(&**name),
            _ => None,
        },
        _ => None,
    };
    let table = Table::new(node, part_place(index, known), &KEYS)?;
    let name = table
        .text("name")?
        .ok_or_else(|| table.missing("name", "name = \"pawl\""))?;
    if name.trim().is_empty() {
        return Err(
            ModelError::new(table.place, "the name is empty").with_help("give every part a name")
        );
    }
    for drawing in ["dxf", "svg"] {
        if table.get(drawing).is_some() {
            return Err(ModelError::new(
                table.place,
                format!("`{drawing}` is given, but drawings in DXF and SVG are not read yet"),
            )
            .with_help("give the outline as `loops = [ [[x, y, bulge], [x, y], ...], ... ]`"));
        }
    }
    let loops = table
        .list("loops")?
        .ok_or_else(|| table.missing("loops", "loops = [ [[x, y, bulge], [x, y], ...], ... ]"))?;
    let loops = loops
        .iter()
        .enumerate()
        .map(|(i, l)| read_loop(&table.place, i, l))
        .collect::<Result<Vec<_>>>()?;
    let part =
        Part::new(name, loops).map_err(|e| ModelError::new(table.place.clone(), e.to_string()))?;
    let motion = table.get("motion").map_or(Ok(Motion::default()), |m| {
        read_motion(&format!("{}, motion", table.place), m)
    })?;
    let symmetry = table.count("symmetry")?;
    Ok(PartEntry {
        part,
        motion,
        symmetry,
    })
}

fn read_loop(place: &str, index: usize, node: &Node) -> Result<Vec<Vertex>> {
    let Node::List(vertices) = node else {
        return Err(ModelError::new(
            format!("{place}, loop {index}"),
            format!("{} where a list of vertices is expected", node.describe()),
        ));
    };
    vertices
        .iter()
        .enumerate()
        .map(|(i, v)| read_vertex(place, index, i, v))
        .collect()
}

fn read_vertex(place: &str, loop_index: usize, index: usize, node: &Node) -> Result<Vertex> {
    let error = |message: String| {
        ModelError::new(
            format!("{place}, loop {loop_index}, vertex {index}"),
            message,
        )
        .with_help("a vertex is [x, y] or [x, y, bulge]")
    };
    let Node::List(numbers) = node else {
        return Err(error(format!(
            "{} where a vertex is expected",
            node.describe()
        )));
    };
    if !(2..=3).contains(&numbers.len()) {
        return Err(error(format!(
            "{} where a vertex is expected",
            node.describe()
        )));
    }
    let mut read = [0.0; 3];
    for (to, from) in read.iter_mut().zip(numbers) {
        *to = number(from)
            .ok_or_else(|| error(format!("{} where a number is expected", from.describe())))?;
    }
    if let Some(bad) = read.iter().find(|x| !x.is_finite()) {
        return Err(error(format!("{bad} is no finite number")));
    }
    Ok(Vertex::new(read[0], read[1], read[2]))
}

fn read_motion(place: &str, node: &Node) -> Result<Motion> {
    const KINDS: [&str; 4] = ["fixed", "revolute", "prismatic", "planar"];
    let table = Table::new(node, place, &["type", "center", "direction", "range"])?;
    let kind = table
        .text("type")?
        .ok_or_else(|| table.missing("type", "type = \"revolute\""))?;
    let only = |keys: &[&str]| Table::new(node, place, keys);
    match kind {
        "fixed" => only(&["type"]).map(|_| Motion::Fixed),
        "planar" => only(&["type"]).map(|_| Motion::Planar),
        "revolute" => {
            let table = only(&["type", "center", "range"])?;
            let (x, y) = table
                .point("center")?
                .ok_or_else(|| table.missing("center", "center = [0, 0]"))?;
            Ok(Motion::Revolute {
                center: Point::new(x, y),
                range: table.interval("range", true)?,
            })
        }
        "prismatic" => {
            let table = only(&["type", "direction", "range"])?;
            Ok(Motion::Prismatic {
                direction: direction(&table)?,
                range: table.interval("range", false)?,
            })
        }
        other => {
            let error = ModelError::new(place, format!("unknown type of motion {}", quoted(other)));
            Err(error.with_help(match nearest(other, KINDS) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => "the types are fixed, revolute, prismatic and planar".to_owned(),
            }))
        }
    }
}

/// A direction, which must have a length.
pub(super) fn direction(table: &Table<'_>) -> Result<Vector> {
    let (x, y) = table
        .point("direction")?
        .ok_or_else(|| table.missing("direction", "direction = [1, 0]"))?;
    if x == 0.0 && y == 0.0 {
        return Err(
            ModelError::new(table.place.clone(), "the direction is zero")
                .with_help("give a vector with a length"),
        );
    }
    Ok(Vector::new(x, y))
}
