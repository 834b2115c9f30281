//! Reports on motions of shipped models, compared with known facts.

mod known;

use std::path::Path;

use cspace_model::Mechanism;
use cspace_motion::{Record, Report, Settings, Simulation};

/// A shipped model.
fn model(name: &str) -> Mechanism {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    match cspace_model::read(models.join(format!("{name}.toml"))).unwrap() {
        cspace_model::Document::Model(model) => model.mechanism,
        cspace_model::Document::Space(_) => panic!("{name} is a model"),
    }
}

/// A mechanism in motion.
fn run(mechanism: &Mechanism, time: f64, every: Option<f64>) -> (Simulation, Record) {
    let simulation = Simulation::new(mechanism).unwrap();
    let record = simulation.kinematic(&Settings { time, every }).unwrap();
    (simulation, record)
}

/// Report on a shipped model.
fn told(name: &str, time: f64) -> Report {
    let (simulation, record) = run(&model(name), time, None);
    Report::of(&simulation, &record)
}
