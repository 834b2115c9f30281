//! Where the outline of a part is put: `place = { at = [x, y], turn = "30deg", mirror = "x" }`.

use cspace::{Part, Point};
use cspace_drawing::{Mirror, Placement};

use super::keys::{Key, Keys};
use super::measure::Measure;
use super::scope::{Result, Scalar};
use super::table::Table;
use super::value::Value;

/// Help text on axes at which something is mirrored.
pub(super) const AXES: &str =
    "give mirror = \"x\", which turns y around, or mirror = \"y\", which turns x around";

#[rustfmt::skip]
pub(super) const PLACE: Keys = Keys::new(
    "give it as place = { at = [x, y], turn = \"30deg\", mirror = \"x\" }, or some of these",
    &[
        Key::new("mirror", "x|y", "The axis through the outline's origin at which it is mirrored, first of all: x turns y around, y turns x around. Default: none."),
        Key::new("turn", "angle", "How far it is turned about its origin, after that. Default: 0."),
        Key::new("at", "point", "Where its origin is moved to, at last. Default: [0, 0]."),
    ],
);

/// The value of the key `place`.
pub(super) fn read_placement<T: Scalar>(place: Value<'_>) -> Result<Placement<T>> {
    let table = Table::new(place.further("place"), &PLACE)?;
    let none = Placement::none();
    let origin = Point::new(none.turn, none.turn);
    let turn = table.get("turn");
    Ok(Placement {
        at: table
            .point("at")?
            .map_or(none.at, |at: Point<T>| at - origin),
        turn: turn.map_or(Ok(none.turn), |turn| Measure::Angle.read("turn", &turn))?,
        mirror: table.choice("mirror", "axis", &Mirror::ALL, AXES)?,
    })
}

/// The part where the key `place` of its table puts it.
pub(super) fn at_place(table: &Table<'_>, part: Part) -> Result<Part> {
    let Some(place) = table.get("place") else {
        return Ok(part);
    };
    let placement = read_placement::<f64>(place)?;
    placement.part(&part).map_err(|e| {
        let error = table.error(
            "place",
            format!("where it is put, the outline is none: {e}"),
        );
        error.with_help("put it nearer to the origin")
    })
}
