//! Lower pairs: the definition of a joint is written independently, by the motion of points, and compared with the pair.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use cspace::pair::{Joint, LowerData, PairMotion, PermanentKind};
use cspace::{
    Axis, Classification, Configuration, Coordinates, Location, LowerPair, Options, PairClass,
    PairError, PairSpace, Part, PatchId, Point, QueryError, Relation, Rotation, Vector, Vertex,
};

const AT: Point = Point::new(1.5, -0.75);
const ALONG: Vector = Vector::new(3.0, -4.0);

fn bar(name: &str, length: f64) -> Part {
    let corners = [(0.0, 0.0), (length, 0.0), (length, 1.0), (0.0, 1.0)];
    let outline = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    Part::new(name, vec![outline]).unwrap()
}

fn pair(joint: Joint, limits: Option<(f64, f64)>) -> LowerPair {
    LowerPair::new(&bar("frame", 4.0), &bar("arm", 3.0), joint, limits)
}

fn joints() -> [Joint; 2] {
    [
        Joint::Revolute { at: AT },
        Joint::Prismatic {
            direction: ALONG,
            at: AT,
        },
    ]
}

/// Image of a point of the moving part at a configuration.
fn placed(c: Configuration, q: Point) -> Point {
    c.position() + Rotation::by(c.theta) * q.to_vector()
}

fn space(joint: Joint) -> PairSpace {
    PairSpace::Lower(Box::new(pair(joint, None)))
}

/// A revolute joint leaves its point in place and turns the rest about it; a prismatic one moves all points alike.
#[test]
fn a_joint_moves_points_as_it_should() {
    let points = [Point::ORIGIN, AT, Point::new(-2.0, 7.0)];
    let [revolute, prismatic] = joints().map(|j| pair(j, None));
    for t in [-9.0, -0.3, 0.0, 1.0, 4.0] {
        for q in points {
            let turned = placed(revolute.configuration(t), q);
            let arm = Rotation::by(t) * (q - AT);
            assert!(turned.distance(AT + arm) < 1e-13, "{t}");
            let slid = placed(prismatic.configuration(t), q);
            assert!(slid.distance(q + Vector::new(0.6, -0.8) * t) < 1e-13, "{t}");
        }
    }
}

/// The table of section 3.2: the contacts of each joint, which vanish on it and only there.
#[test]
fn permanent_contacts_vanish_on_the_joint_and_not_off_it() {
    use PermanentKind::{PointArc, PointLine};
    let kinds: [&[PermanentKind]; 3] =
        [&[PointArc], &[PointLine, PointLine], &[PointArc, PointLine]];
    for (joint, kinds) in joints().into_iter().zip(kinds) {
        let pair = pair(joint, None);
        let contacts = pair.contacts();
        let found: Vec<PermanentKind> = contacts.iter().map(|c| c.kind).collect();
        assert_eq!(found, kinds, "{joint:?}");
        assert!(contacts.iter().all(|c| c.permanent));
        let most = |c: Configuration| {
            (contacts.iter())
                .map(|k| k.function.value(c.position(), c.theta).abs())
                .fold(0.0, f64::max)
        };
        for t in [-7.0, -1.0, 0.0, 0.25, 3.0] {
            let on = pair.configuration(t);
            assert!(most(on) < 1e-14 * (1.0 + t.abs()), "{joint:?} {t}");
            // A step off the joint: across the line of sliding or anywhere, and by turning about a point other than the joint's. It must
            // have a first-order effect.
            for step in [1e-9, 1e-3, 0.5] {
                let away = ALONG.unit().left() * step;
                let shifted = Configuration::new(on.x + away.x, on.y + away.y, on.theta);
                assert!(most(shifted) > 0.5 * step, "{joint:?} {t} {step}");
                let turned = Configuration::new(on.x, on.y, on.theta + step);
                assert!(most(turned) > 0.1 * step, "{joint:?} {t} {step}");
                for c in [shifted, turned] {
                    assert_eq!(pair.classify(c), Some(Classification::Blocked));
                }
            }
            assert_eq!(pair.classify(on), Some(Classification::Contact));
        }
        // Half a turn further: not a configuration of a joint that does not turn, though points may be on their lines again.
        if !matches!(joint, Joint::Revolute { .. }) {
            let over = Configuration::new(0.0, 0.0, PI);
            assert_eq!(pair.classify(over), Some(Classification::Blocked));
        }
        for whole in [TAU, -3.0 * TAU] {
            let on = pair.configuration(0.0);
            let again = Configuration::new(on.x, on.y, on.theta + whole);
            assert_eq!(pair.classify(again), Some(Classification::Contact));
        }
        for bad in [f64::NAN, f64::INFINITY] {
            assert_eq!(pair.classify(Configuration::new(bad, 0.0, 0.0)), None);
            assert_eq!(pair.classify(Configuration::new(0.0, 0.0, bad)), None);
        }
    }
}

