//! A motion as data.

use std::collections::BTreeMap;

use cspace_model::Mechanism;
use cspace_motion::{
    ContactInterval, Cycle, Energy, Event, Forces, Gap, Obstacle, PartCoordinates, Peaks, Record,
    Report, Sample, Simulation, Status, System, Trajectory,
};
use schemars::JsonSchema;
use serde::Serialize;

use crate::made_of::MadeOf;

/// Data that are reported beside coordinates.
#[derive(Debug, Clone, Copy, Default)]
pub struct Reported {
    /// Rates of coordinates.
    pub rates: bool,
    /// Forces of contacts.
    pub forces: bool,
    /// The states between samples, too.
    pub states: bool,
}

/// A motion.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Motion {
    /// How it ended: `done` at the end of its time; `jammed` where what is driven cannot go on; `undetermined` where it cannot be told how it
    /// goes on; `inconsistent` where no accelerations and forces satisfy the laws of contact and friction; `interrupted` where the user wanted
    /// no more of it.
    pub status: Status,
    /// Why it ended before its time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Obstacles that jam it: the conditions that these functions do not decrease, each times its multiplier, add up to a contradiction.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<Obstacle>,
    /// The parts that fit exactly into others at the start, and are smaller all around, so that there is room to move.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gaps: Vec<Gap>,
    /// When it ended, in seconds.
    pub until: f64,
    /// Parts that can move.
    pub parts: Vec<String>,
    /// All parts at even times, and where it ended.
    pub samples: Vec<Row>,
    /// All states that are known, in order of time, of a record that is kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub states: Option<States>,
    /// Hashes of all that the motion depends on, of a record that is kept: a motion goes on only with what it was made of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<MadeOf>,
    /// Events, in order of time.
    pub events: Vec<Event>,
    /// Contacts from touch to release, in the order in which they begin.
    pub contacts: Vec<ContactInterval>,
    /// The cycle in which it repeats; left out where it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle: Option<Period>,
    /// The balance of energy, of a motion with masses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy: Option<Energy>,
    /// The largest forces, if forces are known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peaks: Option<Peaks>,
    /// A summary of the motion, in sentences.
    pub summary: Vec<String>,
    /// How long it took to compute, in seconds.
    pub seconds: f64,
}

/// All states of a motion that are known: each is its time, then the coordinates of all parts in their order, then their rates. Where contacts
/// come and go there are several of one time; what goes at once from one balance to another passes through them.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(transparent)]
pub struct States(pub Vec<Vec<f64>>);

impl States {
    fn of(record: &Record) -> Self {
        let trajectory = Trajectory::of(record);
        let knots = trajectory.knots().iter();
        let state = |s: &&Sample| {
            let numbers = s.coordinates.iter().chain(&s.rates).copied();
            core::iter::once(s.t).chain(numbers).collect()
        };
        Self(knots.map(state).collect())
    }
}

/// All parts at a time.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Row {
    /// The time, in seconds.
    pub t: f64,
    /// Coordinates by the part's name.
    #[serde(flatten)]
    pub parts: BTreeMap<String, Numbers>,
    /// Rates, if they are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rates: Option<BTreeMap<String, Numbers>>,
    /// Forces, if they are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub forces: Option<Forces>,
}

/// The cycle in which the motion repeats.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Period {
    /// How long it takes, in seconds.
    pub period: f64,
    /// The time from which on the motion repeats, in seconds.
    pub since: f64,
    /// How far two cycles are from each other at most, in the unit of length; angles count by the sizes of their parts.
    pub difference: f64,
    /// The first part that is driven to turn at a constant rate, to which ratios refer.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub driver: Option<String>,
    /// The motion of each part that can move in it, by its name.
    pub parts: BTreeMap<String, InCycle>,
}

/// Motion of a part in a cycle.
#[derive(Debug, Serialize, JsonSchema)]
pub struct InCycle {
    /// How far it has gone on after a cycle, 0 if it is back.
    pub advance: Numbers,
    /// The smallest values in the last cycle.
    pub least: Numbers,
    /// The largest values in the last cycle.
    pub greatest: Numbers,
    /// Its advance by that of the driver: the ratio of transmission, or a length per radian.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<f64>,
}

impl Period {
    fn of(model: &Mechanism, cycle: &Cycle) -> Self {
        let name = |i: usize| model.parts[i].part.name().to_owned();
        let parts = cycle.parts.iter().map(|p| {
            let in_cycle = InCycle {
                advance: Numbers::of(&p.advance),
                least: Numbers::of(&p.least),
                greatest: Numbers::of(&p.greatest),
                ratio: cycle.ratio(p.part),
            };
            (name(p.part), in_cycle)
        });
        Self {
            period: cycle.period,
            since: cycle.since,
            difference: cycle.difference,
            driver: cycle.driver.map(name),
            parts: parts.collect(),
        }
    }
}

/// Numbers of a part with one degree of freedom, or with three.
#[derive(Debug, Clone, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Numbers {
    /// One degree of freedom.
    One(f64),
    /// Three degrees of freedom: x, y, θ.
    Three([f64; 3]),
}

impl Numbers {
    fn of(all: &[f64]) -> Self {
        match *all {
            [x, y, theta] => Self::Three([x, y, theta]),
            [u] => Self::One(u),
            _ => Self::One(0.0),
        }
    }
}

/// Names and coordinates of the parts that can move.
pub fn moving<'a>(
    model: &'a Mechanism,
    system: &'a System,
) -> impl Iterator<Item = (&'a str, PartCoordinates)> {
    let names = model.parts.iter().map(|p| p.part.name());
    (names.zip(system.parts().iter().copied())).filter(|(_, p)| !p.indices().is_empty())
}

impl Motion {
    /// The data of a motion, which took so many seconds to compute.
    ///
    /// # Errors
    /// If the model cannot be written as JSON, which plain data always can.
    pub fn of(
        model: &Mechanism,
        simulation: &Simulation,
        (record, report): (&Record, &Report),
        reported: Reported,
        seconds: f64,
    ) -> serde_json::Result<Self> {
        let system = simulation.system();
        let by_name = |all: &[f64]| -> BTreeMap<String, Numbers> {
            moving(model, system)
                .map(|(name, part)| (name.to_owned(), Numbers::of(&all[part.indices()])))
                .collect()
        };
        let row = |s: &Sample| Row {
            t: s.t,
            parts: by_name(&s.coordinates),
            rates: reported.rates.then(|| by_name(&s.rates)),
            forces: s.forces.clone().filter(|_| reported.forces),
        };
        let made_of = reported.states.then(|| MadeOf::of(model)).transpose()?;
        Ok(Self {
            status: record.status,
            reason: record.reason.clone(),
            gaps: simulation.gaps().to_vec(),
            obstacles: record.obstacles.clone(),
            until: record.until,
            parts: moving(model, system).map(|(n, _)| n.to_owned()).collect(),
            samples: record.samples.iter().map(row).collect(),
            states: reported.states.then(|| States::of(record)),
            model: made_of,
            events: record.events.clone(),
            contacts: report.contacts.clone(),
            cycle: report.cycle.as_ref().map(|c| Period::of(model, c)),
            energy: record.energy,
            peaks: report.peaks.clone(),
            summary: report.summary.clone(),
            seconds,
        })
    }
}
