//! Taking values out of tables, with errors that say where.

use std::collections::BTreeMap;

use cspace::{Ball, Dual, Point, Real};

use super::error::ModelError;
use super::node::Node;
use super::place::Place;
use super::suggest::nearest;
use crate::shown::{self, quoted};
use crate::{LARGEST_ANGLE, angle::parse_angle};

/// A table of the file, with its place.
pub(super) struct Table<'a> {
    pub(super) place: Place,
    entries: &'a BTreeMap<String, Node>,
}

pub(super) type Result<T> = core::result::Result<T, ModelError>;

impl<'a> Table<'a> {
    /// The value as a table that has no keys but these; `help` is what to do where it is no table.
    pub(super) fn new(node: &'a Node, place: Place, keys: &[&str], help: &str) -> Result<Self> {
        Self::with_others(node, place, keys, &[], help)
    }

    /// As above, with further keys that are refused later, with a reason: they are never suggested.
    pub(super) fn with_others(
        node: &'a Node,
        place: Place,
        keys: &[&str],
        others: &[&str],
        help: &str,
    ) -> Result<Self> {
        let Node::Table(entries) = node else {
            let message = format!("{} where a table is expected", node.describe());
            return Err(ModelError::new(&place, message).with_help(help));
        };
        for key in entries.keys() {
            if !keys.contains(&key.as_str()) && !others.contains(&key.as_str()) {
                let message = format!("unknown key {}", quoted(key));
                let help = match nearest(key, keys.iter().copied()) {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => format!("the keys here are {}", keys.join(", ")),
                };
                return Err(ModelError::new(&place.key(key).itself(), message).with_help(help));
            }
        }
        Ok(Self { place, entries })
    }

