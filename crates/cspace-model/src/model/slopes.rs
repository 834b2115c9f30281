//! Derivatives of a model's numbers by one of its parameters: dual numbers through expressions, patterns, arcs and fillets.

use std::collections::BTreeMap;

use cspace::part::Loop;
use cspace::{Part, Real, Vertex};
use cspace_drawing::{Placement, Touch};

use super::loops::read_loops;
use super::node::Node;
use super::placement::read_placement;
use super::profile::Profile;
use super::requirements::Coordinate;
use super::scope::{Number, Result, Scalar, Varied};
use super::union::Entries;
use super::value::Value;
use crate::mechanism::Mechanism;

/// Advice where there are no derivatives.
const HELP: &str = "vary the parameter with `sweep` to see what it does";

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

/// Result type of the evaluation of a number that varies.
pub(super) trait Slope: Copy {
    fn from_number(number: Varied) -> Self;
}

impl Slope for f64 {
    fn from_number(number: Varied) -> Self {
        number.slope[0].mid
    }
}

impl Slope for Varied {
    fn from_number(number: Self) -> Self {
        number
    }
}

/// Collects the derivatives of a file's numbers.
pub(super) fn slopes<T: Slope>(file: &Value<'_>, mechanism: &Mechanism) -> Result<Slopes<T>> {
    let items = |key: &str| file.get(key).and_then(|list| list.items());
    let written = items("part").unwrap_or_default();
    let parts = mechanism.parts.iter().map(|entry| {
        let drawn = entry.drawn();
        let members = drawn.iter().filter_map(|of| {
            let value = (written.iter()).find(|v| v.text_of("name") == Some(of.name()))?;
            let words = format!("part {}", crate::shown::quoted(of.name()));
            Some(part(&value.clone().called(words), of))
        });
        Ok(together(members.collect::<Result<_>>()?, &drawn))
    });
    let requirements = items("requirement").unwrap_or_default();
    let requirements = requirements.iter().map(|r| Ok((name(r), requirement(r)?)));
    Ok(Slopes {
        parts: parts.collect::<Result<_>>()?,
        requirements: requirements.collect::<Result<_>>()?,
    })
}

/// Derivatives of a part, by those of the parts that it is made of.
fn together<T: Slope>(members: Vec<PartSlopes<T>>, drawn: &[Part]) -> PartSlopes<T> {
    let moves = members.iter().any(|m| !m.loops.is_empty());
    let mut all = PartSlopes {
        loops: Vec::new(),
        axis: members.iter().find_map(|m| m.axis),
        range: members.iter().find_map(|m| m.range),
    };
    for (member, of) in members.into_iter().zip(drawn).filter(|_| moves) {
        all.loops.extend(match member.loops.is_empty() {
            true => numbers(&own(of.loops())),
            false => member.loops,
        });
    }
    all
}

fn numbers<T: Slope>(loops: &[Vec<Vertex<Varied>>]) -> Vec<Vec<[T; 3]>> {
    let number = |v: &Vertex<Varied>| [v.x, v.y, v.bulge].map(T::from_number);
    let loops = loops.iter();
    loops.map(|l| l.iter().map(number).collect()).collect()
}

fn name(requirement: &Value<'_>) -> String {
    requirement.text_of("name").unwrap_or_default().to_owned()
}

/// Whether anything in a value is written as text, which may be an expression.
fn has_text(node: &Node) -> bool {
    match node {
        Node::Text(_) => true,
        Node::List(items) => items.iter().any(has_text),
        Node::Table(entries) => entries.values().any(has_text),
        _ => false,
    }
}

