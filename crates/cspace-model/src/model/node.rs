//! Tree of values, common to TOML and JSON.

use std::collections::{BTreeMap, btree_map::Entry};
use std::fmt;

use crate::shown::{self, quoted};
use serde::de::{Deserialize, Deserializer, Error, MapAccess, SeqAccess, Visitor};

/// The key under which the TOML reader hands over a date.
const DATE_KEY: &str = "$__toml_private_datetime";

/// A value of a model file. Small (24 bytes), since an outline has several for each vertex.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Node {
    Null,
    Bool(bool),
    Integer(i64),
    Number(f64),
    Text(Box<str>),
    Date,
    List(Box<[Node]>),
    // Boxed for size: a table is rare, a number is not.
    #[allow(clippy::box_collection)]
    Table(Box<BTreeMap<String, Node>>),
}

impl Node {
    /// The value of a key, of a table that has it.
    pub(super) fn get(&self, key: &str) -> Option<&Self> {
        match self {
            Self::Table(entries) => entries.get(key),
            _ => None,
        }
    }

    /// The text, of a text.
    pub(super) fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// Description of the value, for a message.
    pub(super) fn describe(&self) -> String {
        match self {
            Self::Null => "null".into(),
            Self::Bool(b) => format!("`{b}`"),
            Self::Integer(i) => format!("the number {i}"),
            Self::Number(x) => format!("the number {}", shown::number(*x)),
            Self::Text(t) => format!("the text {}", quoted(t)),
            Self::Date => "a date".into(),
            Self::List(list) => match list.len() {
                0 => "an empty list".into(),
                1 => "a list of one item".into(),
                n => format!("a list of {n} items"),
            },
            Self::Table(_) => "a table".into(),
        }
    }
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(AnyValue)
    }
}

struct AnyValue;

impl<'de> Visitor<'de> for AnyValue {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a value")
    }

    fn visit_unit<E>(self) -> Result<Node, E> {
        Ok(Node::Null)
    }

    fn visit_bool<E>(self, v: bool) -> Result<Node, E> {
        Ok(Node::Bool(v))
    }

    fn visit_i64<E>(self, v: i64) -> Result<Node, E> {
        Ok(Node::Integer(v))
    }

    fn visit_u64<E>(self, v: u64) -> Result<Node, E> {
        Ok(i64::try_from(v).map_or(Node::Number(v as f64), Node::Integer))
    }

    fn visit_i128<E>(self, v: i128) -> Result<Node, E> {
        Ok(i64::try_from(v).map_or(Node::Number(v as f64), Node::Integer))
    }

    fn visit_u128<E>(self, v: u128) -> Result<Node, E> {
        Ok(i64::try_from(v).map_or(Node::Number(v as f64), Node::Integer))
    }

    fn visit_f64<E>(self, v: f64) -> Result<Node, E> {
        Ok(Node::Number(v))
    }

    fn visit_str<E>(self, v: &str) -> Result<Node, E> {
        Ok(Node::Text(v.into()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Node, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = seq.next_element()? {
            list.push(item);
        }
        Ok(Node::List(list.into_boxed_slice()))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Node, A::Error> {
        let mut table = BTreeMap::new();
        while let Some(key) = map.next_key::<String>()? {
            match table.entry(key) {
                Entry::Vacant(entry) => {
                    entry.insert(map.next_value()?);
                }
                Entry::Occupied(entry) => {
                    let key = quoted(entry.key());
                    return Err(A::Error::custom(format!("the key {key} is given twice")));
                }
            }
        }
        if table.len() == 1 && table.contains_key(DATE_KEY) {
            return Ok(Node::Date);
        }
        Ok(Node::Table(Box::new(table)))
    }
}

#[cfg(test)]
mod tests {
    use super::Node;

    #[test]
    fn a_value_is_small() {
        assert!(size_of::<Node>() <= 24);
    }

    #[test]
    fn toml_and_json_give_the_same_tree() {
        let toml: Node =
            toml::from_str("a = [1, 2.5, \"x\", true]\nb = { c = 1979-05-27 }").unwrap();
        let json: Node =
            serde_json::from_str(r#"{"a": [1, 2.5, "x", true], "b": {"c": null}}"#).unwrap();
        let (Node::Table(toml), Node::Table(json)) = (toml, json) else {
            panic!("both are tables");
        };
        assert_eq!(toml["a"], json["a"]);
        let Node::Table(b) = &toml["b"] else {
            panic!("b is a table");
        };
        assert_eq!(b["c"], Node::Date);
    }
}
