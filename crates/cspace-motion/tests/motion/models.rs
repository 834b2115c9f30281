//! Models that ship, driven.

use std::f64::consts::TAU;

use cspace::Mechanism;
use cspace_motion::{EventKind, Record, Status};

use crate::helpers::{at, run};

fn model(name: &str) -> Mechanism {
    let path = format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    match cspace_io::read(std::path::Path::new(&path)).unwrap() {
        cspace_io::Document::Model(model) => *model,
        cspace_io::Document::Space(_) => panic!("{name} is a model"),
    }
}

#[track_caller]
fn is_done(record: &Record) {
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
}

/// 60 degrees a turn, to 1e-9 degrees, and at rest while the disc locks it.
#[test]
fn a_geneva_wheel_steps() {
    let (_, record) = run(&model("geneva"), 4.0, 0.01);
    is_done(&record);
    for t in [1.0, 1.25, 1.5, 1.7, 2.0, 2.9] {
        let step = at(&record, t + 1.0)[0] - at(&record, t)[0];
        let error = (step.to_degrees() + 60.0).abs();
        assert!(error < 1e-9, "{t}: {error:e}");
    }
    assert_eq!(at(&record, 2.0)[0], at(&record, 2.3)[0]);
    // The pin comes in and the disc lets go once a turn, at the same times.
    let touches: Vec<f64> = (record.events.iter())
        .filter(|e| e.kind == EventKind::Touch && e.t > 1.0)
        .map(|e| e.t)
        .collect();
    assert_eq!(touches.len(), 6);
    assert!(touches.windows(3).all(|w| (w[2] - w[0] - 1.0).abs() < 1e-9));
}

/// 12 teeth drive 10: over whole turns the ratio is exact, and tooth for tooth the motion is the same.
#[test]
fn gears_turn() {
    let (_, record) = run(&model("gears_on_shafts"), 3.0, 0.025);
    is_done(&record);
    for t in [0.5, 1.0, 1.75] {
        let turned = at(&record, t + 1.0)[1] - at(&record, t)[1];
        assert!((turned / TAU + 1.2).abs() < 1e-11, "{}", turned / TAU);
    }
    // From one tooth to the next: a twelfth of a second.
    let touches: Vec<f64> = (record.events.iter())
        .filter(|e| e.kind == EventKind::Touch)
        .map(|e| e.t)
        .collect();
    assert!(touches.len() > 30);
    assert!(
        touches[2..]
            .windows(2)
            .all(|w| (w[1] - w[0] - 1.0 / 12.0).abs() < 1e-9)
    );
}

/// One tooth, 18 degrees, a turn of the driver.
#[test]
fn a_ratchet_advances() {
    let (simulation, record) = run(&model("ratchet_mechanism"), 4.0, 0.01);
    is_done(&record);
    let wheel = simulation.system().parts()[4].indices().start;
    for t in [1.0, 1.25, 1.5, 2.0, 2.6, 3.0] {
        let turned = (at(&record, t + 1.0)[wheel] - at(&record, t)[wheel]).to_degrees();
        assert!((turned - 18.0).abs() < 1e-9, "{t}: {turned}");
    }
    // The link follows the direction of the eccentric's centre, but for its play: 11.25 degrees either way.
    let link = simulation.system().parts()[2].indices().start;
    let angles = || {
        record
            .samples
            .iter()
            .filter(|s| s.t > 0.1)
            .map(|s| s.coordinates[link].to_degrees())
    };
    let (least, most) = (
        angles().fold(f64::MAX, f64::min),
        angles().fold(f64::MIN, f64::max),
    );
    let swing = (19.5_f64 / 100.0).asin().to_degrees();
    assert!(
        (most - swing).abs() < 0.1 && (least + swing).abs() < 0.2,
        "{least} {most}"
    );
}

/// Times of events are the same whatever is sampled; which part is called fixed and which comes first changes nothing.
#[test]
fn how_it_is_told_changes_nothing() {
    let gears = model("gears_on_shafts");
    let (_, one) = run(&gears, 1.0, 0.5);
    let (_, often) = run(&gears, 1.0, 0.0137);
    assert_eq!(one.events, often.events);
    let mut swapped = gears;
    swapped.parts.reverse();
    swapped.dynamics.drives[0].part = 1;
    let (_, swapped) = run(&swapped, 1.0, 0.5);
    assert_eq!(one.events.len(), swapped.events.len());
    assert!(one.events.len() > 20);
    for (e, s) in one.events.iter().zip(&swapped.events) {
        assert!((e.t - s.t).abs() < 1e-9 && e.kind == s.kind, "{e:?} {s:?}");
    }
    for (s, t) in one.samples.iter().zip(&swapped.samples) {
        assert!((s.coordinates[1] - t.coordinates[0]).abs() < 1e-10);
    }
}
