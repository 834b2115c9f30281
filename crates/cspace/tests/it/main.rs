//! Contact spaces held against brute force, known numbers and each other.
#![allow(clippy::panic, clippy::unwrap_used)]

mod axes;
mod classifier;
mod part;
mod query;
mod space;

use std::sync::LazyLock;

use cspace::{ContactSpace, Options};
use cspace_oracle::{Pair, pairs};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Pairs to try, each with its space. The largest is left out: it takes half a minute, and gears are covered by the smaller pair.
/// Tests ask for it on their own threads: a worker of the pool that computes it would wait for itself.
static SPACES: LazyLock<Vec<(Pair, ContactSpace)>> = LazyLock::new(|| {
    let all: Vec<Pair> = (pairs().into_iter().filter(|p| p.name != LARGEST)).collect();
    let space = |p: &Pair| ContactSpace::compute(&p.fixed, &p.moving, &Options::default());
    let spaces: Vec<ContactSpace> = all.par_iter().map(|p| space(p).unwrap()).collect();
    all.into_iter().zip(spaces).collect()
});

/// Name of the largest pair.
const LARGEST: &str = "gears 26 and 24";

/// Names the case that a test fails in.
struct Case(u64);

impl Drop for Case {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("in random case {}", self.0);
        }
    }
}

/// Random cases, the same in every run: each has the numbers that follow from its own.
fn cases(count: u64, mut case: impl FnMut(&mut ChaCha8Rng)) {
    for number in 0..count {
        let _named = Case(number);
        case(&mut ChaCha8Rng::seed_from_u64(number));
    }
}
