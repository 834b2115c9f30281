//! Derivatives of a model's numbers by one of its parameters: dual numbers through expressions, patterns, arcs and fillets.

use std::collections::BTreeMap;

use cspace::{Ball, Dual, Part, Real, Vertex};

use super::error::ModelError;
use super::loops::read_loops;
use super::node::Node;
use super::place::Place;
use super::profile::{KEY, Profile};
use super::requirements::Coordinate;
use super::table::{Result, number};
use crate::mechanism::Mechanism;

/// Derivatives of a model's numbers by one of its parameters; or, of another type, enclosures of the numbers with theirs.
#[derive(Debug, Clone, PartialEq)]
pub struct Slopes<T = f64> {
    /// Derivatives for each part, in the order of the model.
    pub parts: Vec<PartSlopes<T>>,
    /// Derivatives for each requirement, by its name.
    pub requirements: BTreeMap<String, RequirementSlopes<T>>,
}

/// Derivatives of the numbers of a part.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PartSlopes<T = f64> {
    /// Derivatives of x, y and bulge of every vertex of every loop. Empty for a part whose outline does not depend on
    /// anything that varies.
    pub loops: Vec<Vec<[T; 3]>>,
    /// Derivatives of the centre or the direction of its axis, as it is given; `None` if it does not depend on anything
    /// that varies.
    pub axis: Option<[T; 2]>,
    /// Derivatives of the range of its motion; `None` if it does not depend on anything that varies.
    pub range: Option<[T; 2]>,
}

/// Derivatives of the configurations of a requirement: by x, y and θ, or by u and v. `None` of those that do not depend on anything that
/// varies.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RequirementSlopes<T = f64> {
    /// Derivatives of the configuration at which it is measured.
    pub at: [Option<T>; 3],
    /// Derivatives of the displacement of a motion.
    pub along: [Option<T>; 3],
}

/// A number with its derivative, and what encloses both.
type Given = Dual<1, Ball>;

/// Result type of the evaluation of a number that varies.
pub(super) trait Slope: Copy {
    fn of(number: Dual<1, Ball>) -> Self;
}

impl Slope for f64 {
    fn of(number: Dual<1, Ball>) -> Self {
        number.slope[0].mid
    }
}

impl Slope for Dual<1, Ball> {
    fn of(number: Self) -> Self {
        number
    }
}

/// Collects the derivatives from a tree whose numbers have them.
pub(super) fn slopes<T: Slope>(tree: &Node, mechanism: &Mechanism) -> Result<Slopes<T>> {
    let items = |key: &str| match entry(tree, key) {
        Some(Node::List(items)) => &items[..],
        _ => &[],
    };
    let place = Place::default().key("part");
    let parts = items("part").iter().zip(&mechanism.parts).enumerate();
    let parts = parts.map(|(i, (node, of))| {
        let words = format!("part {}", crate::shown::quoted(of.part.name()));
        part(&place.item(i).called(words), node, &of.part)
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

/// Whether anything in a value depends on a parameter that varies.
fn depends(node: &Node) -> bool {
    match node {
        Node::Varied(_) => true,
        Node::List(items) => items.iter().any(depends),
        Node::Table(entries) => entries.values().any(depends),
        _ => false,
    }
}

fn varied(node: &Node) -> Option<Dual<1, Ball>> {
    match node {
        Node::Varied(x) => Some(**x),
        _ => None,
    }
}

fn part<T: Slope>(place: &Place, node: &Node, of: &Part) -> Result<PartSlopes<T>> {
    // Derivatives of parts that are offset or drawn elsewhere are unknown; only whether they depend on it is known.
    for key in ["offset", "scale", "trace", "join"] {
        if entry(node, key).is_some_and(depends) {
            let message = format!("`{key}` depends on the parameter, and has no derivatives");
            return Err(ModelError::new(&place.key(key), message)
                .with_help("vary the parameter with `sweep` to see what it does"));
        }
    }
    let mut slopes = PartSlopes {
        loops: Vec::new(),
        axis: None,
        range: None,
    };
    let mut outlines: Vec<Vec<Vertex<Given>>> = Vec::new();
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
            let drawn = read_loops::<Given>(&loops, i, node)?;
            outlines.extend(drawn.into_iter().map(|l| l.vertices));
        }
    }
    if let Some(node) = entry(node, KEY).filter(|p| depends(p) || !outlines.is_empty()) {
        let place = place.key(KEY);
        let mut profile = Profile::<Given>::read(&place, node, of)?;
        if outlines.is_empty() {
            // The part's own are off by the values already.
            profile = profile.beyond();
            let given = |v: &Vertex| {
                let [x, y, bulge] = [v.x, v.y, v.bulge].map(Given::constant);
                Vertex::new(x, y, bulge)
            };
            let loops = of.loops().iter();
            outlines = loops
                .map(|l| l.vertices().iter().map(given).collect())
                .collect();
        }
        outlines = profile.loops(&place, of, &outlines)?;
    }
    for outline in outlines {
        let number = |v: &Vertex<Given>| [v.x, v.y, v.bulge].map(T::of);
        slopes.loops.push(outline.iter().map(number).collect());
    }
    let Some(motion) = entry(node, "motion") else {
        return Ok(slopes);
    };
    let pair = |key: &str| match entry(motion, key) {
        Some(list @ Node::List(items)) if items.len() == 2 && depends(list) => {
            let of = |node: &Node| {
                let number = number(node).unwrap_or(f64::NAN);
                T::of(varied(node).unwrap_or(Dual::constant(number)))
            };
            Some([&items[0], &items[1]].map(of))
        }
        _ => None,
    };
    slopes.axis = pair("center").or_else(|| pair("direction"));
    slopes.range = pair("range");
    Ok(slopes)
}

fn requirement<T: Slope>(node: &Node) -> Option<(String, RequirementSlopes<T>)> {
    let Some(Node::Text(name)) = entry(node, "name") else {
        return None;
    };
    let mut slopes = RequirementSlopes {
        at: [None; 3],
        along: [None; 3],
    };
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
                slopes.at[of.index()] = varied(value).map(T::of);
            }
        }
    }
    if let Some(Node::List(along)) = entry(node, "along") {
        for (to, from) in slopes.along.iter_mut().zip(along) {
            *to = varied(from).map(T::of);
        }
    }
    Some((name.to_string(), slopes))
}
