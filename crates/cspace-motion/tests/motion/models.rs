//! Models that ship, driven.

use std::f64::consts::TAU;

use cspace::Mechanism;
use cspace_motion::Status;

use crate::helpers::{driven, run};

fn model(name: &str) -> Mechanism {
    let path = format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    match cspace_io::read(std::path::Path::new(&path)).unwrap() {
        cspace_io::Document::Model(model) => *model,
        cspace_io::Document::Space(_) => panic!("{name} is a model"),
    }
}

#[test]
fn a_geneva_wheel_steps() {
    let mut geneva = model("geneva");
    geneva.dynamics.drives.clear();
    let begin = std::time::Instant::now();
    let (_, record) = run(&driven(geneva, 1, TAU), 3.0, 0.01);
    eprintln!("{:?}", begin.elapsed());
    eprintln!("{:#?} {} events", record.reason, record.events.len());
    for e in &record.events {
        eprintln!("{:.6} {:?} {} {:?}", e.t, e.kind, e.what, e.at);
    }
    for s in record.samples.iter().step_by(10) {
        eprintln!("{} {:.9}", s.t, s.coordinates[0].to_degrees());
    }
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
}

#[test]
fn gears_turn() {
    let mut gears = model("gears_on_shafts");
    gears.dynamics.drives.clear();
    let begin = std::time::Instant::now();
    let (_, record) = run(&driven(gears, 0, TAU), 3.0, 0.01);
    eprintln!("{:?}", begin.elapsed());
    eprintln!("{:#?} {} events", record.reason, record.events.len());
    for e in record.events.iter().take(60) {
        eprintln!("{:.6} {:?} {} {:?}", e.t, e.kind, e.what, e.at);
    }
    for s in record.samples.iter().step_by(50) {
        eprintln!("{} {:.9}", s.t, s.coordinates[1].to_degrees());
    }
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
}

#[test]
fn a_ratchet_advances() {
    let mut ratchet = model("ratchet_mechanism");
    ratchet.dynamics = Default::default();
    use cspace::mechanism::*;
    ratchet.dynamics.springs.push(Spring {
        part: 3,
        other: Some(2),
        kind: SpringKind::Torsion {
            stiffness: 0.0,
            angle: 0.0,
            damping: 1.0,
        },
    });
    ratchet.dynamics.springs.push(Spring {
        part: 4,
        other: None,
        kind: SpringKind::Torsion {
            stiffness: 0.0,
            angle: 0.0,
            damping: 1e9,
        },
    });
    ratchet.dynamics.loads.push(Load {
        part: 3,
        kind: LoadKind::Torque(2e6),
    });
    let begin = std::time::Instant::now();
    let (_, record) = run(&driven(ratchet, 1, TAU), 3.0, 0.01);
    eprintln!("{:?}", begin.elapsed());
    eprintln!("{:#?} {} events", record.reason, record.events.len());
    for e in record.events.iter().take(60) {
        eprintln!("{:.6} {:?} {} {:?}", e.t, e.kind, e.what, e.at);
    }
    for s in record.samples.iter().step_by(5) {
        eprintln!(
            "{:.2} {:?}",
            s.t,
            s.coordinates
                .iter()
                .map(|x| format!("{:.6}", x.to_degrees()))
                .collect::<Vec<_>>()
        );
    }
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
}
