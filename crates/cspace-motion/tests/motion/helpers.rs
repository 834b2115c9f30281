//! What the tests share.

use cspace::mechanism::{Drive, DriveMotion};
use cspace::{Mechanism, Part, PartEntry, Vertex};
use cspace_motion::{Record, Sample, Settings, Simulation};
use cspace_oracle::Oracle;

/// A mechanism of parts, each two of them a pair.
pub(crate) fn mechanism(parts: Vec<PartEntry>) -> Mechanism {
    let mut mechanism = Mechanism::new("test");
    mechanism.parts = parts;
    mechanism.pairs = mechanism.every_two();
    mechanism
}

pub(crate) fn driven(mut mechanism: Mechanism, part: usize, rate: f64) -> Mechanism {
    mechanism.dynamics.drives.push(Drive {
        part,
        motion: DriveMotion::Rate(rate),
    });
    mechanism
}

/// Runs it, and lets brute force judge every sample.
pub(crate) fn run(mechanism: &Mechanism, time: f64, every: f64) -> (Simulation, Record) {
    let simulation = Simulation::new(mechanism).unwrap();
    let settings = Settings {
        time,
        every: Some(every),
    };
    let record = simulation.kinematic(&settings).unwrap();
    judge(&simulation, &record);
    (simulation, record)
}

/// No pair overlaps at any sample by more than the resolution.
pub(crate) fn judge(simulation: &Simulation, record: &Record) {
    let system = simulation.system();
    for pair in simulation.pairs().list() {
        let parts = &system.mechanism().parts;
        let (fixed, moving) = (&parts[pair.fixed].part, &parts[pair.moving].part);
        let oracle = Oracle::new(fixed, moving);
        for sample in &record.samples {
            let q = &sample.coordinates;
            let relative = system.relative(pair.fixed, pair.moving, q);
            let verdict = oracle.judge(relative);
            assert!(
                !verdict.overlap || verdict.margin <= pair.touch,
                "{} and {} overlap by {:.2e} at {}",
                fixed.name(),
                moving.name(),
                verdict.margin,
                sample.t
            );
        }
    }
}

/// A part with one loop of lines.
pub(crate) fn polygon(name: &str, corners: &[(f64, f64)]) -> Part {
    let vertices = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    Part::new(name, vec![vertices]).unwrap()
}

/// All coordinates at the sample of a time.
pub(crate) fn at(record: &Record, time: f64) -> &[f64] {
    let near = |s: &&Sample| (s.t - time).abs() < 1e-9;
    &record.samples.iter().find(near).unwrap().coordinates
}

/// A model that ships.
pub(crate) fn model(name: &str) -> Mechanism {
    let path = format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    match cspace_io::read(std::path::Path::new(&path)).unwrap() {
        cspace_io::Document::Model(model) => *model,
        cspace_io::Document::Space(_) => panic!("{name} is a model"),
    }
}
