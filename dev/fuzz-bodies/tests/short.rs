//! A short run of every target: the inputs that were kept, and random ones from a fixed seed.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use cspace_fuzz::{Target, target};
use cspace_oracle::effort;
use rand::{Rng, RngCore, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Time limit for any input, even on a busy machine.
const LONGEST: Duration = Duration::from_secs(20);

/// The longest random input, bytes.
const BYTES: usize = 600;

/// Runs one input: how many answers were judged.
fn one(target: &Target, data: &[u8], name: &str) -> u64 {
    let begin = Instant::now();
    let judged = (target.run)(data).unwrap_or_else(|f| panic!("{} {name}:\n{f}", target.name));
    let took = begin.elapsed();
    assert!(took < LONGEST, "{} {name} took {took:?}", target.name);
    judged
}

/// The files of `dev/fuzz/<folder>/<target>`, in the order of their names.
fn kept(folder: &str, target: &Target) -> Vec<PathBuf> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz");
    let Ok(entries) = fs::read_dir(format!("{root}/{folder}/{}", target.name)) else {
        return Vec::new();
    };
    let mut all: Vec<_> = entries.map(|e| e.unwrap().path()).collect();
    all.sort();
    all
}

/// The kept inputs, then `inputs` random ones; at least `least` answers of the random ones are judged.
fn short(name: &str, inputs: usize, least: u64) {
    let target = target(name).unwrap();
    for folder in ["seeds", "regressions"] {
        for file in kept(folder, target) {
            one(
                target,
                &fs::read(&file).unwrap(),
                &file.display().to_string(),
            );
        }
    }
    let inputs = inputs * effort(1, 20);
    let mut rng = ChaCha8Rng::seed_from_u64(2026);
    let (mut judged, mut idle) = (0, 0);
    for k in 0..inputs {
        let mut data = vec![0; rng.random_range(1..BYTES)];
        rng.fill_bytes(&mut data);
        if name.ends_with("_reader") {
            // Edits of a text that was right: random bytes are no text.
            data[0] = 0xff;
        }
        let n = one(target, &data, &format!("random input {k}"));
        judged += n;
        idle += usize::from(n == 0);
    }
    println!("{name}: {inputs} random inputs, {idle} of no meaning, {judged} answers judged");
    assert!(judged >= least, "{judged} judged");
}

#[test]
fn model_reader() {
    short("model_reader", 3000, 9000);
}

#[test]
fn dxf_reader() {
    short("dxf_reader", 1500, 1500);
}

#[test]
fn svg_reader() {
    short("svg_reader", 1500, 1500);
}

#[test]
fn points_reader() {
    short("points_reader", 800, 800);
}

#[test]
fn predicates() {
    short("predicates", 20_000, 40_000);
}

#[test]
fn slice() {
    short("slice", 300, 2000);
}

#[test]
fn pipeline() {
    short("pipeline", 150, 5000);
}
