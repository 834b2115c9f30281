//! What a design must do: `[[requirement]]`.

use std::collections::HashMap;

use cspace::{Axis, AxisMotion, Configuration, Coordinates, Mechanism, PairEntry, Relation};

use super::error::ModelError;
use super::measure::{Measure, read_list};
use super::node::Node;
use super::place::Place;
use super::suggest::nearest;
use super::table::{Result, Table};
use crate::shown::quoted;

/// Something that a pair of parts is measured for, and what it must be.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirement {
    /// What it is called, unlike any other of the model.
    pub name: String,
    /// The pair, with the window of orientations that the model gives it.
    pub pair: PairEntry,
    /// What is measured.
    pub quantity: Quantity,
    /// Whether its value is an angle, in radians.
    pub is_angle: bool,
    /// What it must be, if anything.
    pub target: Option<Target>,
}

/// A coordinate of a pair's configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinate {
    /// The position of the moving part along the first axis of the fixed part's frame.
    X,
    /// Along the second axis.
    Y,
    /// The orientation, radians.
    Theta,
    /// The motion of the fixed part on its axis.
    U,
    /// The motion of the moving part on its axis.
    V,
}

impl Coordinate {
    const PLANAR: [(&'static str, Self); 3] =
        [("x", Self::X), ("y", Self::Y), ("theta", Self::Theta)];
    const AXES: [(&'static str, Self); 2] = [("u", Self::U), ("v", Self::V)];

    /// Its name in configurations.
    pub const fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Theta => "theta",
            Self::U => "u",
            Self::V => "v",
        }
    }

    /// Its number among those of its class: x, y and θ, or u and v.
    pub const fn index(self) -> usize {
        match self {
            Self::X | Self::U => 0,
            Self::Y | Self::V => 1,
            Self::Theta => 2,
        }
    }

    /// Gives it a value in a configuration; one in the coordinates of another class stays.
    pub fn put(self, at: &mut Coordinates, value: f64) {
        match (self, at) {
            (Self::X, Coordinates::Planar(c)) => c.x = value,
            (Self::Y, Coordinates::Planar(c)) => c.y = value,
            (Self::Theta, Coordinates::Planar(c)) => c.theta = value,
            (Self::U, Coordinates::Axes { u, .. }) => *u = value,
            (Self::V, Coordinates::Axes { v, .. }) => *v = value,
            _ => {}
        }
    }

    /// Its value in a configuration; `None` of one in the coordinates of another class.
    pub const fn of(self, at: Coordinates) -> Option<f64> {
        match (self, at) {
            (Self::X, Coordinates::Planar(c)) => Some(c.x),
            (Self::Y, Coordinates::Planar(c)) => Some(c.y),
            (Self::Theta, Coordinates::Planar(c)) => Some(c.theta),
            (Self::U, Coordinates::Axes { u, .. }) => Some(u),
            (Self::V, Coordinates::Axes { v, .. }) => Some(v),
            _ => None,
        }
    }
}

/// What a requirement measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// The length of the whole range of a coordinate that is free around a configuration, the others held.
    Play {
        /// The coordinate.
        of: Coordinate,
        /// The configuration.
        at: Coordinates,
    },
    /// The value of a coordinate where a motion of constant rates meets the first contact.
    Position {
        /// Where the motion begins.
        from: Coordinates,
        /// Its whole displacement.
        along: Coordinates,
        /// The coordinate.
        of: Coordinate,
    },
    /// The distance of the parts at a configuration.
    Clearance {
        /// The configuration.
        at: Coordinates,
    },
    /// The angle between the common normal of two features and the motion of the point where they touch when a coordinate changes:
    /// the pressure angle, 0 where the one pushes the other straight on.
    Angle {
        /// The configuration, at which the nearest features count.
        at: Coordinates,
        /// A displacement to a first contact, whose features count then.
        along: Option<Coordinates>,
        /// The coordinate.
        of: Coordinate,
    },
    /// The clearance of the widest motion from one configuration to another, where it is narrowest.
    Bottleneck {
        /// Where it begins.
        at: Coordinates,
        /// Where it ends.
        to: Coordinates,
    },
    /// The largest or the smallest value of a coordinate in the free region of a configuration.
    Extreme {
        /// The configuration.
        at: Coordinates,
        /// The coordinate.
        of: Coordinate,
        /// Whether it is the largest.
        upper: bool,
    },
    /// Whether the free region of a configuration ends everywhere.
    Caged {
        /// The configuration.
        at: Coordinates,
    },
    /// Whether a motion without overlap leads from one configuration to another.
    Connected {
        /// Where it begins.
        at: Coordinates,
        /// Where it ends.
        to: Coordinates,
    },
}

impl Quantity {
    /// The names of all of them.
    const NAMES: [&'static str; 8] = [
        "play",
        "position",
        "clearance",
        "angle",
        "bottleneck",
        "extreme",
        "caged",
        "connected",
    ];

