//! Numbers and angles of motions: where a part is and how fast it moves, by how it can move.

use cspace::{Axis, AxisMotion};

use super::error::ModelError;
use super::node::Node;
use super::place::Place;
use super::table::{Result, angle_of, number};
use crate::LARGEST_ANGLE;
use crate::shown;

/// Quantity that a number measures, which determines how it may be written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Measure {
    /// Written as a number alone.
    Number,
    /// An angle: radians, or text with a unit; at most [`LARGEST_ANGLE`].
    Angle,
    /// An angle for each second, of any size.
    AngleRate,
}

impl Measure {
    /// Measure of the coordinate of a part on an axis.
    pub(super) fn along(axis: &Axis) -> Self {
        match axis.motion {
            AxisMotion::Revolute { .. } => Self::Angle,
            AxisMotion::Prismatic { .. } | AxisMotion::Fixed => Self::Number,
        }
    }

    /// Measure of the derivative by time.
    pub(super) const fn rate(self) -> Self {
        match self {
            Self::Number => Self::Number,
            Self::Angle | Self::AngleRate => Self::AngleRate,
        }
    }

    /// Description of the expected value, for messages.
    const fn expected(self) -> &'static str {
        match self {
            Self::Number => "a finite number",
            Self::Angle => "an angle",
            Self::AngleRate => "an angle per second",
        }
    }

    /// Example of the notation.
    const fn example(self) -> &'static str {
        match self {
            Self::Number => "2.5",
            Self::Angle | Self::AngleRate => "\"30deg\", or in radians, 0.5",
        }
    }

    /// The value at a place, which belongs to a key.
    pub(super) fn read(self, place: &Place, key: &str, node: &Node) -> Result<f64> {
        let value = match self {
            Self::Number => number(node),
            Self::Angle | Self::AngleRate => angle_of(node),
        };
        let Some(value) = value.filter(|x| x.is_finite()) else {
            let (found, expected) = (node.describe(), self.expected());
            let message = format!("`{key}` has {found} where {expected} is expected");
            let help = format!("write it as {}", self.example());
            return Err(ModelError::new(place, message).with_help(help));
        };
        if self == Self::Angle && value.abs() > LARGEST_ANGLE {
            let message = format!(
                "`{key}` has the angle {} rad, more than {LARGEST_ANGLE:e} rad from 0",
                shown::number(value)
            );
            return Err(ModelError::new(place, message).with_help("take off whole turns"));
        }
        Ok(value)
    }
}

/// Values of a list, each of its own measure; `help` is how the list is written.
pub(super) fn read_list<const N: usize>(
    place: &Place,
    key: &str,
    node: &Node,
    measures: [Measure; N],
    help: &str,
) -> Result<[f64; N]> {
    let items = match node {
        Node::List(items) if items.len() == N => items,
        _ => {
            let found = node.describe();
            let message = format!("`{key}` has {found} where a list of {N} numbers is expected");
            return Err(ModelError::new(place, message).with_help(help));
        }
    };
    let mut values = [0.0; N];
    for (i, (value, measure)) in values.iter_mut().zip(measures).enumerate() {
        *value = measure.read(&place.item(i), key, &items[i])?;
    }
    Ok(values)
}
