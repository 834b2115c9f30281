//! Contact spaces of random parts, compared with brute force.
//!
//! About one pair in a thousand has a conflict; cells that are then decided one by one must be right as well.

use cspace::{ContactSpace, Options};
use cspace_oracle::shapes::{random_part, random_ring, scaled};
use cspace_oracle::{Oracle, near_contact};
use proptest::prelude::*;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Number of pairs: `PROPTEST_CASES` if it is set.
fn cases() -> u32 {
    std::env::var("PROPTEST_CASES")
        .ok()
        .and_then(|n| n.parse().ok())
        .unwrap_or(32)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_spaces_agree_with_brute_force(
        seed in 0..1_000_000_u64,
        n in 3..10_usize,
        m in 3..8_usize,
        arcs in 0.0..1.0_f64,
        size in 0.2..1.5_f64,
        ring in any::<bool>(),
    ) {
        let fixed = if ring { random_ring(seed, n.max(5), arcs) } else { random_part(seed, n, arcs) };
        let moving = scaled(&random_part(seed + 1, m, arcs), size);
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        let oracle = Oracle::new(&fixed, &moving);
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        for near in near_contact(&oracle, &mut rng, 60) {
            if near.verdict.margin > 1e-10 * oracle.size() {
                let c = near.configuration;
                let free = space.slice(c.theta).is_free(c.position());
                prop_assert_eq!(free, near.free, "{:?}", near);
            }
        }
    }
}
