//! Numbers of a file: as they stand, or expressions of its parameters.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;

use cspace::{Ball, Dual, Real};

use super::error::ModelError;
use super::expression::{Expression, Wrong};
use super::node::Node;
use super::place::{Place, Step};
use crate::angle::parse_angle;
use crate::shown::quoted;

pub(super) type Result<T> = core::result::Result<T, ModelError>;

/// An enclosure of a number, with its derivative by the parameter that is varied.
pub(super) type Varied = Dual<1, Ball>;

/// An entry of a list of the model, or a key of the model itself.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Entry {
    pub(super) key: String,
    pub(super) item: Option<usize>,
}

impl Entry {
    fn at(way: &[Step]) -> Option<Self> {
        let (key, item) = match way {
            [Step::Key(key), Step::Item(i), Step::Key(_), ..] => (key, Some(*i)),
            [Step::Key(key), ..] => (key, None),
            _ => return None,
        };
        let key = key.clone();
        Some(Self { key, item })
    }
}

/// A number that was read.
#[derive(Clone, Copy)]
pub(super) struct Number {
    pub(super) value: f64,
    /// Its enclosure, if it depends on a parameter that varies.
    pub(super) varied: Option<Varied>,
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        let varied = None;
        Self { value, varied }
    }
}

/// Numbers that drawings are read in: values alone, or enclosures with derivatives by a parameter.
pub(super) trait Scalar: Real {
    fn of(number: Number) -> Self;
}

impl Scalar for f64 {
    fn of(number: Number) -> Self {
        number.value
    }
}

impl Scalar for Varied {
    fn of(number: Number) -> Self {
        number.varied.unwrap_or(Self::constant(number.value))
    }
}

/// The parameters that expressions may name, by their numbers.
#[derive(Default)]
pub(super) struct Scope {
    pub(super) numbers: BTreeMap<String, u32>,
    pub(super) values: Vec<f64>,
    /// Enclosures of the values over the ranges of a variation, with their derivatives by the parameter that is varied; none without one.
    pub(super) varied: Vec<Varied>,
    /// Flags of the parameters that depend on one that is varied or has a range.
    pub(super) moves: Vec<bool>,
    /// For each parameter the entries of the model that name it, as far as they were read.
    pub(super) uses: RefCell<Vec<Vec<Entry>>>,
    /// Whether a number was read that depends on a parameter that varies.
    has_moved: Cell<bool>,
    /// Whether every text is a text, and none an expression.
    is_literal: bool,
}

impl Scope {
    /// For numbers that are no expressions.
    pub(super) fn literal() -> Self {
        Self {
            is_literal: true,
            ..Self::default()
        }
    }

    pub(super) fn parse(&self, text: &str) -> core::result::Result<Expression, Wrong> {
        let number = |name: &str| self.numbers.get(name).copied();
        Expression::parse(text, number, || self.numbers.keys().map(String::as_str))
    }

    /// The number in a value; none where there is something else. An angle with a unit is not a number.
    pub(super) fn number(
        &self,
        node: &Node,
        place: impl FnOnce() -> Place,
    ) -> Result<Option<Number>> {
        match node {
            Node::Integer(i) => Ok(Some((*i as f64).into())),
            Node::Number(x) => Ok(Some((*x).into())),
            Node::Text(text) if !self.is_literal && parse_angle(text).is_none() => {
                self.evaluated(text, &place()).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// The angle in a value, in radians: a number, or text with a unit.
    pub(super) fn angle(
        &self,
        node: &Node,
        place: impl FnOnce() -> Place,
    ) -> Result<Option<Number>> {
        let angle = match node {
            Node::Text(text) => parse_angle(text),
            _ => None,
        };
        angle.map_or_else(|| self.number(node, place), |x| Ok(Some(x.into())))
    }

    /// Whether reading comes upon a number that depends on a parameter that varies.
    pub(super) fn moves_in<T>(&self, read: impl FnOnce() -> Result<T>) -> Result<(T, bool)> {
        self.has_moved.set(false);
        let value = read()?;
        Ok((value, self.has_moved.get()))
    }

    /// The value of an expression.
    pub(super) fn evaluated(&self, text: &str, place: &Place) -> Result<Number> {
        let value = self
            .parse(text)
            .and_then(|e| Ok((e.evaluate(&self.values)?, e)));
        let (value, expression) = value.map_err(|wrong| in_text(place, text, &wrong))?;
        if let Some(entry) = Entry::at(place.way()) {
            let mut uses = self.uses.borrow_mut();
            for name in expression.names() {
                let uses = &mut uses[name as usize];
                if uses.last() != Some(&entry) {
                    uses.push(entry.clone());
                }
            }
        }
        let varied = self.enclosure(&expression, value);
        self.has_moved.set(self.has_moved.get() || varied.is_some());
        Ok(Number { value, varied })
    }

    /// The enclosure of an expression's value, of one that depends on what varies.
    fn enclosure(&self, expression: &Expression, value: f64) -> Option<Varied> {
        if self.varied.is_empty() || !expression.names().any(|n| self.moves[n as usize]) {
            return None;
        }
        // Where it cannot be evaluated, as at a division by what may be 0, nothing is known.
        let unknown = |_| Varied::constant(value).unknown();
        Some(expression.evaluate(&self.varied).unwrap_or_else(unknown))
    }
}

/// Error in an expression of the file.
pub(super) fn in_text(place: &Place, text: &str, wrong: &Wrong) -> ModelError {
    let message = format!("in {}: {}", quoted(text), wrong.message);
    // Behind the quote.
    ModelError::new(place, message)
        .with_help(wrong.help.as_str())
        .further_by(1 + wrong.at)
}
