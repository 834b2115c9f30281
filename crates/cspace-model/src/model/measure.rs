//! Numbers and angles of motions: where a part is and how fast it moves, by how it can move.

use cspace::{Axis, AxisMotion};

use super::scope::{Result, Scalar};
use super::value::Value;
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

    /// The number in the value of a key, or in a part of it.
    pub(super) fn read<T: Scalar>(self, key: &str, value: &Value<'_>) -> Result<T> {
        let read = match self {
            Self::Number => value.number()?,
            Self::Angle | Self::AngleRate => value.read_angle()?.map(T::of),
        };
        let Some(number) = read.filter(|x| x.value().is_finite()) else {
            let (found, expected) = (value.node.describe(), self.expected());
            let message = format!("`{key}` has {found} where {expected} is expected");
            let help = format!("write it as {}", self.example());
            return Err(value.error(message).with_help(help));
        };
        if self == Self::Angle && number.value().abs() > LARGEST_ANGLE {
            let message = format!(
                "`{key}` has the angle {} rad, more than {LARGEST_ANGLE:e} rad from 0",
                shown::number(number.value())
            );
            return Err(value.error(message).with_help("take off whole turns"));
        }
        Ok(number)
    }
}

/// Numbers of a list, each of its own measure; `help` is how the list is written.
pub(super) fn read_list<const N: usize>(
    key: &str,
    value: &Value<'_>,
    measures: [Measure; N],
    help: &str,
) -> Result<[f64; N]> {
    let items = value.items().filter(|items| items.len() == N);
    let Some(items) = items else {
        let found = value.node.describe();
        let message = format!("`{key}` has {found} where a list of {N} numbers is expected");
        return Err(value.error(message).with_help(help));
    };
    let mut numbers = [0.0; N];
    for ((number, measure), item) in numbers.iter_mut().zip(measures).zip(&items) {
        *number = measure.read(key, item)?;
    }
    Ok(numbers)
}
