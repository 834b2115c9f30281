//! Tests of the kinds of critical orientations.

use core::f64::consts::FRAC_PI_2;

use cspace::{ContactSpace, Options, Part, Symmetry, Vertex};
use cspace_baseline::kinds::{self, Kinds};
use cspace_baseline::paper;
use cspace_model::model;

fn space(fixed: &Part, moving: &Part) -> ContactSpace {
    let options = Options {
        symmetry: Symmetry::Ignore,
        ..Options::default()
    };
    ContactSpace::compute(fixed, moving, &options).unwrap()
}

/// Each critical orientation has a kind, and those of a symmetric pair occur as often as the parts are symmetric.
#[test]
fn every_critical_orientation_of_the_papers_pairs_has_a_kind() {
    for pair in &paper::PAIRS {
        let model = model::from_toml(pair.model, pair.name).unwrap();
        let [fixed, moving] =
            [model.pairs[0].fixed, model.pairs[0].moving].map(|i| &model.parts[i].part);
        let space = space(fixed, moving);
        let all = kinds::of(&space);
        assert_eq!(all.len(), space.critical_orientations().len());
        for (theta, kinds) in &all {
            assert_ne!(*kinds, Kinds::default(), "{} {theta}", pair.name);
        }
        let slab = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
        let slabs = slab.symmetry().slabs as usize;
        let count = |has: fn(&Kinds) -> bool| all.iter().filter(|k| has(&k.1)).count();
        for n in [
            count(|k| k.aligned),
            count(|k| k.end),
            count(|k| k.tangent),
            count(|k| k.triple),
        ] {
            assert!(n.is_multiple_of(slabs), "{} {n} {slabs}", pair.name);
        }
    }
}

fn ring(x: f64, y: f64) -> Vec<Vertex> {
    let corners = [(-x, -y), (x, -y), (x, y), (-x, y)];
    corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
}

/// A block in a frame jams where its height 10 sin θ + 6 cos θ is the frame's 8: a third corner reaches a side.
#[test]
fn jamming_takes_three_contacts_and_parallel_sides_one() {
    let frame = Part::new("frame", vec![ring(9.0, 7.0), ring(6.0, 4.0)]).unwrap();
    let block = Part::new("block", vec![ring(5.0, 3.0)]).unwrap();
    let all = kinds::of(&space(&frame, &block));
    let jam = (8.0_f64 / 10f64.hypot(6.0)).asin() - 6f64.atan2(10.0);
    let at = |theta: f64| {
        let near = all.iter().find(|k| (k.0 - theta).abs() < 1e-9);
        near.unwrap_or_else(|| panic!("{theta}: {all:?}")).1
    };
    for theta in [jam, -jam] {
        assert!(at(theta).triple && !at(theta).aligned, "{theta} {all:?}");
    }
    for theta in [0.0, FRAC_PI_2, -FRAC_PI_2] {
        assert!(at(theta).aligned && !at(theta).triple, "{theta} {all:?}");
    }
}

/// Two discs against two discs: contact curves are circles, and a passage between two closes where those are tangent.
#[test]
fn a_passage_between_discs_closes_where_contact_circles_are_tangent() {
    let discs = |name: &str, x: f64, r: f64| {
        let disc = |x: f64| vec![Vertex::new(x + r, 0.0, 1.0), Vertex::new(x - r, 0.0, 1.0)];
        Part::new(name, vec![disc(-x), disc(x)]).unwrap()
    };
    let all = kinds::of(&space(
        &discs("posts", 4.0, 1.2),
        &discs("dumbbell", 2.0, 1.0),
    ));
    // Centres of the circles at 4 - 2 e and -4 + 2 e, e = exp(i θ), radii 2.2: |8 - 4 e|² = 4.4².
    let closes = ((64.0 + 16.0 - 4.4_f64.powi(2)) / 64.0).acos();
    for theta in [closes, -closes] {
        let near = all.iter().find(|k| (k.0 - theta).abs() < 1e-9).unwrap();
        assert!(near.1.tangent && !near.1.triple, "{theta} {all:?}");
    }
}
