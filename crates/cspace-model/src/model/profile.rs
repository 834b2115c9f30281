//! Deviations of form: `profile = 0.02` of a part, or `profile = { "tip" = 0.01 }` of its features.
//!
//! A number is a tolerance. It becomes a parameter of its own, `pawl_profile = { value = 0, tol = 0.02 }`, by which the
//! outline is offset along its normals; an expression gives the offset itself.

use std::collections::BTreeMap;

use cspace::part::PartFeature;
use cspace::{Part, Vertex};
use cspace_drawing::profile;

use super::error::ModelError;
use super::names::feature;
use super::node::Node;
use super::place::Place;
use super::suggest::nearest;
use super::table::{Result, Scalar, number};
use super::tolerance::LARGEST;
use crate::shown::quoted;

/// The key.
pub(super) const KEY: &str = "profile";

const HELP: &str = "give how far the outline may be off: profile = 0.02, or of features: profile = { \"tip\" = 0.02 }";

/// Offsets of a part's edges.
pub(super) struct Profile<T> {
    /// Offset of all edges that are not named.
    whole: T,
    named: Vec<(PartFeature, T)>,
}

/// Replaces every profile that is a number by the name of a parameter, which is added to the tree.
pub(super) fn add_parameters(tree: &mut Node) -> Result<()> {
    let Node::Table(model) = tree else {
        return Ok(());
    };
    let mut added: Vec<(String, f64, Place)> = Vec::new();
    if let Some(Node::List(parts)) = model.get_mut("part") {
        for (i, part) in parts.iter_mut().enumerate() {
            let Node::Table(part) = part else { continue };
            let name = match part.get("name") {
                Some(Node::Text(name)) => name.to_string(),
                _ => format!("part{i}"),
            };
            let place = Place::default()
                .key("part")
                .item(i)
                .called(format!("part {i} {}", quoted(&name)))
                .key(KEY);
            match part.get_mut(KEY) {
                Some(Node::Table(features)) => {
                    for (feature, node) in features.iter_mut() {
                        let name = format!("{name} {feature}");
                        added.extend(parameter(&name, node, place.key(feature))?);
                    }
                }
                Some(node) => added.extend(parameter(&name, node, place)?),
                None => {}
            }
        }
    }
    if added.is_empty() {
        return Ok(());
    }
    let parameters = model
        .entry("parameter".to_owned())
        .or_insert_with(|| Node::Table(Box::default()));
    let Node::Table(parameters) = parameters else {
        return Ok(());
    };
    for (name, tolerance, place) in added {
        let table = [("value", 0.0), ("tol", tolerance)].map(|(k, x)| (k.into(), Node::Number(x)));
        let table = Node::Table(Box::new(BTreeMap::from(table)));
        if parameters.insert(name.clone(), table).is_some() {
            let message = format!("the profile is the parameter `{name}`, and there is another");
            return Err(ModelError::new(&place, message)
                .with_help(format!("rename it, or give {KEY} = \"{name}\"")));
        }
    }
    Ok(())
}

/// The parameter that stands for a profile that is a number: its name, and how far it may be off.
fn parameter(of: &str, node: &mut Node, place: Place) -> Result<Option<(String, f64, Place)>> {
    if matches!(node, Node::Text(_)) {
        return Ok(None);
    }
    let Some(tolerance) = number(node).filter(|x| (0.0..=LARGEST).contains(x)) else {
        let message = format!(
            "{} where a number of 0 or more is expected",
            node.describe()
        );
        return Err(ModelError::new(&place, message).with_help(HELP));
    };
    let letter = |c: char| if c.is_alphanumeric() { c } else { '_' };
    let mut name: String = of.chars().map(letter).collect();
    if name.starts_with(|c: char| c.is_numeric()) {
        name.insert_str(0, "part_");
    }
    name.push_str("_profile");
    *node = Node::Text(name.as_str().into());
    Ok(Some((name, tolerance, place)))
}

