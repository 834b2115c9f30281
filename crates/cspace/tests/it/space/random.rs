//! Contact spaces of random parts, compared with brute force.
//!
//! About one pair in a thousand has a conflict; cells that are then decided one by one must be right as well.

use cspace::{ContactSpace, Options};
use cspace_oracle::shapes::{random_part, random_ring, scaled};
use cspace_oracle::{Oracle, near_contact};
use rand::Rng;

use crate::cases;

fn agree_with_brute_force(count: u64) {
    cases(count, |rng| {
        let seed = rng.random_range(0..1_000_000);
        let (n, m) = (rng.random_range(3..10_usize), rng.random_range(3..8));
        let (arcs, size) = (rng.random_range(0.0..1.0), rng.random_range(0.2..1.5));
        let fixed = if rng.random_bool(0.5) {
            random_ring(seed, n.max(5), arcs)
        } else {
            random_part(seed, n, arcs)
        };
        let moving = scaled(&random_part(seed + 1, m, arcs), size);
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        let oracle = Oracle::new(&fixed, &moving);
        for near in near_contact(&oracle, rng, 60) {
            if near.verdict.margin > 1e-10 * oracle.size() {
                let c = near.configuration;
                let free = space.slice(c.theta).is_free(c.position());
                assert_eq!(free, near.free, "{near:?}");
            }
        }
    });
}

#[test]
fn random_spaces_agree_with_brute_force() {
    agree_with_brute_force(16);
}

#[test]
#[ignore = "long: minutes"]
fn many_random_spaces_agree_with_brute_force() {
    agree_with_brute_force(2000);
}
