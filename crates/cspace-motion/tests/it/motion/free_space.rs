//! Models that ship stay in free space: brute force judges every event and many places between.

use std::path::Path;

use cspace::Silent;
use cspace_model::Mechanism;
use cspace_motion::{Settings, Simulation, Status};
use cspace_oracle::effort;
use rayon::prelude::*;

use crate::motion::helpers::overlaps;

/// For so long they move, in seconds: longer than a turn of those that are driven once a second.
const TIME: f64 = 1.3;

/// With masses, contacts that begin and end within a step are not met if they are shallower than this, relative to the size of the mechanism
/// (docs/limits.md). One model comes to 2·10⁻⁹, at one of five hundred events of a square that rattles in its frame.
const MISSED: f64 = 1e-8;

/// Every model that ships and has something that moves it, by name.
fn moved() -> Vec<(String, Mechanism)> {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let folders = ["", "paper", "tolerances"].map(|f| models.join(f));
    let entries = folders.iter().flat_map(|f| std::fs::read_dir(f).unwrap());
    let mut found = Vec::new();
    for path in entries.map(|e| e.unwrap().path()) {
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        if let cspace_model::Document::Model(model) = cspace_model::read(&path).unwrap() {
            let mechanism = model.mechanism;
            let driven = !mechanism.dynamics.drives.is_empty();
            if driven || cspace_motion::has_forces(&mechanism) {
                found.push((name, mechanism));
            }
        }
    }
    found.sort_by(|a, b| a.0.cmp(&b.0));
    found
}

#[test]
fn nothing_overlaps_at_events_nor_between() {
    // Number of even samples that are checked, beside all events.
    let samples = effort(100, 1000);
    let models = moved();
    assert!(models.len() >= 40, "{}", models.len());
    let some: Vec<_> = models.into_iter().step_by(effort(14, 1)).collect();
    let found = some.into_par_iter().flat_map(|(name, mechanism)| {
        let simulation = Simulation::new(&mechanism).unwrap();
        let settings = Settings {
            time: TIME,
            every: Some(TIME / f64::from(samples)),
        };
        let mut record = simulation.follow_with(&settings, &Silent).unwrap();
        assert_eq!(record.status, Status::Done, "{name}: {:?}", record.reason);
        assert!(record.samples.len() >= samples as usize, "{name}");
        let at_event = |t: f64| record.events.iter().any(|e| e.t == t);
        let events = record.trace.iter().filter(|s| at_event(s.t)).cloned();
        let events: Vec<_> = events.collect();
        record.samples.extend(events);
        let system = simulation.system();
        let slack = match system.mechanism().has_masses() {
            true => MISSED * system.size(),
            false => 0.0,
        };
        let found = overlaps(&simulation, &record, slack);
        found
            .into_iter()
            .map(|o| format!("{name}: {o}"))
            .collect::<Vec<_>>()
    });
    let found: Vec<String> = found.collect();
    assert!(found.is_empty(), "{found:#?}");
}
