//! The largest forces of a motion, as data and in words.

use cspace::AxisMotion;
use cspace_model::Quantity;
use schemars::JsonSchema;
use serde::Serialize;

use super::number::digits;
use super::phase::Clock;
use crate::record::{End, Record, What};
use crate::system::System;

/// The largest forces among the samples of a motion, in kg·unit/s²; torques in kg·unit²/s², powers in kg·unit²/s³.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema)]
pub struct Peaks {
    /// The forces of each two parts that press on each other, and at each end of a range that is pressed on.
    pub contacts: Vec<ContactPeak>,
    /// The forces and powers of each drive.
    pub drives: Vec<DrivePeak>,
}

/// The largest normal force of two parts, all their contacts together, or at an end of a range.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ContactPeak {
    /// Two parts, or a part and an end of its range.
    #[serde(flatten)]
    pub what: Pressing,
    /// The force.
    pub force: Peak,
}

/// Two parts, or a part and an end of its range, that press on each other.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Pressing {
    /// Two parts on each other.
    Pair {
        /// Name of the pair's fixed part.
        fixed: String,
        /// Name of its moving part.
        moving: String,
    },
    /// A part on an end of its range.
    Limit {
        /// Name of the part.
        part: String,
        /// End of the range.
        limit: End,
    },
}

/// The largest force and power of a drive.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct DrivePeak {
    /// The name of the driven part.
    pub part: String,
    /// Torque, or force if the part slides: that of the largest magnitude.
    pub force: Peak,
    /// The largest power that the drive gives; below 0 where it only takes.
    pub power: Peak,
}

/// A value and its time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Peak {
    /// The value.
    pub value: f64,
    /// Its time, in seconds.
    pub t: f64,
}

impl Peaks {
    /// The largest forces among the samples of a record; of equal ones the first. None if it has no forces.
    pub(super) fn of(record: &Record) -> Option<Self> {
        let mut peaks = Self::default();
        let mut with_forces = (record.samples.iter())
            .filter_map(|s| Some((s.t, s.forces.as_ref()?)))
            .peekable();
        with_forces.peek()?;
        for (t, forces) in with_forces {
            let mut sums: Vec<(Pressing, f64)> = Vec::new();
            for contact in &forces.contacts {
                let Some(what) = pressing(&contact.what) else {
                    continue;
                };
                match sums.iter_mut().find(|s| s.0 == what) {
                    Some(sum) => sum.1 += contact.normal,
                    None => sums.push((what, contact.normal)),
                }
            }
            for (what, value) in sums.into_iter().filter(|s| s.1 > 0.0) {
                let force = Peak { value, t };
                match peaks.contacts.iter_mut().find(|p| p.what == what) {
                    Some(known) => known.force.raise(force, |x| x),
                    None => peaks.contacts.push(ContactPeak { what, force }),
                }
            }
            for drive in &forces.drives {
                let [force, power] = [drive.force, drive.power].map(|value| Peak { value, t });
                match peaks.drives.iter_mut().find(|p| p.part == drive.part) {
                    Some(known) => {
                        known.force.raise(force, f64::abs);
                        known.power.raise(power, |x| x);
                    }
                    None => peaks.drives.push(DrivePeak {
                        part: drive.part.clone(),
                        force,
                        power,
                    }),
                }
            }
        }
        Some(peaks)
    }
}

impl Peak {
    /// Takes another in its place if that is larger by a measure.
    fn raise(&mut self, other: Self, measure: impl Fn(f64) -> f64) {
        if measure(other.value) > measure(self.value) {
            *self = other;
        }
    }
}

fn pressing(what: &What) -> Option<Pressing> {
    match what {
        What::Contact { fixed, moving, .. } => Some(Pressing::Pair {
            fixed: fixed.clone(),
            moving: moving.clone(),
        }),
        What::Limit { part, limit } => Some(Pressing::Limit {
            part: part.clone(),
            limit: *limit,
        }),
        What::Part { .. } => None,
    }
}

/// Sentences on the largest force between each two parts, the largest force and power of each drive, and the mean power of all.
pub(super) fn sentences(
    system: &System,
    record: &Record,
    peaks: &Peaks,
    clock: &Clock<'_>,
) -> Vec<String> {
    let mechanism = system.mechanism();
    let shown = |quantity: Quantity, value: f64| {
        let unit = quantity.shown(mechanism.unit.as_deref(), value);
        format!(
            "{} {}",
            digits(unit.factor * value + 0.0, DIGITS),
            unit.name
        )
    };
    let mut all = Vec::new();
    for ContactPeak { what, force } in &peaks.contacts {
        let (most, at) = (shown(Quantity::Force, force.value), clock.at(force.t));
        let press = match what {
            Pressing::Pair { fixed, moving } => format!("{fixed} and {moving} press on each other"),
            Pressing::Limit { part, limit } => {
                format!("the {part} presses on the {limit} end of its range")
            }
        };
        all.push(format!(
            "{press} with at most {most} at the samples, at {at}"
        ));
    }
    for DrivePeak { part, force, power } in &peaks.drives {
        let axis = mechanism.parts.iter().find(|p| p.part.name() == part);
        let axis = axis.and_then(|p| p.axis);
        let turns = axis.is_some_and(|a| matches!(a.motion, AxisMotion::Revolute { .. }));
        let quantity = if turns {
            Quantity::Torque
        } else {
            Quantity::Force
        };
        let push = shown(quantity, force.value.abs());
        let most = match power.value > 0.0 {
            true => shown(Quantity::Power, power.value),
            false => "no power".to_owned(),
        };
        let gives = match force.t == power.t {
            true => format!("{push} and {most} at the samples, at {}", clock.at(force.t)),
            false => format!(
                "{push}, at {}, and {most}, at {}, at the samples",
                clock.at(force.t),
                clock.again(power.t)
            ),
        };
        all.push(format!("the drive of the {part} gives at most {gives}"));
    }
    if let (Some(energy), [_, rest @ ..]) = (&record.energy, &peaks.drives[..]) {
        let mean = shown(Quantity::Power, energy.drives / record.until);
        let who = if rest.is_empty() {
            "the drive gives"
        } else {
            "all drives together give"
        };
        all.push(format!("{who} {mean} on average, impacts included"));
    }
    all
}

/// Digits of forces in sentences.
const DIGITS: i32 = 5;
