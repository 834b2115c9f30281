//! Joints and pairs from a file's tree of values.

use std::collections::HashMap;

use cspace::Point;
use cspace::pair::Joint;

use super::error::ModelError;
use super::keys::{Key, Keys, Kind, Kinds};
use super::node::Node;
use super::parts::direction;
use super::place::Place;
use super::scope::Result;
use super::suggest::did_you_mean;
use super::table::Table;
use super::value::Value;
use crate::mechanism::{JointEntry, MechanismError, PairEntry, PairSurface, PartEntry};
use crate::shown::quoted;

/// The type of joint that makes one body of parts.
const RIGID: &str = "rigid";

#[rustfmt::skip]
pub(super) const JOINT: Keys = Keys {
    kinds: Some(Kinds {
        what: "type of joint",
        key: "type",
        default: None,
        all: &[
            Kind { name: "revolute", needs: &["at"], takes: &[] },
            Kind { name: "prismatic", needs: &["direction"], takes: &["at"] },
            Kind { name: RIGID, needs: &[], takes: &[] },
        ],
    }),
    ..Keys::new(
        "a joint is a table with type = \"revolute\", parts = [\"link\", \"pawl\"] and at = [x, y]",
        &[
            Key::new("type", "kind", "revolute: a hinge. prismatic: a slide. rigid: the parts are one body, called `a + b`.").needed("type = \"revolute\""),
            Key::new("parts", "two_names", "The names of the two parts.").needed("parts = [\"link\", \"pawl\"]"),
            Key::new("at", "point", "Where the hinge is, or a point of the slide, at zero motion. Default for a slide: [0, 0].").like("at = [x, y]"),
            Key::new("direction", "point", "The direction of the slide, at zero motion.").like("direction = [1, 0]"),
        ],
    )
};

#[rustfmt::skip]
pub(super) const PAIR: Keys = Keys::new(
    "a pair is a table with fixed = \"ratchet\" and moving = \"pawl\"",
    &[
        Key::new("fixed", "part_name", "The part in whose frame the other moves.").needed("fixed = \"ratchet\""),
        Key::new("moving", "part_name", "The part that moves.").needed("moving = \"pawl\""),
        Key::new("theta", "angles", "The window of orientations, at most a turn. Default: all."),
        Key::new("friction", "not_negative", "The coefficient of friction. Default: that of all pairs."),
        Key::new("restitution", "up_to_one", "The coefficient of restitution, from 0 to 1. Default: that of all pairs."),
    ],
);

/// The index of the part that the text at a place names.
pub(super) fn part_index(place: &Place, name: &str, parts: &[PartEntry]) -> Result<usize> {
    parts.iter().position(|p| p.is_called(name)).ok_or_else(|| {
        let names = || {
            let single = parts.iter().filter(|p| p.members.is_empty());
            let members = parts.iter().flat_map(|p| &p.members);
            let members = members.map(|m| m.name.as_str());
            single.map(|p| p.part.name()).chain(members)
        };
        let error = ModelError::new(place, format!("there is no part named {}", quoted(name)));
        let all = || format!("the parts are {}", names().collect::<Vec<_>>().join(", "));
        error.with_help(did_you_mean(name, names(), all))
    })
}

pub(super) fn read_joints(root: &Table<'_>, parts: &[PartEntry]) -> Result<Vec<JointEntry>> {
    let mut joints: Vec<JointEntry> = Vec::new();
    // The joint of a file that each of them is.
    let mut numbers: Vec<usize> = Vec::new();
    root.each("joint", |i, value| {
        if value.text_of("type") == Some(RIGID) {
            return Ok(());
        }
        let place = value.place.clone();
        let joint = read_joint(value, parts)?;
        (joint.check(i, &joints, parts)).map_err(|e| no_joint(&place, &e, parts, &numbers))?;
        joints.push(joint);
        numbers.push(i);
        Ok(())
    })?;
    Ok(joints)
}

/// A rigid joint of two parts of the file.
pub(super) struct Weld {
    pub(super) parts: [usize; 2],
    pub(super) place: Place,
}

/// The rigid joints, between the parts of the file.
pub(super) fn read_welds(root: &Table<'_>, parts: &[PartEntry]) -> Result<Vec<Weld>> {
    let welds = root.each("joint", |_, value| {
        if value.text_of("type") != Some(RIGID) {
            return Ok(None);
        }
        let table = Table::new(value, &JOINT)?;
        let two = two_of(&table, parts)?;
        table.only_of(table.kind()?, "joint")?;
        Ok(Some(Weld {
            parts: two.into(),
            place: table.place,
        }))
    })?;
    Ok(welds.into_iter().flatten().collect())
}