#[test]
fn configurations_beyond_the_limits_are_blocked() {
    let [revolute, prismatic] = joints();
    let class = |p: &LowerPair, t: f64| p.classify(p.configuration(t)).unwrap();
    let turning = pair(revolute, Some((-0.5, 2.0)));
    // Orientations repeat: a turn more or less is the same configuration.
    for turn in [0.0, TAU, -TAU] {
        for (t, expected) in [
            (-0.5001, Classification::Blocked),
            (-0.5, Classification::Contact),
            (1.0, Classification::Contact),
            (2.0, Classification::Contact),
            (2.0001, Classification::Blocked),
            (4.0, Classification::Blocked),
        ] {
            assert_eq!(class(&turning, t + turn), expected, "{t} {turn}");
        }
    }
    let sliding = pair(prismatic, Some((0.0, 5.0)));
    for (t, expected) in [
        (-1e-6, Classification::Blocked),
        (0.0, Classification::Contact),
        (5.0, Classification::Contact),
        (5.000_001, Classification::Blocked),
        (5.0 + TAU, Classification::Blocked),
    ] {
        assert_eq!(class(&sliding, t), expected, "{t}");
    }
    assert_eq!(sliding.limits(), Some((0.0, 5.0)));
    let more_than_a_turn = pair(revolute, Some((-4.0, 4.0)));
    assert_eq!(class(&more_than_a_turn, PI), Classification::Contact);
}

#[test]
fn limits_follow_from_the_ranges_of_the_parts() {
    let [revolute, prismatic] = joints();
    let of = LowerPair::limits_from_axes;
    let turning = Axis::revolute(AT).within(-1.0, 2.0);
    assert_eq!(of(&revolute, &Axis::FIXED, &turning), Some((-1.0, 2.0)));
    assert_eq!(of(&revolute, &turning, &Axis::FIXED), Some((-2.0, 1.0)));
    let other = Axis::revolute(AT).within(0.0, 0.5);
    assert_eq!(of(&revolute, &turning, &other), Some((-2.0, 1.5)));
    // Without a range, about another point, or of another kind: no limits follow.
    for axis in [
        Axis::revolute(AT),
        Axis::revolute(Point::new(1.5, 0.0)).within(-1.0, 2.0),
        Axis::prismatic(ALONG).within(-1.0, 2.0),
    ] {
        assert_eq!(of(&revolute, &Axis::FIXED, &axis), None, "{axis:?}");
    }
    // The direction's length does not matter, but its sense does.
    let sliding = |by: f64| Axis::prismatic(ALONG * by).within(-1.0, 2.0);
    assert_eq!(
        of(&prismatic, &Axis::FIXED, &sliding(7.0)),
        Some((-1.0, 2.0))
    );
    assert_eq!(
        of(&prismatic, &Axis::FIXED, &sliding(-7.0)),
        Some((-2.0, 1.0))
    );
    assert_eq!(of(&revolute, &Axis::FIXED, &Axis::FIXED), None);
}

