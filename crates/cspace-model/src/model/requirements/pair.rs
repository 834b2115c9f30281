//! Requirements on the configuration space of a pair.

use crate::mechanism::{Mechanism, PairEntry};

use super::quantity::{Coordinate, Dimension, OverRanges, Quantity, Subject};
use super::space::Space;
use crate::model::measure::Measure;
use crate::model::node::Node;
use crate::model::relations::part_index;
use crate::model::scope::Result;
use crate::model::table::Table;

/// The quantity of a kind.
pub(super) fn read_pair(
    table: &Table<'_>,
    kind: &str,
    mechanism: &Mechanism,
) -> Result<(Subject, Dimension)> {
    let pair = pair_of(table, mechanism)?;
    let space = Space::of(mechanism, &pair, table)?;
    let at = space.configuration(table)?;
    let vector = |key: &str| {
        let missing = || table.missing_as(key, &format!("{key} = {}", space.example()));
        space.list(key, &table.get(key).ok_or_else(missing)?)
    };
    let needed = || {
        let of = space.coordinate(table)?;
        of.ok_or_else(|| table.missing_as("of", &format!("of = \"{}\"", space.names()[0].0)))
    };
    let quantity = match kind {
        "play" => Quantity::Play { of: needed()?, at },
        "angle" => Quantity::Angle {
            at,
            along: table.has("along").then(|| vector("along")).transpose()?,
            of: needed()?,
        },
        "extreme" => Quantity::Extreme {
            at,
            of: needed()?,
            upper: is_upper(table, &space)?,
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
            let of = match (space.coordinate(table)?, &changed[..]) {
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
        "clearance" if is_over_ranges(table)? => {
            space.must_have_axes(table, kind)?;
            let what = OverRanges::Clearance;
            Quantity::Ranges { what, at }
        }
        "clearance" => Quantity::Clearance { at },
        "fits" => {
            let Space::Planar = space else {
                let message = "the pair moves on axes, and not in x, y and theta";
                let help = "measure its clearance with over = \"ranges\"";
                return Err(table.error("measure", message).with_help(help));
            };
            let box_of = vector("within")?;
            let within = Coordinate::PLANAR.map(|(_, c)| c.of(box_of).unwrap_or(0.0));
            if within.iter().any(|&d| d < 0.0) {
                let error = table.error("within", "a box does not extend by less than 0");
                return Err(error.with_help("give how far x, y and theta may be from `at`"));
            }
            Quantity::Fits { at, within }
        }
        "reaches" | "follows" | "backlash" => {
            space.must_have_axes(table, kind)?;
            if kind != "reaches" {
                space.must_turn(table, kind)?;
            }
            let of = needed()?;
            let what = match kind {
                "reaches" => OverRanges::Reaches(of),
                "backlash" => OverRanges::Backlash(of),
                _ if is_truth_asked(table)? => OverRanges::Together,
                _ => OverRanges::Follows(of),
            };
            Quantity::Ranges { what, at }
        }
        "caged" => Quantity::Caged { at },
        _ => Quantity::Connected {
            at,
            to: vector("to")?,
        },
    };
    let dimension = match quantity {
        Quantity::Play { of, .. }
        | Quantity::Position { of, .. }
        | Quantity::Extreme { of, .. } => match space.measure(of) {
            Measure::Angle | Measure::AngleRate => Dimension::Angle,
            Measure::Number => Dimension::Length,
        },
        Quantity::Angle { .. } => Dimension::Angle,
        Quantity::Clearance { .. } | Quantity::Bottleneck { .. } | Quantity::Fits { .. } => {
            Dimension::Length
        }
        Quantity::Caged { .. } | Quantity::Connected { .. } => Dimension::Truth,
        Quantity::Ranges { what, .. } => match what {
            OverRanges::Clearance => Dimension::Length,
            OverRanges::Reaches(_) | OverRanges::Together => Dimension::Truth,
            OverRanges::Follows(_) => Dimension::Number,
            OverRanges::Backlash(_) => Dimension::Angle,
        },
    };
    Ok((Subject::Pair(pair, quantity), dimension))
}

/// Whether a clearance is over the ranges of the parts, and not at one configuration.
fn is_over_ranges(table: &Table<'_>) -> Result<bool> {
    let all = [("drawn", false), ("ranges", true)];
    let help = "give over = \"ranges\", or leave `over` out for the clearance at `at`";
    let over = table.choice("over", "extent", &all, help)?;
    Ok(over.unwrap_or(false))
}

/// Whether `follows` asks for yes or no, and not for a ratio.
fn is_truth_asked(table: &Table<'_>) -> Result<bool> {
    if table.has("equals") && table.has("limits") {
        let error = table.error_at_key("equals", "`equals` is given beside `limits`");
        return Err(error.with_help("give limits of the ratio, or whether there must be one"));
    }
    Ok(table.has("equals"))
}

/// Whether the key `end` names the upper end of a coordinate's range, which is the default.
fn is_upper(table: &Table<'_>, space: &Space) -> Result<bool> {
    if matches!(space, Space::Planar) {
        let error = table.error(
            "measure",
            "the pair moves in x, y and theta, of whose regions no extremes are known",
        );
        return Err(error.with_help("measure the play, or the position where a motion touches"));
    }
    let ends = [("upper", true), ("lower", false)];
    let help = "give end = \"lower\" or end = \"upper\"";
    Ok(table.choice("end", "end", &ends, help)?.unwrap_or(true))
}

/// The pair that is named, or the model's only one.
fn pair_of(table: &Table<'_>, mechanism: &Mechanism) -> Result<PairEntry> {
    let Some([fixed, moving]) = two_parts(table, mechanism)? else {
        return match mechanism.pairs[..] {
            [pair] => Ok(pair),
            _ => Err(table.missing("pair")),
        };
    };
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

/// The two parts that are named as the pair, if they are.
pub(in crate::model) fn two_parts(
    table: &Table<'_>,
    mechanism: &Mechanism,
) -> Result<Option<[usize; 2]>> {
    const HELP: &str = "give it as pair = [\"fixed part\", \"moving part\"]";
    let Some(names) = table.nodes("pair", HELP)? else {
        return Ok(None);
    };
    let [Node::Text(fixed), Node::Text(moving)] = names else {
        return Err(table
            .error("pair", "the pair is not the names of two parts")
            .with_help(HELP));
    };
    let part = |i: usize, name: &str| {
        let place = table.place.key("pair").item(i);
        part_index(&place, name, &mechanism.parts)
    };
    let (fixed, moving) = (part(0, fixed)?, part(1, moving)?);
    if fixed == moving {
        return Err(table
            .error("pair", "a part is paired with itself")
            .with_help("name two different parts"));
    }
    Ok(Some([fixed, moving]))
}
