//! Writing a model as TOML.

use std::fmt::Write as _;

use cspace::pair::Joint;
use cspace::part::Loop;
use cspace::{Axis, AxisMotion, Layer, Part};

use super::show::show_to_toml;
use super::toml_dynamics::{of_pair, of_part, of_whole, written_apart};
use super::toml_values::{lines, list, point, text, two, vector};
use crate::mechanism::{JointEntry, Mechanism, PairEntry, PartDynamics, PartEntry};

/// Writes the model as the text of a TOML file. Reading it gives an equal model: numbers are written with as many
/// digits as necessary, angles in radians.
///
/// Pairs are left out if they equal the default pairs of a file without pairs and none has a friction of its own. A
/// model that breaks the reader's rules, for example by a part index out of range (the name is written as empty), a
/// number that is not finite or a control character in a name, is written without an error, and refused when read.
///
/// ```
/// use cspace::Part;
/// use cspace_model::{Mechanism, PartEntry, model};
/// let mut mechanism = Mechanism::new("disc");
/// mechanism.parts.push(PartEntry::planar(Part::circle("disc", (0.0, 0.0), 0.5)?));
/// assert_eq!(model::from_toml(&model::to_toml(&mechanism), "disc.toml")?, mechanism);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_toml(mechanism: &Mechanism) -> String {
    let dynamics = &mechanism.dynamics;
    let name = |part: usize| text(mechanism.parts.get(part).map_or("", |p| p.part.name()));
    let mut out = lines([
        ("name", Some(text(&mechanism.name))),
        ("unit", mechanism.unit.as_deref().map(text)),
        ("show", show_to_toml(&mechanism.show, &name)),
    ]) + &of_whole(dynamics);
    for (i, entry) in mechanism.parts.iter().enumerate() {
        let own = dynamics.part(i);
        match &entry.drawn()[..] {
            [_] => out += &(part(entry, &entry.part) + &of_part(&own)),
            members => out += &body(entry, members, &own.of_outline(&entry.part)),
        }
    }
    for entry in &mechanism.joints {
        out += &joint(entry, &name);
    }
    if mechanism.pairs != mechanism.every_two() || !dynamics.pairs.is_empty() {
        for entry in &mechanism.pairs {
            out += &(pair(entry, &name) + &of_pair(dynamics, entry));
        }
    }
    out + &written_apart(dynamics, &name)
}

/// Some loops of a part.
pub(super) fn outlines(loops: &[Loop]) -> String {
    let of = loops;
    let mut loops = String::from("[\n");
    for outline in of {
        loops.push_str("  [\n");
        for v in outline.vertices() {
            // Writing to a string cannot fail. A bulge of −0 is distinguished from 0, so that it is read back unchanged.
            let _ = match v.bulge.to_bits() {
                0 => writeln!(loops, "    [{:?}, {:?}],", v.x, v.y),
                _ => writeln!(loops, "    [{:?}, {:?}, {:?}],", v.x, v.y, v.bulge),
            };
        }
        loops.push_str("  ],\n");
    }
    loops.push(']');
    loops
}

/// The parts of a body, of which the first says how it moves, and their joints.
fn body(entry: &PartEntry, members: &[Part], dynamics: &PartDynamics) -> String {
    let mut out = String::new();
    for (i, member) in members.iter().enumerate() {
        match i {
            0 => out += &(part(entry, member) + &of_part(dynamics)),
            _ => out += &part(&PartEntry::planar(member.clone()), member),
        }
    }
    for member in &members[1..] {
        let parts = list([&members[0], member].map(|p| text(p.name())));
        let keys = [("type", Some(text("rigid"))), ("parts", Some(parts))];
        out += &format!("\n[[joint]]\n{}", lines(keys));
    }
    out
}

/// A part with the motion of an entry.
fn part(entry: &PartEntry, part: &Part) -> String {
    let (all, layers) = (part.loops(), part.layers());
    let layer = |l: &Layer| {
        let loops = outlines(&all[l.loops()]);
        match l.z() {
            Some([lo, hi]) => format!("{{ z = [{lo:?}, {hi:?}], loops = {loops} }}"),
            None => format!("{{ loops = {loops} }}"),
        }
    };
    let layers = (part.has_heights()).then(|| list(layers.iter().map(layer)));
    let loops = layers.is_none().then(|| outlines(all));
    let names: Vec<String> = (part.feature_names())
        .map(|(feature, name)| format!("\"{feature}\" = {}", text(name)))
        .collect();
    let names = (!names.is_empty()).then(|| format!("{{ {} }}", names.join(", ")));
    let keys = [
        ("name", Some(text(part.name()))),
        ("loops", loops),
        ("layers", layers),
        ("names", names),
        ("motion", entry.axis.map(motion)),
        ("symmetry", entry.symmetry.map(|fold| fold.to_string())),
    ];
    format!("\n[[part]]\n{}", lines(keys))
}

fn joint(entry: &JointEntry, name: &dyn Fn(usize) -> String) -> String {
    let (kind, along, at) = match entry.joint {
        Joint::Revolute { at } => ("revolute", None, at),
        Joint::Prismatic { direction, at } => ("prismatic", Some(direction), at),
    };
    let keys = [
        ("type", Some(text(kind))),
        (
            "parts",
            Some(list([entry.parts.0, entry.parts.1].map(name))),
        ),
        ("direction", along.map(vector)),
        ("at", Some(point(at))),
    ];
    format!("\n[[joint]]\n{}", lines(keys))
}

fn pair(pair: &PairEntry, name: &dyn Fn(usize) -> String) -> String {
    let keys = [
        ("fixed", Some(name(pair.fixed))),
        ("moving", Some(name(pair.moving))),
        ("theta", pair.window.map(two)),
    ];
    format!("\n[[pair]]\n{}", lines(keys))
}

/// A motion relative to the ground.
pub(super) fn motion(axis: Axis) -> String {
    let range = (axis.range).map_or_else(String::new, |r| format!(", range = {}", two(r)));
    match axis.motion {
        AxisMotion::Fixed => r#"{ type = "fixed" }"#.into(),
        AxisMotion::Revolute { center } => {
            let center = point(center);
            format!(r#"{{ type = "revolute", center = {center}{range} }}"#)
        }
        AxisMotion::Prismatic { direction } => {
            let direction = vector(direction);
            format!(r#"{{ type = "prismatic", direction = {direction}{range} }}"#)
        }
    }
}
