//! Operating modes, as text.

use std::fmt::{self, Write};

use cspace_api::modes::{Is, OperatingModes, Requested};
use cspace_model::shown;
use cspace_plan::modes::{TreeMode, coordinate_name};

use crate::command::regions::Coordinate;
use crate::wording::count;

pub(super) fn describe(
    text: &mut String,
    unit: Option<&str>,
    answer: &OperatingModes,
) -> fmt::Result {
    let unit = unit.map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let modes = &answer.found;
    let letters: Vec<String> = (0..modes.axes().len()).map(coordinate_name).collect();
    let coordinates: Vec<Coordinate<'_>> = (letters.iter().enumerate())
        .map(|(k, name)| Coordinate::new(name, &modes.names()[k], modes.axes()[k], &unit))
        .collect();
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
    let all = match letters.len() {
        3 => "the three",
        _ => "all these parts",
    };
    match answer.modes.len() {
        0 => writeln!(text, "blocked: no configuration of {all} is free")?,
        n => writeln!(text, "{}", count(n, "mode", "modes"))?,
    }
    for (k, mode) in modes.list().iter().enumerate() {
        writeln!(text, "mode {k}")?;
        for (i, c) in coordinates.iter().enumerate() {
            let range = c.range(mode.ranges[i], mode.open[i], mode.around(i));
            writeln!(text, "  {range}")?;
        }
        if !mode.turns.is_empty() {
            writeln!(text, "  comes back {}", comes_back(mode, &letters))?;
        }
        writeln!(
            text,
            "  for example at {}",
            values(&coordinates, &mode.sample)
        )?;
    }
    let place = values(&coordinates, &answer.requested.at.all());
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
    Ok(())
}

fn values(coordinates: &[Coordinate<'_>], at: &[f64]) -> String {
    let values = coordinates.iter().zip(at).map(|(c, &t)| c.value(t));
    values.collect::<Vec<_>>().join(", ")
}

fn comes_back(mode: &TreeMode, letters: &[String]) -> String {
    let one = |turns: &Vec<i64>| {
        let each = letters.iter().zip(turns).filter(|(_, t)| **t != 0);
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
        (Is::Contact, _) => format!("in no mode: {between} touch"),
        (Is::Blocked, _) => format!("in no mode: {between} overlap"),
        (Is::Outside, _) => format!("in no mode: outside the range of {between}"),
        _ => "in no mode: there is no opening between contacts of several pairs".to_owned(),
    }
}
