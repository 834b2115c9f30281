//! The answer of `cspace simulate` as text.

use std::fmt::{self, Write};

use cspace_model::{Mechanism, Quantity, shown};
use cspace_motion::{Conduct, Energy, Event, EventKind, Status, What};

use crate::subject::placed_by_name;
use crate::wording::{count, decimals, degrees, digits_beside, length};

use cspace_api::simulate::{Motion, Numbers};

pub(super) fn describe(text: &mut String, model: &Mechanism, motion: &Motion) -> fmt::Result {
    /// More of them are for programs.
    const MOST: usize = 40;
    let unit = (model.unit.as_deref()).map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let until = shown::number(motion.until);
    match motion.status {
        Status::Done => writeln!(text, "done: {until} s")?,
        Status::Jammed => writeln!(text, "jammed at {until:.9} s")?,
        Status::Undetermined => writeln!(text, "undetermined from {until:.9} s on")?,
        Status::Interrupted => writeln!(text, "interrupted at {until:.9} s")?,
        Status::Inconsistent => writeln!(text, "inconsistent at {until:.9} s")?,
    }
    if let Some(reason) = &motion.reason {
        writeln!(text, "  {}", shown::text(reason))?;
    }
    if let (Some(first), Some(last)) = (motion.samples.first(), motion.samples.last()) {
        for name in &motion.parts {
            let turns = model.parts.iter().any(|p| {
                p.part.name() == name
                    && (p.axis)
                        .is_some_and(|a| matches!(a.motion, cspace::AxisMotion::Revolute { .. }))
            });
            let shown_at = |n: &Numbers| match n {
                Numbers::One(u) if turns => degrees(*u),
                Numbers::One(u) => format!("{}{unit}", length(*u)),
                Numbers::Three([x, y, theta]) => format!(
                    "x {}, y {}{unit}, theta {}",
                    length(*x),
                    length(*y),
                    degrees(*theta)
                ),
            };
            if let (Some(a), Some(b)) = (first.parts.get(name), last.parts.get(name)) {
                let name = shown::text(name);
                writeln!(text, "{name}: from {} to {}", shown_at(a), shown_at(b))?;
            }
        }
    }
    for sentence in &motion.summary {
        writeln!(text, "{}", shown::text(sentence))?;
    }
    if let Some(energy) = &motion.energy {
        describe_energy(text, model, energy)?;
    }
    write!(text, "{}", count(motion.events.len(), "event", "events"))?;
    let of = |kind| motion.events.iter().filter(|e| e.kind == kind).count();
    let told = [
        (
            of(EventKind::Choice),
            "choice among possible motions",
            "choices among possible motions",
        ),
        (of(EventKind::Bridge), "bridge by steps", "bridges by steps"),
    ];
    for (n, one, many) in told.into_iter().filter(|t| t.0 > 0) {
        write!(text, ", {}", count(n, one, many))?;
    }
    writeln!(text)?;
    for event in motion.events.iter().take(MOST) {
        describe_event(text, model, event)?;
    }
    if motion.events.len() > MOST {
        let more = &motion.events[MOST..];
        write!(text, "  {} more", more.len())?;
        let is_told = |e: &&Event| matches!(e.kind, EventKind::Choice | EventKind::Bridge);
        if let Some(first) = more.iter().find(is_told) {
            write!(text, ", a {} at {:.6} s first", kind(first), first.t)?;
        }
        writeln!(text, "; --json has all")?;
    }
    Ok(())
}

