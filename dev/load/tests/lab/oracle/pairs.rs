//! The pairs, and the oracle on all of them.

use core::f64::consts::PI;
use std::collections::HashSet;

use cspace::Configuration;
use cspace_oracle::{Oracle, Pair, near_contact_about, pairs};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Configurations where the parts may meet, and those worth a look.
fn some(pair: &Pair, oracle: &Oracle, rng: &mut ChaCha8Rng, n: usize) -> Vec<Configuration> {
    let size = oracle.size();
    let (f, m) = (oracle.fixed_center(), oracle.moving_center());
    let mut all = pair.notable.clone();
    for _ in 0..n {
        let theta = rng.random_range(-PI..PI);
        let q = Configuration::new(0.0, 0.0, theta).fixed_from_moving(m);
        all.push(Configuration::new(
            f.x - q.x + size * rng.random_range(-1.0..1.0),
            f.y - q.y + size * rng.random_range(-1.0..1.0),
            theta,
        ));
    }
    all
}

#[test]
fn there_are_enough_of_different_names() {
    let all = pairs();
    assert!(all.len() >= 44, "{}", all.len());
    let names: HashSet<_> = all.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(names.len(), all.len());
}

#[test]
fn each_part_seen_from_the_other_says_the_same() {
    for pair in pairs() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let there = Oracle::new(&pair.fixed, &pair.moving);
        let back = Oracle::new(&pair.moving, &pair.fixed);
        let reach =
            there.fixed_center().to_vector().length() + there.moving_center().to_vector().length();
        for c in some(&pair, &there, &mut rng, 300) {
            let (v, w) = (there.judge(c), back.judge(c.inverse()));
            // The inverse is rounded, and nearly straight arcs have large radii.
            let rounding =
                1e-13 * there.size() + 1e-14 * (there.size() + reach + c.x.abs() + c.y.abs());
            if v.margin > rounding {
                assert_eq!(v.overlap, w.overlap, "{}: {c:?} {v:?} {w:?}", pair.name);
                assert!(
                    (v.clearance - w.clearance).abs() < rounding,
                    "{}: {c:?} {v:?} {w:?}",
                    pair.name
                );
            }
        }
    }
}

#[test]
fn no_translation_below_the_margin_changes_the_verdict() {
    for pair in pairs() {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        for c in some(&pair, &oracle, &mut rng, 200) {
            let v = oracle.judge(c);
            for _ in 0..5 {
                let (r, a) = (
                    0.999 * v.margin * rng.random_range(0.0..1.0),
                    rng.random_range(-PI..PI),
                );
                let d = Configuration::new(c.x + r * a.cos(), c.y + r * a.sin(), c.theta);
                if (d.x - c.x).hypot(d.y - c.y) < v.margin {
                    let w = oracle.judge(d);
                    assert_eq!(
                        v.overlap, w.overlap,
                        "{}: {c:?} {v:?} {d:?} {w:?}",
                        pair.name
                    );
                }
            }
        }
    }
}

#[test]
fn near_contact_finds_both_sides_of_every_pair() {
    for pair in pairs() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let found = near_contact_about(&oracle, &pair.notable, &mut rng, 120);
        assert!(found.len() >= 120, "{}: {}", pair.name, found.len());
        let free = found.iter().filter(|n| n.free).count();
        assert!(
            4 * free > found.len() && 4 * free < 3 * found.len(),
            "{}: {free} of {}",
            pair.name,
            found.len()
        );
        for n in &found {
            assert_eq!(oracle.judge(n.configuration), n.verdict);
            assert_eq!(n.free, !n.verdict.overlap);
            assert!(!oracle.judge(n.contact).overlap, "{}", pair.name);
            assert!(n.verdict.margin > 1e-12 * oracle.size());
            // Turning by an angle moves no point of the moving part by more than the angle times its distance.
            assert!(
                n.verdict.margin < 1.5 * n.step * oracle.size() + 1e-9 * oracle.size() || !n.free,
                "{}: {n:?}",
                pair.name
            );
        }
        assert!(
            found
                .iter()
                .any(|n| n.step < 1e-8 && n.verdict.margin < 2e-7 * oracle.size())
        );
    }
}
