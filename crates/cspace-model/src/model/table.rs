//! Taking values out of tables, with errors that say where.

use std::collections::BTreeMap;

use cspace::Point;

use super::error::ModelError;
use super::keys::{Keys, Kind};
use super::node::Node;
use super::place::Place;
use super::scope::{Result, Scalar, Scope};
use super::suggest::did_you_mean;
use super::value::Value;
use crate::LARGEST_ANGLE;
use crate::shown::{self, quoted};

/// A table of the file, with its place.
pub(super) struct Table<'a> {
    pub(super) place: Place,
    pub(super) scope: &'a Scope,
    entries: &'a BTreeMap<String, Node>,
    keys: &'static Keys,
}

impl<'a> Table<'a> {
    /// The value as a table that has no other keys than these.
    pub(super) fn new(value: Value<'a>, keys: &'static Keys) -> Result<Self> {
        let Node::Table(entries) = value.node else {
            let message = format!("{} where a table is expected", value.node.describe());
            return Err(value.error(message).with_help(keys.help));
        };
        let kinds = keys.kinds.as_ref();
        let kind = kinds.and_then(|k| k.get(value.text_of(k.key).or(k.default)?));
        let table = Self {
            place: value.place,
            scope: value.scope,
            entries,
            keys,
        };
        // Keys of other kinds are not suggested; `only_of` refuses them.
        match entries.keys().find(|key| keys.get(key).is_none()) {
            Some(key) => Err(table.unknown(key, &keys.names(kind))),
            None => Ok(table),
        }
    }

