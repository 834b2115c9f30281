//! A value of the file, with its place, and what its expressions are evaluated with.

use super::error::ModelError;
use super::node::Node;
use super::place::Place;
use super::scope::{Number, Result, Scalar, Scope};

/// A value of the file.
#[derive(Clone)]
pub(super) struct Value<'a> {
    pub(super) node: &'a Node,
    pub(super) place: Place,
    pub(super) scope: &'a Scope,
}

impl<'a> Value<'a> {
    /// The whole file.
    pub(super) fn root(node: &'a Node, scope: &'a Scope) -> Self {
        Self {
            node,
            place: Place::default(),
            scope,
        }
    }

    pub(super) fn called(mut self, words: impl Into<String>) -> Self {
        self.place = self.place.called(words);
        self
    }

    pub(super) fn further(mut self, words: &str) -> Self {
        self.place = self.place.further(words);
        self
    }

    /// The value of a key, if this is a table that has it.
    pub(super) fn get(&self, key: &str) -> Option<Self> {
        let node = self.node.get(key)?;
        let place = self.place.key(key);
        Some(Self {
            node,
            place,
            ..*self
        })
    }

    /// The text of a key, of what may not be a table that has it.
    pub(super) fn text_of(&self, key: &str) -> Option<&'a str> {
        self.node.get(key)?.text()
    }

    /// The keys of a table with their values; none where there is something else.
    pub(super) fn entries(&self) -> Option<Vec<(&'a str, Self)>> {
        let Node::Table(entries) = self.node else {
            return None;
        };
        let entry = |(key, node): (&'a String, _)| {
            let place = self.place.key(key);
            (
                key.as_str(),
                Self {
                    node,
                    place,
                    ..*self
                },
            )
        };
        Some(entries.iter().map(entry).collect())
    }

    /// The items of a list; none where there is something else.
    pub(super) fn items(&self) -> Option<Vec<Self>> {
        let Node::List(items) = self.node else {
            return None;
        };
        let item = |(i, node)| Self {
            node,
            place: self.place.item(i),
            ..*self
        };
        Some(items.iter().enumerate().map(item).collect())
    }

    pub(super) fn error(&self, message: impl Into<String>) -> ModelError {
        ModelError::new(&self.place, message)
    }

    /// The number in it, and how it varies; none where there is something else.
    pub(super) fn read_number(&self) -> Result<Option<Number>> {
        self.scope.number(self.node, || self.place.clone())
    }

    /// The number in it; none where there is something else.
    pub(super) fn number<T: Scalar>(&self) -> Result<Option<T>> {
        Ok(self.read_number()?.map(T::of))
    }

    /// The angle in it, and how it varies, in radians; none where there is something else.
    pub(super) fn read_angle(&self) -> Result<Option<Number>> {
        self.scope.angle(self.node, || self.place.clone())
    }

    /// The angle in it, in radians; none where there is something else.
    pub(super) fn angle(&self) -> Result<Option<f64>> {
        Ok(self.read_angle()?.map(|angle| angle.value))
    }
}
