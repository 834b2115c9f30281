//! Classification and nearest contacts, against brute force and dense sampling.

use cspace::{Classification, Configuration, ContactSpace, Options};
use cspace_oracle::{Oracle, near_contact_about, pair};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const NAMES: [&str; 6] = [
    "peg in chamfered hole",
    "ball caged in a C",
    "ratchet 8 and pawl",
    "random 5",
    "random rings",
    "half discs",
];

#[test]
fn classification_agrees_with_brute_force() {
    for name in NAMES {
        let p = pair(name);
        let space = ContactSpace::compute(&p.fixed, &p.moving, &Options::default()).unwrap();
        let saved = ContactSpace::from_data(space.data().clone()).unwrap();
        let oracle = Oracle::new(&p.fixed, &p.moving);
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        for near in near_contact_about(&oracle, &p.notable, &mut rng, 100) {
            let expected = if near.free {
                Classification::Free
            } else {
                Classification::Blocked
            };
            let c = near.configuration;
            assert_eq!(space.classify(c), Some(expected), "{name} at {c:?}");
            assert_eq!(saved.classify(c), Some(expected), "{name}, saved, at {c:?}");
        }
    }
}

#[test]
fn nearest_contacts_are_nearest_of_densely_sampled_ones() {
    for name in NAMES {
        let p = pair(name);
        let space = ContactSpace::compute(&p.fixed, &p.moving, &Options::default()).unwrap();
        let size = p.fixed.size().max(p.moving.size());
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        for _ in 0..50 {
            let mut at = || rng.random_range(-1.0..1.0) * size;
            let c = Configuration::new(at(), at(), rng.random_range(-3.0..3.0));
            let nearest = space.nearest_contact(c).unwrap();
            let slice = space.slice(c.theta);
            let sampled = slice
                .curves
                .iter()
                .flat_map(|g| (0..=200).map(move |i| g.geometry.point(f64::from(i) / 200.0)))
                .map(|q| q.distance(c.position()))
                .fold(f64::INFINITY, f64::min);
            assert!(
                nearest.distance <= sampled + 1e-12 * size,
                "{name} at {c:?}"
            );
            assert!(nearest.distance >= sampled - 0.02 * size, "{name} at {c:?}");
            let function = space
                .patch(nearest.patch)
                .unwrap()
                .contact_function(nearest.configuration);
            assert!(function.abs() < 1e-10 * size, "{name} at {c:?}: {function}");
            assert_eq!(
                space.classify(nearest.configuration),
                Some(Classification::Contact)
            );
        }
    }
}
