//! Requirements on the motion of a mechanism.

use cspace::AxisMotion;

use super::pair::two_parts;
use super::quantity::{Coordinate, Dimension, Happening, MotionQuantity, Subject};
use crate::mechanism::Mechanism;
use crate::model::relations::part_index;
use crate::model::scope::Result;
use crate::model::table::Table;
use crate::shown::quoted;

/// The quantity of a kind.
pub(super) fn read_motion(
    table: &Table<'_>,
    kind: &str,
    mechanism: &Mechanism,
) -> Result<(Subject, Dimension)> {
    let time: f64 = table.needed("time", table.number("time")?)?;
    if time <= 0.0 {
        let error = table.error("time", "the time of a motion is not more than 0");
        return Err(error.with_help("give how long the motion is followed, in seconds"));
    }
    let (quantity, dimension) = match kind {
        "event" => (event(table, mechanism)?, Dimension::Time),
        "stroke" => stroke(table, mechanism)?,
        _ => (ratio(table, mechanism)?, Dimension::Number),
    };
    Ok((Subject::Motion(time, quantity), dimension))
}

fn event(table: &Table<'_>, mechanism: &Mechanism) -> Result<MotionQuantity> {
    let names = Happening::ALL.map(|h| h.0).join(", ");
    let help = format!("the events are {names}");
    let happens = table.choice("event", "event", &Happening::ALL, &help)?;
    Ok(MotionQuantity::Event {
        happens: table.needed("event", happens)?,
        parts: two_parts(table, mechanism)?,
        number: table.count("number")?.unwrap_or(1),
    })
}

fn stroke(table: &Table<'_>, mechanism: &Mechanism) -> Result<(MotionQuantity, Dimension)> {
    let part = moving_part(table, "part", mechanism)?;
    let names = Coordinate::PLANAR.map(|c| c.0).join(", ");
    let given = table.text("of")?;
    let (of, dimension) = match (mechanism.parts[part].axis, given) {
        (Some(axis), None) => (
            Coordinate::V,
            match axis.motion {
                AxisMotion::Revolute { .. } => Dimension::Angle,
                _ => Dimension::Length,
            },
        ),
        (Some(_), Some(_)) => {
            let error = table.error("of", "the part moves on an axis, in one coordinate alone");
            return Err(error.with_help("remove `of`"));
        }
        (None, None) => return Err(table.missing_as("of", "of = \"x\"")),
        (None, Some(given)) => {
            let Some(&(_, of)) = Coordinate::PLANAR.iter().find(|c| c.0 == given) else {
                let error = table.error(
                    "of",
                    format!("the part has no coordinate {}", quoted(given)),
                );
                return Err(error.with_help(format!("its coordinates are {names}")));
            };
            let dimension = match of {
                Coordinate::Theta => Dimension::Angle,
                _ => Dimension::Length,
            };
            (of, dimension)
        }
    };
    Ok((MotionQuantity::Stroke { part, of }, dimension))
}

fn ratio(table: &Table<'_>, mechanism: &Mechanism) -> Result<MotionQuantity> {
    let [by, of] = ["by", "part"].map(|key| {
        let part = moving_part(table, key, mechanism)?;
        if mechanism.parts[part].axis.is_none() {
            let error = table.error(key, "the part does not move on an axis");
            return Err(error.with_help("name a part that turns or slides on an axis"));
        }
        Ok(part)
    });
    Ok(MotionQuantity::Ratio { by: by?, of: of? })
}

/// The part that a key names, which must be able to move.
fn moving_part(table: &Table<'_>, key: &str, mechanism: &Mechanism) -> Result<usize> {
    let name = table.needed(key, table.text(key)?)?;
    let part = part_index(&table.place.key(key), name, &mechanism.parts)?;
    if (mechanism.parts[part].axis).is_some_and(|a| matches!(a.motion, AxisMotion::Fixed)) {
        let error = table.error(key, format!("the part {} is fixed", quoted(name)));
        return Err(error.with_help("name a part that moves"));
    }
    Ok(part)
}
