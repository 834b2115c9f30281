//! Derivatives of a model's numbers by one of its parameters: dual numbers through expressions, patterns, arcs and fillets.

use std::collections::BTreeMap;

use cspace::{Dual, Mechanism, Vertex};

use super::error::ModelError;
use super::loops::read_loops;
use super::node::Node;
use super::place::Place;
use super::requirements::Coordinate;
use super::table::Result;

/// Derivatives of a model's numbers by one of its parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Slopes {
    /// Of each part, in the order of the model.
    pub parts: Vec<PartSlopes>,
    /// Of each requirement, by its name.
    pub requirements: BTreeMap<String, RequirementSlopes>,
}

/// Derivatives of the numbers of a part.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PartSlopes {
    /// Of every vertex of every loop: x, y and bulge. Empty of a part that does not depend on the parameter.
    pub loops: Vec<Vec<[f64; 3]>>,
    /// Of the centre or the direction of its axis, as it is given.
    pub axis: [f64; 2],
    /// Of the range of its motion.
    pub range: [f64; 2],
}

/// Derivatives of the configurations of a requirement: by x, y and θ, or by u and v.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RequirementSlopes {
    /// Of the configuration at which it is measured.
    pub at: [f64; 3],
    /// Of the displacement of a motion.
    pub along: [f64; 3],
}

/// The derivatives in a tree of which the numbers have them.
pub(super) fn slopes(tree: &Node, mechanism: &Mechanism) -> Result<Slopes> {
    let items = |key: &str| match entry(tree, key) {
        Some(Node::List(items)) => &items[..],
        _ => &[],
    };
    let place = Place::default().key("part");
    let parts = items("part").iter().enumerate().map(|(i, node)| {
        let name = mechanism.parts.get(i).map_or("", |p| p.part.name());
        let words = format!("part {}", crate::shown::quoted(name));
        part(&place.item(i).called(words), node)
    });
    Ok(Slopes {
        parts: parts.collect::<Result<_>>()?,
        requirements: items("requirement")
            .iter()
            .filter_map(requirement)
            .collect(),
    })
}

fn entry<'n>(node: &'n Node, key: &str) -> Option<&'n Node> {
    match node {
        Node::Table(entries) => entries.get(key),
        _ => None,
    }
}

/// Whether anything in a value depends on the parameter.
fn depends(node: &Node) -> bool {
    match node {
        Node::Varied(_) => true,
        Node::List(items) => items.iter().any(depends),
        Node::Table(entries) => entries.values().any(depends),
        _ => false,
    }
}

fn slope(node: &Node) -> f64 {
    match node {
        Node::Varied(x) => x.slope[0],
        _ => 0.0,
    }
}

fn part(place: &Place, node: &Node) -> Result<PartSlopes> {
    let mut slopes = PartSlopes::default();
    // Of what is offset or drawn elsewhere, only that it depends is known.
    for key in ["offset", "scale", "trace", "join"] {
        if entry(node, key).is_some_and(depends) {
            let message = format!("`{key}` depends on the parameter, and has no derivatives");
            return Err(ModelError::new(&place.key(key), message)
                .with_help("vary the parameter with `sweep` to see what it does"));
        }
    }
    if let Some(loops @ Node::List(items)) = entry(node, "loops")
        && depends(loops)
    {
        if entry(node, "offset").is_some() {
            let message = "the part has an offset, of which there are no derivatives";
            return Err(ModelError::new(&place.key("offset"), message)
                .with_help("vary the parameter with `sweep` to see what it does"));
        }
        let loops = place.key("loops");
        for (i, node) in items.iter().enumerate() {
            for drawn in read_loops::<Dual<1>>(&loops, i, node)? {
                let of = |v: &Vertex<Dual<1>>| [v.x, v.y, v.bulge].map(|x| x.slope[0]);
                slopes.loops.push(drawn.vertices.iter().map(of).collect());
            }
        }
    }
    let Some(motion) = entry(node, "motion") else {
        return Ok(slopes);
    };
    let pair = |key: &str| match entry(motion, key) {
        Some(Node::List(items)) if items.len() == 2 => Some([&items[0], &items[1]]),
        _ => None,
    };
    let axis = pair("center").or_else(|| pair("direction"));
    slopes.axis = axis.map_or([0.0; 2], |axis| axis.map(slope));
    slopes.range = pair("range").map_or([0.0; 2], |range| range.map(slope));
    Ok(slopes)
}

fn requirement(node: &Node) -> Option<(String, RequirementSlopes)> {
    let Some(Node::Text(name)) = entry(node, "name") else {
        return None;
    };
    let mut slopes = RequirementSlopes::default();
    let numbers = [
        Coordinate::X,
        Coordinate::Y,
        Coordinate::Theta,
        Coordinate::U,
        Coordinate::V,
    ];
    if let Some(at) = entry(node, "at") {
        for of in numbers {
            if let Some(value) = entry(at, of.name()) {
                slopes.at[of.index()] = slope(value);
            }
        }
    }
    if let Some(Node::List(along)) = entry(node, "along") {
        for (to, from) in slopes.along.iter_mut().zip(along) {
            *to = slope(from);
        }
    }
    Some((name.to_string(), slopes))
}
