//! Helpers shared by the tests.

use cspace::{Part, Vertex};
use cspace_model::{Drive, DriveMotion, Mechanism, PartEntry};
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

/// A key that fills its slot, drawn in it; its sides are 5 from the middle.
pub(crate) fn keyed() -> Mechanism {
    let slot = [
        (-9.0, -9.0),
        (9.0, -9.0),
        (9.0, 0.0),
        (5.0, 0.0),
        (5.0, -5.0),
        (-5.0, -5.0),
        (-5.0, 0.0),
        (-9.0, 0.0),
    ];
    mechanism(vec![
        PartEntry::fixed(polygon("slot", &slot)),
        PartEntry::planar(Part::rectangle("key", (0.0, 0.0), 10.0, 10.0).unwrap()),
    ])
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

/// Checks that no pair overlaps at any sample by more than the resolution.
pub(crate) fn judge(simulation: &Simulation, record: &Record) {
    let found = overlaps(simulation, record, 0.0);
    assert!(found.is_empty(), "{found:#?}");
}

/// The pairs that overlap by more than the resolution, or a length, each with where it is deepest.
pub(crate) fn overlaps(simulation: &Simulation, record: &Record, slack: f64) -> Vec<String> {
    let system = simulation.system();
    let deepest = |pair: &cspace_motion::MovingPair| {
        let parts = &system.mechanism().parts;
        let (fixed, moving) = (&parts[pair.fixed].part, &parts[pair.moving].part);
        let oracle = Oracle::new(fixed, moving);
        let depths = record.samples.iter().map(|sample| {
            let relative = system.relative(pair.fixed, pair.moving, &sample.coordinates);
            let verdict = oracle.judge(relative);
            (if verdict.overlap { verdict.margin } else { 0.0 }, sample.t)
        });
        let (depth, t) = depths.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
        let names = (fixed.name(), moving.name());
        (depth > pair.touch.max(slack))
            .then(|| format!("{} and {} overlap by {depth:.2e} at {t}", names.0, names.1))
    };
    simulation
        .pairs()
        .list()
        .iter()
        .filter_map(deepest)
        .collect()
}

/// A part with one loop of lines.
pub(crate) fn polygon(name: &str, corners: &[(f64, f64)]) -> Part {
    let vertices = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    Part::new(name, vec![vertices]).unwrap()
}

/// Coordinates of the sample at a time.
pub(crate) fn at(record: &Record, time: f64) -> &[f64] {
    let near = |s: &&Sample| (s.t - time).abs() < 1e-9;
    &record.samples.iter().find(near).unwrap().coordinates
}

/// A model that ships.
pub(crate) fn model(name: &str) -> Mechanism {
    let path = format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    match cspace_model::read(std::path::Path::new(&path)).unwrap() {
        cspace_model::Document::Model(model) => model.mechanism,
        cspace_model::Document::Space(_) => panic!("{name} is a model"),
    }
}

/// A model as it is written in a file.
#[track_caller]
pub(crate) fn read(text: &str) -> Mechanism {
    cspace_model::model::from_toml(text, "m.toml").unwrap_or_else(|e| panic!("{e}: {text}"))
}

/// Motion of a model with masses.
#[track_caller]
pub(crate) fn thrown(text: &str, time: f64, every: f64) -> (Simulation, Record) {
    thrown_model(&read(text), time, every)
}

/// The motion of a mechanism with masses.
#[track_caller]
pub(crate) fn thrown_model(mechanism: &Mechanism, time: f64, every: f64) -> (Simulation, Record) {
    let simulation = Simulation::new(mechanism).unwrap();
    let settings = Settings {
        time,
        every: Some(every),
    };
    let record = simulation.dynamic(&settings).unwrap();
    (simulation, record)
}

/// Checks that two numbers differ by no more than an error.
#[track_caller]
pub(crate) fn near(what: &str, found: f64, wanted: f64, error: f64) {
    let off = (found - wanted).abs();
    println!("{what}: off by {off:.2e} of {wanted} ({error:.0e} allowed)");
    assert!(
        off <= error,
        "{what}: {found} is not {wanted}, off by {off:.2e}"
    );
}

/// The rates right before and right after the first event at or after a time.
#[track_caller]
pub(crate) fn across(record: &Record, t: f64) -> (Vec<f64>, Vec<f64>) {
    let at: Vec<&Sample> = record.trace.iter().filter(|s| s.t == t).collect();
    let (first, last) = (at.first().unwrap(), at.last().unwrap());
    assert!(at.len() >= 2, "{t} is no event");
    (first.rates.clone(), last.rates.clone())
}

/// The energy does not drift by more than a share of what goes through.
#[track_caller]
pub(crate) fn balanced(record: &Record, through: f64, share: f64) {
    let energy = record.energy.unwrap();
    near("drift of energy", energy.drift / through, 0.0, share);
}

/// A generator of numbers from 0 to 1, the same everywhere.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn roll(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.roll()
    }
}
