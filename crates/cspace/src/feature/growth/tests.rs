//! Growths of rings with known sums.

use super::super::tolerance::SAME_CARRIER;
use super::*;
use crate::geometry::Point;
use crate::part::{Part, Vertex};

/// Whether all loops are grown alike.
fn are_even(growths: &Growths) -> bool {
    growths.levels.iter().all(|&l| l == 0)
}

/// A loop of two half circles.
fn circle(radius: f64) -> Vec<Vertex> {
    vec![
        Vertex::new(radius, 0.0, 1.0),
        Vertex::new(-radius, 0.0, 1.0),
    ]
}

fn outline(radii: &[f64], growth: f64) -> Outline {
    let part = Part::new("rings", radii.iter().map(|&r| circle(r)).collect()).unwrap();
    Outline::new(&part, Point::ORIGIN, 0.125, growth)
}

fn loops(outline: &Outline, features: (u32, u32)) -> (u32, u32) {
    let of = |i: u32| outline.features[i as usize].name.loop_index;
    (of(features.0), of(features.1))
}

/// Material within 0.5 and from 1.5 to 2, against material from 0.75 to 1.25 and from 2.25 to 2.5: the clearances inside, between and
/// outside are equal.
#[test]
fn rings_of_equal_room_have_equal_sums() {
    let fixed = outline(&[2.0, 1.5, 0.5], GROWTH);
    let moving = outline(&[2.5, 2.25, 1.25, 0.75], MOVING_GROWTH);
    let sums = equal_sums(&fixed, &moving).unwrap();
    assert!(!sums.is_empty());
    let radius = |o: &Outline, i: u32| o.features[i as usize].radius();
    for s in &sums {
        let one = radius(&fixed, s.fixed.0) + radius(&moving, s.moving.0);
        let other = radius(&fixed, s.fixed.1) + radius(&moving, s.moving.1);
        assert!((one - other).abs() <= SAME_CARRIER, "{s:?}");
        assert!(radius(&fixed, s.fixed.0) < radius(&fixed, s.fixed.1));
    }
    let touch = |fixed_loops, moving_loops| {
        sums.iter().any(|s| {
            (loops(&fixed, s.fixed), loops(&moving, s.moving)) == (fixed_loops, moving_loops)
        })
    };
    // The disc in the inner ring's hole and the outer edge in the outer one's: 0.5 − 0.75 = 2 − 2.25.
    assert!(touch((2, 0), (3, 1)));
    // The groove and the inner ring: 1.25 − 1.5.
    assert!(touch((1, 2), (2, 3)));
    let (f, m) = Growths::new(&fixed, &moving);
    assert!(!are_even(&f) && are_even(&m));
    // As grown then, no sums are equal.
    let [fixed, moving] =
        [(vec![2.0, 1.5, 0.5], f), (vec![2.5, 2.25, 1.25, 0.75], m)].map(|(radii, growths)| {
            let part = Part::new("rings", radii.into_iter().map(circle).collect()).unwrap();
            Outline::grown_by(&part, Point::ORIGIN, 0.125, |l| growths.of(l), None)
        });
    assert_eq!(equal_sums(&fixed, &moving), Some(Vec::new()));
}

#[test]
fn what_has_no_equal_sums_is_grown_evenly() {
    let fixed = outline(&[2.0, 1.5, 0.5], GROWTH);
    let moving = outline(&[2.5, 2.2, 1.25, 0.8], MOVING_GROWTH);
    assert_eq!(equal_sums(&fixed, &moving), Some(Vec::new()));
    let (f, m) = Growths::new(&fixed, &moving);
    assert!(are_even(&f) && are_even(&m));
    assert_eq!([f.of(0), f.of(2), f.greatest()], [GROWTH; 3]);
    assert_eq!([m.of(1), m.greatest()], [MOVING_GROWTH; 2]);
}

/// As many levels are used as there are; loops that are alike get none.
#[test]
fn loops_that_are_listed_together_get_different_levels() {
    let rings = outline(&[2.0, 1.5, 1.0, 0.5, 0.25], GROWTH);
    let alike = Alike::new(&rings);
    assert_eq!(alike.class, [4, 3, 2, 1, 0]);
    let of = |together: &[(usize, usize)]| alike.levels(together.iter().copied(), 3);
    assert_eq!(of(&[]), [0; 5]);
    assert_eq!(of(&[(2, 0), (0, 2), (1, 1)]), [0, 0, 1, 0, 0]);
    assert_eq!(of(&[(0, 1), (1, 2), (2, 0), (3, 2)]), [0, 0, 2, 1, 0]);
    let all = (0..4).flat_map(|a| (0..4).map(move |b| (a, b)));
    assert_eq!(of(&all.collect::<Vec<_>>()), [0, 0, 2, 1, 0]);
}

/// Pieces of three rings that a third of a turn maps to each other are grown alike.
#[test]
fn copies_are_grown_alike() {
    let piece = |k: u8| {
        let at = |r: f64, a: f64, bulge: f64| {
            let a = a + f64::from(k) * core::f64::consts::TAU / 3.0;
            Vertex::new(r * a.cos(), r * a.sin(), bulge)
        };
        let bulge = 0.125_f64.tan();
        vec![
            at(1.0, 0.0, bulge),
            at(1.0, 0.5, 0.0),
            at(0.7, 0.5, -bulge),
            at(0.7, 0.0, 0.0),
        ]
    };
    let part = Part::new("pieces", (0..3).map(piece).collect()).unwrap();
    let pieces = Outline::new(&part, Point::ORIGIN, 0.125, GROWTH);
    let rings = outline(&[1.5, 1.2, 0.5], MOVING_GROWTH);
    let sums = equal_sums(&pieces, &rings).unwrap();
    assert!(!sums.is_empty());
    let (p, r) = Growths::new(&pieces, &rings);
    assert!(are_even(&p) && !are_even(&r));
}
