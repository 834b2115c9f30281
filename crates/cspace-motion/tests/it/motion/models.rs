//! Models that ship, driven.

use std::f64::consts::TAU;

use cspace_motion::{EventKind, Record, Status};

use crate::motion::helpers::{at, model, run};

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

/// The ratchet advances by one tooth, 18 degrees, per turn of the driver.
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

/// The wheel turns by one of its 30 teeth while the anchor swings to and fro, and rests in between.
#[test]
fn an_escapement_ticks() {
    let (_, record) = run(&model("escapement"), 6.0, 0.0125);
    is_done(&record);
    let wheel = |t: f64| at(&record, t)[0].to_degrees();
    for t in [1.25, 2.25, 3.25, 4.25, 1.75, 2.75, 3.75] {
        let step = wheel(t + 1.0) - wheel(t);
        assert!((step + 12.0).abs() < 1e-9, "{t}: {step}");
    }
    // On the arc about the anchor's pivot it does not move.
    assert!((wheel(3.25) - wheel(3.3)).abs() < 1e-9);
}

/// Between the dwell at R34 and the base circle at R22, drawn 0.1 above the dwell.
#[test]
fn a_tappet_rises_and_falls() {
    let (_, record) = run(&model("cam_tappet"), 2.0, 0.005);
    is_done(&record);
    let lifts = || record.samples.iter().skip(4).map(|s| s.coordinates[1]);
    let (least, most) = (
        lifts().fold(f64::MAX, f64::min),
        lifts().fold(f64::MIN, f64::max),
    );
    assert!((most + 0.1).abs() < 1e-9, "{most}");
    assert!((least + 12.1).abs() < 1e-9, "{least}");
}

/// From tooth to tooth a rack moves by 24 times the angle of its pinion.
#[test]
fn a_rack_is_pushed_on() {
    let mut rack = model("rack_pinion");
    rack.dynamics.drives[0].motion = cspace_model::DriveMotion::Rate(1.0);
    let tooth = TAU / 12.0;
    let (_, record) = run(&rack, 4.5 * tooth, tooth / 8.0);
    is_done(&record);
    for k in [4.0, 8.0, 11.0, 17.0] {
        let t = k * tooth / 8.0;
        let step = at(&record, t + 2.0 * tooth)[1] - at(&record, t)[1];
        assert!((step - 2.0 * 24.0 * tooth).abs() < 1e-9, "{t}: {step}");
    }
}

/// Contacts do not depend on the length of steps: if two contacts hold the same pair in turn, neither is missed.
#[test]
fn a_rack_is_held_by_one_tooth_after_the_other() {
    let rack = model("rack_pinion");
    let (_, short) = run(&rack, 0.0045, 0.0005);
    let (_, long) = run(&rack, 1.3, 0.0005);
    assert_eq!(short.events.len(), 3, "{:#?}", short.events);
    for (s, l) in short.events.iter().zip(&long.events) {
        assert!((s.t - l.t).abs() < 1e-9 && s.kind == l.kind && s.what == l.what);
    }
}

/// The spring keeps the hook straight while nothing touches it: it lags behind by what turns it over the stiffness.
#[test]
fn a_stiff_hook_is_not_lost() {
    let (_, record) = run(&model("snap_in"), 0.4, 0.0005);
    is_done(&record);
    assert_eq!(record.events, []);
    let most = (record.samples.iter()).fold(0.0_f64, |m, s| m.max(s.coordinates[3].abs()));
    assert!(most < 2e-4, "{most}");
}
