//! Requirements of a design: `[[requirement]]`.

mod motion;
mod pair;
mod quantity;
mod space;

use std::collections::HashMap;

use crate::mechanism::Mechanism;

pub use quantity::{
    Coordinate, Dimension, Happening, MotionQuantity, OverRanges, Quantity, Requirement, Subject,
    Target,
};

use self::motion::read_motion;
use self::pair::read_pair;
pub(super) use self::pair::two_parts;
pub(super) use self::space::{AXES, PLANAR};
use super::keys::{Key, Keys, Kind, Kinds};
use super::scope::Result;
use super::table::Table;
use crate::shown::quoted;

#[rustfmt::skip]
pub(super) const REQUIREMENT: Keys = Keys {
    kinds: Some(Kinds {
        what: "measure",
        key: "measure",
        default: None,
        all: &[
            Kind { name: "play", needs: &["of"], takes: &["pair", "at", "limits"] },
            Kind { name: "position", needs: &["along"], takes: &["pair", "at", "of", "limits"] },
            Kind { name: "clearance", needs: &[], takes: &["pair", "at", "over", "limits"] },
            Kind { name: "angle", needs: &["of"], takes: &["pair", "at", "along", "limits"] },
            Kind { name: "bottleneck", needs: &["to"], takes: &["pair", "at", "limits"] },
            Kind { name: "extreme", needs: &["of"], takes: &["pair", "at", "end", "limits"] },
            Kind { name: "caged", needs: &[], takes: &["pair", "at", "equals"] },
            Kind { name: "connected", needs: &["to"], takes: &["pair", "at", "equals"] },
            Kind { name: "reaches", needs: &["of"], takes: &["pair", "at", "equals"] },
            Kind { name: "follows", needs: &["of"], takes: &["pair", "at", "limits", "equals"] },
            Kind { name: "backlash", needs: &["of"], takes: &["pair", "at", "limits"] },
            Kind { name: "fits", needs: &["within"], takes: &["pair", "at", "limits"] },
            Kind { name: "event", needs: &["time", "event"], takes: &["pair", "number", "limits"] },
            Kind { name: "stroke", needs: &["time", "part"], takes: &["of", "limits"] },
            Kind { name: "ratio", needs: &["time", "part", "by"], takes: &["limits"] },
        ],
    }),
    ..Keys::new(
    "a requirement is a table with keys such as name = \"play\", measure = \"play\" and limits = [0, 0.1]",
    &[
        Key::new("name", "part_name", "What it is called, unlike any other.").needed("name = \"play\""),
        Key::new("pair", "two_names", "The fixed and the moving part. Default: the model's only pair; of an event, any two parts.").like("pair = [\"fixed part\", \"moving part\"]"),
        Key::new("measure", "kind", "play: the whole range of a coordinate that is free around a configuration. position: a coordinate where a motion first touches. clearance: the distance of the parts; with `over`, the smallest over all motions that their ranges allow. angle: between the normal at a contact and the motion of its point, the pressure angle. bottleneck: the clearance of the widest motion to `to` where it is narrowest. extreme: how far a coordinate goes in the free region. caged: whether the free region ends everywhere. connected: whether a motion leads from `at` to `to`. reaches: whether a part on an axis comes to both ends of its range, or around, in the free region of `at`. follows: by how much one of two parts turns for each turn of the other, where neither can turn alone; with `equals`, whether that is so. backlash: the largest play of one over a turn of the other then. fits: the largest clearance of a configuration that is no farther from `at` than `within`, less than 0 where none is free. event: when something happens in the motion of the mechanism. stroke: from the smallest to the largest value of a part's coordinate in the motion. ratio: how far a part goes by how far another goes.").needed("measure = \"play\""),
        Key::new("of", "x|y|theta|u|v", "Of a play, position, angle or extreme: the coordinate, x, y or theta, or u or v of a pair on fixed axes. Of reaches, follows and backlash: u or v, of the part that comes to its ends, follows the other, or has play. Of the stroke of a part that moves in the plane: x, y or theta."),
        Key::new("at", "coordinates", "The configuration; coordinates left out are as drawn."),
        Key::new("over", "drawn|ranges", "Of a clearance: drawn, at the configuration `at`; or ranges, over all motions that the ranges of two parts on axes allow. Default: drawn."),
        Key::new("along", "configuration", "Of a position: the displacement of the motion from `at`, [dx, dy, dtheta] or [du, dv]."),
        Key::new("to", "configuration", "Of connected: where the motion leads, [x, y, theta] or [u, v]."),
        Key::new("within", "configuration", "Of fits: how far from `at` x, y and theta may be, [dx, dy, dtheta].").like("within = [1, 1, \"5deg\"]"),
        Key::new("end", "lower|upper", "Of an extreme: which end of the range of the coordinate."),
        Key::new("time", "positive", "Of an event, stroke or ratio: how long the motion is followed, in seconds.").like("time = 2, in seconds"),
        Key::new("event", "touch|release|impact|stick|slip|rest", "What happens: two parts come into lasting contact, are released, strike each other, begin or cease to slide, or their impacts are over.").like("event = \"touch\""),
        Key::new("number", "count", "Of an event: which of several, counted from 1. Default: 1."),
        Key::new("part", "part_name", "Of a stroke or ratio: the part.").like("part = \"name of a part\""),
        Key::new("by", "part_name", "Of a ratio: the part by whose motion it is.").like("by = \"name of a part\""),
        Key::new("limits", "limits", "The smallest and the largest value that is allowed; of a backlash, at every place of the turn. Default: none, the value is measured alone."),
        Key::new("equals", "bool", "Of caged, connected, reaches and follows: what is required."),
    ],
    )
};