/// The loops of a part's outline, as it is drawn; none if they do not depend on anything that varies.
fn outline(part: &Value<'_>) -> Result<Vec<Vec<Vertex<Varied>>>> {
    let written = |key| part.get(key).filter(|outline| has_text(outline.node));
    // Enclosures of what does not vary might be too wide to draw by, for nothing.
    if let Some(loops) = written("loops") {
        let (_, moves) = part.scope.moves_in(|| drawn::<f64>(&loops))?;
        return if moves { drawn(&loops) } else { Ok(Vec::new()) };
    }
    let Some(union) = written("union") else {
        return Ok(Vec::new());
    };
    let (_, moves) = (part.scope).moves_in(|| Entries::<f64>::read(&union))?;
    if moves {
        united(&union)
    } else {
        Ok(Vec::new())
    }
}

/// The loops of a union.
fn united(union: &Value<'_>) -> Result<Vec<Vec<Vertex<Varied>>>> {
    /// Derivatives of a gap that are rounding.
    const ROUNDING: f64 = 1e-9;
    let entries = Entries::read(union)?;
    let united = entries.united()?;
    let opens = |touch: &&Touch<Varied>| touch.gap.slope[0].mid.abs() > ROUNDING;
    if let Some(touch) = united.touches.iter().find(opens) {
        let [a, b] = touch.edges.map(|edge| entries.edge(edge).0);
        let message = format!(
            "{a} and {b} lie on each other at this value of the parameter alone, and the outline has no derivatives"
        );
        return Err(union.error(message).with_help(HELP));
    }
    let mut vertices = united.loops.iter().flatten();
    if vertices.any(|v| !v.x.spread().is_finite()) {
        let message = "over a range of the parameter other edges of the union may cross, and it has no derivatives";
        return Err(union.error(message).with_help(HELP));
    }
    Ok(united.loops)
}

fn drawn<T: Scalar>(loops: &Value<'_>) -> Result<Vec<Vec<Vertex<T>>>> {
    let mut outlines = Vec::new();
    if let Node::List(items) = loops.node {
        for (i, node) in items.iter().enumerate() {
            let drawn = read_loops(&loops.place, i, node, loops.scope)?;
            outlines.extend(drawn.into_iter().map(|l| l.vertices));
        }
    }
    Ok(outlines)
}

/// The loops of a part that is put where its `place` says, off by its profile; none if they do not depend on anything that varies.
fn outlines(value: &Value<'_>, of: &Part) -> Result<Vec<Vec<Vertex<Varied>>>> {
    let drawn = match value.get("layers") {
        Some(layers) => stacked(value, &layers, of)?,
        None => outline(value)?,
    };
    let is_drawn = !drawn.is_empty();
    if let Some(offset) = value.get("offset").filter(|_| is_drawn) {
        let message = "the part has an offset, of which there are no derivatives";
        return Err(offset.error(message).with_help(HELP));
    }
    let (placement, is_moved) = placement(value)?;
    let mut outlines = match (is_drawn, is_moved) {
        (true, _) => placement.loops(&drawn),
        // The part's own are where they were put.
        (false, true) => placement.beyond().loops(&own(of.loops())),
        (false, false) => Vec::new(),
    };
    let Some(given) = value.get("profile") else {
        return Ok(outlines);
    };
    let read = || Profile::<Varied>::read(&given, of);
    let (mut profile, moves) = value.scope.moves_in(read)?;
    if !is_drawn {
        if !moves {
            return Ok(outlines);
        }
        // The part's own are off by the values already.
        profile = profile.beyond();
        if outlines.is_empty() {
            outlines = own(of.loops());
        }
    }
    profile.loops(&given.place, of, &outlines)
}

/// Where a part or a layer is put, and whether that depends on anything that varies.
fn placement(value: &Value<'_>) -> Result<(Placement<Varied>, bool)> {
    let place = value.get("place");
    let read = || place.map_or_else(|| Ok(Placement::none()), read_placement);
    value.scope.moves_in(read)
}