#[test]
fn questions_without_a_meaning_are_refused() {
    let axes = Coordinates::Axes { u: 0.0, v: 0.0 };
    let planar = Coordinates::Planar(Configuration::default());
    for joint in joints() {
        let space = space(joint);
        assert_eq!(space.class(), PairClass::Lower);
        assert_eq!((space.region_count(), space.band_count()), (0, 1));
        let permanent = space.patch_count();
        assert!(matches!(
            space.classify(axes),
            Err(QueryError::Coordinates {
                class: PairClass::Lower,
                wanted: "x, y and theta",
                given: "u and v"
            })
        ));
        assert!(space.contacts(axes, 1.0).is_err());
        assert_eq!(
            space.bands(),
            Err(QueryError::NoOrientation {
                class: PairClass::Lower
            })
        );
        assert_eq!(space.locate(planar), Ok(Location::Contact));
        let patch = space.patches().next().unwrap();
        assert_eq!(patch.features(), Err(QueryError::Permanent));
        let nowhere = Coordinates::Planar(Configuration::new(f64::NAN, 0.0, 0.0));
        assert_eq!(space.classify(nowhere), Err(QueryError::Outside));
        assert_eq!(space.contacts(planar, 1e-9).unwrap().len(), permanent);
        assert_eq!(
            space.first_contact(planar, planar, 1.0),
            Err::<PairMotion, _>(QueryError::Permanent)
        );
        for i in 0..permanent as u32 {
            let n = space.neighbours(PatchId(i)).unwrap();
            assert!(
                [n.before, n.after, n.below, n.above]
                    .iter()
                    .all(Vec::is_empty)
            );
        }
        assert!(matches!(
            space.neighbours(PatchId(permanent as u32)),
            Err(QueryError::NoPatch { .. })
        ));
    }
}

#[test]
fn a_window_of_orientations_is_refused() {
    let (frame, arm) = (bar("frame", 4.0), bar("arm", 3.0));
    let options = Options {
        window: Some((0.0, 1.0)),
        ..Options::default()
    };
    let relation = Relation::Joint(Joint::Revolute { at: AT }, None);
    let error = PairSpace::compute(&frame, &arm, relation, &options).unwrap_err();
    let class = PairClass::Lower;
    assert_eq!(error, PairError::Window { class });
    assert!(error.to_string().contains("lower pair"), "{error}");
}

#[test]
fn saved_pairs_are_read_as_the_same() {
    for joint in joints() {
        for limits in [None, Some((-0.5, 1.0 / 3.0))] {
            let pair = pair(joint, limits);
            let text = serde_json::to_string(&pair.data()).unwrap();
            let saved: LowerData = serde_json::from_str(&text).unwrap();
            assert_eq!(saved, pair.data());
            let again = LowerPair::from_data(saved).unwrap();
            assert_eq!(again.data(), pair.data());
            assert_eq!(again.contacts(), pair.contacts());
            assert_eq!(again.fixed(), pair.fixed());
            for t in [-0.4, 0.0, 0.3, 0.5, FRAC_PI_2] {
                let c = pair.configuration(t);
                assert_eq!(again.classify(c), pair.classify(c));
            }
        }
    }
}

#[test]
fn damaged_data_are_refused() {
    let good = pair(joints()[1], Some((0.0, 1.0))).data();
    let refused = |change: &dyn Fn(&mut LowerData)| {
        let mut bad = good.clone();
        change(&mut bad);
        LowerPair::from_data(bad).unwrap_err().to_string()
    };
    assert!(refused(&|s| s.format = "contact-space".into()).contains("contact-space"));
    assert!(refused(&|s| s.version += 1).contains("version"));
    assert!(refused(&|s| s.limits = Some((1.0, 0.0))).contains("limits"));
    assert!(refused(&|s| s.limits = Some((0.0, f64::NAN))).contains("limits"));
    let at = AT;
    for joint in [
        Joint::Prismatic {
            direction: Vector::ZERO,
            at,
        },
        Joint::Prismatic {
            direction: Vector::new(f64::NAN, 1.0),
            at,
        },
        Joint::Revolute {
            at: Point::new(0.0, f64::INFINITY),
        },
    ] {
        assert!(refused(&|s| s.joint = joint).contains("joint"), "{joint:?}");
    }
    let mut json = serde_json::to_value(&good).unwrap();
    json["fixed"]["loops"] = serde_json::json!([]);
    let error = serde_json::from_value::<LowerData>(json).unwrap_err();
    assert!(error.to_string().contains("loop"), "{error}");
}
