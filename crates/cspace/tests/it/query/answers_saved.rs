//! Answers that are written and read again are equal.

use core::fmt::Debug;

use cspace::pair::{Neighbours, PairContact, PairMotion, PairNearest};
use cspace::part::{ArcSize, Direction};
use cspace::{
    Axis, Classification, Configuration, Coordinates, Edge, FirstContact, Metric, MotionOutcome,
    NearestContact, Part, PatchId, Point, Projection, Relation, Vector,
};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Text of an answer, from which the answer is read back.
fn again<T: Serialize + DeserializeOwned + PartialEq + Debug>(answer: T) -> String {
    let text = serde_json::to_string(&answer).unwrap();
    assert_eq!(serde_json::from_str::<T>(&text).unwrap(), answer, "{text}");
    text
}

#[test]
fn answers_come_back() {
    let c = Configuration::new(1.0, 2.0, 0.1);
    let (patch, at) = (PatchId(7), Coordinates::Axes { u: 0.25, v: -1.0 });
    assert_eq!(again(Classification::Blocked), r#""blocked""#);
    assert_eq!(again(at), r#"{"u":0.25,"v":-1.0}"#);
    assert_eq!(
        again(Coordinates::Planar(c)),
        r#"{"x":1.0,"y":2.0,"theta":0.1}"#
    );
    assert_eq!(again(PairMotion::Free), r#""free""#);
    assert_eq!(
        again(PairMotion::Leaves { time: 0.5 }),
        r#"{"leaves":{"time":0.5}}"#
    );
    again(PairMotion::Contact(PairContact {
        time: 0.5,
        at,
        patch,
    }));
    again(PairNearest {
        patch,
        at,
        distance: 0.125,
    });
    again(Metric {
        length_per_radian: 2.5,
    });
    again(Projection {
        at,
        distance: 0.125,
    });
    again(Neighbours {
        before: vec![PatchId(1)],
        after: vec![PatchId(2), PatchId(3)],
        ..Neighbours::default()
    });
    again(MotionOutcome::LeavesWindow { time: 2.0 });
    again(MotionOutcome::Free);
    let (configuration, distance) = (c, 0.5);
    again(NearestContact {
        patch,
        configuration,
        distance,
    });
    again(Relation::Planar);
    again(Relation::Axes {
        fixed: Axis::FIXED,
        moving: Axis::prismatic(Vector::new(1.0, 0.0)),
    });
    assert_eq!(again(Direction::CounterClockwise), r#""counter-clockwise""#);
    assert_eq!(again(ArcSize::Long), r#""long""#);
    let part = Part::circle("disc", Point::ORIGIN, 1.0).unwrap();
    again(part.bounds());
    again(part.edges().collect::<Vec<Edge>>());
    assert!(
        serde_json::to_string(&part.symmetry())
            .unwrap()
            .contains(r#""round":true"#)
    );
    let _: fn(FirstContact) -> String = again;
}
