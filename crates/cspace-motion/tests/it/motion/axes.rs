//! Parts on axes.

use std::f64::consts::TAU;

use cspace::{Axis, Part, Point, Vector};
use cspace_model::{
    Drive, DriveMotion, Load, LoadKind, Mechanism, PartEntry, PartPosition, Spring, SpringKind,
};
use cspace_motion::{EventKind, Status, What};

use crate::motion::helpers::{at, driven, mechanism, polygon, run};

/// A wedge of 30 degrees slides under a roller and lifts it.
#[test]
fn a_wedge_lifts_a_roller() {
    let slope = 30_f64.to_radians().tan();
    let wedge = polygon("wedge", &[(0.0, 0.0), (20.0, 0.0), (20.0, 20.0 * slope)]);
    let roller = Part::circle("roller", (-2.0, 3.0), 1.0).unwrap();
    let parts = vec![
        PartEntry::prismatic(wedge, (-1.0, 0.0)),
        PartEntry::prismatic(roller, (0.0, 1.0)),
    ];
    let (_, record) = run(&driven(mechanism(parts), 0, 2.0), 5.0, 0.05);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    // The face at the roller's centre is slope · (2t − 2) high, and the roller's centre 1/cos 30° above it.
    let touches = 1.0 + (3.0 - 1.0 / 30_f64.to_radians().cos()) / slope / 2.0;
    assert_eq!(record.events.len(), 1, "{:#?}", record.events);
    let touch = &record.events[0];
    assert_eq!(touch.kind, EventKind::Touch);
    assert!((touch.t - touches).abs() < 1e-10, "{} {touches}", touch.t);
    for sample in &record.samples {
        let lift = 2.0 * slope * (sample.t - touches).max(0.0);
        assert!((sample.coordinates[1] - lift).abs() < 1e-9, "{}", sample.t);
        assert!((sample.coordinates[0] - 2.0 * sample.t).abs() < 1e-15);
    }
}

/// A roller of radius r on a disc of radius R that turns about a point e off its centre, held on it by a load.
#[test]
fn a_roller_rides_on_an_eccentric() {
    let (e, big, small) = (3.0, 10.0, 2.0);
    let eccentric = Part::circle("eccentric", (0.0, e), big).unwrap();
    let roller = Part::circle("roller", (0.0, e + big + small), small).unwrap();
    let parts = vec![
        PartEntry::revolute(eccentric, (0.0, 0.0)),
        PartEntry::prismatic(roller, (0.0, 1.0)),
    ];
    let mut cam = driven(mechanism(parts), 0, TAU);
    let kind = LoadKind::Force {
        force: Vector::new(0.0, -1e4),
        at: None,
    };
    cam.dynamics.loads.push(Load { part: 1, kind });
    let (_, record) = run(&cam, 2.0, 0.005);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    for sample in &record.samples {
        let (sin, cos) = (TAU * sample.t).sin_cos();
        let height = e * cos + ((big + small).powi(2) - (e * sin).powi(2)).sqrt();
        let found = e + big + small + sample.coordinates[1];
        assert!(
            (found - height).abs() < 1e-10,
            "{}: {found} {height}",
            sample.t
        );
    }
    assert!(record.events.iter().all(|e| e.kind == EventKind::Touch));
}

/// A block that is pushed to the end of its range stops the drive, and the proof names both.
#[test]
fn the_end_of_a_range_jams() {
    let pusher = Part::rectangle("pusher", (0.0, 0.0), 2.0, 2.0).unwrap();
    let block = Part::rectangle("block", (4.0, 0.0), 2.0, 2.0).unwrap();
    let parts = vec![
        PartEntry::prismatic(pusher, (1.0, 0.0)),
        PartEntry::on(
            block,
            Axis::prismatic(Vector::new(1.0, 0.0)).within(-1.0, 1.5),
        ),
    ];
    let (_, record) = run(&driven(mechanism(parts), 0, 1.0), 10.0, 0.1);
    assert_eq!(record.status, Status::Jammed);
    assert!((record.until - 3.5).abs() < 1e-9, "{}", record.until);
    let limit = What::Limit {
        part: "block".to_owned(),
        limit: cspace_motion::End::Upper,
    };
    assert!(record.obstacles.iter().any(|o| o.what == limit));
    assert!(
        record
            .obstacles
            .iter()
            .any(|o| matches!(o.what, What::Contact { .. }))
    );
    assert!(record.obstacles.iter().all(|o| o.multiplier > 0.0));
    let last = record.samples.last().unwrap();
    assert!((last.t - record.until).abs() < 1e-15 && (last.coordinates[1] - 1.5).abs() < 1e-9);
}