/// Error for an invalid joint, in the words of the file.
fn no_joint(
    place: &Place,
    error: &MechanismError,
    parts: &[PartEntry],
    numbers: &[usize],
) -> ModelError {
    match *error {
        MechanismError::JoinedTwice { first, .. } => {
            let message = format!("it joins the same parts as joint {}", numbers[first]);
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

/// The two parts that a joint names.
fn two_of(table: &Table<'_>, parts: &[PartEntry]) -> Result<(usize, usize)> {
    const PARTS: &str = "a joint connects two parts: parts = [\"link\", \"pawl\"]";
    let names = table.needed("parts", table.nodes("parts", PARTS)?)?;
    let [Node::Text(first), Node::Text(second)] = names else {
        let error = table.error("parts", "`parts` is not a list of two names");
        return Err(error.with_help(PARTS));
    };
    let list = table.place.key("parts");
    let (a, b) = (
        part_index(&list.item(0), first, parts)?,
        part_index(&list.item(1), second, parts)?,
    );
    if a == b && first != second {
        let error = table.error("parts", of_one_body(first, second));
        return Err(error.with_help("remove this joint, or a rigid one between them"));
    }
    if a == b {
        let error = table.error("parts", format!("it joins {} to itself", quoted(first)));
        return Err(error.with_help("a joint connects two different parts"));
    }
    Ok((a, b))
}

/// Message about two names of one body where two parts are expected.
fn of_one_body(first: &str, second: &str) -> String {
    let [a, b] = [first, second].map(quoted);
    format!("{a} and {b} are joined rigidly and are one body")
}

fn read_joint(value: Value<'_>, parts: &[PartEntry]) -> Result<JointEntry> {
    let table = Table::new(value, &JOINT)?;
    let parts = two_of(&table, parts)?;
    let kind = table.kind()?;
    table.only_of(kind, "joint")?;
    let at = table.point("at")?;
    let joint = match kind.name {
        "revolute" => Joint::Revolute {
            at: table.needed("at", at)?,
        },
        _ => Joint::Prismatic {
            direction: direction(&table)?,
            at: at.unwrap_or(Point::ORIGIN),
        },
    };
    Ok(JointEntry { joint, parts })
}

/// The pairs, and what is said of the surfaces of some.
pub(super) fn read_pairs(
    root: &Table<'_>,
    parts: &[PartEntry],
) -> Result<(Vec<PairEntry>, Vec<PairSurface>)> {
    let mut surfaces: Vec<PairSurface> = Vec::new();
    let mut known: HashMap<(usize, usize), usize> = HashMap::new();
    let pairs = root.each("pair", |i, value| {
        let table = Table::new(value, &PAIR)?;
        let side = |key: &str| {
            let name = table.needed(key, table.text(key)?)?;
            part_index(&table.place.key(key), name, parts)
        };
        let (fixed, moving) = (side("fixed")?, side("moving")?);
        let [first, second] = ["fixed", "moving"].map(|key| table.text(key).ok().flatten());
        if fixed == moving
            && let (Some(first), Some(second)) = (first, second)
            && first != second
        {
            let error = table.error("moving", of_one_body(first, second));
            return Err(error.with_help("remove this pair: parts of one body never meet"));
        }
        if fixed == moving {
            let error = table.error("moving", "a part is paired with itself");
            return Err(error.with_help("name two different parts"));
        }
        if let Some(first) = known.insert((fixed.min(moving), fixed.max(moving)), i) {
            let message = format!("it is the same pair as pair {first}");
            let is_body = [fixed, moving]
                .iter()
                .any(|&i| !parts[i].members.is_empty());
            let help = match is_body {
                true => {
                    "list every pair once: parts that are joined rigidly are one part of a pair"
                }
                false => "list every pair once",
            };
            return Err(ModelError::new(&table.place, message).with_help(help));
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
        let surface = PairSurface {
            parts: (fixed, moving),
            friction: table.number("friction")?,
            restitution: table.number("restitution")?,
        };
        if surface.friction.is_some() || surface.restitution.is_some() {
            surfaces.push(surface);
        }
        Ok(PairEntry {
            fixed,
            moving,
            window,
        })
    })?;
    Ok((pairs, surfaces))
}
