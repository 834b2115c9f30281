//! A disc larger than its hole does not pass, whatever pushes it.

use cspace::{Part, Vector};
use cspace_model::{Load, LoadKind, PartEntry};
use cspace_motion::{Record, Status};

use crate::motion::helpers::{mechanism, polygon, run};

/// Excess of the discs over their hole, as a share of its width.
const LARGER: [f64; 4] = [1e-9, 1e-7, 1e-5, 1e-3];
/// Forces from a push to one that nothing withstands.
const FORCES: [f64; 3] = [1e2, 1e6, 1e12];

/// A plate with a hole 2 wide, its corners sharp or rounded.
fn plate(round: bool) -> PartEntry {
    let halves = [-1.0, 1.0].map(|side: f64| {
        if round {
            vec![
                cspace::Vertex::new(2.0 * side, 1.0, 1.0),
                cspace::Vertex::new(2.0 * side, -1.0, 1.0),
            ]
        } else {
            [(1.0, -1.0), (6.0, -1.0), (6.0, 0.0), (1.0, 0.0)]
                .map(|(x, y)| cspace::Vertex::line(side * x, y))
                .to_vec()
        }
    });
    PartEntry::fixed(Part::new("plate", halves.to_vec()).unwrap())
}

fn pushed(round: bool, planar: bool, radius: f64, force: f64) -> Record {
    let disc = Part::circle("disc", (0.0, 3.0), radius).unwrap();
    let disc = if planar {
        PartEntry::planar(disc)
    } else {
        PartEntry::prismatic(disc, (0.0, -1.0))
    };
    let mut scene = mechanism(vec![plate(round), disc]);
    let force = Vector::new(0.0, -force);
    let kind = LoadKind::Force { force, at: None };
    scene.dynamics.loads.push(Load { part: 1, kind });
    let (_, record) = run(&scene, 1e3 / force.length() + 1e-3, 1.0);
    record
}

/// Height of the disc's centre at the end.
fn low(record: &Record, planar: bool) -> f64 {
    let q = &record.samples.last().unwrap().coordinates;
    3.0 + if planar { q[1] } else { -q[0] }
}

#[test]
fn a_disc_larger_than_its_hole_does_not_pass() {
    for round in [false, true] {
        for planar in [false, true] {
            for larger in LARGER {
                for force in FORCES {
                    let what = format!("round {round}, planar {planar}, {larger:e}, {force:e}");
                    let radius = 1.0 + larger;
                    let record = pushed(round, planar, radius, force);
                    // It rests on both corners, or on both roundings of radius 1 about (±2, 0).
                    let (reach, half) = if round {
                        (radius + 1.0, 2.0)
                    } else {
                        (radius, 1.0)
                    };
                    let height = (reach * reach - half * half).sqrt();
                    let low = low(&record, planar);
                    assert_eq!(record.status, Status::Done, "{what}: {:?}", record.reason);
                    // What rests there is known to the resolution, and its height, as wedges go, to less.
                    assert!(low >= height - 1e-11 / height, "{what}: {low} {height}");
                    assert!(low <= height + 1e-11 / height, "{what}: {low} {height}");
                }
            }
        }
    }
}

/// A disc that is smaller than its hole passes, and nothing stops it.
#[test]
fn a_disc_smaller_than_its_hole_passes() {
    for round in [false, true] {
        for planar in [false, true] {
            for smaller in [1e-6, 1e-3] {
                let record = pushed(round, planar, 1.0 - smaller, 1e2);
                let what = format!("{round} {planar} {smaller}");
                assert_eq!(record.status, Status::Undetermined, "{what}");
                let reason = record.reason.unwrap();
                assert!(reason.starts_with("nothing stops disc"), "{what}: {reason}");
            }
        }
    }
}

/// A bar pushed across a slot that is shorter than it is, by a corner, stays on it however it turns.
#[test]
fn a_bar_longer_than_its_slot_stays_on_it() {
    for force in FORCES {
        let halves = |side: f64| {
            [(1.0, -1.0), (6.0, -1.0), (6.0, 0.0), (1.0, 0.0)]
                .map(|(x, y)| cspace::Vertex::line(side * x, y))
                .to_vec()
        };
        let table = Part::new("table", vec![halves(-1.0), halves(1.0)]).unwrap();
        let bar = polygon(
            "bar",
            &[(-1.001, 0.5), (1.001, 0.5), (1.001, 2.6), (-1.001, 2.6)],
        );
        let mut scene = mechanism(vec![PartEntry::fixed(table), PartEntry::planar(bar)]);
        let kind = LoadKind::Force {
            force: Vector::new(0.0, -force),
            at: None,
        };
        scene.dynamics.loads.push(Load { part: 1, kind });
        let (_, record) = run(&scene, 1e3 / force, 1.0);
        let q = &record.samples.last().unwrap().coordinates;
        assert!((q[1] + 0.5).abs() < 1e-9 && q[2].abs() < 1e-9, "{q:?}");
    }
}
