//! The largest forces of a motion with masses, in words.

use super::number::digits;
use super::phase::Clock;
use crate::record::{ContactForce, Record, What};
use crate::system::System;

/// The largest force between each two parts, and the power of each drive.
pub(super) fn sentences(system: &System, record: &Record, clock: &Clock<'_>) -> Vec<String> {
    let unit = system.mechanism().unit.as_deref().unwrap_or("unit");
    let mut largest: Vec<(f64, &ContactForce)> = Vec::new();
    // Of each drive: its name, its power's largest value and where, and the integral of its power so far.
    let mut drives: Vec<(&str, f64, f64, f64)> = Vec::new();
    let mut before: Option<(f64, Vec<f64>)> = None;
    for sample in &record.samples {
        let Some(forces) = &sample.forces else {
            continue;
        };
        for contact in &forces.contacts {
            match largest.iter_mut().find(|l| same(&l.1.what, &contact.what)) {
                Some(old) if old.1.normal >= contact.normal => {}
                Some(old) => *old = (sample.t, contact),
                None => largest.push((sample.t, contact)),
            }
        }
        for drive in &forces.drives {
            match drives.iter_mut().find(|d| d.0 == drive.part) {
                Some(old) if old.1 >= drive.power => {}
                Some(old) => (old.1, old.2) = (drive.power, sample.t),
                None => drives.push((&drive.part, drive.power, sample.t, 0.0)),
            }
        }
        let powers: Vec<f64> = forces.drives.iter().map(|d| d.power).collect();
        if let Some((t, old)) = &before {
            for ((drive, a), b) in drives.iter_mut().zip(old).zip(&powers) {
                drive.3 += 0.5 * (sample.t - t) * (a + b);
            }
        }
        before = Some((sample.t, powers));
    }
    let mut all = Vec::new();
    for (t, contact) in largest.iter().filter(|l| l.1.normal > 0.0) {
        let force = digits(contact.normal, 4);
        let at = clock.at(*t);
        all.push(match &contact.what {
            What::Contact { fixed, moving, .. } => format!(
                "{fixed} and {moving} press on each other with at most {force} kg·{unit}/s², at {at}"
            ),
            What::Limit { part, limit } => format!(
                "the {part} presses on the {limit} end of its range with at most {force}, at {at}"
            ),
        });
    }
    for (name, most, t, work) in drives {
        let mean = digits(work / record.until, 4);
        let (most, at) = (digits(most, 4), clock.at(t));
        all.push(format!(
            "the drive of the {name} gives at most {most} kg·{unit}²/s³, at {at}, and {mean} on average"
        ));
    }
    all
}

/// Of the same parts.
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
