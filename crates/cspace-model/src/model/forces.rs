//! Drives, loads and springs from a file's tree of values.

use cspace::{Axis, AxisMotion, Point, Vector};

use super::keys::{Key, Keys, Kind, Kinds};
use super::measure::{Measure, read_list};
use super::node::Node;
use super::relations::part_index;
use super::scope::Result;
use super::table::Table;
use crate::mechanism::{
    Drive, DriveMotion, DynamicsFault, Load, LoadKind, PartEntry, Spring, SpringKind,
};
use crate::shown::quoted;

#[rustfmt::skip]
pub(super) const DRIVE: Keys = Keys::new(
    "a drive is a table with part = \"driver\" and rate = \"360deg\"",
    &[
        Key::new("part", "part_name", "The part that is driven, which turns or slides.").needed("part = \"pawl\""),
        Key::new("rate", "angle_rate", "How fast it moves from where it starts, per second: an angle or a length.").like("rate = \"360deg\" or table = [[0, 0], [1, 2]]"),
        Key::new("table", "positions", "Where it is at which time, [[t, u], [t, u], ...]: seconds that increase, and angles or lengths. A cubic spline goes through all points."),
    ],
);

#[rustfmt::skip]
pub(super) const LOAD: Keys = Keys::new(
    "a load is a table with part = \"pawl\" and force = [0, -3], or torque = 0.5",
    &[
        Key::new("part", "part_name", "The part on which it acts.").needed("part = \"pawl\""),
        Key::new("force", "point", "A force in the assembly's frame, kg·unit/s².").like("force = [0, -3], or torque = 0.5"),
        Key::new("at", "point", "Where the force acts, in the part's frame. Default: at the centre of mass."),
        Key::new("torque", "number", "A torque, kg·unit²/s², counter-clockwise."),
    ],
);

#[rustfmt::skip]
pub(super) const SPRING: Keys = Keys {
    kinds: Some(Kinds {
        what: "type of spring",
        key: "type",
        default: Some("linear"),
        all: &[
            Kind { name: "linear", needs: &["at"], takes: &["length"] },
            Kind { name: "torsion", needs: &[], takes: &["angle"] },
        ],
    }),
    ..Keys::new(
        "a spring is a table with parts = [\"pawl\", \"link\"], at = [[x, y], [x, y]] and stiffness = 2.5",
        &[
            Key::new("type", "kind", "linear, the default: between two points. torsion: between two orientations."),
            Key::new("parts", "names_of_parts", "The names of two parts, or of one for a spring to the ground.").needed("parts = [\"pawl\", \"link\"]"),
            Key::new("at", "two_points", "The two points, each in its part's frame, one of the ground in the assembly's.").like("at = [[x, y], [x, y]]"),
            Key::new("stiffness", "not_negative", "The force per length, kg/s², or torque per radian, kg·unit²/s². Default: 0, a damper alone.").like("stiffness = 2.5"),
            Key::new("length", "not_negative", "The distance of the points at which there is no force. Default: as drawn."),
            Key::new("angle", "angle", "The orientation of the first part less that of the second at which there is no torque. Default: 0, as drawn."),
            Key::new("damping", "not_negative", "The force per rate of change of the distance, kg/s, or torque per rad/s, kg·unit²/s. Default: 0."),
        ],
    )
};

/// The part that the key `part` names.
fn part_of(table: &Table<'_>, parts: &[PartEntry]) -> Result<usize> {
    let name = table.needed("part", table.text("part")?)?;
    part_index(&table.place.key("part"), name, parts)
}

pub(super) fn read_drives(root: &Table<'_>, parts: &[PartEntry]) -> Result<Vec<Drive>> {
    root.each("drive", |_, value| {
        let table = Table::new(value, &DRIVE)?;
        let part = part_of(&table, parts)?;
        let axis = drivable(&table, &parts[part])?;
        let measure = Measure::along(&axis);
        let motion = match (table.get("rate"), table.has("table")) {
            (Some(_), true) => {
                let error = table.error("table", "`rate` and `table` are both given");
                return Err(error.with_help("keep one: a table says the rate, too"));
            }
            (Some(rate), false) => DriveMotion::Rate(measure.rate().read("rate", &rate)?),
            (None, true) => DriveMotion::Table(points(&table, measure)?),
            (None, false) => return Err(table.missing("rate")),
        };
        Ok(Drive { part, motion })
    })
}

