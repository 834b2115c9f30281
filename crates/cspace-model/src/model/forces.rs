//! Drives, loads and springs from a file's tree of values.

use cspace::{Axis, AxisMotion, Point, Vector};

use super::error::ModelError;
use super::measure::{Measure, read_list};
use super::node::Node;
use super::parts::kind_of;
use super::place::Place;
use super::relations::part_index;
use super::suggest::nearest;
use super::table::{Result, Table};
use crate::mechanism::{
    Drive, DriveMotion, DynamicsFault, Load, LoadKind, PartEntry, Spring, SpringKind,
};
use crate::shown::quoted;

/// The tables of a list, each called by its number, read one by one.
fn each<T>(
    place: &Place,
    nodes: &[Node],
    what: &str,
    read: impl Fn(Place, &Node) -> Result<T>,
) -> Result<Vec<T>> {
    (nodes.iter().enumerate())
        .map(|(i, node)| read(place.item(i).called(format!("{what} {i}")), node))
        .collect()
}

/// The part that the key `part` names.
fn part_of(table: &Table<'_>, parts: &[PartEntry]) -> Result<usize> {
    let name = table
        .text("part")?
        .ok_or_else(|| table.missing("part", "part = \"pawl\""))?;
    part_index(&table.place.key("part"), name, parts)
}

pub(super) fn read_drives(
    place: &Place,
    nodes: &[Node],
    parts: &[PartEntry],
) -> Result<Vec<Drive>> {
    const HELP: &str = "a drive is a table with part = \"driver\" and rate = \"360deg\"";
    each(place, nodes, "drive", |place, node| {
        let table = Table::new(node, place, &["part", "rate", "table"], HELP)?;
        let part = part_of(&table, parts)?;
        let axis = drivable(&table, &parts[part])?;
        let measure = Measure::along(&axis);
        let motion = match (table.get("rate"), table.get("table")) {
            (Some(_), Some(_)) => {
                let error = table.error("table", "`rate` and `table` are both given");
                return Err(error.with_help("keep one: a table says the rate, too"));
            }
            (Some(node), None) => {
                let rate = measure
                    .rate()
                    .read(&table.place.key("rate"), "rate", node)?;
                DriveMotion::Rate(rate)
            }
            (None, Some(_)) => DriveMotion::Table(points(&table, measure)?),
            (None, None) => {
                return Err(table.missing("rate", "rate = \"360deg\" or table = [[0, 0], [1, 2]]"));
            }
        };
        Ok(Drive { part, motion })
    })
}

/// The axis of a part that can be driven.
fn drivable(table: &Table<'_>, entry: &PartEntry) -> Result<Axis> {
    let fault = match entry.axis {
        None => DynamicsFault::MovesFreely,
        Some(_) => DynamicsFault::StandsStill,
    };
    let moving = entry.axis.filter(|x| x.motion != AxisMotion::Fixed);
    moving.ok_or_else(|| {
        let message = format!("{}: {fault}", quoted(entry.part.name()));
        table.error("part", message).with_help(fault.help())
    })
}

/// The points (t, u) of a drive's table.
fn points(table: &Table<'_>, measure: Measure) -> Result<Vec<(f64, f64)>> {
    const HELP: &str =
        "give it as table = [[t, u], [t, u], ...]: times in seconds and where the part is";
    let nodes = table.list("table", HELP)?.unwrap_or_default();
    let place = table.place.key("table");
    (nodes.iter().enumerate())
        .map(|(i, node)| {
            let place = place.item(i);
            let measures = [Measure::Number, measure];
            read_list(&place, "table", node, measures, HELP).map(|[t, u]| (t, u))
        })
        .collect()
}

pub(super) fn read_loads(place: &Place, nodes: &[Node], parts: &[PartEntry]) -> Result<Vec<Load>> {
    const HELP: &str =
        "a load is a table with part = \"pawl\" and force = [0, -3], or torque = 0.5";
    each(place, nodes, "load", |place, node| {
        let table = Table::new(node, place, &["part", "force", "at", "torque"], HELP)?;
        let part = part_of(&table, parts)?;
        let at = table.point("at")?.map(|(x, y)| Point::new(x, y));
        let kind = match (table.point("force")?, table.number("torque")?) {
            (Some(_), Some(_)) => {
                let error = table.error("torque", "`force` and `torque` are both given");
                return Err(error.with_help("make two loads of them"));
            }
            (Some((x, y)), None) => LoadKind::Force {
                force: Vector::new(x, y),
                at,
            },
            (None, Some(_)) if at.is_some() => {
                let error = table.error("at", "a torque has no point at which it acts");
                return Err(error.with_help("leave out `at`, or give a force"));
            }
            (None, Some(torque)) => LoadKind::Torque(torque),
            (None, None) => {
                return Err(table.missing("force", "force = [0, -3], or torque = 0.5"));
            }
        };
        Ok(Load { part, kind })
    })
}

