//! What becomes of a mechanism, as JSON.

use std::collections::BTreeMap;

use cspace::Mechanism;
use cspace_motion::{Event, Obstacle, PartCoordinates, Record, Sample, Status, System};
use serde::Serialize;

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
    pub(super) events: Vec<Event>,
    pub(super) seconds: f64,
}

/// All parts at a time.
#[derive(Debug, Serialize)]
pub(super) struct Row {
    pub(super) t: f64,
    #[serde(flatten)]
    pub(super) parts: BTreeMap<String, Numbers>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) rates: Option<BTreeMap<String, Numbers>>,
}

/// Of a part with one degree of freedom, or with three.
#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
pub(super) enum Numbers {
    One(f64),
    Three([f64; 3]),
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
        record: Record,
        with_rates: bool,
        seconds: f64,
    ) -> Self {
        let numbers = |part: PartCoordinates, all: &[f64]| match all[part.indices()] {
            [x, y, theta] => Numbers::Three([x, y, theta]),
            [u] => Numbers::One(u),
            _ => Numbers::One(0.0),
        };
        let by_name = |all: &[f64]| -> BTreeMap<String, Numbers> {
            moving(model, system)
                .map(|(name, part)| (name.to_owned(), numbers(part, all)))
                .collect()
        };
        let row = |s: &Sample| Row {
            t: s.t,
            parts: by_name(&s.coordinates),
            rates: with_rates.then(|| by_name(&s.rates)),
        };
        Self {
            status: record.status,
            reason: record.reason,
            obstacles: record.obstacles,
            until: record.until,
            parts: moving(model, system).map(|(n, _)| n.to_owned()).collect(),
            samples: record.samples.iter().map(row).collect(),
            events: record.events,
            seconds,
        }
    }
}
