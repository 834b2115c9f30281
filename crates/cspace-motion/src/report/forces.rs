//! The largest forces of a motion with masses, in words.

use super::number::digits;
use super::phase::Clock;
use crate::record::{Record, What};
use crate::system::System;

/// Sentences on the largest force between each two parts and the largest and mean power of each drive, among the
/// samples.
pub(super) fn sentences(system: &System, record: &Record, clock: &Clock<'_>) -> Vec<String> {
    let unit = system.mechanism().unit.as_deref().unwrap_or("unit");
    let mut largest: Vec<Largest<&What>> = Vec::new();
    let mut drives: Vec<Largest<&str>> = Vec::new();
    for sample in &record.samples {
        let Some(forces) = &sample.forces else {
            continue;
        };
        // All contacts of two parts together.
        let mut sums: Vec<(&What, f64)> = Vec::new();
        for contact in &forces.contacts {
            match sums.iter_mut().find(|s| same(s.0, &contact.what)) {
                Some(sum) => sum.1 += contact.normal,
                None => sums.push((&contact.what, contact.normal)),
            }
        }
        for (what, force) in sums {
            keep(&mut largest, what, force, sample.t, same);
        }
        for drive in &forces.drives {
            let part: &str = &drive.part;
            keep(&mut drives, part, drive.power, sample.t, |a, b| a == b);
        }
    }
    let mut all = Vec::new();
    for found in largest.iter().filter(|l| l.value > 0.0) {
        let force = digits(found.value, 4);
        let at = clock.at(found.t);
        all.push(match found.of {
            What::Contact { fixed, moving, .. } => format!(
                "{fixed} and {moving} press on each other with at most {force} kg·{unit}/s² at the samples, at {at}"
            ),
            What::Part { .. } => continue,
            What::Limit { part, limit } => format!(
                "the {part} presses on the {limit} end of its range with at most {force} at the samples, at {at}"
            ),
        });
    }
    for found in &drives {
        let (most, at) = (digits(found.value + 0.0, 4), clock.at(found.t));
        all.push(format!(
            "the drive of the {} gives at most {most} kg·{unit}²/s³ at the samples, at {at}",
            found.of
        ));
    }
    if let (Some(energy), [_, rest @ ..]) = (&record.energy, &drives[..]) {
        let mean = digits(energy.drives / record.until, 4);
        let who = if rest.is_empty() {
            "the drive gives"
        } else {
            "all drives together give"
        };
        all.push(format!(
            "{who} {mean} kg·{unit}²/s³ on average, impacts included"
        ));
    }
    all
}

/// Largest value of a quantity so far, with its time.
struct Largest<T> {
    of: T,
    value: f64,
    t: f64,
}

/// Keeps the larger of two values of the same.
fn keep<T: Copy>(
    all: &mut Vec<Largest<T>>,
    of: T,
    value: f64,
    t: f64,
    same: impl Fn(T, T) -> bool,
) {
    match all.iter_mut().find(|l| same(l.of, of)) {
        Some(old) if old.value >= value => {}
        Some(old) => (old.value, old.t) = (value, t),
        None => all.push(Largest { of, value, t }),
    }
}

/// Whether two subjects concern the same parts.
fn same(a: &What, b: &What) -> bool {
    match (a, b) {
        (
            What::Contact { fixed, moving, .. },
            What::Contact {
                fixed: f,
                moving: m,
                ..
            },
        ) => fixed == f && moving == m,
        (a, b) => a == b,
    }
}