/// A drive against a part that stands still.
#[test]
fn a_fixed_part_jams() {
    let wall = Part::rectangle("wall", (5.0, 0.0), 2.0, 9.0).unwrap();
    let arm = Part::rectangle("arm", (0.0, 3.0), 1.0, 6.0).unwrap();
    let parts = vec![PartEntry::fixed(wall), PartEntry::revolute(arm, (0.0, 0.0))];
    let (_, record) = run(&driven(mechanism(parts), 1, -1.0), 3.0, 0.01);
    assert_eq!(record.status, Status::Jammed);
    // The arm's corner (0.5, 6) comes to x = 4.
    let radius = 6.0_f64.hypot(0.5);
    let turned = (0.5_f64).atan2(6.0) - (4.0 / radius).asin();
    assert!(
        (record.until + turned).abs() < 1e-9,
        "{} {turned}",
        record.until
    );
}

/// A block that slides on a spring, 4 from where that is at rest.
fn sprung(stiffness: f64, damping: f64) -> Mechanism {
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 3.0).unwrap();
    let mut mechanism = mechanism(vec![PartEntry::prismatic(block, (1.0, 0.0))]);
    mechanism.dynamics.part_mut(0).start = Some(PartPosition::Axis(4.0));
    mechanism.dynamics.springs.push(Spring {
        part: 0,
        other: None,
        kind: SpringKind::Linear {
            at: (Point::ORIGIN, Point::new(-10.0, 0.0)),
            stiffness,
            length: 10.0,
            damping,
        },
    });
    mechanism
}

/// A part on a spring jumps to where the spring is at rest, whatever its damper.
#[test]
fn springs_relax() {
    for damping in [0.0, 7.0] {
        for stiffness in [5.0, 1e-9, 1e12] {
            let (_, record) = run(&sprung(stiffness, damping), 3.0, 0.1);
            assert_eq!(record.status, Status::Done, "{:?}", record.reason);
            for sample in &record.samples {
                assert!(sample.coordinates[0].abs() < 1e-12, "{}", sample.t);
            }
            let kinds: Vec<EventKind> = record.events.iter().map(|e| e.kind).collect();
            assert_eq!(kinds, [EventKind::Snap]);
        }
    }
}

/// A wheel drags another by a damper c against the resistance I of that one's outline, by c / (c + I) of its turn.
#[test]
fn a_driven_part_drags_another_by_a_damper() {
    let disc = Part::circle("disc", (0.0, 0.0), 2.0).unwrap();
    let plate = Part::rectangle("plate", (20.0, 0.0), 4.0, 2.0).unwrap();
    let parts = vec![
        PartEntry::revolute(disc, (0.0, 0.0)),
        PartEntry::revolute(plate, (20.0, 0.0)),
    ];
    let mut mechanism = driven(mechanism(parts), 0, 1.0);
    mechanism.dynamics.springs.push(Spring {
        part: 1,
        other: Some(0),
        kind: SpringKind::Torsion {
            stiffness: 0.0,
            angle: 0.0,
            damping: 100.0,
        },
    });
    let (_, record) = run(&mechanism, 1.0, 0.1);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let inertia = 8.0 * (16.0 + 4.0) / 12.0;
    let expected = 100.0 / (100.0 + inertia);
    let turned = at(&record, 1.0)[1];
    assert!((turned - expected).abs() < 1e-9, "{turned} for {expected}");
}

