//! Deviations of form: `profile = 0.02` of a part, or `profile = { "tip" = 0.01 }` of its features.
//!
//! A number is a tolerance. It becomes a parameter of its own, `pawl_profile = { value = 0, tol = 0.02 }`, by which the
//! outline is offset along its normals; an expression gives the offset itself.

use std::borrow::Cow;
use std::collections::BTreeMap;

use cspace::part::PartFeature;
use cspace::{Part, Vertex};
use cspace_drawing::profile;

use super::error::ModelError;
use super::names::feature;
use super::node::Node;
use super::place::Place;
use super::scope::{Result, Scalar, Scope};
use super::suggest::did_you_mean;
use super::tolerance::LARGEST;
use super::value::Value;
use crate::shown::quoted;

const HELP: &str = "give how far the outline may be off: profile = 0.02, or of features: profile = { \"tip\" = 0.02 }";

/// Offsets of a part's edges.
pub(super) struct Profile<T> {
    /// Offset of all edges that are not named.
    whole: T,
    named: Vec<(PartFeature, T)>,
}

/// The parameters of a file, its key `parameter`, and those that stand for profiles that are numbers.
pub(super) fn with_profiles(file: &Node) -> Result<Option<Cow<'_, Node>>> {
    let scope = Scope::literal();
    let given = file.get("parameter");
    let file = Value::root(file, &scope);
    let mut added: Vec<(String, f64, Place)> = Vec::new();
    let parts = file.get("part").and_then(|parts| parts.items());
    for (i, part) in parts.unwrap_or_default().into_iter().enumerate() {
        let name = part.text_of("name");
        let name = name.map_or_else(|| format!("part{i}"), str::to_owned);
        let part = part.called(format!("part {i} {}", quoted(&name)));
        let Some(profile) = part.get("profile") else {
            continue;
        };
        match profile.entries() {
            Some(features) => {
                for (feature, value) in features {
                    added.extend(tolerance(parameter_of(&name, Some(feature)), value)?);
                }
            }
            None => added.extend(tolerance(parameter_of(&name, None), profile)?),
        }
    }
    if added.is_empty() {
        return Ok(given.map(Cow::Borrowed));
    }
    let mut all = match given {
        None => BTreeMap::new(),
        Some(Node::Table(entries)) => BTreeMap::clone(entries),
        Some(other) => return Ok(Some(Cow::Borrowed(other))),
    };
    for (name, tolerance, place) in added {
        let table = [("value", 0.0), ("tol", tolerance)].map(|(k, x)| (k.into(), Node::Number(x)));
        let table = Node::Table(Box::new(BTreeMap::from(table)));
        if all.insert(name.clone(), table).is_some() {
            let message = format!("the profile is the parameter `{name}`, and there is another");
            return Err(ModelError::new(&place, message)
                .with_help(format!("rename it, or give profile = \"{name}\"")));
        }
    }
    Ok(Some(Cow::Owned(Node::Table(Box::new(all)))))
}

/// The parameter of a profile that is a number, how far it may be off, and where it is.
fn tolerance(name: String, value: Value<'_>) -> Result<Option<(String, f64, Place)>> {
    if value.node.text().is_some() {
        return Ok(None);
    }
    let Some(tolerance) = value.number()?.filter(|x| (0.0..=LARGEST).contains(x)) else {
        let found = value.node.describe();
        let message = format!("{found} where a number of 0 or more is expected");
        return Err(value.error(message).with_help(HELP));
    };
    Ok(Some((name, tolerance, value.place)))
}

/// The name of the parameter that stands for the profile of a part, or of one of its features.
fn parameter_of(part: &str, feature: Option<&str>) -> String {
    let letter = |c: char| if c.is_alphanumeric() { c } else { '_' };
    let words = [part].into_iter().chain(feature);
    let words: Vec<String> = words.map(|w| w.chars().map(letter).collect()).collect();
    let mut name = words.join("_");
    if name.starts_with(|c: char| c.is_numeric()) {
        name.insert_str(0, "part_");
    }
    name + "_profile"
}

impl<T: Scalar> Profile<T> {
    /// The value of the key.
    pub(super) fn read(profile: &Value<'_>, part: &Part) -> Result<Self> {
        let read = |value: &Value<'_>, feature: Option<&str>| {
            if value.node.text().is_none() && value.number::<f64>()?.is_some() {
                let parameter = parameter_of(part.name(), feature);
                return value.scope.evaluated(&parameter, &value.place).map(T::of);
            }
            let number = value.number()?.filter(|x: &T| x.value().is_finite());
            number.ok_or_else(|| {
                let message = format!("{} where a number is expected", value.node.describe());
                value.error(message).with_help(HELP)
            })
        };
        let Some(features) = profile.entries() else {
            return Ok(Self {
                whole: read(profile, None)?,
                named: Vec::new(),
            });
        };
        let mut named = Vec::with_capacity(features.len());
        for (name, value) in features {
            let called = part.feature_names().find(|(_, n)| *n == name);
            let of = called
                .map(|(f, _)| f)
                .or_else(|| feature(name).map(|f| f.1));
            match of {
                Some(edge @ PartFeature::Edge { loop_index, index })
                    if (part.loops().get(loop_index as usize))
                        .is_some_and(|l| (index as usize) < l.vertices().len()) =>
                {
                    named.push((edge, read(&value, Some(name))?));
                }
                Some(PartFeature::Vertex { .. }) => {
                    let message = format!("{} is a vertex", quoted(name));
                    return Err(ModelError::new(&value.place.itself(), message)
                        .with_help("give the profile of the edges beside it"));
                }
                _ => {
                    let message = format!("there is no edge {}", quoted(name));
                    let names = part.feature_names().map(|(_, n)| n);
                    let help = did_you_mean(name, names, || {
                        "give a name of the part's `names`, or \"line 3 of loop 0\", as `cspace play` and others print it".to_owned()
                    });
                    return Err(ModelError::new(&value.place.itself(), message).with_help(help));
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
pub(super) fn at_profile(part: Part, value: &Value<'_>) -> Result<Part> {
    let profile = Profile::<f64>::read(value, &part)?;
    if profile.is_zero() {
        return Ok(part);
    }
    let loops: Vec<Vec<Vertex>> = part.loops().iter().map(|l| l.vertices().to_vec()).collect();
    let off = profile.loops(&value.place, &part, &loops)?;
    let wrong = |e: cspace::PartError| {
        (value.error(format!("with the profile, {e}"))).with_help("give a smaller profile")
    };
    part.redrawn(off).map_err(wrong)
}
