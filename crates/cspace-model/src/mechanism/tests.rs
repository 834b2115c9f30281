#![allow(clippy::unwrap_used)]

use super::{JointEntry, Mechanism, MechanismError, PairEntry, PartEntry};
use cspace::geometry::Point;
use cspace::pair::{Joint, PairClass, PairError};
use cspace::part::Part;
use cspace::space::Options;

fn disc(name: &str, x: f64) -> Part {
    Part::circle(name, (x, 0.0), 1.0).unwrap()
}

/// A frame, a wheel at x = 4 and a block that moves freely.
fn three() -> Mechanism {
    let mut mechanism = Mechanism::new("three");
    let block = Part::rectangle("block", (0.0, 9.0), 2.0, 1.0).unwrap();
    mechanism.parts = vec![
        PartEntry::fixed(disc("frame", 0.0)),
        PartEntry::revolute(disc("wheel", 4.0), (4.0, 0.0)),
        PartEntry::planar(block),
    ];
    mechanism.pairs = mechanism.every_two();
    mechanism
}

fn joined(at: f64) -> JointEntry {
    JointEntry {
        joint: Joint::Revolute {
            at: Point::new(at, 0.0),
        },
        parts: (1, 0),
    }
}

#[test]
fn classes_follow_from_axes_and_joints() {
    let mut mechanism = three();
    let classes =
        |m: &Mechanism| -> Vec<PairClass> { m.pairs.iter().map(|p| m.pair_class(p)).collect() };
    let (axes, general) = (PairClass::FixedAxes, PairClass::General);
    assert_eq!(classes(&mechanism), [axes, general, general]);
    mechanism.joints.push(joined(4.0));
    mechanism.check().unwrap();
    assert_eq!(classes(&mechanism), [PairClass::Lower, general, general]);
    for pair in &mechanism.pairs {
        let space = mechanism.compute(pair, &Options::default()).unwrap();
        let name = |i: usize| mechanism.parts[i].part.name();
        assert_eq!(space.fixed().name(), name(pair.fixed));
        assert_eq!(space.moving().name(), name(pair.moving));
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    let refused = |change: &dyn Fn(&mut Mechanism)| {
        let mut mechanism = three();
        change(&mut mechanism);
        mechanism.check().unwrap_err()
    };
    assert_eq!(
        refused(&|m| m.parts.push(PartEntry::planar(disc("wheel", 0.0)))),
        MechanismError::SameName { part: 3, first: 1 }
    );
    assert_eq!(
        refused(&|m| m.parts[2].symmetry = Some(3)),
        MechanismError::Symmetry {
            part: 2,
            declared: 3,
            largest: 2
        }
    );
    assert_eq!(
        refused(&|m| m.joints.push(joined(4.1))),
        MechanismError::Contradiction { joint: 0, part: 1 }
    );
    assert_eq!(
        refused(&|m| m.joints = vec![joined(4.0), joined(4.0)]),
        MechanismError::JoinedTwice { joint: 1, first: 0 }
    );
    assert_eq!(
        refused(&|m| {
            m.joints.push(JointEntry {
                parts: (1, 1),
                ..joined(4.0)
            });
        }),
        MechanismError::JoinsItself { joint: 0 }
    );
    let pair = |fixed, moving, window| PairEntry {
        fixed,
        moving,
        window,
    };
    assert_eq!(
        refused(&|m| m.pairs.push(pair(2, 7, None))),
        MechanismError::NoSuchPart { part: 7, parts: 3 }
    );
    assert_eq!(
        refused(&|m| m.pairs = vec![pair(2, 2, None)]),
        MechanismError::PairedWithItself { pair: 0 }
    );
    assert_eq!(
        refused(&|m| m.pairs.push(pair(2, 0, None))),
        MechanismError::PairedTwice { pair: 3, first: 1 }
    );
    for (lo, hi) in [(1.0, 1.0), (0.0, 7.0)] {
        let error = refused(&|m| m.pairs = vec![pair(0, 2, Some((lo, hi)))]);
        assert_eq!(error, MechanismError::Window { pair: 0, lo, hi });
    }
    let error = refused(&|m| m.pairs = vec![pair(0, 2, Some((f64::NAN, 1.0)))]);
    assert!(matches!(error, MechanismError::Window { .. }));
}

#[test]
fn a_pair_has_its_own_window_where_it_has_orientations() {
    let mut mechanism = three();
    mechanism.pairs[1].window = Some((0.0, 1.0));
    let compute = |i: usize, options: &Options| mechanism.compute(&mechanism.pairs[i], options);
    let window = |options: &Options| match compute(1, options).unwrap() {
        cspace::PairSpace::Planar(space) => (space.window().lo, space.window().hi),
        _ => (0.0, 0.0),
    };
    let other = Options {
        window: Some((2.0, 3.0)),
        ..Options::default()
    };
    assert_eq!(window(&Options::default()), (0.0, 1.0));
    assert_eq!(window(&other), (2.0, 3.0));
    let refused = compute(0, &other).unwrap_err();
    let MechanismError::Pair { fixed, error, .. } = &refused else {
        panic!("{refused}");
    };
    assert_eq!(fixed, "frame");
    assert!(matches!(error, PairError::Window { .. }));
}