/// A drive with a table moves out and back: it pushes a block and leaves it where it is.
#[test]
fn a_table_pushes_and_lets_go() {
    let pusher = Part::rectangle("pusher", (0.0, 0.0), 2.0, 2.0).unwrap();
    let block = Part::rectangle("block", (3.0, 0.0), 2.0, 2.0).unwrap();
    let parts = vec![
        PartEntry::prismatic(pusher, (1.0, 0.0)),
        PartEntry::prismatic(block, (1.0, 0.0)),
    ];
    let mut mechanism = mechanism(parts);
    let table = vec![(0.0, 0.0), (1.0, 3.0), (2.0, 0.0)];
    let motion = DriveMotion::Table(table);
    mechanism.dynamics.drives.push(Drive { part: 0, motion });
    let (_, record) = run(&mechanism, 4.0, 0.01);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let kinds: Vec<EventKind> = record.events.iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EventKind::Touch, EventKind::Release]);
    assert!((record.events[1].t - 1.0).abs() < 1e-9);
    // u = 4.5 t − 1.5 t³ on the way out.
    let t = record.events[0].t;
    assert!((4.5 * t - 1.5 * t.powi(3) - 1.0).abs() < 1e-9);
    assert!((at(&record, 4.0)[1] - 2.0).abs() < 1e-9);
}

/// Models that cannot be simulated are reported, at once.
#[test]
fn hostile_springs_are_told() {
    for stiffness in [1e300, f64::MAX] {
        let (_, record) = run(&sprung(stiffness, 0.0), 3.0, 0.1);
        let rests = record.samples.last().unwrap().coordinates[0].abs() < 1e-9;
        let is_done = record.status == Status::Done;
        assert!(rests || !is_done, "{stiffness}");
        assert_eq!(record.reason.is_none(), is_done);
    }
}

/// The end is a sample, also if it is none of the even times.
#[test]
fn the_end_is_a_sample() {
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0).unwrap();
    let mechanism = driven(
        mechanism(vec![PartEntry::prismatic(block, (1.0, 0.0))]),
        0,
        2.0,
    );
    for (time, every, count) in [(1.0, 0.3, 5), (0.3, 0.1, 4), (0.7, 0.1, 8), (1.0, 5.0, 2)] {
        let (_, record) = run(&mechanism, time, every);
        assert_eq!(record.samples.len(), count, "{time} {every}");
        let last = record.samples.last().unwrap();
        assert!((last.t - time).abs() < 1e-12 && (last.coordinates[0] - 2.0 * time).abs() < 1e-12);
        assert_eq!(last.rates, [2.0]);
    }
}

/// Nor does a drive that no step can follow go on for ever.
#[test]
fn hostile_drives_are_told() {
    for rate in [1e30, 1e300, f64::MAX] {
        let block = Part::rectangle("block", (0.0, 0.0), 2.0, 3.0).unwrap();
        let wall = Part::rectangle("wall", (9.0, 0.0), 2.0, 3.0).unwrap();
        let parts = vec![
            PartEntry::revolute(block, (0.0, 0.0)),
            PartEntry::planar(wall),
        ];
        let simulation =
            cspace_motion::Simulation::new(&driven(mechanism(parts), 0, rate)).unwrap();
        let settings = cspace_motion::Settings {
            time: 3.0,
            every: None,
        };
        let record = simulation.kinematic(&settings).unwrap();
        assert_eq!(record.status, Status::Undetermined, "{rate}");
    }
}

/// A coupler between two cranks, and between three that are parallel, one too many.
#[test]
fn freedoms_are_counted() {
    let count = |places: &[f64]| {
        let mut text =
            "[[part]]\nname = \"coupler\"\nloops = [ [[-4, 8], [4, 8], [4, 9], [-4, 9]] ]\n"
                .to_owned();
        for (k, x) in places.iter().enumerate() {
            let (a, b) = (x - 0.5, x + 0.5);
            text += &format!(
                "[[part]]\nname = \"crank {k}\"\nmotion = {{ type = \"revolute\", center = [{x}, 0] }}\nloops = [ [[{a}, 0], [{b}, 0], [{x}, 8]] ]\n\
                 [[joint]]\nparts = [\"crank {k}\", \"coupler\"]\ntype = \"revolute\"\nat = [{x}, 8.5]\n"
            );
        }
        let mechanism = cspace_model::model::from_toml(&text, "m.toml").unwrap();
        let freedom = cspace_motion::Simulation::new(&mechanism)
            .unwrap()
            .freedom();
        (freedom.left(), freedom.redundant())
    };
    assert_eq!(count(&[-3.0, 3.0]), (1, 0));
    assert_eq!(count(&[-3.0, 0.5, 3.0]), (1, 1));
}
