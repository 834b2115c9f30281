//! The answer of `cspace modes`, as data and as text.

use std::fmt::{self, Write};

use cspace::AxisMotion;
use cspace_model::{Mechanism, shown};
use cspace_plan::modes::{Mode, ModePlace, Modes, PAIRS};
use serde::Serialize;

use super::ask::LETTERS;
use crate::command::regions::Coordinate;
use crate::wording::count;

/// The whole answer.
#[derive(Debug, Serialize)]
pub(crate) struct Answer {
    parts: Vec<Part>,
    pairs: Vec<Pair>,
    modes: Vec<Row>,
    requested: Requested,
    /// Pairs of the model with one of the three parts and another part, which are not considered.
    left_out: Vec<[String; 2]>,
    doubts: usize,
    seconds: f64,
}

#[derive(Debug, Serialize)]
struct Part {
    name: String,
    coordinate: &'static str,
    motion: &'static str,
    range: Option<[f64; 2]>,
}

#[derive(Debug, Serialize)]
struct Pair {
    fixed: String,
    moving: String,
    /// The coordinates that are the pair's u and v.
    coordinates: [&'static str; 2],
    /// Whether the model has the pair.
    listed: bool,
    patches: usize,
    free_regions: usize,
}

#[derive(Debug, Serialize)]
struct Row {
    u: Reach,
    v: Reach,
    w: Reach,
    turns: Vec<[i64; 3]>,
    sample: At,
}

/// The range of a coordinate within a mode; `null` for no limit.
#[derive(Debug, Serialize)]
struct Reach {
    lo: Option<f64>,
    hi: Option<f64>,
    /// Whether the part can turn for ever.
    around: bool,
}

#[derive(Debug, Clone, Copy, Serialize)]
struct At {
    u: f64,
    v: f64,
    w: f64,
}

#[derive(Debug, Serialize)]
struct Requested {
    at: At,
    result: &'static str,
    mode: Option<usize>,
    /// The parts that touch or overlap, or the one whose range it leaves.
    between: Vec<String>,
}

fn at([u, v, w]: [f64; 3]) -> At {
    At { u, v, w }
}

pub(crate) fn of(
    model: &Mechanism,
    modes: &Modes,
    (requested, place): ([f64; 3], ModePlace),
    seconds: f64,
) -> Answer {
    let names = modes.names();
    let part = |k: usize| {
        let axis = modes.axes()[k];
        Part {
            name: names[k].clone(),
            coordinate: LETTERS[k],
            motion: match axis.motion {
                AxisMotion::Prismatic { .. } => "prismatic",
                _ => "revolute",
            },
            range: axis.range.map(|(lo, hi)| [lo, hi]),
        }
    };
    let pairs = modes.pairs().iter().map(|pair| Pair {
        fixed: names[pair.coordinates[0]].clone(),
        moving: names[pair.coordinates[1]].clone(),
        coordinates: pair.coordinates.map(|c| LETTERS[c]),
        listed: pair.space.is_some(),
        patches: pair.space.as_ref().map_or(0, |s| s.patches().len()),
        free_regions: pair.space.as_ref().map_or(1, |s| s.regions().len()),
    });
    let both = |pair: usize| PAIRS[pair].map(|k| names[k].clone()).to_vec();
    let (result, mode, between) = match place {
        ModePlace::Mode(mode) => ("free", Some(mode), Vec::new()),
        ModePlace::Contact(pair) => ("contact", None, both(pair)),
        ModePlace::Blocked(pair) => ("blocked", None, both(pair)),
        ModePlace::Outside(k) => ("outside", None, vec![names[k].clone()]),
        ModePlace::Closed => ("closed", None, Vec::new()),
    };
    Answer {
        parts: (0..3).map(part).collect(),
        pairs: pairs.collect(),
        modes: modes.list().iter().map(row).collect(),
        requested: Requested {
            at: at(requested),
            result,
            mode,
            between,
        },
        left_out: left_out(model, modes.parts()),
        doubts: modes.doubts(),
        seconds,
    }
}

fn row(mode: &Mode) -> Row {
    let reach = |k: usize| Reach {
        lo: Some(mode.ranges[k].0).filter(|_| !mode.open[k].0 && !mode.around(k)),
        hi: Some(mode.ranges[k].1).filter(|_| !mode.open[k].1 && !mode.around(k)),
        around: mode.around(k),
    };
    Row {
        u: reach(0),
        v: reach(1),
        w: reach(2),
        turns: mode.turns.clone(),
        sample: at(mode.sample),
    }
}

fn left_out(model: &Mechanism, parts: [usize; 3]) -> Vec<[String; 2]> {
    let is_one = |part: usize| parts.contains(&part);
    let pairs = model
        .pairs
        .iter()
        .filter(|p| is_one(p.fixed) != is_one(p.moving));
    pairs
        .map(|p| [p.fixed, p.moving].map(|i| model.parts[i].part.name().to_owned()))
        .collect()
}

pub(super) fn text(
    model: &Mechanism,
    modes: &Modes,
    answer: &Answer,
) -> Result<String, fmt::Error> {
    let unit = (model.unit.as_deref()).map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let coordinates =
        [0, 1, 2].map(|k| Coordinate::new(LETTERS[k], &modes.names()[k], modes.axes()[k], &unit));
    let mut text = String::new();
    for pair in &answer.pairs {
        let (a, b) = (shown::text(&pair.fixed), shown::text(&pair.moving));
        let what = match (pair.listed, pair.patches) {
            (false, _) => "not a pair of the model: unconstrained".to_owned(),
            (true, 0) if pair.free_regions == 0 => {
                "the parts overlap in every configuration".to_owned()
            }
            (true, 0) => "the parts never meet".to_owned(),
            (true, n) => format!(
                "{}, {}",
                count(n, "contact patch", "contact patches"),
                count(pair.free_regions, "free region", "free regions")
            ),
        };
        writeln!(text, "{a}, {b}: {what}")?;
    }
    writeln!(text, "{}", count(answer.modes.len(), "mode", "modes"))?;
    for (k, mode) in modes.list().iter().enumerate() {
        writeln!(text, "mode {k}")?;
        for (i, c) in coordinates.iter().enumerate() {
            let range = c.range(mode.ranges[i], mode.open[i], mode.around(i));
            writeln!(text, "  {range}")?;
        }
        if !mode.turns.is_empty() {
            writeln!(text, "  comes back {}", comes_back(mode))?;
        }
        writeln!(
            text,
            "  for example at {}",
            values(&coordinates, mode.sample)
        )?;
    }
    let At { u, v, w } = answer.requested.at;
    let place = values(&coordinates, [u, v, w]);
    writeln!(text, "{place}: {}", requested(&answer.requested))?;
    if !answer.left_out.is_empty() {
        let pairs: Vec<String> = (answer.left_out.iter())
            .map(|[a, b]| format!("{} and {}", shown::text(a), shown::text(b)))
            .collect();
        writeln!(text, "not considered: {}", pairs.join(", "))?;
    }
    if answer.doubts > 0 {
        writeln!(
            text,
            "{}: contacts coincide but for rounding, so the modes are not to be relied upon",
            count(answer.doubts, "doubt", "doubts")
        )?;
    }
    Ok(text)
}

fn values(coordinates: &[Coordinate<'_>; 3], at: [f64; 3]) -> String {
    let values = coordinates.iter().zip(at).map(|(c, t)| c.value(t));
    values.collect::<Vec<_>>().join(", ")
}

fn comes_back(mode: &Mode) -> String {
    let one = |turns: &[i64; 3]| {
        let each = LETTERS.iter().zip(turns).filter(|(_, t)| **t != 0);
        let each: Vec<String> = each
            .map(|(letter, &t)| {
                let turns = if t.abs() == 1 { "turn" } else { "turns" };
                format!("{t} {turns} of {letter}")
            })
            .collect();
        each.join(" with ")
    };
    let all: Vec<String> = mode.turns.iter().map(one).collect();
    format!("after {}", all.join("; after "))
}

fn requested(requested: &Requested) -> String {
    let between: Vec<_> = requested.between.iter().map(|n| shown::text(n)).collect();
    let between = between.join(" and ");
    match (requested.result, requested.mode) {
        (_, Some(mode)) => format!("mode {mode}"),
        ("contact", _) => format!("in no mode: {between} touch"),
        ("blocked", _) => format!("in no mode: {between} overlap"),
        ("outside", _) => format!("in no mode: outside the range of {between}"),
        _ => "in no mode: there is no opening between contacts of several pairs".to_owned(),
    }
}