    /// Whether its value is yes or no.
    pub const fn is_truth(&self) -> bool {
        matches!(self, Self::Caged { .. } | Self::Connected { .. })
    }

    /// The name in a model.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Play { .. } => "play",
            Self::Position { .. } => "position",
            Self::Clearance { .. } => "clearance",
            Self::Angle { .. } => "angle",
            Self::Bottleneck { .. } => "bottleneck",
            Self::Extreme { .. } => "extreme",
            Self::Caged { .. } => "caged",
            Self::Connected { .. } => "connected",
        }
    }
}

/// What a quantity must be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Target {
    /// From one limit to another, both included.
    Limits(f64, f64),
    /// True or false.
    Equals(bool),
}

/// The requirements in the values of a list.
pub(super) fn read_requirements(
    place: &Place,
    nodes: &[Node],
    mechanism: &Mechanism,
) -> Result<Vec<Requirement>> {
    let mut all: Vec<Requirement> = Vec::with_capacity(nodes.len());
    let mut names: HashMap<String, usize> = HashMap::new();
    for (i, node) in nodes.iter().enumerate() {
        let name = match node {
            Node::Table(entries) => match entries.get("name") {
                Some(Node::Text(name)) => format!("requirement {}", quoted(name)),
                _ => format!("requirement {i}"),
            },
            _ => format!("requirement {i}"),
        };
        let place = place.item(i).called(name);
        let requirement = read_requirement(place.clone(), node, mechanism)?;
        if let Some(first) = names.insert(requirement.name.clone(), i) {
            let message = format!("the name is already that of requirement {first}");
            return Err(ModelError::new(&place.key("name"), message)
                .with_help("give every requirement a name of its own"));
        }
        all.push(requirement);
    }
    Ok(all)
}

