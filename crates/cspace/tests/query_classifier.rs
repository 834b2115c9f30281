//! The classifier gives the answers of the space itself, and those of brute force.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use cspace::{Classification, Classifier, Configuration, ContactSpace, Options};
use cspace_oracle::{Oracle, Pair, near_contact_about, pair, pairs};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Too slow, or accepted with conflicts, where optimisation is off.
const SLOW: [&str; 3] = [
    "gears 26 and 24",
    "lens and crescent",
    "crescents of equal arcs",
];

fn tried() -> Vec<Pair> {
    let mut all = pairs();
    all.retain(|p| !cfg!(debug_assertions) || !SLOW.contains(&p.name.as_str()));
    all
}

fn space_of(pair: &Pair) -> ContactSpace {
    ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default()).unwrap()
}

/// A configuration anywhere the parts may meet, or a little beyond.
fn anywhere(oracle: &Oracle, rng: &mut impl Rng) -> Configuration {
    let theta = rng.random_range(-PI..PI);
    let (at, drawn) = (oracle.fixed_center(), oracle.moving_center());
    let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(drawn);
    let mut share = || oracle.size() * rng.random_range(-1.2..1.2);
    Configuration::new(at.x + share() - turned.x, at.y + share() - turned.y, theta)
}

fn agree(space: &ContactSpace, classifier: &Classifier<'_>, c: Configuration, name: &str) {
    assert_eq!(classifier.classify(c), space.classify(c), "{name} at {c:?}");
}

#[test]
fn agrees_with_the_space_and_with_brute_force() {
    for pair in tried() {
        let name = &pair.name;
        let space = space_of(&pair);
        let classifier = space.classifier();
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let n = if SLOW.contains(&name.as_str()) { 500 } else { 2000 };
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        let near = near_contact_about(&oracle, &pair.notable, &mut rng, n);
        near.par_iter().for_each(|near| {
            let c = near.configuration;
            agree(&space, &classifier, c, name);
            if near.verdict.margin > 1e-10 * oracle.size() {
                let expected = if near.free {
                    Classification::Free
                } else {
                    Classification::Blocked
                };
                assert_eq!(classifier.classify(c), Some(expected), "{name} at {c:?}");
            }
        });
        let all: Vec<Configuration> = (0..n).map(|_| anywhere(&oracle, &mut rng)).collect();
        all.par_iter().enumerate().for_each(|(i, &c)| {
            agree(&space, &classifier, c, name);
            let verdict = (i % 8 == 0).then(|| oracle.judge(c));
            if let Some(verdict) = verdict.filter(|v| v.margin > 1e-10 * oracle.size()) {
                let free = classifier.classify(c) == Some(Classification::Free);
                assert_eq!(free, !verdict.overlap, "{name} at {c:?}");
            }
        });
    }
}