    pub(super) fn get(&self, key: &str) -> Option<&'a Node> {
        self.entries.get(key)
    }

    /// An error at the value of a key.
    pub(super) fn error(&self, key: &str, message: impl Into<String>) -> ModelError {
        ModelError::new(&self.place.key(key), message)
    }

    pub(super) fn wrong(&self, key: &str, node: &Node, expected: &str, help: &str) -> ModelError {
        let found = node.describe();
        self.error(
            key,
            format!("`{key}` is {found} where {expected} is expected"),
        )
        .with_help(help)
    }

    pub(super) fn missing(&self, key: &str, example: &str) -> ModelError {
        ModelError::new(&self.place, format!("`{key}` is missing"))
            .with_help(format!("give it as {example}"))
    }

    pub(super) fn text(&self, key: &str) -> Result<Option<&'a str>> {
        match self.get(key) {
            None => Ok(None),
            // A terminal obeys control characters, and XML has no place for them.
            Some(Node::Text(t)) if t.contains(char::is_control) => Err(self
                .error(
                    key,
                    format!("`{key}` has a control character: {}", quoted(t)),
                )
                .with_help("leave out line breaks, tabs and escape characters")),
            Some(Node::Text(t)) => Ok(Some(t)),
            Some(other) => {
                let help = format!("write text in quotes: {key} = \"...\"");
                Err(self.wrong(key, other, "text", &help))
            }
        }
    }

    pub(super) fn list(&self, key: &str, help: &str) -> Result<Option<&'a [Node]>> {
        match self.get(key) {
            None => Ok(None),
            Some(Node::List(l)) => Ok(Some(l)),
            Some(other) => Err(self.wrong(key, other, "a list", help)),
        }
    }

    pub(super) fn count(&self, key: &str) -> Result<Option<u32>> {
        const MOST: i64 = 1_000_000;
        match self.get(key) {
            None => Ok(None),
            Some(&Node::Integer(i)) if (1..=MOST).contains(&i) => Ok(Some(i as u32)),
            Some(Node::Varied(_)) => {
                Err(self.error(key, format!("`{key}` is a count, which has no derivatives")))
            }
            Some(other) => {
                let help = format!("give a whole number from 1 to {MOST}, or leave it out");
                Err(self.wrong(key, other, "a whole number from 1 up", &help))
            }
        }
    }

    /// A finite number.
    pub(super) fn number<T: Scalar>(&self, key: &str) -> Result<Option<T>> {
        let Some(node) = self.get(key) else {
            return Ok(None);
        };
        match T::read(node).filter(|x| x.value().is_finite()) {
            Some(x) => Ok(Some(x)),
            None => {
                let help = format!("give it as {key} = 2.5");
                Err(self.wrong(key, node, "a finite number", &help))
            }
        }
    }

    /// True or false; false where it is not given.
    pub(super) fn flag(&self, key: &str) -> Result<bool> {
        match self.get(key) {
            None => Ok(false),
            Some(&Node::Bool(b)) => Ok(b),
            Some(other) => {
                let help = format!("give it as {key} = true, without quotes, or leave it out");
                Err(self.wrong(key, other, "`true` or `false`", &help))
            }
        }
    }

    /// Two finite numbers.
    pub(super) fn point(&self, key: &str) -> Result<Option<(f64, f64)>> {
        Ok(self.place_at(key)?.map(|p: Point| (p.x, p.y)))
    }

    /// A place, by two finite numbers.
    pub(super) fn place_at<T: Scalar>(&self, key: &str) -> Result<Option<Point<T>>> {
        let Some(node) = self.get(key) else {
            return Ok(None);
        };
        let numbers = match node {
            Node::List(l) if l.len() == 2 => T::read(&l[0]).zip(T::read(&l[1])),
            _ => None,
        };
        match numbers {
            Some((x, y)) if x.value().is_finite() && y.value().is_finite() => {
                Ok(Some(Point::new(x, y)))
            }
            _ => {
                let help = format!("give it as {key} = [1.5, -2]");
                Err(self.wrong(key, node, "a pair of finite numbers [x, y]", &help))
            }
        }
    }

    /// Two finite numbers or angles, the first smaller; angles are at most [`LARGEST_ANGLE`].
    pub(super) fn interval(&self, key: &str, angles: bool) -> Result<Option<(f64, f64)>> {
        let Some(node) = self.get(key) else {
            return Ok(None);
        };
        let read = if angles { angle_of } else { number };
        let (what, help) = if angles {
            (
                "two angles",
                format!(
                    "give it as {key} = [\"-10deg\", \"10deg\"], or in radians, {key} = [-0.2, 0.2]"
                ),
            )
        } else {
            ("two numbers", format!("give it as {key} = [0, 25]"))
        };
        let Node::List(bounds) = node else {
            return Err(self.wrong(key, node, what, &help));
        };
        let [lo, hi] = &**bounds else {
            return Err(self.wrong(key, node, what, &help));
        };
        let bound = |i: usize, bound: &Node| {
            let value = read(bound).filter(|x| x.is_finite());
            if let Some(x) = value.filter(|x| angles && x.abs() > LARGEST_ANGLE) {
                let message = format!(
                    "`{key}` has the angle {} rad, more than {LARGEST_ANGLE:e} rad from 0",
                    shown::number(x)
                );
                return Err(ModelError::new(&self.place.key(key).item(i), message)
                    .with_help("take off whole turns: angles a turn apart are the same position"));
            }
            value.ok_or_else(|| {
                let one = if angles {
                    "an angle"
                } else {
                    "a finite number"
                };
                let message = format!("`{key}` has {} where {one} is expected", bound.describe());
                ModelError::new(&self.place.key(key).item(i), message).with_help(help.as_str())
            })
        };
        let (lo, hi) = (bound(0, lo)?, bound(1, hi)?);
        if lo < hi {
            return Ok(Some((lo, hi)));
        }
        Err(self
            .error(
                key,
                format!(
                    "`{key}` goes from {} to {}: it is empty or reversed",
                    shown::number(lo),
                    shown::number(hi)
                ),
            )
            .with_help("give the smaller bound first"))
    }
}

/// A number as it stands.
pub(super) fn number(node: &Node) -> Option<f64> {
    match *node {
        Node::Integer(i) => Some(i as f64),
        Node::Number(x) => Some(x),
        Node::Varied(ref x) => Some(x.value.mid),
        _ => None,
    }
}

/// Numbers that drawings are read in: values alone, or with derivatives by a parameter.
pub(super) trait Scalar: Real {
    /// A number as it stands.
    fn read(node: &Node) -> Option<Self>;
}

impl Scalar for f64 {
    fn read(node: &Node) -> Option<Self> {
        number(node)
    }
}

impl Scalar for Dual<1> {
    fn read(node: &Node) -> Option<Self> {
        match node {
            Node::Varied(x) => Some(Self {
                value: x.value.mid,
                slope: x.slope.map(|s| s.mid),
            }),
            _ => number(node).map(Self::constant),
        }
    }
}

impl Scalar for Dual<1, Ball> {
    fn read(node: &Node) -> Option<Self> {
        match node {
            Node::Varied(x) => Some(**x),
            _ => number(node).map(Self::constant),
        }
    }
}

/// An angle in radians: a number, or text with a unit.
pub(super) fn angle_of(node: &Node) -> Option<f64> {
    match node {
        Node::Text(t) => parse_angle(t),
        other => number(other),
    }
}
