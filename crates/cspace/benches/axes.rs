//! Times of fixed-axes pairs: minimum and median of several runs, with the counts that explain them. Then lower pairs.
//!
//! Arguments on the command line select the pairs whose names contain one of them.

#![allow(clippy::unwrap_used, missing_docs)]

use std::hint::black_box;
use std::time::Instant;

use cspace::pair::Joint;
use cspace::{FixedAxesSpace, Options, PairSpace, Point, Relation, Vector};
use cspace_oracle::shapes::mechanisms::{Mechanism, gears, geneva, mechanisms};

const RUNS: usize = 15;
const QUESTIONS: u32 = 20_000;

fn main() {
    // cargo adds --bench.
    let words: Vec<String> = std::env::args()
        .skip(1)
        .filter(|w| !w.starts_with('-'))
        .collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|w| name.contains(w.as_str()));
    let mut all = vec![gears(14, 12), gears(20, 18), geneva(6, 0.05)];
    all.extend(mechanisms());
    for m in all.iter().filter(|m| wanted(&m.name)) {
        report(m);
    }
    let at = Point::new(0.5, 0.0);
    let direction = Vector::new(1.0, 0.0);
    for (name, joint) in [
        ("revolute joint", Joint::Revolute { at }),
        ("prismatic joint", Joint::Prismatic { direction, at }),
    ] {
        if wanted(name) {
            lower(name, joint);
        }
    }
}

fn lower(name: &str, joint: Joint) {
    const TIMES: u32 = 10_000;
    let m = gears(10, 9);
    let options = Options::default();
    let begin = Instant::now();
    for _ in 0..TIMES {
        let relation = Relation::Joint(joint, None);
        black_box(PairSpace::compute(&m.fixed, &m.moving, relation, &options).unwrap());
    }
    let each = 1e6 * begin.elapsed().as_secs_f64() / f64::from(TIMES);
    let edges = m.fixed.edges().count() + m.moving.edges().count();
    println!("{name:34} {edges:4} edges {each:8.3} µs");
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
