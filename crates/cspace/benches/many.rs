//! Spaces of many small pairs on one thread: rate per minute, and times of the stages.

#![allow(clippy::unwrap_used, missing_docs)]

mod timed;

use std::time::Instant;

use cspace::{Options, PairSpace, Part, Relation, StageSeconds, Symmetry};
use cspace_oracle::shapes::random_part;

/// Pairs of each kind.
const PAIRS: u64 = 400;

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    pool.build().unwrap().install(|| {
        for (name, vertices, arcs) in KINDS {
            report(name, vertices, arcs);
        }
    });
    println!("on {} threads:", rayon::current_num_threads());
    for (name, vertices, arcs) in KINDS {
        batch(name, vertices, arcs);
    }
}

/// Kinds of parts measured (both parts of a pair are of the same kind): name, number of sides, and share of sides that are arcs. Five sides
/// with their corners are ten features.
const KINDS: [(&str, usize, f64); 4] = [
    ("polygons of 5 sides", 5, 0.0),
    ("outlines of 5 edges, 4 of 10 arcs", 5, 0.4),
    ("polygons of 10 sides", 10, 0.0),
    ("outlines of 10 edges, 4 of 10 arcs", 10, 0.4),
];

fn pairs(vertices: usize, arcs: f64) -> Vec<(Part, Part)> {
    (0..PAIRS)
        .map(|k| {
            let part = |seed| random_part(seed, vertices, arcs);
            (part(2 * k), part(2 * k + 1))
        })
        .collect()
}

/// Rate per minute: each pair divided among all threads, and as a batch.
fn batch(name: &str, vertices: usize, arcs: f64) {
    let parts = pairs(vertices, arcs);
    let pairs: Vec<_> = (parts.iter())
        .map(|(fixed, moving)| (fixed, moving, Relation::Planar))
        .collect();
    let options = Options {
        symmetry: Symmetry::Ignore,
        ..Options::default()
    };
    let a_minute = |seconds: f64| 60.0 * PAIRS as f64 / seconds;
    let begin = Instant::now();
    let each: Vec<usize> = (pairs.iter())
        .map(|&(fixed, moving, relation)| {
            let space = PairSpace::compute(fixed, moving, relation, &options);
            space.unwrap().patch_count()
        })
        .collect();
    let divided = begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    let batch = PairSpace::compute_each(&pairs, &options, |_, space| space.unwrap().patch_count());
    let batched = begin.elapsed().as_secs_f64();
    assert_eq!(each, batch);
    println!(
        "{name}: {:.0} pairs a minute one by one, {:.0} as a batch",
        a_minute(divided),
        a_minute(batched)
    );
}

fn report(name: &str, vertices: usize, arcs: f64) {
    let parts = pairs(vertices, arcs);
    let options = Options {
        symmetry: Symmetry::Ignore,
        ..Options::default()
    };
    let mut stages = StageSeconds::default();
    let (mut patches, mut sheets, mut cells) = (0, 0, 0);
    let begin = Instant::now();
    for (fixed, moving) in &parts {
        let space = timed::compute(fixed, moving, &options).unwrap();
        let s = space.statistics();
        patches += space.patches().len();
        sheets += s.sheets;
        cells += s.cells;
        for (sum, one) in [
            (&mut stages.sheets, s.seconds.sheets),
            (&mut stages.candidates, s.seconds.candidates),
            (&mut stages.pair_events, s.seconds.pair_events),
            (&mut stages.branches, s.seconds.branches),
            (&mut stages.triple_events, s.seconds.triple_events),
            (&mut stages.cells, s.seconds.cells),
            (&mut stages.shells, s.seconds.shells),
            (&mut stages.graph, s.seconds.graph),
            (&mut stages.total, s.seconds.total),
        ] {
            *sum += one;
        }
    }
    let took = begin.elapsed().as_secs_f64();
    let each = |seconds: f64| 1e6 * seconds / PAIRS as f64;
    println!(
        "{name}: {:.0} pairs a minute, {:.0} µs each",
        60.0 * PAIRS as f64 / took,
        each(took)
    );
    println!(
        "  µs: sheets {:.0}, candidates {:.0}, pair events {:.0}, branches {:.0}, triple events {:.0}, cells {:.0}, shells {:.0}, graph {:.0}, rest {:.0}",
        each(stages.sheets),
        each(stages.candidates),
        each(stages.pair_events),
        each(stages.branches),
        each(stages.triple_events),
        each(stages.cells),
        each(stages.shells),
        each(stages.graph),
        each(
            took - stages.sheets
                - stages.candidates
                - stages.pair_events
                - stages.branches
                - stages.triple_events
                - stages.cells
                - stages.shells
                - stages.graph
        )
    );
    let mean = |n: f64| n / PAIRS as f64;
    println!(
        "  {:.0} sheets, {:.0} cells, {:.0} patches a pair; {:.1} µs a patch",
        mean(sheets as f64),
        mean(cells as f64),
        mean(patches as f64),
        1e6 * took / patches as f64
    );
}
