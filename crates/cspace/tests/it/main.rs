//! Contact spaces held against brute force, known numbers and each other.
#![allow(clippy::panic, clippy::unwrap_used)]

mod axes;
mod classifier;
mod part;
mod query;
mod space;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

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