fn read_requirement(place: Place, node: &Node, mechanism: &Mechanism) -> Result<Requirement> {
    const KEYS: [&str; 10] = [
        "name", "pair", "measure", "of", "at", "along", "to", "end", "limits", "equals",
    ];
    const HELP: &str = "a requirement is a table with keys such as name = \"play\", measure = \"play\" and limits = [0, 0.1]";
    let table = Table::new(node, place, &KEYS, HELP)?;
    let name = (table.text("name")?).ok_or_else(|| table.missing("name", "name = \"play\""))?;
    if name.trim().is_empty() {
        let error = table.error("name", "the name is empty");
        return Err(error.with_help("give every requirement a name, such as name = \"play\""));
    }
    let pair = pair_of(&table, mechanism)?;
    let kind =
        (table.text("measure")?).ok_or_else(|| table.missing("measure", "measure = \"play\""))?;
    let (needs, takes): (&[&str], &[&str]) = match kind {
        "play" => (&["of"], &["at"]),
        "position" => (&["along"], &["at", "of"]),
        "clearance" | "caged" => (&[], &["at"]),
        "angle" => (&["of"], &["at", "along"]),
        "extreme" => (&["of"], &["at", "end"]),
        "connected" | "bottleneck" => (&["to"], &["at"]),
        other => {
            let error = table.error("measure", format!("unknown measure {}", quoted(other)));
            return Err(error.with_help(match nearest(other, Quantity::NAMES) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => format!("the measures are {}", Quantity::NAMES.join(", ")),
            }));
        }
    };
    for key in ["of", "at", "along", "to", "end"] {
        if table.get(key).is_some() && !needs.contains(&key) && !takes.contains(&key) {
            let error = ModelError::new(
                &table.place.key(key).itself(),
                format!("`{key}` is given of the measure {kind}"),
            );
            return Err(error.with_help(format!("remove `{key}`")));
        }
    }
    let space = Space::of(mechanism, &pair, &table)?;
    let at = space.configuration(&table)?;
    let vector = |key: &str| {
        let given = table
            .get(key)
            .ok_or_else(|| table.missing(key, &format!("{key} = {}", space.example())))?;
        space.list(&table.place.key(key), key, given)
    };
    let needed = || {
        let of = space.coordinate(&table)?;
        of.ok_or_else(|| table.missing("of", &format!("of = \"{}\"", space.names()[0].0)))
    };
    let quantity = match kind {
        "play" => Quantity::Play { of: needed()?, at },
        "angle" => Quantity::Angle {
            at,
            along: table.get("along").map(|_| vector("along")).transpose()?,
            of: needed()?,
        },
        "extreme" => Quantity::Extreme {
            at,
            of: needed()?,
            upper: is_upper(&table, &space)?,
        },
        "bottleneck" => Quantity::Bottleneck {
            at,
            to: vector("to")?,
        },
        "position" => {
            let along = vector("along")?;
            let changed: Vec<Coordinate> = (space.names().iter())
                .map(|n| n.1)
                .filter(|c| c.of(along).is_some_and(|d| d != 0.0))
                .collect();
            let of = match (space.coordinate(&table)?, &changed[..]) {
                (_, []) => {
                    let error = table.error("along", "the motion goes nowhere");
                    return Err(error.with_help("give a displacement that is not 0"));
                }
                (Some(of), _) => of,
                (None, [one]) => *one,
                (None, several) => {
                    let names: Vec<&str> = several.iter().map(|c| c.name()).collect();
                    let message = format!("the motion changes {}", names.join(", "));
                    return Err(table
                        .error("along", message)
                        .with_help(format!("say which is measured: of = \"{}\"", names[0])));
                }
            };
            Quantity::Position {
                from: at,
                along,
                of,
            }
        }
        "clearance" => Quantity::Clearance { at },
        "caged" => Quantity::Caged { at },
        _ => Quantity::Connected {
            at,
            to: vector("to")?,
        },
    };
    let is_angle = match quantity {
        Quantity::Play { of, .. }
        | Quantity::Position { of, .. }
        | Quantity::Extreme { of, .. } => space.measure(of) == Measure::Angle,
        Quantity::Angle { .. } => true,
        _ => false,
    };
    Ok(Requirement {
        name: name.to_owned(),
        pair,
        quantity,
        is_angle,
        target: target(&table, &quantity, is_angle)?,
    })
}

/// Which end of the range of a coordinate the key `end` names: the upper if it is left out.
fn is_upper(table: &Table<'_>, space: &Space) -> Result<bool> {
    if matches!(space, Space::Planar) {
        let error = table.error(
            "measure",
            "the pair moves in x, y and theta, of whose regions no extremes are known",
        );
        return Err(error.with_help("measure the play, or the position where a motion touches"));
    }
    match table.text("end")? {
        None | Some("upper") => Ok(true),
        Some("lower") => Ok(false),
        Some(other) => Err(table
            .error("end", format!("unknown end {}", quoted(other)))
            .with_help("give end = \"lower\" or end = \"upper\"")),
    }
}

/// The pair that is named, or the model's only one.
fn pair_of(table: &Table<'_>, mechanism: &Mechanism) -> Result<PairEntry> {
    const HELP: &str = "give it as pair = [\"fixed part\", \"moving part\"]";
    let Some(names) = table.list("pair", HELP)? else {
        return match mechanism.pairs[..] {
            [pair] => Ok(pair),
            _ => Err(table.missing("pair", "pair = [\"fixed part\", \"moving part\"]")),
        };
    };
    let [Node::Text(fixed), Node::Text(moving)] = names else {
        return Err(table
            .error("pair", "the pair is not the names of two parts")
            .with_help(HELP));
    };
    let part = |i: usize, name: &str| {
        let place = table.place.key("pair").item(i);
        super::relations::part_index(&place, name, &mechanism.parts)
    };
    let (fixed, moving) = (part(0, fixed)?, part(1, moving)?);
    if fixed == moving {
        return Err(table
            .error("pair", "a part is paired with itself")
            .with_help("name two different parts"));
    }
    let listed = mechanism
        .pairs
        .iter()
        .find(|p| (p.fixed, p.moving) == (fixed, moving));
    Ok(PairEntry {
        fixed,
        moving,
        window: listed.and_then(|p| p.window),
    })
}

