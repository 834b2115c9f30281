//! How an assembly comes apart, as text.

use std::fmt::{self, Write};

use cspace::Coordinates;
use cspace_api::disassemble::{Disassembly, Locked, Outcome, Step, Tree};
use cspace_model::{Mechanism, shown};
use cspace_plan::assembly::{Kind, PartFeature, Tried};

use crate::subject::placed;
use crate::wording::{about_point, count, degrees, length};

pub(super) fn describe(text: &mut String, model: &Mechanism, found: &Disassembly) -> fmt::Result {
    let unit = (model.unit.as_deref()).map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let steps = count(found.steps.len(), "step", "steps");
    match found.verdict {
        Outcome::Apart => writeln!(text, "apart: {steps}")?,
        Outcome::Locked => writeln!(
            text,
            "locked: some parts stay together however the others move, after {steps}"
        )?,
        Outcome::Unknown => writeln!(
            text,
            "unknown: no way was found to take all apart, and none is excluded, {steps}"
        )?,
    }
    if let Some(Tried { aside, places }) = found.tried.filter(|_| found.verdict != Outcome::Apart) {
        let places = count(places, "place", "places");
        writeln!(text, "tried: at most {aside} parts moved aside, {places}")?;
    }
    writeln!(text, "gap {}{unit}", length(found.gap))?;
    writeln!(text, "{}", list(&found.tree.parts))?;
    branches(text, &found.tree, &found.steps, 1)?;
    for (i, step) in found.steps.iter().enumerate() {
        describe_step(text, &unit, i + 1, step)?;
    }
    match &found.locked {
        Some(locked) => describe_locked(text, model, locked, found.verdict),
        None => Ok(()),
    }
}

fn list(names: &[String]) -> String {
    shown::text(&names.join(", ")).into_owned()
}

/// Prints the tree with the numbers of the steps; groups that are taken apart further are indented more.
fn branches(text: &mut String, tree: &Tree, steps: &[Step], depth: usize) -> fmt::Result {
    let indent = "  ".repeat(depth);
    for branch in &tree.out {
        let Some(step) = steps.get(branch.step) else {
            continue;
        };
        for (i, room) in (branch.room.iter()).filter_map(|&i| Some((i, steps.get(i)?))) {
            let (parts, does) = (list(&room.moving), room.words.join(", "));
            writeln!(text, "{indent}{}. {parts} {does} (makes room)", i + 1)?;
        }
        writeln!(text, "{indent}{}. {}", branch.step + 1, list(&step.moving))?;
        if let Some(tree) = &branch.tree {
            branches(text, tree, steps, depth + 2)?;
        }
    }
    writeln!(text, "{indent}left: {}", list(&tree.left))
}

fn describe_step(text: &mut String, unit: &str, number: usize, step: &Step) -> fmt::Result {
    let (moving, staying) = (list(&step.moving), list(&step.staying));
    let clearance = step.clearance.map(length);
    let clearance = clearance.map_or(String::new(), |c| format!(", clearance {c}{unit}"));
    match step.kind {
        Kind::Leaves => writeln!(text, "{number}. {moving} out of {staying}{clearance}")?,
        Kind::Moves => writeln!(
            text,
            "{number}. {moving} makes room, {staying} stay{clearance}"
        )?,
    }
    for (i, at) in step.path.iter().enumerate() {
        if let Some(words) = i.checked_sub(1).and_then(|i| step.words.get(i)) {
            writeln!(text, "  {words}")?;
        }
        if let Coordinates::Planar(c) = at {
            let (x, y, theta) = (length(c.x), length(c.y), degrees(c.theta));
            writeln!(text, "    x {x}, y {y}{unit}, theta {theta}")?;
        }
    }
    if let Some(point) = about_point(&step.path, step.about, unit) {
        writeln!(text, "  legs are about the point {point}")?;
    }
    Ok(())
}

fn describe_locked(
    text: &mut String,
    model: &Mechanism,
    locked: &Locked,
    verdict: Outcome,
) -> fmt::Result {
    /// Maximum number of pairs of features that are listed.
    const MOST: usize = 12;
    match verdict {
        Outcome::Locked => writeln!(text, "lock each other: {}", list(&locked.parts))?,
        _ => writeln!(
            text,
            "none leaves while the others stay: {}",
            list(&locked.parts)
        )?,
    }
    for why in &locked.why {
        writeln!(
            text,
            "  {} cannot leave {}: enclosed by {}",
            list(&why.moving),
            list(&why.staying),
            count(why.patches, "contact patch", "contact patches")
        )?;
        let place = |f: PartFeature| placed(&model.parts[f.part].part, f.feature);
        for &(a, b) in why.features.iter().take(MOST) {
            let (a, b) = (place(a), place(b));
            writeln!(text, "    {} and {}", shown::text(&a), shown::text(&b))?;
        }
        let more = why.touching.len().saturating_sub(MOST);
        if more > 0 {
            writeln!(text, "    {more} more pairs of features")?;
        }
    }
    Ok(())
}
