//! Masses, forces and drives of a mechanism as text.

use std::fmt::{self, Write};

use cspace_api::info::{DriveInfo, Dynamics, Forces, LoadInfo, OneOrThree, SpringInfo, Surface};
use cspace_model::{Quantity, shown};

use crate::wording::{angle, count};

/// Digits after the first of numbers that were computed, such as an inertia, whose size may be any.
const DIGITS: usize = 6;

/// A number with a few digits, whatever its size.
fn short(x: f64) -> String {
    let rounded = format!("{x:.DIGITS$e}").parse().unwrap_or(x);
    shown::number(rounded).to_string()
}

/// A list of numbers in brackets.
fn list<const N: usize>(values: [f64; N]) -> String {
    format!("({})", values.map(short).join(", "))
}

/// Lines of a part; `unit` is the label of the model's unit, with a space before it, or empty.
pub(super) fn part(text: &mut String, motion: &Dynamics, unit: &str) -> fmt::Result {
    let squared = compound("kg·", unit, "²");
    if let Some(mass) = motion.mass {
        writeln!(text, "    mass       {} kg", short(mass))?;
    }
    if let Some(center) = motion.center_of_mass {
        writeln!(text, "    centre     of mass at {}", list(center))?;
    }
    if let Some(inertia) = motion.inertia {
        writeln!(text, "    inertia    {} {squared} about it", short(inertia))?;
    }
    if let Some(start) = motion.start {
        let start = match start {
            OneOrThree::One(u) if motion.turns => angle(u),
            OneOrThree::One(u) => format!("{}{unit}", short(u)),
            OneOrThree::Three([x, y, theta]) => format!("{}, {}", list([x, y]), angle(theta)),
        };
        writeln!(text, "    start      at {start}")?;
    }
    if let Some(rate) = motion.rate {
        let rate = match rate {
            OneOrThree::One(u) => one_rate(u, motion.turns, unit),
            OneOrThree::Three([x, y, omega]) => {
                let speed = compound("", unit, "/s");
                format!("{} {speed}, {}", list([x, y]), one_rate(omega, true, unit))
            }
        };
        writeln!(text, "    rate       {rate}")?;
    }
    Ok(())
}

/// Numbers in the unit that fits the largest of them.
fn quantity<const N: usize>(
    quantity: Quantity,
    values: [f64; N],
    unit: &str,
) -> ([f64; N], String) {
    let largest = values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let known = Some(unit.trim()).filter(|u| !u.is_empty());
    let unit = quantity.shown(known, largest);
    (values.map(|x| x * unit.factor), unit.name)
}

/// A number in the unit that fits it.
fn one(of: Quantity, value: f64, unit: &str) -> String {
    let ([value], unit) = quantity(of, [value], unit);
    format!("{} {unit}", short(value))
}

/// A unit made with that of length, which is called `unit` where the model does not name it.
fn compound(before: &str, unit: &str, after: &str) -> String {
    let unit = match unit.trim() {
        "" => "unit",
        named => named,
    };
    format!("{before}{unit}{after}")
}

fn one_rate(rate: f64, turns: bool, unit: &str) -> String {
    if turns {
        format!("{} rad/s ({} deg/s)", short(rate), short(rate.to_degrees()))
    } else {
        format!("{} {}", short(rate), compound("", unit, "/s"))
    }
}

/// The friction and restitution of a pair, as far as given, each after a comma.
pub(super) fn surface(surface: &Surface) -> String {
    let own = |what: &str, x: Option<f64>| {
        x.map_or_else(String::new, |x| format!(", {what} {}", short(x)))
    };
    own("friction", surface.friction) + &own("restitution", surface.restitution)
}

/// Gravity, friction, drives, loads and springs, under headings of their own.
pub(super) fn forces(text: &mut String, forces: &Forces, unit: &str) -> fmt::Result {
    let whole = [
        forces.gravity.map(|g| {
            let unit = compound("", unit, "/s²");
            format!("gravity {} {unit}", list(g))
        }),
        forces.friction.map(|x| format!("friction {}", short(x))),
        forces
            .restitution
            .map(|x| format!("restitution {}", short(x))),
    ];
    section(text, "everywhere", whole.into_iter().flatten())?;
    section(text, "drives", forces.drives.iter().map(|d| drive(d, unit)))?;
    section(text, "loads", forces.loads.iter().map(|l| load(l, unit)))?;
    section(
        text,
        "springs",
        forces.springs.iter().map(|s| spring(s, unit)),
    )
}

fn section(
    text: &mut String,
    heading: &str,
    mut lines: impl Iterator<Item = String>,
) -> fmt::Result {
    let Some(first) = lines.next() else {
        return Ok(());
    };
    writeln!(text, "\n{heading}\n  {first}")?;
    lines.try_for_each(|line| writeln!(text, "  {line}"))
}

fn drive(drive: &DriveInfo, unit: &str) -> String {
    let how = match (&drive.table, drive.rate) {
        (Some(points), _) => {
            let ends = points.first().zip(points.last());
            let (from, to) = ends.map_or((0.0, 0.0), |(a, b)| (a.0, b.0));
            let points = count(points.len(), "point", "points");
            format!("a table of {points}, {} s to {} s", short(from), short(to))
        }
        (None, rate) => one_rate(rate.unwrap_or_default(), drive.turns, unit),
    };
    format!("{}: {how}", drive.part)
}

fn load(load: &LoadInfo, unit: &str) -> String {
    let what = match (load.force, load.torque) {
        (Some(force), _) => {
            let (force, unit) = quantity(Quantity::Force, force, unit);
            let at = load
                .at
                .map_or_else(|| "its centre of mass".to_owned(), list);
            format!("force {} {unit} at {at}", list(force))
        }
        (None, torque) => {
            let torque = one(Quantity::Torque, torque.unwrap_or_default(), unit);
            format!("torque {torque}")
        }
    };
    format!("{}: {what}", load.part)
}

fn spring(spring: &SpringInfo, unit: &str) -> String {
    let mut ends = spring.parts.clone();
    if ends.len() == 1 {
        ends.push("the ground".to_owned());
    }
    if let Some(at) = spring.at {
        for (end, at) in ends.iter_mut().zip(at) {
            *end = format!("{end} at {}", list(at));
        }
    }
    let (kind, per_move, per_rate) = match (spring.angle, spring.length) {
        (Some(rest), _) => (
            format!("torsion, at rest at {}", angle(rest)),
            Quantity::TorsionStiffness,
            Quantity::TorsionDamping,
        ),
        (None, length) => (
            format!("at rest at {}{unit}", short(length.unwrap_or_default())),
            Quantity::Stiffness,
            Quantity::Damping,
        ),
    };
    let damping = match spring.damping {
        0.0 => String::new(),
        damping => format!(", damping {}", one(per_rate, damping, unit)),
    };
    let stiffness = format!("stiffness {}", one(per_move, spring.stiffness, unit));
    format!("{}: {kind}, {stiffness}{damping}", ends.join(" and "))
}