/// The requirements of a file.
pub(super) fn read_requirements(
    root: &Table<'_>,
    mechanism: &Mechanism,
) -> Result<Vec<Requirement>> {
    let mut names: HashMap<String, usize> = HashMap::new();
    root.each("requirement", |i, mut value| {
        if let Some(name) = value.text_of("name") {
            value = value.called(format!("requirement {}", quoted(name)));
        }
        let table = Table::new(value, &REQUIREMENT)?;
        let requirement = read_requirement(&table, mechanism)?;
        match names.insert(requirement.name.clone(), i) {
            Some(first) => {
                let message = format!("the name is already that of requirement {first}");
                let help = "give every requirement a name of its own";
                Err(table.error("name", message).with_help(help))
            }
            None => Ok(requirement),
        }
    })
}

fn read_requirement(table: &Table<'_>, mechanism: &Mechanism) -> Result<Requirement> {
    let name = table.needed("name", table.text("name")?)?;
    if name.trim().is_empty() {
        let error = table.error("name", "the name is empty");
        return Err(error.with_help("give every requirement a name, such as name = \"play\""));
    }
    let kind = table.kind()?;
    if let Some(key) = table.other_than(kind) {
        let message = format!("`{key}` is given of the measure {}", kind.name);
        let help = match key {
            "limits" => "give equals = true".to_owned(),
            "equals" => "give limits = [0, 0.1]".to_owned(),
            _ => format!("remove `{key}`"),
        };
        return Err(table.error_at_key(key, message).with_help(help));
    }
    let (subject, dimension) = match kind.name {
        "event" | "stroke" | "ratio" => read_motion(table, kind.name, mechanism)?,
        _ => read_pair(table, kind.name, mechanism)?,
    };
    Ok(Requirement {
        name: name.to_owned(),
        subject,
        dimension,
        target: target(table, dimension)?,
    })
}

fn target(table: &Table<'_>, dimension: Dimension) -> Result<Option<Target>> {
    if dimension == Dimension::Truth {
        let wanted = table.flag("equals")?;
        return Ok(table.has("equals").then_some(Target::Equals(wanted)));
    }
    Ok(table
        .limits("limits", dimension == Dimension::Angle)?
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
