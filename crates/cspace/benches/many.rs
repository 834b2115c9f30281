//! Spaces of many small pairs on one thread: how many a minute, and where the time goes.

#![allow(clippy::unwrap_used, missing_docs)]

use std::time::Instant;

use cspace::{ContactSpace, Options, Part, StageSeconds, Symmetry};
use cspace_oracle::shapes::random_part;

/// Pairs of each kind.
const PAIRS: u64 = 400;

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
    pool.build().unwrap().install(|| {
        for (name, vertices, arcs) in [
            ("polygons of 10 sides", 10, 0.0),
            ("outlines of 10 edges, 4 of 10 arcs", 10, 0.4),
            ("outlines of 5 edges, 4 of 10 arcs", 5, 0.4),
        ] {
            report(name, vertices, arcs);
        }
    });
}

fn report(name: &str, vertices: usize, arcs: f64) {
    let parts: Vec<(Part, Part)> = (0..PAIRS)
        .map(|k| {
            let part = |seed| random_part(seed, vertices, arcs);
            (part(2 * k), part(2 * k + 1))
        })
        .collect();
    let options = Options {
        symmetry: Symmetry::Ignore,
        ..Options::default()
    };
    let mut stages = StageSeconds::default();
    let (mut patches, mut sheets, mut cells) = (0, 0, 0);
    let begin = Instant::now();
    for (fixed, moving) in &parts {
        let space = ContactSpace::compute(fixed, moving, &options).unwrap();
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
