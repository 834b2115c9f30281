//! Answer of `cspace simulate`: its schema is `docs/answers/simulate.schema.json`.

use std::collections::BTreeMap;

use cspace_mechanism::Mechanism;
use cspace_motion::{
    ContactInterval, Cycle, Energy, Event, Forces, Gap, Obstacle, PartCoordinates, Record, Report,
    Sample, Simulation, Status, System, Trajectory,
};
use serde::Serialize;

use crate::made_of::MadeOf;

/// Options for what is reported beside coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    /// Rates of coordinates.
    pub rates: bool,
    /// Forces of contacts.
    pub forces: bool,
    /// The states between samples, too.
    pub states: bool,
}

/// The whole answer.
#[derive(Debug, Serialize)]
pub struct Told {
    /// How it ended.
    pub status: Status,
    /// Why it ended before its time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Obstacles that stopped it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub obstacles: Vec<Obstacle>,
    /// The parts that fit exactly at the start, and by how much they are smaller.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gaps: Vec<Gap>,
    /// The time of the last state (s).
    pub until: f64,
    /// Parts that can move.
    pub parts: Vec<String>,
    /// Samples at equal intervals.
    pub samples: Vec<Row>,
    /// States along the motion, for a record that is kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub states: Option<States>,
    /// Hashes of the model, for a record that is kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub model: Option<MadeOf>,
    /// Events, in order of time.
    pub events: Vec<Event>,
    /// Which features touched, and when.
    pub contacts: Vec<ContactInterval>,
    /// The cycle in which it repeats.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cycle: Option<Period>,
    /// The energy at the beginning and the end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy: Option<Energy>,
    /// Summary of the events, in sentences.
    pub summary: Vec<String>,
    /// How long it took to compute (s).
    pub seconds: f64,
}

/// All states of a motion that are known: each is its time, then the coordinates of all parts in their order, then their rates. Where contacts
/// come and go there are several of one time; what goes at once from one balance to another passes through them.
#[derive(Debug, Serialize)]
#[serde(transparent)]
pub struct States(Vec<Vec<f64>>);

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
pub struct Row {
    /// The time (s).
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
#[derive(Debug, Serialize)]
pub struct Period {
    period: f64,
    since: f64,
    difference: f64,
    /// Evenly driven part, to which ratios refer.
    #[serde(skip_serializing_if = "Option::is_none")]
    driver: Option<String>,
    parts: BTreeMap<String, InCycle>,
}

/// Motion of a part in a cycle.
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

/// Numbers of a part with one degree of freedom, or with three.
#[derive(Debug, Clone, Serialize)]
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

impl Told {
    /// Answer for a motion, which took so many seconds to compute.
    ///
    /// # Errors
    /// If the model cannot be written as JSON, which plain data always can.
    pub fn of(
        model: &Mechanism,
        simulation: &Simulation,
        (record, report): (&Record, &Report),
        wanted: Wanted,
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
            rates: wanted.rates.then(|| by_name(&s.rates)),
            forces: s.forces.clone().filter(|_| wanted.forces),
        };
        let made_of = wanted.states.then(|| MadeOf::of(model)).transpose()?;
        Ok(Self {
            status: record.status,
            reason: record.reason.clone(),
            gaps: simulation.gaps().to_vec(),
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
