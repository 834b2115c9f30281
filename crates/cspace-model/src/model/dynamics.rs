//! Reads masses, drives, loads, springs and friction from a file's tree of values.

use cspace::Vector;

use super::bodies::Bodies;
use super::error::ModelError;
use super::forces::{read_drives, read_loads, read_springs};
use super::scope::Result;
use super::table::Table;
use crate::mechanism::{
    Dynamics, DynamicsError, DynamicsItem, Mechanism, PairSurface, PartDynamics,
};

/// Gravity, friction, drives, loads and springs of the file's `table`; with what its parts and pairs say, checked as a whole.
pub(super) fn read_dynamics(
    table: &Table<'_>,
    mechanism: &Mechanism,
    bodies: &Bodies,
    pairs: Vec<PairSurface>,
) -> Result<Dynamics> {
    let mut parts = bodies.dynamics(table)?;
    // Default values are not stored.
    while parts.last() == Some(&PartDynamics::default()) {
        parts.pop();
    }
    let entries = &mechanism.parts;
    let gravity = table.point::<f64>("gravity")?.unwrap_or_default();
    let dynamics = Dynamics {
        gravity: Vector::new(gravity.x, gravity.y),
        friction: table.number("friction")?.unwrap_or_default(),
        restitution: table.number("restitution")?.unwrap_or_default(),
        parts,
        pairs,
        drives: read_drives(table, entries)?,
        loads: read_loads(table, entries)?,
        springs: read_springs(table, entries)?,
    };
    (dynamics.check(mechanism)).map_err(|e| in_the_file(table, mechanism, bodies, &e))?;
    Ok(dynamics)
}

/// Error for values that can be read but are invalid, at their key in the file.
fn in_the_file(
    table: &Table<'_>,
    mechanism: &Mechanism,
    bodies: &Bodies,
    error: &DynamicsError,
) -> ModelError {
    let root = &table.place;
    let item = |key: &str, i: usize| root.key(key).item(i).called(format!("{key} {i}"));
    let place = match error.item {
        DynamicsItem::Part(i) => match bodies.place(table, i, error.key) {
            Ok(place) => place,
            Err(error) => return error,
        },
        DynamicsItem::Pair(a, b) => {
            let is = |p: &crate::mechanism::PairEntry| (p.fixed, p.moving) == (a, b);
            let pair = mechanism.pairs.iter().position(is);
            pair.map_or_else(|| root.clone(), |i| item("pair", i))
        }
        DynamicsItem::Drive(i) => item("drive", i),
        DynamicsItem::Load(i) => item("load", i),
        DynamicsItem::Spring(i) => item("spring", i),
        _ => root.clone(),
    };
    let message = format!("`{}`: {}", error.key, error.fault);
    ModelError::new(&place.key(error.key), message).with_help(error.fault.help())
}
