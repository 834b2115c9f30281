//! Taking values out of tables, with errors that say where.

use std::collections::BTreeMap;

use super::angle;
use super::error::ModelError;
use super::node::{Node, quoted};
use super::suggest::nearest;

/// A table of the file, with words for where it is.
pub(super) struct Table<'a> {
    pub(super) place: String,
    entries: &'a BTreeMap<String, Node>,
}

pub(super) type Result<T> = core::result::Result<T, ModelError>;

impl<'a> Table<'a> {
    /// The value as a table that has no keys but these.
    pub(super) fn new(node: &'a Node, place: impl Into<String>, keys: &[&str]) -> Result<Self> {
        let place = place.into();
        let Node::Table(entries) = node else {
            return Err(ModelError::new(
                place,
                format!("{} where a table is expected", node.describe()),
            ));
        };
        for key in entries.keys() {
            if !keys.contains(&key.as_str()) {
                let error = ModelError::new(place, format!("unknown key {}", quoted(key)));
                let help = match nearest(key, keys.iter().copied()) {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => format!("the keys here are {}", keys.join(", ")),
                };
                return Err(error.with_help(help));
            }
        }
        Ok(Self { place, entries })
    }

    pub(super) fn get(&self, key: &str) -> Option<&'a Node> {
        self.entries.get(key)
    }

    fn error(&self, key: &str, node: &Node, expected: &str) -> ModelError {
        ModelError::new(
            self.place.clone(),
            format!(
                "`{key}` is {} where {expected} is expected",
                node.describe()
            ),
        )
    }

    pub(super) fn missing(&self, key: &str, example: &str) -> ModelError {
        ModelError::new(self.place.clone(), format!("`{key}` is missing"))
            .with_help(format!("give it as {example}"))
    }

    pub(super) fn text(&self, key: &str) -> Result<Option<&'a str>> {
        match self.get(key) {
            None => Ok(None),
            Some(Node::Text(t)) => Ok(Some(t)),
            Some(other) => Err(self.error(key, other, "text")),
        }
    }

    pub(super) fn list(&self, key: &str) -> Result<Option<&'a [Node]>> {
        match self.get(key) {
            None => Ok(None),
            Some(Node::List(l)) => Ok(Some(l)),
            Some(other) => Err(self.error(key, other, "a list")),
        }
    }

    pub(super) fn count(&self, key: &str) -> Result<Option<u32>> {
        match self.get(key) {
            None => Ok(None),
            Some(&Node::Integer(i)) if (1..=1_000_000).contains(&i) => Ok(Some(i as u32)),
            Some(other) => Err(self.error(key, other, "a whole number from 1 up")),
        }
    }

    /// Two finite numbers.
    pub(super) fn point(&self, key: &str) -> Result<Option<(f64, f64)>> {
        let Some(node) = self.get(key) else {
            return Ok(None);
        };
        let numbers = match node {
            Node::List(l) if l.len() == 2 => number(&l[0]).zip(number(&l[1])),
            _ => None,
        };
        match numbers {
            Some((x, y)) if x.is_finite() && y.is_finite() => Ok(Some((x, y))),
            _ => Err(self.error(key, node, "a pair of finite numbers [x, y]")),
        }
    }

    /// Two finite numbers or angles, the first smaller.
    pub(super) fn interval(&self, key: &str, angles: bool) -> Result<Option<(f64, f64)>> {
        let Some(node) = self.get(key) else {
            return Ok(None);
        };
        let read = if angles { angle_of } else { number };
        let numbers = match node {
            Node::List(l) if l.len() == 2 => read(&l[0]).zip(read(&l[1])),
            _ => None,
        };
        let what = if angles {
            "two angles such as [\"-10deg\", \"10deg\"] or [-0.2, 0.2]"
        } else {
            "two numbers [lo, hi]"
        };
        match numbers {
            Some((lo, hi)) if lo.is_finite() && hi.is_finite() => {
                if lo < hi {
                    return Ok(Some((lo, hi)));
                }
                Err(ModelError::new(
                    self.place.clone(),
                    format!("`{key}` goes from {lo} to {hi}: it is empty or reversed"),
                )
                .with_help("give the smaller bound first"))
            }
            _ => Err(self.error(key, node, what)),
        }
    }
}

/// A number as it stands.
pub(super) fn number(node: &Node) -> Option<f64> {
    match *node {
        Node::Integer(i) => Some(i as f64),
        Node::Number(x) => Some(x),
        _ => None,
    }
}

/// An angle in radians: a number, or text with a unit.
fn angle_of(node: &Node) -> Option<f64> {
    match node {
        Node::Text(t) => angle::parse(t),
        other => number(other),
    }
}
