//! Parts on axes.

use std::f64::consts::TAU;

use cspace::{Part, PartEntry};
use cspace_motion::{EventKind, Status};

use crate::helpers::{driven, mechanism, run};

/// A bar turns about the origin and pushes a bar that turns about a pivot beside it.
#[test]
fn a_turning_part_pushes_another() {
    let arm = Part::rectangle("arm", (5.0, 0.0), 10.0, 1.0).unwrap();
    let lever = Part::rectangle("lever", (8.0, 6.0), 1.0, 8.0).unwrap();
    let parts = vec![
        PartEntry::revolute(arm, (0.0, 0.0)),
        PartEntry::revolute(lever, (8.0, 9.0)),
    ];
    let (_, record) = run(&driven(mechanism(parts), 0, 1.0), 3.0, 0.01);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    assert_eq!(record.events[0].kind, EventKind::Touch);
    let end = record.samples.last().unwrap();
    assert!((end.coordinates[0] - 3.0).abs() < 1e-12 && end.coordinates[1].abs() > 0.5);
    eprintln!("{:#?}", record.events);
    let _ = TAU;
}