/// The coordinates of a pair.
enum Space {
    Planar,
    Axes([Axis; 2]),
}

impl Space {
    fn of(mechanism: &Mechanism, pair: &PairEntry, table: &Table<'_>) -> Result<Self> {
        match mechanism.relation(pair) {
            Relation::Planar => Ok(Self::Planar),
            Relation::Axes { fixed, moving } => Ok(Self::Axes([fixed, moving])),
            Relation::Joint(..) => Err(table
                .error("pair", "a joint connects the parts, which never part")
                .with_help("name a pair that meets by contact")),
        }
    }

    fn names(&self) -> &'static [(&'static str, Coordinate)] {
        match self {
            Self::Planar => &Coordinate::PLANAR,
            Self::Axes(_) => &Coordinate::AXES,
        }
    }

    fn example(&self) -> &'static str {
        match self {
            Self::Planar => "[0, -10, 0]",
            Self::Axes(_) => "[0, -10]",
        }
    }

    fn measure(&self, of: Coordinate) -> Measure {
        match (self, of) {
            (Self::Axes([fixed, _]), Coordinate::U) => Measure::along(fixed),
            (Self::Axes([_, moving]), Coordinate::V) => Measure::along(moving),
            (_, Coordinate::Theta) => Measure::Angle,
            _ => Measure::Number,
        }
    }

    fn at(&self, value: impl Fn(Coordinate) -> f64) -> Coordinates {
        match self {
            Self::Planar => Coordinates::Planar(Configuration::new(
                value(Coordinate::X),
                value(Coordinate::Y),
                value(Coordinate::Theta),
            )),
            Self::Axes(_) => Coordinates::Axes {
                u: value(Coordinate::U),
                v: value(Coordinate::V),
            },
        }
    }

    /// The configuration in the table `at`; coordinates that it leaves out are as drawn.
    fn configuration(&self, table: &Table<'_>) -> Result<Coordinates> {
        let Some(node) = table.get("at") else {
            return Ok(self.at(|_| 0.0));
        };
        let names: Vec<&str> = self.names().iter().map(|n| n.0).collect();
        let help = format!(
            "give the coordinates {}, such as at = {{ {} = 0 }}",
            names.join(", "),
            names[0]
        );
        let at = Table::new(node, table.place.key("at"), &names, &help)?;
        let mut values = HashMap::new();
        for &(name, of) in self.names() {
            if let Some(node) = at.get(name) {
                values.insert(
                    name,
                    self.measure(of).read(&at.place.key(name), name, node)?,
                );
            }
        }
        Ok(self.at(|of| values.get(of.name()).copied().unwrap_or(0.0)))
    }

    /// All coordinates of a list.
    fn list(&self, place: &Place, key: &str, node: &Node) -> Result<Coordinates> {
        let measures: Vec<Measure> = self.names().iter().map(|n| self.measure(n.1)).collect();
        let help = format!("give it as {key} = {}", self.example());
        match *measures {
            [u, v] => {
                let [u, v] = read_list(place, key, node, [u, v], &help)?;
                Ok(Coordinates::Axes { u, v })
            }
            _ => {
                let measures = [Measure::Number, Measure::Number, Measure::Angle];
                let [x, y, theta] = read_list(place, key, node, measures, &help)?;
                Ok(Coordinates::Planar(Configuration::new(x, y, theta)))
            }
        }
    }

    fn coordinate(&self, table: &Table<'_>) -> Result<Option<Coordinate>> {
        let Some(text) = table.text("of")? else {
            return Ok(None);
        };
        let names: Vec<&str> = self.names().iter().map(|n| n.0).collect();
        let Some(&(_, of)) = self.names().iter().find(|n| n.0 == text) else {
            let error = table.error("of", format!("the pair has no coordinate {}", quoted(text)));
            return Err(error.with_help(format!("its coordinates are {}", names.join(", "))));
        };
        let is_fixed = |axis: &Axis| matches!(axis.motion, AxisMotion::Fixed);
        if let Self::Axes([fixed, moving]) = self
            && is_fixed(if of == Coordinate::U { fixed } else { moving })
        {
            let error = table.error(
                "of",
                format!("the part of the coordinate {text} does not move"),
            );
            return Err(error.with_help("name the coordinate of the other part"));
        }
        Ok(Some(of))
    }
}