    /// The kind of the table, by the key that names it.
    pub(super) fn kind(&self) -> Result<&'static Kind> {
        let Some(kinds) = &self.keys.kinds else {
            return Err(ModelError::new(&self.place, "a table without kinds"));
        };
        let all: Vec<(&str, &Kind)> = kinds.all.iter().map(|kind| (kind.name, kind)).collect();
        let names: Vec<&str> = all.iter().map(|kind| kind.0).collect();
        let default = kinds
            .default
            .map(|name| format!(", or leave it out for {name}"));
        let help = format!(
            "give one of {}{}",
            names.join(", "),
            default.unwrap_or_default()
        );
        let kind = self.choice(kinds.key, kinds.what, &all, &help)?;
        self.needed(kinds.key, kind.or_else(|| kinds.get(kinds.default?)))
    }

    /// A key of the table that one of this kind does not use: it would be taken for a statement about it.
    pub(super) fn other_than(&self, kind: &Kind) -> Option<&'a str> {
        self.beside(&self.keys.names(Some(kind)))
    }

    /// Refuses keys that a table of this kind does not use. `what` is the table's name.
    pub(super) fn only_of(&self, kind: &Kind, what: &str) -> Result<()> {
        let names = self.keys.names(Some(kind));
        self.only(&names, &format!("a {} {what}", kind.name))
    }

    /// Refuses other keys than these, which are those of `what`.
    pub(super) fn only(&self, names: &[&str], what: &str) -> Result<()> {
        self.beside(names).map_or(Ok(()), |key| {
            let help = format!("{what} has the keys {}", names.join(", "));
            Err(self.unknown(key, names).with_help(help))
        })
    }

    /// A key of the table that is none of these.
    fn beside(&self, names: &[&str]) -> Option<&'a str> {
        let mut keys = self.entries.keys().map(String::as_str);
        keys.find(|key| !names.contains(key))
    }

    fn unknown(&self, key: &str, names: &[&str]) -> ModelError {
        let message = format!("unknown key {}", quoted(key));
        let all = || format!("the keys here are {}", names.join(", "));
        let help = did_you_mean(key, names.iter().copied(), all);
        self.error_at_key(key, message).with_help(help)
    }

    /// The value of a key.
    pub(super) fn get(&self, key: &str) -> Option<Value<'a>> {
        let node = self.node(key)?;
        let place = self.place.key(key);
        let scope = self.scope;
        Some(Value { node, place, scope })
    }

    pub(super) fn has(&self, key: &str) -> bool {
        self.node(key).is_some()
    }

    fn node(&self, key: &str) -> Option<&'a Node> {
        debug_assert!(self.keys.get(key).is_some(), "no key {key} is known");
        self.entries.get(key)
    }

    /// The tables of a list, in two brackets each, read one by one by their numbers.
    pub(super) fn each<T>(
        &self,
        key: &str,
        mut read: impl FnMut(usize, Value<'a>) -> Result<T>,
    ) -> Result<Vec<T>> {
        let help = format!("write each {key} as [[{key}]], in two brackets");
        let items = self.items(key, &help)?.unwrap_or_default().into_iter();
        (items.enumerate())
            .map(|(i, item)| read(i, item.called(format!("{key} {i}"))))
            .collect()
    }

    /// An error at the value of a key.
    pub(super) fn error(&self, key: &str, message: impl Into<String>) -> ModelError {
        ModelError::new(&self.place.key(key), message)
    }

    /// An error at a key itself.
    pub(super) fn error_at_key(&self, key: &str, message: impl Into<String>) -> ModelError {
        ModelError::new(&self.place.key(key).itself(), message)
    }

    pub(super) fn wrong(&self, key: &str, node: &Node, expected: &str, help: &str) -> ModelError {
        let found = node.describe();
        self.error(
            key,
            format!("`{key}` is {found} where {expected} is expected"),
        )
        .with_help(help)
    }

    /// Error for a key that is needed and not given.
    pub(super) fn missing(&self, key: &str) -> ModelError {
        let example = self.keys.get(key).map_or("", |key| key.example);
        self.missing_as(key, example)
    }

    /// As above, with an example of the value.
    pub(super) fn missing_as(&self, key: &str, example: &str) -> ModelError {
        ModelError::new(&self.place, format!("`{key}` is missing"))
            .with_help(format!("give it as {example}"))
    }

    /// The value of a key that is needed.
    pub(super) fn needed<T>(&self, key: &str, given: Option<T>) -> Result<T> {
        given.ok_or_else(|| self.missing(key))
    }

    pub(super) fn text(&self, key: &str) -> Result<Option<&'a str>> {
        match self.node(key) {
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

    /// Meaning of a text that is one of these; `help` says what there is, where it is none.
    pub(super) fn choice<T: Copy>(
        &self,
        key: &str,
        what: &str,
        all: &[(&str, T)],
        help: &str,
    ) -> Result<Option<T>> {
        let Some(text) = self.text(key)? else {
            return Ok(None);
        };
        match all.iter().find(|one| one.0 == text) {
            Some(one) => Ok(Some(one.1)),
            None => {
                let names = all.iter().map(|one| one.0);
                let help = did_you_mean(text, names, || help.to_owned());
                let message = format!("unknown {what} {}", quoted(text));
                Err(self.error(key, message).with_help(help))
            }
        }
    }

    /// The items of a list.
    pub(super) fn nodes(&self, key: &str, help: &str) -> Result<Option<&'a [Node]>> {
        match self.node(key) {
            None => Ok(None),
            Some(Node::List(l)) => Ok(Some(l)),
            Some(other) => Err(self.wrong(key, other, "a list", help)),
        }
    }

    /// The items of a list, with their places.
    pub(super) fn items(&self, key: &str, help: &str) -> Result<Option<Vec<Value<'a>>>> {
        self.nodes(key, help)?;
        Ok(self.get(key).and_then(|list| list.items()))
    }

    /// A whole number from 1 up.
    pub(super) fn count(&self, key: &str) -> Result<Option<u32>> {
        const MOST: f64 = 1e6;
        let Some(value) = self.get(key) else {
            return Ok(None);
        };
        let number = value.read_number()?;
        if number.is_some_and(|x| x.varied.is_some()) {
            let message = format!("`{key}` is a count, which has no derivatives");
            return Err(value.error(message));
        }
        let is_whole = |x: &f64| x.fract() == 0.0 && (1.0..=MOST).contains(x);
        // A number that stands there itself has no decimal point either.
        let count = (number.map(|x| x.value)).filter(|_| !matches!(value.node, Node::Number(_)));
        match (count.filter(is_whole), count) {
            (Some(count), _) => Ok(Some(count as u32)),
            (None, found) => {
                let help = format!("give a whole number from 1 to {MOST}, or leave it out");
                let found = found.map(Node::Number);
                let found = found.as_ref().unwrap_or(value.node);
                Err(self.wrong(key, found, "a whole number from 1 up", &help))
            }
        }
    }

    /// A finite number.
    pub(super) fn number<T: Scalar>(&self, key: &str) -> Result<Option<T>> {
        let Some(node) = self.node(key) else {
            return Ok(None);
        };
        let number = self.scope.number(node, || self.place.key(key))?.map(T::of);
        match number.filter(|x| x.value().is_finite()) {
            Some(x) => Ok(Some(x)),
            None => {
                let help = format!("give it as {key} = 2.5");
                Err(self.wrong(key, node, "a finite number", &help))
            }
        }
    }

    /// True or false; false where it is not given.
    pub(super) fn flag(&self, key: &str) -> Result<bool> {
        match self.node(key) {
            None => Ok(false),
            Some(&Node::Bool(b)) => Ok(b),
            Some(other) => {
                let help = format!("give it as {key} = true, without quotes, or leave it out");
                Err(self.wrong(key, other, "`true` or `false`", &help))
            }
        }
    }

    /// A place, by two finite numbers.
    pub(super) fn point<T: Scalar>(&self, key: &str) -> Result<Option<Point<T>>> {
        let Some(node) = self.node(key) else {
            return Ok(None);
        };
        let number = |i: usize, node| {
            let place = || self.place.key(key).item(i);
            Ok(self.scope.number(node, place)?.map(T::of))
        };
        let numbers = match node {
            Node::List(l) if l.len() == 2 => number(0, &l[0])?.zip(number(1, &l[1])?),
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
        self.two(key, angles, |lo, hi| lo < hi)
    }

    /// As [`interval`](Self::interval), of limits, which may be one value.
    pub(super) fn limits(&self, key: &str, angles: bool) -> Result<Option<(f64, f64)>> {
        self.two(key, angles, |lo, hi| lo <= hi)
    }

    fn two(
        &self,
        key: &str,
        angles: bool,
        are_ordered: fn(f64, f64) -> bool,
    ) -> Result<Option<(f64, f64)>> {
        let Some(value) = self.get(key) else {
            return Ok(None);
        };
        let (what, one, help) = if angles {
            (
                "two angles",
                "an angle",
                format!(
                    "give it as {key} = [\"-10deg\", \"10deg\"], or in radians, {key} = [-0.2, 0.2]"
                ),
            )
        } else {
            (
                "two numbers",
                "a finite number",
                format!("give it as {key} = [0, 25]"),
            )
        };
        let items = value.items();
        let Some([lo, hi]) = items.as_deref() else {
            return Err(self.wrong(key, value.node, what, &help));
        };
        let bound = |bound: &Value<'_>| {
            let read = if angles {
                bound.angle()?
            } else {
                bound.number()?
            };
            let value = read.filter(|x| x.is_finite());
            if let Some(x) = value.filter(|x| angles && x.abs() > LARGEST_ANGLE) {
                let message = format!(
                    "`{key}` has the angle {} rad, more than {LARGEST_ANGLE:e} rad from 0",
                    shown::number(x)
                );
                return Err(bound
                    .error(message)
                    .with_help("take off whole turns: angles a turn apart are the same position"));
            }
            value.ok_or_else(|| {
                let found = bound.node.describe();
                let message = format!("`{key}` has {found} where {one} is expected");
                bound.error(message).with_help(help.as_str())
            })
        };
        let (lo, hi) = (bound(lo)?, bound(hi)?);
        if are_ordered(lo, hi) {
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
