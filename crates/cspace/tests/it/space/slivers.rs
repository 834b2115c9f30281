//! Parts and slits far thinner than they are long, down to the limits of parts, compared with brute force.

use cspace::{Classification, Configuration, ContactSpace, Options, Part, Vertex};
use cspace_oracle::{Oracle, near_contact_about};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Heights of outlines that are 2 long.
const HEIGHTS: [f64; 6] = [1e-6, 5e-8, 8e-9, 1e-9, 1e-10, 6e-11];

/// Widths of slits in a part that is nearly 6 large, whose sides would touch if they were narrower.
const WIDTHS: [f64; 4] = [1e-6, 5e-8, 8e-9, 4e-10];

/// Outlines that are pointed at both ends.
fn outlines(height: f64) -> [(&'static str, Vec<Vertex>); 3] {
    let line = |(x, y)| Vertex::line(x, y);
    let half = 0.5 * height;
    let bulge = half;
    [
        (
            "triangle",
            [(-1.0, 0.0), (1.0, 0.0), (0.1, height)].map(line).to_vec(),
        ),
        (
            "kite",
            [(-1.0, 0.0), (-0.2, -half), (1.0, 0.0), (0.3, half)]
                .map(line)
                .to_vec(),
        ),
        (
            "lens",
            vec![Vertex::new(-1.0, 0.0, bulge), Vertex::new(1.0, 0.0, bulge)],
        ),
    ]
}

fn square(r: f64) -> Vec<Vertex> {
    [(-r, -r), (r, -r), (r, r), (-r, r)]
        .map(|(x, y)| Vertex::line(x, y))
        .to_vec()
}

fn part(loops: Vec<Vec<Vertex>>) -> Part {
    Part::new("part", loops).unwrap()
}

fn check(what: &str, fixed: &Part, moving: &Part) {
    let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
    assert_eq!(space.statistics().conflicts, 0, "{what}");
    let oracle = Oracle::new(fixed, moving);
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let about = [Configuration::default()];
    let mut told = 0;
    for near in near_contact_about(&oracle, &about, &mut rng, 24) {
        if near.verdict.margin <= 2.0 * space.resolution() {
            continue;
        }
        let c = near.configuration;
        let right = if near.free {
            Classification::Free
        } else {
            Classification::Blocked
        };
        assert_eq!(space.classify(c), Some(right), "{what} at {c:?}");
        told += 1;
    }
    assert!(told > 5, "{what}: {told}");
}

/// A sliver across a square, as the part that moves and as the one that does not, and two slivers.
#[test]
fn slivers_are_not_passed_through() {
    let plate = part(vec![square(2.0)]);
    for height in HEIGHTS {
        for (name, outline) in outlines(height) {
            let what = format!("{name} of {height:e}");
            let sliver = part(vec![outline]);
            for (fixed, moving) in [(&plate, &sliver), (&sliver, &plate)] {
                let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
                let at = |x, theta| space.classify(Configuration::new(x, 0.0, theta));
                for theta in [0.0, 0.3, 2.0] {
                    assert_eq!(at(0.0, theta), Some(Classification::Blocked), "{what}");
                    assert_eq!(at(4.5, theta), Some(Classification::Free), "{what}");
                }
            }
            check(&what, &plate, &sliver);
            check(&what, &sliver, &sliver);
        }
    }
}

/// A slit in a plate, and a notch from its side, admit no part.
#[test]
fn slits_let_nothing_in() {
    let block = part(vec![square(0.3)]);
    for height in WIDTHS {
        for (name, outline) in outlines(height) {
            check(
                &format!("slit as a {name} of {height:e}"),
                &part(vec![square(2.0), outline]),
                &block,
            );
        }
        let mut notched = square(2.0);
        notched.splice(
            2..2,
            [(2.0, -0.5 * height), (0.5, 0.0), (2.0, 0.5 * height)]
                .map(|(x, y)| Vertex::line(x, y)),
        );
        check(
            &format!("notch of {height:e}"),
            &part(vec![notched]),
            &block,
        );
    }
}
