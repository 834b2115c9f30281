//! Slices computed from scratch, against brute force.

use cspace::Slice;
use cspace_oracle::{Oracle, near_contact_about, pairs};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

#[test]
fn slices_agree_with_brute_force() {
    let mut checked = 0;
    let mut bad = Vec::new();
    for pair in pairs() {
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let before = bad.len();
        let mut n = 0;
        for near in near_contact_about(&oracle, &pair.notable, &mut rng, 200) {
            let c = near.configuration;
            let slice = Slice::compute(&pair.fixed, &pair.moving, c.theta);
            checked += 1;
            n += 1;
            if slice.is_free(c.position()) != near.free {
                bad.push(format!(
                    "{}: {c:?} free={} step={} margin={:?}",
                    pair.name, near.free, near.step, near.verdict
                ));
            }
        }
        println!("{:40} {:5} wrong of {n}", pair.name, bad.len() - before);
    }
    for b in bad.iter().take(60) {
        println!("{b}");
    }
    assert!(bad.is_empty(), "{} of {checked} wrong", bad.len());
}
