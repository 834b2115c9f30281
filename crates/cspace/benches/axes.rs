//! Times of fixed-axes pairs: the best and the middle one of several runs, with the counts that explain them.

#![allow(clippy::unwrap_used, missing_docs)]

use std::hint::black_box;
use std::time::Instant;

use cspace::FixedAxesSpace;
use cspace_oracle::shapes::mechanisms::{Mechanism, gears, geneva, mechanisms};

const RUNS: usize = 15;
const QUESTIONS: u32 = 20_000;

fn main() {
    let mut all = vec![gears(10, 9), gears(14, 12), geneva(6, 0.05)];
    all.extend(mechanisms());
    for m in &all {
        report(m);
    }
}

fn report(m: &Mechanism) {
    let compute = || FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis);
    let mut times: Vec<f64> = (0..RUNS)
        .map(|_| {
            let begin = Instant::now();
            black_box(compute().unwrap());
            1e3 * begin.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    let space = compute().unwrap();
    let begin = Instant::now();
    for k in 0..QUESTIONS {
        black_box(space.classify(0.001 * f64::from(k % 6283), 0.37 * f64::from(k)));
    }
    let each = 1e6 * begin.elapsed().as_secs_f64() / f64::from(QUESTIONS);
    let (s, edges) = (
        space.statistics(),
        m.fixed.edges().count() + m.moving.edges().count(),
    );
    println!(
        "{:34} {edges:4} edges {:8.3} ms best {:8.3} ms middle; {each:.2} µs a question; {} patches, {} regions; {} pieces, {} crossings, {} tests, {} conflicts",
        m.name,
        times[0],
        times[RUNS / 2],
        space.patches().len(),
        space.regions().len(),
        s.pieces,
        s.crossings,
        s.tests,
        s.conflicts,
    );
}
