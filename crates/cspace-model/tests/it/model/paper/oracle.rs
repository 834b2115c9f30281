//! The pairs against brute force, near contact and about the configuration in which the parts work.

use cspace::{Classification, Configuration, ContactSpace, Slice, Slicer};
use cspace_oracle::{Oracle, near_contact_about};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::helpers::space;

/// The pairs, and a configuration in which each works.
const WORKING: [(&str, [f64; 3]); 11] = [
    ("cam", [0.0, 32.0, 0.0]),
    ("fixture", [0.0, 0.0, 0.0]),
    ("fastener", [0.0, 0.0, 0.0]),
    ("ratchet_pawl", [42.0, 56.0, 0.0]),
    ("geneva", [56.568_542_494_923_8, 0.0, 0.0]),
    ("film_advance", [0.0, -1.469_655_114_602_889, 0.0]),
    ("crank_slider", [60.0, 0.0, 0.0]),
    ("blocks", [0.0, 0.0, 0.0]),
    (
        "chain_gear",
        [27.821_176_365_200_9, 0.0, core::f64::consts::FRAC_PI_2],
    ),
    ("tibia_femur", [0.0, 0.0, 0.0]),
    ("patella_femur", [0.0, 0.0, 0.0]),
];

/// Verdicts count that are certain by more than this share of the pair's size; the resolution is 2⁻⁴⁰ of it.
const CERTAIN: f64 = 1e-10;

/// Asks for `n` classes near contact, half of them about the given configurations.
fn try_pair(name: &str, space: &ContactSpace, about: &[Configuration], n: usize) {
    let oracle = Oracle::new(space.fixed(), space.moving());
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let (mut free, mut blocked) = (0, 0);
    for near in near_contact_about(&oracle, about, &mut rng, n) {
        if near.verdict.margin < CERTAIN * oracle.size() {
            continue;
        }
        let expected = if near.verdict.overlap {
            blocked += 1;
            Classification::Blocked
        } else {
            free += 1;
            Classification::Free
        };
        assert_eq!(
            space.classify(near.configuration),
            Some(expected),
            "{name} {near:?}"
        );
    }
    assert!(4 * free > n && 4 * blocked > n, "{name}: {free} {blocked}");
}

#[test]
fn classes_are_those_of_brute_force() {
    for (name, [x, y, theta]) in WORKING {
        try_pair(name, &space(name), &[Configuration::new(x, y, theta)], 120);
    }
}

/// Slices within bands, not in the middle, which may be an axis of symmetry, against those made from the parts at that orientation alone: no band may lack a piece.
#[test]
fn slices_are_those_made_from_scratch() {
    let length = |slice: &Slice| -> f64 { slice.curves.iter().map(|c| c.geometry.length()).sum() };
    for (name, _) in WORKING {
        let space = space(name);
        let slicer = Slicer::new(space.fixed(), space.moving());
        let size = Oracle::new(space.fixed(), space.moving()).size();
        let bands = space.bands();
        // Those that were computed, and a copy of each slab's first.
        let computed = space.computed_bands();
        let copies = bands.iter().skip(computed).step_by(computed);
        for band in bands.iter().take(computed).chain(copies) {
            let theta = 0.63 * band.lo + 0.37 * band.hi;
            let (mine, fresh) = (space.slice(theta), slicer.slice(theta));
            assert_eq!(mine.loops.len(), fresh.loops.len(), "{name} {band:?}");
            let (a, b) = (length(&mine), length(&fresh));
            assert!(
                a > 0.0 && (a - b).abs() < 1e-7 * size,
                "{name} {band:?}: {a} {b}"
            );
        }
    }
}
