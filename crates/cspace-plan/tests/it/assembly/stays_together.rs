//! Assemblies that do not come apart.

use cspace::{Part, Vertex};
use cspace_model::PartEntry;
use cspace_plan::assembly::{Assembly, AssemblyError, Outcome};

use crate::assembly::judged::{asked, mechanism, polygon};

fn circle(x: f64, y: f64, r: f64) -> Vec<Vertex> {
    vec![Vertex::new(x - r, y, 1.0), Vertex::new(x + r, y, 1.0)]
}

#[test]
fn a_ring_stays_on_its_post() {
    let ring = Part::new("ring", vec![circle(0.0, 0.0, 3.0), circle(0.0, 0.0, 1.5)]).unwrap();
    let post = Part::new("post", vec![circle(0.0, 0.0, 1.5)]).unwrap();
    let block = Part::rectangle("block", (4.0, 0.0), 2.0, 1.0).unwrap();
    let apart = asked(&mechanism(&[], &[ring, block, post]));
    assert_eq!(apart.outcome, Outcome::Locked);
    // The block leaves, or is left.
    assert_eq!(apart.steps.len(), 1);
    assert_eq!(apart.steps[0].moving, [1]);
    let locked = apart.locked.unwrap();
    assert_eq!(locked.parts, [0, 2]);
    assert_eq!(locked.why.len(), 1);
    // The hole of the ring around the post, and nothing else.
    let features = &locked.why[0].features;
    assert!(!features.is_empty());
    for (a, b) in features {
        let of_ring = if a.part == 0 { a } else { b };
        assert_eq!(of_ring.feature.loop_index, 1);
    }
}

/// A base with two hooks, a cover with two that go under these by a shift, and a key that keeps it from shifting.
fn keyed() -> [Part; 3] {
    [
        polygon(
            "base",
            &[
                (0.0, 0.0),
                (10.0, 0.0),
                (10.0, 1.0),
                (8.0, 1.0),
                (8.0, 2.0),
                (9.0, 2.0),
                (9.0, 3.0),
                (7.0, 3.0),
                (7.0, 1.0),
                (2.0, 1.0),
                (2.0, 2.0),
                (3.0, 2.0),
                (3.0, 3.0),
                (1.0, 3.0),
                (1.0, 1.0),
                (0.0, 1.0),
            ],
        ),
        polygon(
            "cover",
            &[
                (0.0, 3.0),
                (3.0, 3.0),
                (3.0, 2.0),
                (2.0, 2.0),
                (2.0, 1.0),
                (4.0, 1.0),
                (4.0, 3.0),
                (9.0, 3.0),
                (9.0, 2.0),
                (8.0, 2.0),
                (8.0, 1.0),
                (10.0, 1.0),
                (10.0, 4.0),
                (0.0, 4.0),
            ],
        ),
        Part::rectangle("key", (5.5, 2.0), 3.0, 2.0).unwrap(),
    ]
}

#[test]
fn three_lock_each_other_of_which_no_two_do() {
    let [base, cover, key] = keyed();
    for two in [[&base, &cover], [&base, &key], [&cover, &key]] {
        let apart = asked(&mechanism(&[], &two.map(Part::clone)));
        assert_eq!(
            apart.outcome,
            Outcome::Apart,
            "{} and {}",
            two[0].name(),
            two[1].name()
        );
    }
    for (fixed, planar) in [
        (vec![base.clone()], vec![cover.clone(), key.clone()]),
        (vec![], vec![base, cover, key]),
    ] {
        let apart = asked(&mechanism(&fixed, &planar));
        // Nothing proves that all three at once could not.
        assert_eq!(apart.outcome, Outcome::Unknown);
        assert!(apart.steps.is_empty());
        let locked = apart.locked.unwrap();
        assert_eq!(locked.parts, [0, 1, 2]);
        // Each division of the three in two.
        assert_eq!(locked.why.len(), 3);
        // Features of several parts that are taken as one are told as each part draws them: all have one loop.
        for why in &locked.why {
            for (staying, moving) in &why.features {
                assert!(why.staying.contains(&staying.part), "{why:?}");
                assert!(why.moving.contains(&moving.part), "{why:?}");
                let loops = [staying.feature.loop_index, moving.feature.loop_index];
                assert_eq!(loops, [0, 0], "{why:?}");
            }
        }
    }
}

#[test]
fn a_key_of_two_lets_them_go_and_a_wider_one_does_not() {
    // The cover must shift by 1 to come off its hooks; the key, at the far end of its room of 3, leaves 3 less its width. The gap of a
    // hundred-thousandth is between the two.
    for (width, outcome) in [(1.999_999, Outcome::Apart), (2.000_1, Outcome::Unknown)] {
        let [base, cover, _] = keyed();
        let key = Part::rectangle("key", (7.0 - 0.5 * width, 1.95), width, 1.9).unwrap();
        let apart = asked(&mechanism(&[base], &[cover, key]));
        assert_eq!(apart.outcome, outcome, "{width}");
    }
}

#[test]
fn parts_that_are_joined_move_as_one() {
    let [base, cover, key] = keyed();
    let mut joined = mechanism(&[], &[key]);
    let body = PartEntry::body(&[base, cover].map(PartEntry::planar)).unwrap();
    joined.parts.push(body);
    let apart = asked(&joined);
    assert_eq!(apart.locked.unwrap().parts, [0, 1]);
}

#[test]
fn overlaps_are_refused_by_name_and_depth() {
    let a = Part::rectangle("left", (0.0, 0.0), 2.0, 2.0).unwrap();
    let b = Part::rectangle("right", (1.9, 0.0), 2.0, 2.0).unwrap();
    let both = mechanism(&[], &[a, b]);
    match Assembly::new(&both, None) {
        Err(AssemblyError::Overlap {
            first,
            second,
            depth,
            ..
        }) => {
            assert_eq!((first.as_str(), second.as_str()), ("left", "right"));
            let depth = depth.unwrap();
            assert!((depth - 0.1).abs() < 1e-9, "{depth}");
        }
        other => panic!("{other:?}"),
    }
    assert!(matches!(
        Assembly::new(&both, Some(1.0)),
        Err(AssemblyError::Gap { .. })
    ));
}
