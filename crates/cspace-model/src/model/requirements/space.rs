//! The coordinates of the pair that a requirement is about, as they are written.

use std::collections::HashMap;

use cspace::{Axis, AxisMotion, Configuration, Coordinates, Relation};

use super::quantity::Coordinate;
use crate::mechanism::{Mechanism, PairEntry};
use crate::model::keys::{Key, Keys};
use crate::model::measure::{Measure, read_list};
use crate::model::scope::Result;
use crate::model::table::Table;
use crate::model::value::Value;
use crate::shown::quoted;

#[rustfmt::skip]
pub(in crate::model) const PLANAR: Keys = Keys::new(
    "give the coordinates x, y, theta, such as at = { x = 0 }",
    &[
        Key::new("x", "number", "How far the moving part is to the right."),
        Key::new("y", "number", "How far it is up."),
        Key::new("theta", "angle", "How far it is turned."),
    ],
);

#[rustfmt::skip]
pub(in crate::model) const AXES: Keys = Keys::new(
    "give the coordinates u, v, such as at = { u = 0 }",
    &[
        Key::new("u", "angle_rate", "The motion of the fixed part on its axis."),
        Key::new("v", "angle_rate", "The motion of the moving part on its axis."),
    ],
);

/// The coordinates of a pair.
pub(super) enum Space {
    Planar,
    Axes([Axis; 2]),
}

impl Space {
    pub(super) fn of(mechanism: &Mechanism, pair: &PairEntry, table: &Table<'_>) -> Result<Self> {
        match mechanism.relation(pair) {
            Relation::Planar => Ok(Self::Planar),
            Relation::Axes { fixed, moving } => Ok(Self::Axes([fixed, moving])),
            Relation::Joint(..) => Err(table
                .error("pair", "a joint connects the parts, which never part")
                .with_help("name a pair that meets by contact")),
        }
    }

    pub(super) fn names(&self) -> &'static [(&'static str, Coordinate)] {
        match self {
            Self::Planar => &Coordinate::PLANAR,
            Self::Axes(_) => &Coordinate::AXES,
        }
    }

    /// Refuses a pair that does not move on axes.
    pub(super) fn must_have_axes(&self, table: &Table<'_>, kind: &str) -> Result<()> {
        let Self::Planar = self else { return Ok(()) };
        let key = if kind == "clearance" {
            "over"
        } else {
            "measure"
        };
        let message = "the pair moves in x, y and theta, and has no ranges to go through";
        Err(table.error(key, message).with_help(
            "give both parts a motion on an axis, or motion = { type = \"fixed\" }, in [[part]]",
        ))
    }

    /// Refuses a pair of which a part does not turn.
    pub(super) fn must_turn(&self, table: &Table<'_>, kind: &str) -> Result<()> {
        let turns = |axis: &Axis| matches!(axis.motion, AxisMotion::Revolute { .. });
        match self {
            Self::Axes(axes) if !axes.iter().all(turns) => {
                let message = format!("{kind} is of two parts that turn, and one does not");
                let help = "name two parts with motion = { type = \"revolute\", … }, or measure the play of one";
                Err(table.error("measure", message).with_help(help))
            }
            _ => Ok(()),
        }
    }

    pub(super) fn example(&self) -> &'static str {
        match self {
            Self::Planar => "[0, -10, 0]",
            Self::Axes(_) => "[0, -10]",
        }
    }

    pub(super) fn measure(&self, of: Coordinate) -> Measure {
        match (self, of) {
            (Self::Axes([fixed, _]), Coordinate::U) => Measure::along(fixed),
            (Self::Axes([_, moving]), Coordinate::V) => Measure::along(moving),
            (_, Coordinate::Theta) => Measure::Angle,
            _ => Measure::Number,
        }
    }

    pub(super) fn at(&self, value: impl Fn(Coordinate) -> f64) -> Coordinates {
        match self {
            Self::Planar => Coordinates::Planar(Configuration::new(
                value(Coordinate::X),
                value(Coordinate::Y),
                value(Coordinate::Theta),
            )),
            Self::Axes(_) => Coordinates::Axes {
                u: value(Coordinate::U),
                v: value(Coordinate::V),
            },
        }
    }

    /// The configuration in the table `at`; coordinates that it leaves out are as drawn.
    pub(super) fn configuration(&self, table: &Table<'_>) -> Result<Coordinates> {
        let Some(at) = table.get("at") else {
            return Ok(self.at(|_| 0.0));
        };
        let keys = match self {
            Self::Planar => &PLANAR,
            Self::Axes(_) => &AXES,
        };
        let at = Table::new(at, keys)?;
        let mut values = HashMap::new();
        for &(name, of) in self.names() {
            if let Some(value) = at.get(name) {
                values.insert(name, self.measure(of).read(name, &value)?);
            }
        }
        Ok(self.at(|of| values.get(of.name()).copied().unwrap_or(0.0)))
    }

    /// Reads the coordinates of a list.
    pub(super) fn list(&self, key: &str, value: &Value<'_>) -> Result<Coordinates> {
        let help = format!("give it as {key} = {}", self.example());
        match self {
            Self::Axes([u, v]) => {
                let measures = [u, v].map(Measure::along);
                let [u, v] = read_list(key, value, measures, &help)?;
                Ok(Coordinates::Axes { u, v })
            }
            Self::Planar => {
                let measures = [Measure::Number, Measure::Number, Measure::Angle];
                let [x, y, theta] = read_list(key, value, measures, &help)?;
                Ok(Coordinates::Planar(Configuration::new(x, y, theta)))
            }
        }
    }

    pub(super) fn coordinate(&self, table: &Table<'_>) -> Result<Option<Coordinate>> {
        let Some(text) = table.text("of")? else {
            return Ok(None);
        };
        let names: Vec<&str> = self.names().iter().map(|n| n.0).collect();
        let Some(&(_, of)) = self.names().iter().find(|n| n.0 == text) else {
            let error = table.error("of", format!("the pair has no coordinate {}", quoted(text)));
            return Err(error.with_help(format!("its coordinates are {}", names.join(", "))));
        };
        let is_fixed = |axis: &Axis| matches!(axis.motion, AxisMotion::Fixed);
        if let Self::Axes([fixed, moving]) = self
            && is_fixed(if of == Coordinate::U { fixed } else { moving })
        {
            let error = table.error(
                "of",
                format!("the part of the coordinate {text} does not move"),
            );
            return Err(error.with_help("name the coordinate of the other part"));
        }
        Ok(Some(of))
    }
}
