//! Joints and pairs from a file's tree of values.

use cspace::Point;

use super::error::ModelError;
use super::mechanism::{Joint, JointKind, Pair, PartEntry};
use super::node::{Node, quoted};
use super::parts::direction;
use super::suggest::nearest;
use super::table::{Result, Table};

/// The index of a part by its name.
fn part_index(place: &str, name: &str, parts: &[PartEntry]) -> Result<usize> {
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

pub(super) fn read_joints(nodes: &[Node], parts: &[PartEntry]) -> Result<Vec<Joint>> {
    nodes
        .iter()
        .enumerate()
        .map(|(i, n)| read_joint(i, n, parts))
        .collect()
}

fn read_joint(index: usize, node: &Node, parts: &[PartEntry]) -> Result<Joint> {
    const KINDS: [&str; 3] = ["revolute", "prismatic", "rigid"];
    let place = format!("joint {index}");
    let table = Table::new(node, &place, &["type", "parts", "at", "direction"])?;
    let names = table
        .list("parts")?
        .ok_or_else(|| table.missing("parts", "parts = [\"link\", \"pawl\"]"))?;
    let [Node::Text(first), Node::Text(second)] = names else {
        return Err(ModelError::new(place, "`parts` is not a list of two names")
            .with_help("a joint connects two parts: parts = [\"link\", \"pawl\"]"));
    };
    let (a, b) = (
        part_index(&place, first, parts)?,
        part_index(&place, second, parts)?,
    );
    if a == b {
        return Err(
            ModelError::new(place, format!("it joins {} to itself", quoted(first)))
                .with_help("a joint connects two different parts"),
        );
    }
    let at = table.point("at")?.map(|(x, y)| Point::new(x, y));
    let kind = match table
        .text("type")?
        .ok_or_else(|| table.missing("type", "type = \"revolute\""))?
    {
        "revolute" => JointKind::Revolute {
            at: at.ok_or_else(|| table.missing("at", "at = [x, y]"))?,
        },
        "prismatic" => JointKind::Prismatic {
            direction: direction(&table)?,
            at,
        },
        "rigid" => JointKind::Rigid,
        other => {
            let error = ModelError::new(place, format!("unknown type of joint {}", quoted(other)));
            return Err(error.with_help(match nearest(other, KINDS) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => "the types are revolute, prismatic and rigid".to_owned(),
            }));
        }
    };
    Ok(Joint {
        kind,
        parts: (a, b),
    })
}

pub(super) fn read_pairs(nodes: &[Node], parts: &[PartEntry]) -> Result<Vec<Pair>> {
    let mut pairs: Vec<Pair> = Vec::new();
    for (i, node) in nodes.iter().enumerate() {
        let place = format!("pair {i}");
        let table = Table::new(node, &place, &["fixed", "moving", "theta"])?;
        let side = |key: &str| {
            let name = table
                .text(key)?
                .ok_or_else(|| table.missing(key, &format!("{key} = \"ratchet\"")))?;
            part_index(&place, name, parts)
        };
        let (fixed, moving) = (side("fixed")?, side("moving")?);
        if fixed == moving {
            return Err(ModelError::new(place, "a part is paired with itself")
                .with_help("name two different parts"));
        }
        let same = |p: &Pair| {
            (p.fixed, p.moving) == (fixed, moving) || (p.fixed, p.moving) == (moving, fixed)
        };
        if let Some(first) = pairs.iter().position(same) {
            return Err(
                ModelError::new(place, format!("it is the same pair as pair {first}"))
                    .with_help("list every pair once"),
            );
        }
        let window = table.interval("theta", true)?;
        if let Some((lo, hi)) = window
            && hi - lo > core::f64::consts::TAU * (1.0 + 1e-12)
        {
            return Err(ModelError::new(
                place,
                format!(
                    "the window `theta` is {} radians, more than a turn",
                    hi - lo
                ),
            )
            .with_help("leave `theta` out for all orientations"));
        }
        pairs.push(Pair {
            fixed,
            moving,
            window,
        });
    }
    Ok(pairs)
}
