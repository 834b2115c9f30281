//! Writing a model as TOML.

use std::fmt::Write as _;

use cspace::{Point, Vector, Vertex};

use super::mechanism::every_two;
use super::{Joint, JointKind, Model, Motion, Pair, PartEntry};

impl Model {
    /// The model as the text of a TOML file. Reading it gives the same model: numbers are written
    /// with as many digits as that takes, angles in radians.
    ///
    /// Pairs are left out when they are what a file without pairs stands for. A model that breaks
    /// the reader's rules, say by an index that is no part's (whose name is written as empty), a
    /// number that is not finite or a control character in a name, is written all the same, and
    /// refused when read.
    ///
    /// ```
    /// use cspace::{Part, Vertex};
    /// use cspace_io::{Model, Motion, PartEntry};
    /// let disc = vec![vec![Vertex::new(-1.0, 0.0, 1.0), Vertex::new(0.1, 0.0, 1.0)]];
    /// let model = Model {
    ///     name: "disc".into(),
    ///     unit: Some("mm".into()),
    ///     parts: vec![PartEntry {
    ///         part: Part::new("disc", disc)?,
    ///         motion: Motion::Planar,
    ///         symmetry: None,
    ///     }],
    ///     joints: vec![],
    ///     pairs: vec![],
    /// };
    /// assert_eq!(Model::from_toml(&model.to_toml(), "disc.toml")?, model);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_toml(&self) -> String {
        let mut out = Out(format!("name = {}\n", text(&self.name)));
        if let Some(unit) = &self.unit {
            out.line("unit", text(unit));
        }
        for part in &self.parts {
            out.part(part);
        }
        for joint in &self.joints {
            out.joint(joint, self);
        }
        if !(self.pairs.iter().copied()).eq(every_two(self.parts.len())) {
            for pair in &self.pairs {
                out.pair(pair, self);
            }
        }
        out.0
    }

    fn name_of(&self, part: usize) -> String {
        text(self.parts.get(part).map_or("", |p| p.part.name()))
    }
}

/// The text so far.
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
        if entry.motion != Motion::Planar {
            self.line("motion", motion(&entry.motion));
        }
        if let Some(fold) = entry.symmetry {
            self.line("symmetry", fold.to_string());
        }
    }

    fn vertex(&mut self, Vertex { x, y, bulge }: Vertex) {
        // Writing to a string cannot fail. A bulge of −0 is told from 0 to be read as it was.
        let _ = if bulge.to_bits() == 0 {
            writeln!(self.0, "    [{x:?}, {y:?}],")
        } else {
            writeln!(self.0, "    [{x:?}, {y:?}, {bulge:?}],")
        };
    }

    fn joint(&mut self, joint: &Joint, model: &Model) {
        let (a, b) = joint.parts;
        let (kind, along, at) = match joint.kind {
            JointKind::Revolute { at } => ("revolute", None, Some(at)),
            JointKind::Prismatic { direction, at } => ("prismatic", Some(direction), at),
            JointKind::Rigid => ("rigid", None, None),
        };
        self.0.push_str("\n[[joint]]\n");
        self.line("type", text(kind));
        let names = format!("[{}, {}]", model.name_of(a), model.name_of(b));
        self.line("parts", names);
        if let Some(along) = along {
            self.line("direction", vector(along));
        }
        if let Some(at) = at {
            self.line("at", point(at));
        }
    }

    fn pair(&mut self, pair: &Pair, model: &Model) {
        self.0.push_str("\n[[pair]]\n");
        self.line("fixed", model.name_of(pair.fixed));
        self.line("moving", model.name_of(pair.moving));
        if let Some(window) = pair.window {
            self.line("theta", two(window));
        }
    }
}

fn motion(motion: &Motion) -> String {
    let limits = |range: Option<(f64, f64)>| {
        range.map_or_else(String::new, |range| format!(", range = {}", two(range)))
    };
    match *motion {
        Motion::Fixed => r#"{ type = "fixed" }"#.into(),
        Motion::Planar => r#"{ type = "planar" }"#.into(),
        Motion::Revolute { center, range } => format!(
            r#"{{ type = "revolute", center = {}{} }}"#,
            point(center),
            limits(range)
        ),
        Motion::Prismatic { direction, range } => format!(
            r#"{{ type = "prismatic", direction = {}{} }}"#,
            vector(direction),
            limits(range)
        ),
    }
}

fn point(p: Point) -> String {
    two((p.x, p.y))
}

fn vector(v: Vector) -> String {
    two((v.x, v.y))
}

/// Debug prints the fewest digits that are read back as the same number, and a point or exponent.
fn two((a, b): (f64, f64)) -> String {
    format!("[{a:?}, {b:?}]")
}

/// A basic string of TOML: quotes, backslashes and control characters escaped.
fn text(value: &str) -> String {
    let mut out = String::from('"');
    for c in value.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
