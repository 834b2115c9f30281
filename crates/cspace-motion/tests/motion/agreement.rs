//! Without inertia parts move as they do with masses that are small and dampers that are large.
//!
//! With C v + m a = F and v changing over times of a second, the two differ by some m/C of the way. The metric of the outlines
//! adds their areas to C: nothing beside it.

use cspace::mechanism::{Drive, DriveMotion, Mass, PartDynamics, Spring, SpringKind};
use cspace::{Mechanism, Part, PartEntry, Point};
use cspace_motion::{EventKind, Record, Settings, Simulation, Status};

use crate::helpers::{judge, mechanism, polygon};

/// Of all dampers, kg/s.
const DAMPING: f64 = 1e9;
/// Masses over the damping, seconds.
const LAGS: [f64; 3] = [1e-2, 1e-3, 1e-4];

fn damper(part: usize, from: (f64, f64), to: (f64, f64), rate: f64, length: f64) -> Spring {
    let at = (Point::new(from.0, from.1), Point::new(to.0, to.1));
    let kind = SpringKind::Linear {
        at,
        stiffness: rate * DAMPING,
        length,
        damping: DAMPING,
    };
    Spring {
        part,
        other: None,
        kind,
    }
}

fn both(mut mechanism: Mechanism, lag: f64, settings: &Settings) -> [Record; 2] {
    mechanism.dynamics.parts = vec![PartDynamics::default(), PartDynamics::default()];
    mechanism.dynamics.parts[1].mass = Some(Mass::Total(lag * DAMPING));
    let simulation = Simulation::new(&mechanism).unwrap();
    let records = [
        simulation.kinematic(settings).unwrap(),
        simulation.dynamic(settings).unwrap(),
    ];
    for record in &records {
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        judge(&simulation, record);
    }
    records
}

/// How far the two are apart at most, at the same times.
fn apart([one, other]: &[Record; 2]) -> f64 {
    let mut most = 0.0_f64;
    for a in &one.samples {
        let near = |b: &&cspace_motion::Sample| (a.t - b.t).abs() < 1e-9;
        let b = other.samples.iter().find(near).unwrap();
        for (x, y) in a.coordinates.iter().zip(&b.coordinates) {
            most = most.max((x - y).abs());
        }
    }
    most
}

/// They are apart by no more than a speed times the lag, and by some of it.
#[track_caller]
fn agree(scene: &Mechanism, speed: f64, time: f64, kinds: &[EventKind]) {
    let every = Some(time / 16.0);
    let mut before = f64::INFINITY;
    for lag in LAGS {
        let records = both(scene.clone(), lag, &Settings { time, every });
        let found: Vec<EventKind> = records[0].events.iter().map(|e| e.kind).collect();
        assert_eq!(found, kinds, "{:#?}", records[0].events);
        let far = apart(&records);
        assert!(
            far < speed * lag && far > 1e-2 * speed * lag,
            "{lag}: {far:e}"
        );
        assert!(far < 0.2 * before, "{lag}: {far:e} {before:e}");
        before = far;
    }
}

/// A block, free in the plane, is drawn down on a slope by springs and slides and turns there.
#[test]
fn a_block_on_a_slope() {
    let slope = polygon(
        "slope",
        &[(-9.0, -9.0), (9.0, -9.0), (9.0, 1.0), (-9.0, -5.0)],
    );
    let block = polygon(
        "block",
        &[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)],
    );
    let mut scene = mechanism(vec![PartEntry::fixed(slope), PartEntry::planar(block)]);
    scene.dynamics.springs = vec![
        damper(1, (-1.0, 0.0), (-7.0, 0.0), 0.4, 3.0),
        damper(1, (-1.0, -1.0), (-1.5, -6.0), 0.4, 3.0),
        damper(1, (1.0, -1.0), (1.5, -6.0), 0.4, 3.0),
    ];
    agree(&scene, 2.0, 1.5, &[EventKind::Touch]);
}

/// An eccentric lifts a roller, which a spring brings down too slowly to stay on it.
#[test]
fn a_roller_that_falls_behind_its_cam() {
    let eccentric = Part::circle("eccentric", (0.0, 3.0), 10.0).unwrap();
    let roller = Part::circle("roller", (0.0, 15.0), 2.0).unwrap();
    let parts = vec![
        PartEntry::revolute(eccentric, (0.0, 0.0)),
        PartEntry::prismatic(roller, (0.0, 1.0)),
    ];
    let mut scene = mechanism(parts);
    scene.dynamics.drives.push(Drive {
        part: 0,
        motion: DriveMotion::Rate(2.0),
    });
    scene.dynamics.springs = vec![damper(1, (0.0, 15.0), (0.0, 0.0), 0.4, 6.0)];
    let kinds = [
        EventKind::Touch,
        EventKind::Release,
        EventKind::Touch,
        EventKind::Release,
        EventKind::Touch,
    ];
    agree(&scene, 12.0, 5.5, &kinds);
}
