//! Rates of classification on one core, the cost of preparing it, slices of spaces, and first contacts.

#![allow(clippy::unwrap_used, missing_docs)]

use core::f64::consts::PI;
use std::hint::black_box;
use std::time::Instant;

use cspace::{Classification, Classifier, Configuration, ContactSpace, Options, Part, Symmetry};
use cspace_oracle::shapes::{gear, pawl, random_part, ratchet};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn main() {
    for (n, m) in [(10, 9), (26, 24)] {
        let (fixed, moving) = (gear(n, 1.0), gear(m, 1.0));
        // Radius at which the tips' circles touch.
        let reach = 0.5 * (n + m) as f64 + 2.0;
        for symmetry in [Symmetry::Detect, Symmetry::Ignore] {
            let options = Options {
                symmetry,
                ..Options::default()
            };
            let space = ContactSpace::compute(&fixed, &moving, &options).unwrap();
            println!("gears {n} and {m}, {symmetry:?} symmetry");
            report(&space, reach);
            if symmetry == Symmetry::Detect {
                motions(&space, reach);
            }
        }
    }
    for (name, fixed, moving) in small() {
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        println!("{name}");
        report(&space, fixed.size() + moving.size());
    }
}

/// Pairs with few patches.
fn small() -> Vec<(String, Part, Part)> {
    let mut all = vec![("ratchet 8 and pawl".to_owned(), ratchet(8), pawl())];
    for k in 0..3 {
        let part = |seed| random_part(seed, 5, 0.4);
        let name = format!("outlines of 5 edges, {k}");
        all.push((name, part(2 * k), part(2 * k + 1)));
    }
    all
}

fn report(space: &ContactSpace, reach: f64) {
    let build = || {
        let begin = Instant::now();
        black_box(Classifier::new(space));
        begin.elapsed().as_secs_f64()
    };
    let seconds = (0..5).map(|_| build()).fold(f64::INFINITY, f64::min);
    let classifier = Classifier::new(space);
    let computed = space.statistics().seconds.total;
    let patches = space.patches().len();
    println!(
        "  {patches} patches in {:.1} ms; classifier in {:.2} ms, {:.2} times as long; {:.3} MB, {} bytes a patch",
        1e3 * computed,
        1e3 * seconds,
        seconds / computed,
        classifier.bytes() as f64 / 1e6,
        classifier.bytes() / patches
    );
    for factor in [1.0, 2.0] {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let mut at = || rng.random_range(-1.0..1.0) * factor * reach;
        let all: Vec<Configuration> = (0..1_000_000)
            .map(|_| Configuration::new(at(), at(), at() * PI / (factor * reach)))
            .collect();
        let fast = per_second(&all, |c| black_box(classifier.classify(c)).is_some());
        let slow = per_second(&all[..500], |c| black_box(space.classify(c)).is_some());
        println!(
            "  box of {factor} times the reach: {:.2} million a second, {:.0} times as fast as from slices",
            fast / 1e6,
            fast / slow
        );
    }
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    let orientations: Vec<f64> = (0..500).map(|_| rng.random_range(-PI..PI)).collect();
    let curves: usize = (orientations.iter())
        .map(|&t| space.slice(t).curves.len())
        .sum();
    let once = || {
        let begin = Instant::now();
        for &theta in &orientations {
            black_box(space.slice(theta));
        }
        begin.elapsed().as_secs_f64() / orientations.len() as f64
    };
    let seconds = (0..5).map(|_| once()).fold(f64::INFINITY, f64::min);
    let curves = curves as f64 / orientations.len() as f64;
    println!(
        "  a slice in {:.2} µs, of {curves:.0} curves: {:.3} µs each",
        1e6 * seconds,
        1e6 * seconds / curves
    );
}

/// Rate per second, the best of five runs.
fn per_second(all: &[Configuration], f: impl Fn(Configuration) -> bool) -> f64 {
    let once = || {
        let begin = Instant::now();
        let known = all.iter().filter(|&&c| f(c)).count();
        assert_eq!(known, all.len());
        all.len() as f64 / begin.elapsed().as_secs_f64()
    };
    (0..5).map(|_| once()).fold(0.0, f64::max)
}

/// Time of each motion across the contact zone of gears, from free starts.
fn motions(space: &ContactSpace, reach: f64) {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let mut starts = Vec::new();
    while starts.len() < 200 {
        let angle = rng.random_range(-PI..PI);
        let distance = reach * rng.random_range(0.9..1.2);
        let at = Configuration::new(
            distance * angle.cos(),
            distance * angle.sin(),
            rng.random_range(-PI..PI),
        );
        if space.classify(at) == Some(Classification::Free) {
            starts.push(at);
        }
    }
    for (name, speed, turning) in [
        ("translations", 1.0, 0.0),
        ("small turns", 1.0, 0.1),
        ("screws of a turn", 1.0, 6.0),
        ("spins in place of many turns", 0.0, 100.0),
    ] {
        let (mut contacts, mut worst) = (0, 0.0_f64);
        let begin = Instant::now();
        for c in &starts {
            let rates = [-speed * c.x, -speed * c.y, turning];
            let begin = Instant::now();
            let outcome = space.first_contact(*c, rates, 1.0).unwrap();
            worst = worst.max(begin.elapsed().as_secs_f64());
            contacts += usize::from(outcome.contact().is_some());
        }
        let mean = begin.elapsed().as_secs_f64() / starts.len() as f64;
        println!(
            "  first contact of {name}: {:.0} µs, at most {:.0} µs; {contacts} of {} touch",
            1e6 * mean,
            1e6 * worst,
            starts.len()
        );
    }
}
