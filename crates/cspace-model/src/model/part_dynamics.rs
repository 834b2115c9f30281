//! Mass, start and rate of a part.

use cspace::{Axis, AxisMotion, Configuration, Vector};

use super::measure::{Measure, read_list};
use super::node::Node;
use super::scope::Result;
use super::table::Table;
use super::value::Value;
use crate::mechanism::{DynamicsFault, Mass, PartDynamics, PartPosition, PartVelocity};

/// Reads mass and motion from the table of a part; `axis` is how it moves.
pub(super) fn read_part_dynamics(table: &Table<'_>, axis: Option<Axis>) -> Result<PartDynamics> {
    let mass = match (table.number("mass")?, table.number("density")?) {
        (Some(_), Some(_)) => {
            let error = table.error("density", "`mass` and `density` are both given");
            return Err(error.with_help("keep one: the mass is the density times the area"));
        }
        (Some(mass), None) => Some(Mass::Total(mass)),
        (None, density) => density.map(Mass::Density),
    };
    Ok(PartDynamics {
        mass,
        inertia: table.number("inertia")?,
        center_of_mass: table.point("center_of_mass")?,
        start: (table.get("start"))
            .map(|value| start(table, &value, axis))
            .transpose()?,
        rate: (table.get("rate"))
            .map(|value| rate(table, &value, axis))
            .transpose()?,
    })
}

fn start(table: &Table<'_>, value: &Value<'_>, axis: Option<Axis>) -> Result<PartPosition> {
    const HELP: &str = "the part moves freely: give start = [x, y, theta]";
    const PLANAR: [Measure; 3] = [Measure::Number, Measure::Number, Measure::Angle];
    let Some(axis) = axis else {
        let [x, y, theta] = read_list("start", value, PLANAR, HELP)?;
        return Ok(PartPosition::Planar(Configuration::new(x, y, theta)));
    };
    moves(table, "start", &axis)?;
    let measure = Measure::along(&axis);
    one_number("start", value, "give one number, how far along it")?;
    measure.read("start", value).map(PartPosition::Axis)
}

fn rate(table: &Table<'_>, value: &Value<'_>, axis: Option<Axis>) -> Result<PartVelocity> {
    const HELP: &str = "the part moves freely: give rate = [vx, vy, omega]";
    const PLANAR: [Measure; 3] = [Measure::Number, Measure::Number, Measure::AngleRate];
    let Some(axis) = axis else {
        let [x, y, angular] = read_list("rate", value, PLANAR, HELP)?;
        let linear = Vector::new(x, y);
        return Ok(PartVelocity::Planar { linear, angular });
    };
    moves(table, "rate", &axis)?;
    let measure = Measure::along(&axis).rate();
    one_number("rate", value, "give one number, its rate")?;
    measure.read("rate", value).map(PartVelocity::Axis)
}

/// Checks that a part on an axis is not fixed.
fn moves(table: &Table<'_>, key: &str, axis: &Axis) -> Result<()> {
    if axis.motion != AxisMotion::Fixed {
        return Ok(());
    }
    let fault = DynamicsFault::StandsStill;
    Err(table
        .error(key, format!("`{key}`: {fault}"))
        .with_help(fault.help()))
}

/// Checks that the value given for a part on an axis is not a list.
fn one_number(key: &str, value: &Value<'_>, help: &str) -> Result<()> {
    let Node::List(_) = value.node else {
        return Ok(());
    };
    let found = value.node.describe();
    let message = format!("`{key}` has {found} for a part that turns or slides on an axis");
    Err(value.error(message).with_help(help))
}
