//! Joints and pairs from a file's tree of values.

use std::collections::HashMap;

use cspace::Point;
use cspace::pair::Joint;

use super::error::ModelError;
use super::node::Node;
use super::parts::{direction, kind_of};
use super::place::Place;
use super::suggest::nearest;
use super::table::{Result, Table};
use crate::mechanism::{JointEntry, MechanismError, PairEntry, PairSurface, PartEntry};
use crate::shown::quoted;

/// The index of the part that the text at a place names.
pub(super) fn part_index(place: &Place, name: &str, parts: &[PartEntry]) -> Result<usize> {
    parts
        .iter()
        .position(|p| p.part.name() == name)
        .ok_or_else(|| {
            let names = || parts.iter().map(|p| p.part.name());
            let error = ModelError::new(place, format!("there is no part named {}", quoted(name)));
            error.with_help(match nearest(name, names()) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => format!("the parts are {}", names().collect::<Vec<_>>().join(", ")),
            })
        })
}

pub(super) fn read_joints(
    place: &Place,
    nodes: &[Node],
    parts: &[PartEntry],
) -> Result<Vec<JointEntry>> {
    let mut joints: Vec<JointEntry> = Vec::new();
    for (i, node) in nodes.iter().enumerate() {
        let place = place.item(i).called(format!("joint {i}"));
        let joint = read_joint(place.clone(), node, parts)?;
        (joint.check(i, &joints, parts)).map_err(|e| no_joint(&place, &e, parts))?;
        joints.push(joint);
    }
    Ok(joints)
}

/// Error for an invalid joint, in the words of the file.
fn no_joint(place: &Place, error: &MechanismError, parts: &[PartEntry]) -> ModelError {
    match *error {
        MechanismError::JoinedTwice { first, .. } => {
            let message = format!("it joins the same parts as joint {first}");
            ModelError::new(place, message)
                .with_help("two parts have one joint: keep one of the two")
        }
        MechanismError::Contradiction { part, .. } => {
            let name = quoted(parts[part].part.name());
            let message = format!("the joint does not let part {name} move as its `motion` says");
            ModelError::new(place, message).with_help(
                "the other part does not move: give both the same type and the same centre or direction, or leave out one of them",
            )
        }
        ref error => ModelError::new(place, error.to_string()),
    }
}

fn read_joint(place: Place, node: &Node, parts: &[PartEntry]) -> Result<JointEntry> {
    const OTHERS: [&str; 2] = ["at", "direction"];
    const KINDS: [&str; 3] = ["revolute", "prismatic", "rigid"];
    const HELP: &str =
        "a joint is a table with type = \"revolute\", parts = [\"link\", \"pawl\"] and at = [x, y]";
    const PARTS: &str = "a joint connects two parts: parts = [\"link\", \"pawl\"]";
    // Keys that belong to one type only are not suggested; the type refuses those of others.
    let keys: &[&str] = match kind_of(node) {
        Some("rigid") => &["type", "parts"],
        Some("prismatic") => &["type", "parts", "at", "direction"],
        _ => &["type", "parts", "at"],
    };
    let table = Table::with_others(node, place.clone(), keys, &OTHERS, HELP)?;
    let names = table
        .list("parts", PARTS)?
        .ok_or_else(|| table.missing("parts", "parts = [\"link\", \"pawl\"]"))?;
    let [Node::Text(first), Node::Text(second)] = names else {
        let error = table.error("parts", "`parts` is not a list of two names");
        return Err(error.with_help(PARTS));
    };
    let list = table.place.key("parts");
    let (a, b) = (
        part_index(&list.item(0), first, parts)?,
        part_index(&list.item(1), second, parts)?,
    );
    if a == b {
        let error = table.error("parts", format!("it joins {} to itself", quoted(first)));
        return Err(error.with_help("a joint connects two different parts"));
    }
    let kind = table
        .text("type")?
        .ok_or_else(|| table.missing("type", "type = \"revolute\""))?;
    // A key that a joint of this type does not use would be taken for a statement about it.
    let only = |keys: &[&str]| {
        let help = format!("a {kind} joint has the keys {}", keys.join(", "));
        Table::new(node, place.clone(), keys, &help).map_err(|e| e.with_help(help.as_str()))
    };
    let at = |table: &Table<'_>| {
        let point = table.point("at")?;
        Ok(point.map(|(x, y)| Point::new(x, y)))
    };
    let joint = match kind {
        "revolute" => {
            let table = only(&["type", "parts", "at"])?;
            Joint::Revolute {
                at: at(&table)?.ok_or_else(|| table.missing("at", "at = [x, y]"))?,
            }
        }
        "prismatic" => {
            let table = only(&["type", "parts", "direction", "at"])?;
            Joint::Prismatic {
                direction: direction(&table)?,
                at: at(&table)?.unwrap_or(Point::ORIGIN),
            }
        }
        "rigid" => only(&["type", "parts"]).map(|_| Joint::Rigid)?,
        other => {
            let error = table.error("type", format!("unknown type of joint {}", quoted(other)));
            return Err(error.with_help(match nearest(other, KINDS) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => "the types are revolute, prismatic and rigid".to_owned(),
            }));
        }
    };
    Ok(JointEntry {
        joint,
        parts: (a, b),
    })
}

pub(super) fn read_pairs(
    place: &Place,
    nodes: &[Node],
    parts: &[PartEntry],
) -> Result<(Vec<PairEntry>, Vec<PairSurface>)> {
    const KEYS: [&str; 5] = ["fixed", "moving", "theta", "friction", "restitution"];
    const HELP: &str = "a pair is a table with fixed = \"ratchet\" and moving = \"pawl\"";
    let mut pairs: Vec<PairEntry> = Vec::new();
    let mut surfaces: Vec<PairSurface> = Vec::new();
    let mut known: HashMap<(usize, usize), usize> = HashMap::new();
    for (i, node) in nodes.iter().enumerate() {
        let place = place.item(i).called(format!("pair {i}"));
        let table = Table::new(node, place, &KEYS, HELP)?;
        let side = |key: &str| {
            let name = table
                .text(key)?
                .ok_or_else(|| table.missing(key, &format!("{key} = \"ratchet\"")))?;
            part_index(&table.place.key(key), name, parts)
        };
        let (fixed, moving) = (side("fixed")?, side("moving")?);
        if fixed == moving {
            let error = table.error("moving", "a part is paired with itself");
            return Err(error.with_help("name two different parts"));
        }
        if let Some(first) = known.insert((fixed.min(moving), fixed.max(moving)), i) {
            let message = format!("it is the same pair as pair {first}");
            return Err(ModelError::new(&table.place, message).with_help("list every pair once"));
        }
        let window = table.interval("theta", true)?;
        if let Some((lo, hi)) = window
            && hi - lo > cspace::LONGEST_WINDOW
        {
            let message = format!(
                "the window `theta` is {} radians, more than a turn",
                hi - lo
            );
            let error = table.error("theta", message);
            return Err(error.with_help("leave `theta` out for all orientations"));
        }
        pairs.push(PairEntry {
            fixed,
            moving,
            window,
        });
        let surface = PairSurface {
            parts: (fixed, moving),
            friction: table.number("friction")?,
            restitution: table.number("restitution")?,
        };
        if surface.friction.is_some() || surface.restitution.is_some() {
            surfaces.push(surface);
        }
    }
    Ok((pairs, surfaces))
}