pub(super) fn read_springs(
    place: &Place,
    nodes: &[Node],
    parts: &[PartEntry],
) -> Result<Vec<Spring>> {
    const HELP: &str = "a spring is a table with parts = [\"pawl\", \"link\"], at = [[x, y], [x, y]] and stiffness = 2.5";
    const OTHERS: [&str; 3] = ["at", "length", "angle"];
    const LINEAR: [&str; 6] = ["type", "parts", "at", "stiffness", "length", "damping"];
    const TORSION: [&str; 5] = ["type", "parts", "stiffness", "angle", "damping"];
    each(place, nodes, "spring", |place, node| {
        let keys: &[&str] = match kind_of(node) {
            Some("torsion") => &TORSION,
            _ => &LINEAR,
        };
        let table = Table::with_others(node, place.clone(), keys, &OTHERS, HELP)?;
        let (part, other) = ends(&table, parts)?;
        let kind = table.text("type")?.unwrap_or("linear");
        // A key that a spring of this type does not use would be taken for a statement about it.
        let only = |keys: &[&str]| {
            let help = format!("a {kind} spring has the keys {}", keys.join(", "));
            Table::new(node, place.clone(), keys, &help).map_err(|e| e.with_help(help.as_str()))
        };
        let (stiffness, damping) = (table.number("stiffness")?, table.number("damping")?);
        if stiffness.is_none() && damping.is_none() {
            return Err(table.missing("stiffness", "stiffness = 2.5"));
        }
        let (stiffness, damping) = (stiffness.unwrap_or(0.0), damping.unwrap_or(0.0));
        let kind = match kind {
            "linear" => {
                let table = only(&LINEAR)?;
                let at = two_points(&table)?;
                SpringKind::Linear {
                    at,
                    stiffness,
                    length: (table.number("length")?).unwrap_or_else(|| at.0.distance(at.1)),
                    damping,
                }
            }
            "torsion" => {
                let table = only(&TORSION)?;
                let place = table.place.key("angle");
                let angle = table
                    .get("angle")
                    .map_or(Ok(0.0), |node| Measure::Angle.read(&place, "angle", node))?;
                SpringKind::Torsion {
                    stiffness,
                    angle,
                    damping,
                }
            }
            other => {
                let error =
                    table.error("type", format!("unknown type of spring {}", quoted(other)));
                return Err(
                    error.with_help(match nearest(other, ["linear", "torsion"]) {
                        Some(meant) => format!("did you mean `{meant}`?"),
                        None => "the types are linear, the default, and torsion".to_owned(),
                    }),
                );
            }
        };
        Ok(Spring { part, other, kind })
    })
}

/// The part, or two parts, that a spring is between.
fn ends(table: &Table<'_>, parts: &[PartEntry]) -> Result<(usize, Option<usize>)> {
    const HELP: &str = "name two parts, parts = [\"pawl\", \"link\"], or one for a spring to the ground, parts = [\"pawl\"]";
    let names = table
        .list("parts", HELP)?
        .ok_or_else(|| table.missing("parts", "parts = [\"pawl\", \"link\"]"))?;
    let place = table.place.key("parts");
    let index = |i: usize, name: &str| part_index(&place.item(i), name, parts);
    match names {
        [Node::Text(one)] => Ok((index(0, one)?, None)),
        [Node::Text(one), Node::Text(two)] => Ok((index(0, one)?, Some(index(1, two)?))),
        _ => {
            let error = table.error("parts", "`parts` is not a list of one or two names");
            Err(error.with_help(HELP))
        }
    }
}

/// The two points that a spring is between.
fn two_points(table: &Table<'_>) -> Result<(Point, Point)> {
    const HELP: &str = "give two points, at = [[x, y], [x, y]]: each in its part's frame, one of the ground in the assembly's";
    const BOTH: [Measure; 2] = [Measure::Number; 2];
    let nodes = table
        .list("at", HELP)?
        .ok_or_else(|| table.missing("at", "at = [[x, y], [x, y]]"))?;
    let place = table.place.key("at");
    let [first, second] = nodes else {
        let found = match nodes.len() {
            1 => "one point".to_owned(),
            n => format!("{n} points"),
        };
        let message = format!("`at` has {found}: a spring is between two points");
        return Err(ModelError::new(&place, message).with_help(HELP));
    };
    let point = |i: usize, node: &Node| {
        read_list(&place.item(i), "at", node, BOTH, HELP).map(|[x, y]| Point::new(x, y))
    };
    Ok((point(0, first)?, point(1, second)?))
}