/// The loops of all layers of a part, as they are put before the part is; none if they do not depend on anything that varies.
fn stacked(value: &Value<'_>, layers: &Value<'_>, of: &Part) -> Result<Vec<Vec<Vertex<Varied>>>> {
    let mut stack = Vec::with_capacity(of.loops().len());
    let (mut varies, mut stays) = (false, None);
    let items = layers.items().unwrap_or_default();
    for (layer, drawn_as) in items.iter().zip(of.layers()) {
        let (drawn, (placement, is_moved)) = (outline(layer)?, placement(layer)?);
        varies |= is_moved || !drawn.is_empty();
        if drawn.is_empty() {
            // The part's own are where they were put, and also where the part was.
            let own = own(&of.loops()[drawn_as.loops()]);
            stack.extend(match is_moved {
                true => placement.beyond().loops(&own),
                false => own,
            });
            stays = Some(layer);
        } else {
            stack.extend(placement.loops(&drawn));
        }
    }
    let beside = ["place", "profile"]
        .into_iter()
        .find(|key| value.get(key).is_some());
    match (varies, stays, beside) {
        (false, ..) => Ok(Vec::new()),
        (true, Some(layer), Some(key)) => {
            let message = format!(
                "other layers depend on the parameter, and the part has a `{key}`: there are no derivatives"
            );
            Err(layer.error(message).with_help(HELP))
        }
        _ => Ok(stack),
    }
}

/// Loops of a part as they are.
fn own(loops: &[Loop]) -> Vec<Vec<Vertex<Varied>>> {
    let given = |v: &Vertex| {
        let [x, y, bulge] = [v.x, v.y, v.bulge].map(Varied::constant);
        Vertex::new(x, y, bulge)
    };
    let loops = loops.iter();
    loops
        .map(|l| l.vertices().iter().map(given).collect())
        .collect()
}

fn part<T: Slope>(value: &Value<'_>, of: &Part) -> Result<PartSlopes<T>> {
    // Derivatives of parts that are offset or drawn elsewhere are unknown; only whether they depend on it is known.
    for key in ["offset", "scale", "join", "z"] {
        let layers = value.get("layers").and_then(|layers| layers.items());
        let all = layers.into_iter().flatten().chain([value.clone()]);
        let values = all.filter_map(|v| v.get(key));
        for value in values.flat_map(|v| v.items().unwrap_or_else(|| vec![v.clone()])) {
            if value.read_number()?.is_some_and(|x| x.varied.is_some()) {
                let message = format!("`{key}` depends on the parameter, and has no derivatives");
                return Err(value.error(message).with_help(HELP));
            }
        }
    }
    let mut slopes = PartSlopes {
        loops: numbers(&outlines(value, of)?),
        axis: None,
        range: None,
    };
    let Some(motion) = value.get("motion") else {
        return Ok(slopes);
    };
    let pair = |key: &str| {
        let both = motion.get(key).and_then(|both| both.items());
        let Some([a, b]) = both.as_deref() else {
            return Ok(None);
        };
        let both = a.read_angle()?.zip(b.read_angle()?);
        let both = both.filter(|(a, b)| a.varied.or(b.varied).is_some());
        Ok(both.map(|(a, b)| [a, b].map(|x: Number| T::from_number(Varied::of(x)))))
    };
    slopes.axis = pair("center")?.or(pair("direction")?);
    slopes.range = pair("range")?;
    Ok(slopes)
}

fn requirement<T: Slope>(value: &Value<'_>) -> Result<RequirementSlopes<T>> {
    let slope = |value: &Value<'_>| {
        let number = value.read_angle()?;
        Ok(number.and_then(|x| x.varied).map(T::from_number))
    };
    let mut slopes = RequirementSlopes {
        at: [None; 3],
        along: [None; 3],
    };
    if let Some(at) = value.get("at") {
        for (_, of) in Coordinate::PLANAR.into_iter().chain(Coordinate::AXES) {
            if let Some(value) = at.get(of.name()) {
                slopes.at[of.index()] = slope(&value)?;
            }
        }
    }
    if let Some(along) = value.get("along").and_then(|along| along.items()) {
        for (to, from) in slopes.along.iter_mut().zip(&along) {
            *to = slope(from)?;
        }
    }
    Ok(slopes)
}