/// The axis of a part that can be driven.
fn drivable(table: &Table<'_>, entry: &PartEntry) -> Result<Axis> {
    let fault = match entry.axis {
        None => DynamicsFault::MovesFreely,
        Some(_) => DynamicsFault::StandsStill,
    };
    let moving = entry.axis.filter(|x| x.motion != AxisMotion::Fixed);
    moving.ok_or_else(|| {
        let message = format!("{}: {fault}", quoted(entry.part.name()));
        table.error("part", message).with_help(fault.help())
    })
}

/// The points (t, u) of a drive's table.
fn points(table: &Table<'_>, measure: Measure) -> Result<Vec<(f64, f64)>> {
    const HELP: &str =
        "give it as table = [[t, u], [t, u], ...]: times in seconds and where the part is";
    let points = table.items("table", HELP)?.unwrap_or_default();
    let measures = [Measure::Number, measure];
    let read = |point| read_list("table", point, measures, HELP).map(|[t, u]| (t, u));
    points.iter().map(read).collect()
}

pub(super) fn read_loads(root: &Table<'_>, parts: &[PartEntry]) -> Result<Vec<Load>> {
    root.each("load", |_, value| {
        let table = Table::new(value, &LOAD)?;
        let part = part_of(&table, parts)?;
        let at = table.point("at")?;
        let kind = match (table.point::<f64>("force")?, table.number("torque")?) {
            (Some(_), Some(_)) => {
                let error = table.error("torque", "`force` and `torque` are both given");
                return Err(error.with_help("make two loads of them"));
            }
            (Some(force), None) => LoadKind::Force {
                force: Vector::new(force.x, force.y),
                at,
            },
            (None, Some(_)) if at.is_some() => {
                let error = table.error("at", "a torque has no point at which it acts");
                return Err(error.with_help("leave out `at`, or give a force"));
            }
            (None, Some(torque)) => LoadKind::Torque(torque),
            (None, None) => return Err(table.missing("force")),
        };
        Ok(Load { part, kind })
    })
}

pub(super) fn read_springs(root: &Table<'_>, parts: &[PartEntry]) -> Result<Vec<Spring>> {
    root.each("spring", |_, value| {
        let table = Table::new(value, &SPRING)?;
        let (part, other) = ends(&table, parts)?;
        let kind = table.kind()?;
        table.only_of(kind, "spring")?;
        let (stiffness, damping) = (table.number("stiffness")?, table.number("damping")?);
        if stiffness.is_none() && damping.is_none() {
            return Err(table.missing("stiffness"));
        }
        let (stiffness, damping) = (stiffness.unwrap_or(0.0), damping.unwrap_or(0.0));
        let kind = if kind.name == "linear" {
            let at = two_points(&table)?;
            SpringKind::Linear {
                at,
                stiffness,
                length: (table.number("length")?).unwrap_or_else(|| at.0.distance(at.1)),
                damping,
            }
        } else {
            let angle = table.get("angle");
            SpringKind::Torsion {
                stiffness,
                angle: angle.map_or(Ok(0.0), |angle| Measure::Angle.read("angle", &angle))?,
                damping,
            }
        };
        Ok(Spring { part, other, kind })
    })
}

/// The part, or two parts, that a spring is between.
fn ends(table: &Table<'_>, parts: &[PartEntry]) -> Result<(usize, Option<usize>)> {
    const HELP: &str = "name two parts, parts = [\"pawl\", \"link\"], or one for a spring to the ground, parts = [\"pawl\"]";
    let names = table.needed("parts", table.nodes("parts", HELP)?)?;
    let place = table.place.key("parts");
    let index = |i: usize, name: &str| part_index(&place.item(i), name, parts);
    match names {
        [Node::Text(one)] => Ok((index(0, one)?, None)),
        [Node::Text(one), Node::Text(two)] => Ok((index(0, one)?, Some(index(1, two)?))),
        _ => {
            let error = table.error("parts", "`parts` is not a list of one or two names");
            Err(error.with_help(HELP))
        }
    }
}

/// The two points that a spring is between.
fn two_points(table: &Table<'_>) -> Result<(Point, Point)> {
    const HELP: &str = "give two points, at = [[x, y], [x, y]]: each in its part's frame, one of the ground in the assembly's";
    const BOTH: [Measure; 2] = [Measure::Number; 2];
    let points = table.needed("at", table.items("at", HELP)?)?;
    let [first, second] = &points[..] else {
        let found = match points.len() {
            1 => "one point".to_owned(),
            n => format!("{n} points"),
        };
        let message = format!("`at` has {found}: a spring is between two points");
        return Err(table.error("at", message).with_help(HELP));
    };
    let point = |value| read_list("at", value, BOTH, HELP).map(|[x, y]| Point::new(x, y));
    Ok((point(first)?, point(second)?))
}