impl<T: Scalar> Profile<T> {
    /// The value of the key, in a tree without expressions.
    pub(super) fn read(place: &Place, node: &Node, part: &Part) -> Result<Self> {
        let value = |place: &Place, node: &Node| {
            T::read(node)
                .filter(|x| x.value().is_finite())
                .ok_or_else(|| {
                    let message = format!("{} where a number is expected", node.describe());
                    ModelError::new(place, message).with_help(HELP)
                })
        };
        let Node::Table(features) = node else {
            let whole = value(place, node)?;
            return Ok(Self {
                whole,
                named: Vec::new(),
            });
        };
        let mut named = Vec::with_capacity(features.len());
        for (name, node) in features.iter() {
            let place = place.key(name);
            let called = part.feature_names().find(|(_, n)| *n == name);
            let of = called
                .map(|(f, _)| f)
                .or_else(|| feature(name).map(|f| f.1));
            match of {
                Some(edge @ PartFeature::Edge { loop_index, index })
                    if (part.loops().get(loop_index as usize))
                        .is_some_and(|l| (index as usize) < l.vertices().len()) =>
                {
                    named.push((edge, value(&place, node)?));
                }
                Some(PartFeature::Vertex { .. }) => {
                    let message = format!("{} is a vertex", quoted(name));
                    return Err(ModelError::new(&place.itself(), message)
                        .with_help("give the profile of the edges beside it"));
                }
                _ => {
                    let message = format!("there is no edge {}", quoted(name));
                    let names: Vec<&str> = part.feature_names().map(|(_, n)| n).collect();
                    let help = match nearest(name, names.iter().copied()) {
                        Some(meant) => format!("did you mean `{meant}`?"),
                        None => "give a name of the part's `names`, or \"line 3 of loop 0\", as `cspace play` and others print it".to_owned(),
                    };
                    return Err(ModelError::new(&place.itself(), message).with_help(help));
                }
            }
        }
        Ok(Self {
            whole: T::constant(0.0),
            named,
        })
    }

    /// Offset of an edge.
    fn of(&self, edge: PartFeature) -> T {
        let named = self.named.iter().find(|n| n.0 == edge);
        named.map_or(self.whole, |n| n.1)
    }

    /// Whether all offsets are zero.
    pub(super) fn is_zero(&self) -> bool {
        self.whole.value() == 0.0 && self.named.iter().all(|n| n.1.value() == 0.0)
    }

    /// Remainder of the offsets once edges are off by their values: the value is 0, the derivative stays.
    pub(super) fn beyond(self) -> Self {
        let rest = |x: T| x - T::constant(x.value());
        Self {
            whole: rest(self.whole),
            named: self.named.into_iter().map(|(f, x)| (f, rest(x))).collect(),
        }
    }

    /// The loops of a part, off by this.
    pub(super) fn loops(
        &self,
        place: &Place,
        part: &Part,
        loops: &[Vec<Vertex<T>>],
    ) -> Result<Vec<Vec<Vertex<T>>>> {
        profile(part, loops, |edge| self.of(edge)).map_err(|e| {
            ModelError::new(place, format!("with the profile, {e}")).with_help(e.help())
        })
    }
}

/// The part with its edges off by a profile.
pub(super) fn at_profile(part: Part, place: &Place, node: &Node) -> Result<Part> {
    let profile = Profile::<f64>::read(place, node, &part)?;
    if profile.is_zero() {
        return Ok(part);
    }
    let loops: Vec<Vec<Vertex>> = part.loops().iter().map(|l| l.vertices().to_vec()).collect();
    let off = profile.loops(place, &part, &loops)?;
    let wrong = |e: cspace::PartError| {
        ModelError::new(place, format!("with the profile, {e}")).with_help("give a smaller profile")
    };
    let named = Part::new(part.name(), off).map_err(wrong)?;
    (part.feature_names()).try_fold(named, |named, (feature, name)| {
        named.with_feature_name(feature, name).map_err(wrong)
    })
}
