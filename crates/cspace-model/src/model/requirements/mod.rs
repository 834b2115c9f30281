//! Requirements of a design: `[[requirement]]`.

mod motion;
mod pair;
mod quantity;
mod space;

use std::collections::HashMap;

use crate::mechanism::Mechanism;

pub use quantity::{
    Coordinate, Dimension, Happening, MotionQuantity, Quantity, Requirement, Subject, Target,
};

use self::motion::read_motion;
use self::pair::read_pair;
use super::error::ModelError;
use super::node::Node;
use super::place::Place;
use super::suggest::nearest;
use super::table::{Result, Table};
use crate::shown::quoted;

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
    const KEYS: [&str; 15] = [
        "name", "pair", "measure", "of", "at", "along", "to", "end", "time", "event", "number",
        "part", "by", "limits", "equals",
    ];
    const HELP: &str = "a requirement is a table with keys such as name = \"play\", measure = \"play\" and limits = [0, 0.1]";
    let table = Table::new(node, place, &KEYS, HELP)?;
    let name = (table.text("name")?).ok_or_else(|| table.missing("name", "name = \"play\""))?;
    if name.trim().is_empty() {
        let error = table.error("name", "the name is empty");
        return Err(error.with_help("give every requirement a name, such as name = \"play\""));
    }
    let kind =
        (table.text("measure")?).ok_or_else(|| table.missing("measure", "measure = \"play\""))?;
    let takes: &[&str] = match kind {
        "play" => &["pair", "of", "at"],
        "position" => &["pair", "along", "at", "of"],
        "clearance" | "caged" => &["pair", "at"],
        "angle" => &["pair", "of", "at", "along"],
        "extreme" => &["pair", "of", "at", "end"],
        "connected" | "bottleneck" => &["pair", "to", "at"],
        "event" => &["time", "event", "pair", "number"],
        "stroke" => &["time", "part", "of"],
        "ratio" => &["time", "part", "by"],
        other => {
            let error = table.error("measure", format!("unknown measure {}", quoted(other)));
            return Err(error.with_help(match nearest(other, Subject::NAMES) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => format!("the measures are {}", Subject::NAMES.join(", ")),
            }));
        }
    };
    for key in &KEYS[..KEYS.len() - 2] {
        if !["name", "measure"].contains(key) && table.get(key).is_some() && !takes.contains(key) {
            let error = ModelError::new(
                &table.place.key(key).itself(),
                format!("`{key}` is given of the measure {kind}"),
            );
            return Err(error.with_help(format!("remove `{key}`")));
        }
    }
    let (subject, dimension) = match kind {
        "event" | "stroke" | "ratio" => read_motion(&table, kind, mechanism)?,
        _ => read_pair(&table, kind, mechanism)?,
    };
    Ok(Requirement {
        name: name.to_owned(),
        subject,
        dimension,
        target: target(&table, kind, dimension)?,
    })
}

fn target(table: &Table<'_>, kind: &str, dimension: Dimension) -> Result<Option<Target>> {
    let yes_or_no = dimension == Dimension::Truth;
    let (wrong, right) = if yes_or_no {
        ("limits", "equals = true")
    } else {
        ("equals", "limits = [0, 0.1]")
    };
    if table.get(wrong).is_some() {
        let message = format!("`{wrong}` is given of the measure {kind}");
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
        .interval("limits", dimension == Dimension::Angle)?
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