/// From the start to the end: what drives put in, and what was lost, all in one unit and to as many digits.
fn describe_energy(text: &mut String, model: &Mechanism, energy: &Energy) -> fmt::Result {
    let Energy {
        start,
        end,
        drives,
        friction,
        impacts,
        drift,
    } = *energy;
    let all = [start, drives, friction, impacts, end];
    let largest = all.iter().fold(0.0_f64, |m, e| m.max(e.abs()));
    let unit = Quantity::Energy.shown(model.unit.as_deref(), largest);
    let digits = digits_beside(largest * unit.factor);
    let [start, drives, friction, impacts, end] = all.map(|e| decimals(e * unit.factor, digits));
    writeln!(
        text,
        "energy: {start} at the start, {drives} from drives, less {friction} by friction and {impacts} by impacts: \
         {end} {} at the end, {:.1e} off",
        shown::text(&unit.name),
        drift * unit.factor
    )
}

/// The name of an event's kind.
pub(super) fn kind(event: &Event) -> &'static str {
    match event.kind {
        EventKind::Impact => "impact",
        EventKind::Touch => "touch",
        EventKind::Release => "release",
        EventKind::Stick => "stick",
        EventKind::Slip => "slip",
        EventKind::Limit => "limit",
        EventKind::Snap => "snap",
        EventKind::Jam => "jam",
        EventKind::Rest => "rest",
        EventKind::Choice => "choice",
        EventKind::Bridge => "bridge",
    }
}

fn describe_event(text: &mut String, model: &Mechanism, event: &Event) -> fmt::Result {
    write!(text, "  {:.6} s {:7} ", event.t, kind(event))?;
    if let Some(bridge) = &event.bridge {
        return writeln!(
            text,
            "steps lead on to {:.6} s, with overlaps of {:.1e} at most",
            bridge.until, bridge.overlap
        );
    }
    let Some(choice) = &event.choice else {
        return writeln!(text, "{}", named(model, &event.what));
    };
    // What the nearest of the others has otherwise.
    let differs = |other: &Vec<Conduct>| {
        choice
            .taken
            .iter()
            .zip(other)
            .filter(|(a, b)| a != b)
            .count()
    };
    let other = choice.others.iter().min_by_key(|other| differs(other));
    let conducts = choice.taken.iter().zip(other.into_iter().flatten());
    let mut all = choice
        .contacts
        .iter()
        .zip(conducts)
        .filter(|(_, (a, b))| a != b);
    write!(
        text,
        "1 of {}",
        count(choice.others.len() + 1, "motion", "motions")
    )?;
    if let Some((what, (taken, other))) = all.next() {
        write!(
            text,
            ": {} {} rather than {}",
            named(model, what),
            does(*taken),
            does(*other)
        )?;
    }
    writeln!(text)
}

/// Subject of an event, by name.
fn named(model: &Mechanism, what: &What) -> String {
    match what {
        What::Contact {
            fixed,
            moving,
            features: [f, m],
        } => {
            let f = placed_by_name(model, fixed, f);
            let m = placed_by_name(model, moving, m);
            format!("{f} and {m}")
        }
        What::Part { part } => shown::text(part).into_owned(),
        What::Limit { part, limit } => format!("{limit} end of {}", shown::text(part)),
    }
}

/// Conduct of two features, as a verb.
fn does(conduct: Conduct) -> &'static str {
    match conduct {
        Conduct::Opens => "part",
        Conduct::Sticks => "stick",
        Conduct::Slides => "slide",
        Conduct::SlidesBack => "slide back",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A choice tells what is done, and what the nearest of the others has otherwise.
    #[test]
    fn a_choice_tells_what_it_is_between() {
        let event: Event = serde_json::from_str(
            r#"{ "t": 1, "kind": "choice", "part": "box", "choice": {
                "contacts": [{ "part": "rod", "limit": "upper" }, { "part": "box" }],
                "taken": ["slides", "sticks"],
                "others": [["opens", "opens"], ["slides", "slides-back"]] } }"#,
        )
        .unwrap();
        let mut text = String::new();
        describe_event(&mut text, &Mechanism::new("m"), &event).unwrap();
        let expected = "  1.000000 s choice  1 of 3 motions: box stick rather than slide back\n";
        assert_eq!(text, expected);
    }
}
