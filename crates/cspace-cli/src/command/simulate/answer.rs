//! What becomes of a mechanism, as JSON.

use std::collections::BTreeMap;

use cspace::Mechanism;
use cspace_motion::{
    ContactInterval, Cycle, Energy, Event, Forces, Obstacle, PartCoordinates, Record, Report,
    Sample, Status, System, Trajectory,
};
use serde::Serialize;

use crate::failure::Failure;

use super::made_of::MadeOf;

/// What is told beside coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wanted {
    pub(super) rates: bool,
    pub(super) forces: bool,
    /// The states between samples, too.
    pub(super) states: bool,
}

/// The whole answer.
#[derive(Debug, Serialize)]
pub(super) struct Told {
    pub(super) status: Status,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) reason: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) obstacles: Vec<Obstacle>,
    pub(super) until: f64,
    /// Those that can move.
    pub(super) parts: Vec<String>,
    pub(super) samples: Vec<Row>,
    /// Of a record that is kept: the states on the way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) states: Option<States>,
    /// Of a record that is kept: what it was made of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) model: Option<MadeOf>,
    pub(super) events: Vec<Event>,
    pub(super) contacts: Vec<ContactInterval>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) cycle: Option<Period>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) energy: Option<Energy>,
    pub(super) summary: Vec<String>,
    pub(super) seconds: f64,
}

/// All states of a motion that are known: each is its time, then the coordinates of all parts in their order, then their rates. Where contacts
/// come and go there are several of one time; what goes at once from one balance to another passes through them.
#[derive(Debug, Serialize)]
#[serde(transparent)]
pub(super) struct States(Vec<Vec<f64>>);

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
#[derive(Debug, Serialize)]
pub(super) struct Row {
    pub(super) t: f64,
    #[serde(flatten)]
    pub(super) parts: BTreeMap<String, Numbers>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) rates: Option<BTreeMap<String, Numbers>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) forces: Option<Forces>,
}

/// The cycle in which the motion repeats.
#[derive(Debug, Serialize)]
pub(super) struct Period {
    period: f64,
    since: f64,
    difference: f64,
    /// What is driven evenly, by which ratios are told.
    #[serde(skip_serializing_if = "Option::is_none")]
    driver: Option<String>,
    parts: BTreeMap<String, InCycle>,
}

/// What a part does in a cycle.
#[derive(Debug, Serialize)]
struct InCycle {
    advance: Numbers,
    least: Numbers,
    greatest: Numbers,
    /// Its advance, by that of the driver.
    #[serde(skip_serializing_if = "Option::is_none")]
    ratio: Option<f64>,
}

impl Period {
    fn of(model: &Mechanism, cycle: &Cycle) -> Self {
        let name = |i: usize| model.parts[i].part.name().to_owned();
        let parts = cycle.parts.iter().map(|p| {
            let told = InCycle {
                advance: Numbers::of(&p.advance),
                least: Numbers::of(&p.least),
                greatest: Numbers::of(&p.greatest),
                ratio: cycle.ratio(p.part),
            };
            (name(p.part), told)
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

/// Of a part with one degree of freedom, or with three.
#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
pub(super) enum Numbers {
    One(f64),
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
pub(super) fn moving<'a>(
    model: &'a Mechanism,
    system: &'a System,
) -> impl Iterator<Item = (&'a str, PartCoordinates)> {
    let names = model.parts.iter().map(|p| p.part.name());
    (names.zip(system.parts().iter().copied())).filter(|(_, p)| !p.indices().is_empty())
}

impl Told {
    pub(super) fn of(
        model: &Mechanism,
        system: &System,
        (record, report): (&Record, &Report),
        wanted: Wanted,
        seconds: f64,
    ) -> Result<Self, Failure> {
        let by_name = |all: &[f64]| -> BTreeMap<String, Numbers> {
            moving(model, system)
                .map(|(name, part)| (name.to_owned(), Numbers::of(&all[part.indices()])))
                .collect()
        };
        let row = |s: &Sample| Row {
            t: s.t,
            parts: by_name(&s.coordinates),
            rates: wanted.rates.then(|| by_name(&s.rates)),
            forces: s.forces.clone().filter(|_| wanted.forces),
        };
        let made_of = wanted.states.then(|| MadeOf::of(model)).transpose()?;
        Ok(Self {
            status: record.status,
            reason: record.reason.clone(),
            obstacles: record.obstacles.clone(),
            until: record.until,
            parts: moving(model, system).map(|(n, _)| n.to_owned()).collect(),
            samples: record.samples.iter().map(row).collect(),
            states: wanted.states.then(|| States::of(record)),
            model: made_of,
            events: record.events.clone(),
            contacts: report.contacts.clone(),
            cycle: report.cycle.as_ref().map(|c| Period::of(model, c)),
            energy: record.energy,
            summary: report.summary.clone(),
            seconds,
        })
    }
}