fn target(table: &Table<'_>, quantity: &Quantity, angles: bool) -> Result<Option<Target>> {
    let yes_or_no = quantity.is_truth();
    let (wrong, right) = if yes_or_no {
        ("limits", "equals = true")
    } else {
        ("equals", "limits = [0, 0.1]")
    };
    if table.get(wrong).is_some() {
        let message = format!("`{wrong}` is given of the measure {}", quantity.name());
        let error = ModelError::new(&table.place.key(wrong).itself(), message);
        return Err(error.with_help(format!("give {right}")));
    }
    if yes_or_no {
        return match table.get("equals") {
            None => Ok(None),
            Some(_) => Ok(Some(Target::Equals(table.flag("equals")?))),
        };
    }
    Ok(table
        .interval("limits", angles)?
        .map(|(lo, hi)| Target::Limits(lo, hi)))
}

#[cfg(test)]
mod tests {
    use crate::{Document, Host, read_from_hosted};

    const MODEL: &str = r#"
[[part]]
name = "cam"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 2, at = [1, 0] }]

[[part]]
name = "tappet"
motion = { type = "prismatic", direction = [0, 1] }
loops = [{ circle = 1, at = [0, 9] }]

[[requirement]]
name = "lift"
pair = ["cam", "tappet"]
measure = "position"
at = { u = "30deg" }
along = [0, -9]
limits = [-9, 0]
"#;

    #[test]
    fn what_is_wrong_is_told_where_it_is() {
        let read = |text: &str| read_from_hosted(text.as_bytes(), "m.toml", &Host::default());
        assert!(matches!(read(MODEL), Ok(Document::Model(m)) if m.requirements.len() == 1));
        for (from, to, expected, help) in [
            (
                "\"position\"",
                "\"positoin\"",
                "m.toml:15:11: requirement \"lift\": unknown measure \"positoin\"",
                "did you mean `position`?",
            ),
            (
                "u = \"30deg\"",
                "x = 1",
                "m.toml:16:8: requirement \"lift\": unknown key \"x\"",
                "did you mean",
            ),
            (
                "along = [0, -9]",
                "along = [0, 0]",
                "m.toml:17:9: requirement \"lift\": the motion goes nowhere",
                "not 0",
            ),
            (
                "along = [0, -9]",
                "along = [1, -9]",
                "the motion changes u, v",
                "of = \"u\"",
            ),
            (
                "along = [0, -9]",
                "along = [0, -9, 0]",
                "where a list of 2 numbers",
                "along = [0, -10]",
            ),
            (
                "along = [0, -9]",
                "along = [0, \"-9 +\"]",
                "m.toml:17:18: requirement \"lift\": in \"-9 +\": the expression ends",
                "add a number",
            ),
            (
                "[-9, 0]",
                "[0, -9]",
                "empty or reversed",
                "smaller bound first",
            ),
            (
                "limits = [-9, 0]",
                "equals = true",
                "`equals` is given of the measure position",
                "limits",
            ),
            (
                "[\"cam\", \"tappet\"]",
                "[\"cam\", \"tapet\"]",
                "m.toml:14:16: requirement \"lift\"",
                "did you mean `tappet`?",
            ),
            (
                "along = [0, -9]",
                "along = [0, -9]\nof = \"y\"",
                "no coordinate \"y\"",
                "u, v",
            ),
        ] {
            assert!(MODEL.contains(from), "{from}");
            let Err(e) = read(&MODEL.replacen(from, to, 1)) else {
                panic!("{to} was read");
            };
            assert!(e.to_string().contains(expected), "{e}");
            assert!(
                e.help().unwrap_or_default().contains(help),
                "{e}: {:?}",
                e.help()
            );
        }
    }
}
