//! Times of verdicts and ways in computed spaces, of random starts and goals beside each other.

#![allow(clippy::unwrap_used, missing_docs)]

use std::time::Instant;

use cspace::{Configuration, Coordinates, Location, Options, PairSpace, Part, Relation};
use cspace_oracle::shapes::{gear, maze, pawl, ratchet, rectangle, rounded_peg, slotted_block};
use cspace_plan::{Clearance, Planner, Verdict, Wishes};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// So many starts with goals are asked of each pair.
const ASKED: usize = 60;

fn main() {
    println!(
        "{:24} {:>8} {:>7} {:>8} | {:>17} {:>17} {:>17}",
        "ms, median and most",
        "features",
        "patches",
        "prepared",
        "verdict",
        "quick way",
        "half the most"
    );
    let block = slotted_block(8.0, 1.01, 2.0, 0.1);
    report("gears of 10 and 9 teeth", &gear(10, 1.0), &gear(9, 1.0));
    report("ratchet of 20 and pawl", &ratchet(20), &pawl());
    report("block and rounded peg", &block, &rounded_peg(1.0, 2.0));
    report("maze and block", &maze(), &rectangle(0.4, 0.3));
}

fn milliseconds<T>(f: impl FnOnce() -> T) -> (f64, T) {
    let begin = Instant::now();
    let made = f();
    (1e3 * begin.elapsed().as_secs_f64(), made)
}

/// Median and most.
fn shown(times: &mut [f64]) -> String {
    times.sort_by(f64::total_cmp);
    let last = times.len() - 1;
    format!("{:8.3} {:8.3}", times[last / 2], times[last])
}

fn report(name: &str, fixed: &Part, moving: &Part) {
    let options = Options::default();
    let space = PairSpace::compute(fixed, moving, Relation::Planar, &options).unwrap();
    let (prepared, planner) = milliseconds(|| Planner::new(&space).unwrap());
    let mut rng = ChaCha8Rng::seed_from_u64(24);
    let half = 0.5 * (fixed.bounds().diagonal() + moving.bounds().diagonal());
    let mut free = || loop {
        let mut at = || rng.random_range(-half..half);
        let at = Configuration::new(at(), at(), rng.random_range(-3.0..3.0));
        let at = Coordinates::Planar(at);
        if matches!(space.locate(at).unwrap(), Location::Free(_)) {
            return at;
        }
    };
    let asked: Vec<_> = (0..ASKED).map(|_| (free(), free())).collect();
    let mut verdicts = Vec::new();
    for &(from, to) in &asked {
        verdicts.push(milliseconds(|| space.connected(from, to).unwrap()).0);
    }
    let ways = |clearance| {
        let wishes = Wishes {
            clearance,
            ..Wishes::default()
        };
        let mut times = Vec::new();
        for &(from, to) in &asked {
            let (time, answer) = milliseconds(|| planner.plan(from, to, &wishes).unwrap());
            if matches!(answer.verdict, Verdict::Path(_)) {
                times.push(time);
            }
        }
        times
    };
    let features = space.features();
    println!(
        "{name:24} {:8} {:7} {prepared:8.3} | {} {} {}",
        features.fixed + features.moving,
        space.patch_count(),
        shown(&mut verdicts),
        shown(&mut ways(Clearance::Quick)),
        shown(&mut ways(Clearance::Half)),
    );
}
