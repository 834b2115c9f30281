//! Configurations at known small distances from contact, and what is true there.

use std::f64::consts::PI;

use cspace::{Configuration, Vector};
use cspace_oracle::{Oracle, near_contact};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Distances from contact, as shares of the pair's size.
pub(super) const DISTANCES: [f64; 7] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// Places of contact from which configurations are taken.
const PLACES: usize = 800;

/// A configuration near contact.
pub(super) struct Near {
    pub(super) configuration: Configuration,
    pub(super) distance: f64,
    pub(super) overlap: bool,
}

/// Configurations at several distances from places of contact, at each distance in a random direction. Displacements
/// along the contact are left out: no translation shorter than 0.3 of the distance changes the verdict, which is brute
/// force's, where needed in pairs of doubles.
pub(super) fn configurations(oracle: &Oracle) -> Vec<Near> {
    let mut rng = ChaCha8Rng::seed_from_u64(1999);
    let places = near_contact(oracle, &mut rng, 4 * PLACES);
    let mut found = Vec::new();
    // Four are made about each place.
    for place in places.iter().step_by(4) {
        for distance in DISTANCES {
            let by = Vector::from_angle(rng.random_range(-PI..PI)) * (distance * oracle.size());
            let at = place.contact.position() + by;
            let configuration = Configuration::new(at.x, at.y, place.contact.theta);
            let verdict = oracle.judge(configuration);
            if verdict.margin > 0.3 * distance * oracle.size() {
                found.push(Near {
                    configuration,
                    distance,
                    overlap: verdict.overlap,
                });
            }
        }
    }
    found
}

/// Configurations at random where the parts may meet: the middle of the moving part in a box twice as large as the larger of both.
pub(super) fn anywhere(oracle: &Oracle, n: usize) -> Vec<Configuration> {
    let mut rng = ChaCha8Rng::seed_from_u64(2026);
    let (to, q) = (oracle.fixed_center(), oracle.moving_center());
    let one = |rng: &mut ChaCha8Rng| {
        let theta = rng.random_range(-PI..PI);
        let mut share = || oracle.size() * rng.random_range(-1.0..1.0);
        let (dx, dy) = (share(), share());
        let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(q);
        Configuration::new(to.x + dx - turned.x, to.y + dy - turned.y, theta)
    };
    (0..n).map(|_| one(&mut rng)).collect()
}
