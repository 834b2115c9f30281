//! Writing a model as TOML.

use std::fmt::Write as _;

use cspace::pair::Joint;
use cspace::{Axis, AxisMotion, Vertex};

use super::toml_dynamics::{of_pair, of_part, of_whole, written_apart};
use super::toml_values::{point, text, two, vector};
use crate::mechanism::{JointEntry, Mechanism, PairEntry, PartEntry};

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
    let mut out = Out(format!("name = {}\n", text(&mechanism.name)));
    if let Some(unit) = &mechanism.unit {
        out.line("unit", text(unit));
    }
    let dynamics = &mechanism.dynamics;
    out.0.push_str(&of_whole(dynamics));
    for (i, part) in mechanism.parts.iter().enumerate() {
        out.part(part);
        out.0.push_str(&of_part(&dynamics.part(i)));
    }
    for joint in &mechanism.joints {
        out.joint(joint, mechanism);
    }
    if mechanism.pairs != mechanism.every_two() || !dynamics.pairs.is_empty() {
        for pair in &mechanism.pairs {
            out.pair(pair, mechanism);
            out.0.push_str(&of_pair(dynamics, pair));
        }
    }
    let name = |part: usize| name_of(mechanism, part);
    out.0.push_str(&written_apart(dynamics, &name));
    out.0
}

fn name_of(mechanism: &Mechanism, part: usize) -> String {
    text(mechanism.parts.get(part).map_or("", |p| p.part.name()))
}

/// Text so far.
struct Out(String);

impl Out {
    fn line(&mut self, key: &str, value: impl AsRef<str>) {
        self.0.extend([key, " = ", value.as_ref(), "\n"]);
    }

    fn part(&mut self, entry: &PartEntry) {
        self.0.push_str("\n[[part]]\n");
        self.line("name", text(entry.part.name()));
        self.0.push_str("loops = [\n");
        for outline in entry.part.loops() {
            self.0.push_str("  [\n");
            for vertex in outline.vertices() {
                self.vertex(*vertex);
            }
            self.0.push_str("  ],\n");
        }
        self.0.push_str("]\n");
        let names: Vec<String> = (entry.part.feature_names())
            .map(|(feature, name)| format!("\"{feature}\" = {}", text(name)))
            .collect();
        if !names.is_empty() {
            self.line("names", format!("{{ {} }}", names.join(", ")));
        }
        if let Some(axis) = entry.axis {
            self.line("motion", motion(&axis));
        }
        if let Some(fold) = entry.symmetry {
            self.line("symmetry", fold.to_string());
        }
    }

    fn vertex(&mut self, Vertex { x, y, bulge }: Vertex) {
        // Writing to a string cannot fail. A bulge of −0 is distinguished from 0, so that it is read back unchanged.
        let _ = if bulge.to_bits() == 0 {
            writeln!(self.0, "    [{x:?}, {y:?}],")
        } else {
            writeln!(self.0, "    [{x:?}, {y:?}, {bulge:?}],")
        };
    }

    fn joint(&mut self, entry: &JointEntry, mechanism: &Mechanism) {
        let (a, b) = entry.parts;
        let (kind, along, at) = match entry.joint {
            Joint::Revolute { at } => ("revolute", None, Some(at)),
            Joint::Prismatic { direction, at } => ("prismatic", Some(direction), Some(at)),
            Joint::Rigid => ("rigid", None, None),
        };
        self.0.push_str("\n[[joint]]\n");
        self.line("type", text(kind));
        let names = format!("[{}, {}]", name_of(mechanism, a), name_of(mechanism, b));
        self.line("parts", names);
        if let Some(along) = along {
            self.line("direction", vector(along));
        }
        if let Some(at) = at {
            self.line("at", point(at));
        }
    }

    fn pair(&mut self, pair: &PairEntry, mechanism: &Mechanism) {
        self.0.push_str("\n[[pair]]\n");
        self.line("fixed", name_of(mechanism, pair.fixed));
        self.line("moving", name_of(mechanism, pair.moving));
        if let Some(window) = pair.window {
            self.line("theta", two(window));
        }
    }
}

fn motion(axis: &Axis) -> String {
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
