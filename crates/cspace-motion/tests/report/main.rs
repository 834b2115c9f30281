//! What is told of motions of shipped models, against what is known of them.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::path::Path;

use cspace_motion::{Record, Report, Settings, Simulation};

/// A shipped model in motion.
fn run(name: &str, time: f64) -> (Simulation, Record) {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let mechanism = match cspace_io::read(&models.join(format!("{name}.toml"))).unwrap() {
        cspace_io::Document::Model(model) => *model,
        cspace_io::Document::Space(_) => panic!("{name} is a model"),
    };
    let simulation = Simulation::new(&mechanism).unwrap();
    let settings = Settings { time, every: None };
    let record = simulation.kinematic(&settings).unwrap();
    (simulation, record)
}

#[test]
fn show() {
    for (name, time) in [
        ("geneva", 2.0),
        ("ratchet_mechanism", 2.5),
        ("escapement", 4.0),
        ("gears_on_shafts", 1.0),
        ("cam_tappet", 3.0),
        ("rack_pinion", 0.7),
    ] {
        let (simulation, record) = run(name, time);
        let report = Report::of(simulation.system(), &record);
        println!("== {name} {} knots, {:?}", record.trace.len(), report.cycle);
        println!("{}", report.summary.join("\n"));
    }
}
