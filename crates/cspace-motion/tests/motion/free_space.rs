//! Models that ship stay in free space: brute force judges every event and many places between.

use std::path::Path;

use cspace::Mechanism;
use cspace_motion::{Settings, Simulation};
use rayon::prelude::*;

use crate::helpers::judge;

/// Places between one event and the next.
const BETWEEN: usize = 100;

/// Every model that ships and has a drive, by name.
fn driven() -> Vec<(String, Mechanism)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let mut models = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        match cspace_io::read(&path).unwrap() {
            cspace_io::Document::Model(model) if !model.mechanism.dynamics.drives.is_empty() => {
                models.push((name, model.mechanism));
            }
            _ => {}
        }
    }
    models.sort_by(|a, b| a.0.cmp(&b.0));
    models
}

#[test]
fn nothing_overlaps_at_events_nor_between() {
    let models = driven();
    assert!(models.len() >= 10, "{}", models.len());
    models.into_par_iter().for_each(|(name, mechanism)| {
        let simulation = Simulation::new(&mechanism).unwrap();
        let moved = |time: f64, every: f64| {
            let every = Some(every);
            simulation.kinematic(&Settings { time, every }).unwrap()
        };
        let whole = moved(1.3, 1.3);
        let mut before = 0.0;
        let times = whole.events.iter().map(|e| e.t).chain([1.3]);
        for until in times {
            if until - before < 1e-9 {
                continue;
            }
            // To the event, which the last sample is at; of the others those since the one before.
            let mut record = moved(until, (until - before) / BETWEEN as f64);
            record.samples.retain(|s| s.t >= before);
            assert!(record.samples.len() >= BETWEEN, "{name} {until}");
            assert!((record.samples.last().unwrap().t - until).abs() < 1e-12);
            judge(&simulation, &record);
            before = until;
        }
    });
}
