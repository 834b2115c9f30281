//! Times of slices and contact spaces, compared with 10 ms and 86 ms for a slice of such gears in exact arithmetic.

#![allow(clippy::unwrap_used, missing_docs)]

mod timed;

use std::hint::black_box;
use std::time::Instant;

use cspace::{Options, Part, Slice, Slicer, Symmetry};
use cspace_oracle::shapes::{gear, pawl, ratchet};

fn main() {
    for (n, m, other) in [(10, 9, 10.0), (26, 24, 86.0)] {
        report(
            &format!("gears {n} and {m}"),
            &gear(n, 1.0),
            &gear(m, 1.0),
            Some(other),
        );
    }
    for n in [10, 20, 40, 80] {
        report(&format!("ratchet {n} and pawl"), &ratchet(n), &pawl(), None);
    }
}

fn milliseconds(f: impl FnOnce()) -> f64 {
    let begin = Instant::now();
    f();
    1e3 * begin.elapsed().as_secs_f64()
}

/// Mean time of a function of the orientation, milliseconds.
fn average(f: impl Fn(f64)) -> f64 {
    const TIMES: u32 = 50;
    let all = milliseconds(|| (0..TIMES).for_each(|k| f(0.1 + 0.37 * f64::from(k))));
    all / f64::from(TIMES)
}

fn report(name: &str, fixed: &Part, moving: &Part, other: Option<f64>) {
    let once = average(|theta| {
        black_box(Slice::compute(fixed, moving, theta));
    });
    let slicer = Slicer::new(fixed, moving);
    let slice = average(|theta| {
        black_box(slicer.slice(theta));
    });
    let compute = |symmetry| {
        let options = Options {
            symmetry,
            ..Options::default()
        };
        timed::compute(fixed, moving, &options).unwrap()
    };
    // The general method does not use the repetition of the teeth.
    let space = compute(Symmetry::Ignore);
    let slab = compute(Symmetry::Detect);
    let s = space.statistics();
    let t = s.seconds;
    let read = milliseconds(|| {
        black_box(space.slice(0.3));
    });
    let patches = space.patches().len();
    let bytes = size_of_val(space.patches())
        + size_of_val(space.side_links())
        + size_of_val(space.vertical_links());
    println!("{name}");
    println!(
        "  one slice {slice:.3} ms of a prepared pair, {once:.3} ms from scratch, {read:.3} ms read off"
    );
    println!(
        "  contact space {:.1} ms by the general method; with symmetry {:.1} ms",
        1e3 * t.total,
        1e3 * slab.statistics().seconds.total
    );
    if let Some(other) = other {
        println!(
            "  {:.1} slices' time by exact arithmetic ({other} ms each); one slice {:.0} times as fast",
            1e3 * t.total / other,
            other / slice
        );
    }
    for (stage, seconds) in [
        ("sheets", t.sheets),
        ("candidates", t.candidates),
        ("pair events", t.pair_events),
        ("branches", t.branches),
        ("triple events", t.triple_events),
        ("cells", t.cells),
        ("shells", t.shells),
        ("graph", t.graph),
    ] {
        println!("    {stage:14} {:10.2} ms", 1e3 * seconds);
    }
    println!(
        "  {} sheets, {} pairs, {} + {} events, {} clusters, {} branches, {} cells, {} conflicts",
        s.sheets,
        s.pairs,
        s.pair_events,
        s.triple_events,
        s.clusters,
        s.branches,
        s.cells,
        s.conflicts
    );
    let d = s.decisions;
    println!(
        "  {} passings, {} by places; {} orientations; {} overlaps, {} uncertain; {} shells, {} conflicts",
        d.passings,
        d.passings_by_places,
        d.orientations,
        d.overlaps,
        d.overlaps_uncertain,
        d.shells,
        s.conflicts
    );
    println!(
        "  {patches} patches, {} critical orientations, {} bytes a patch with its links, {:.2} µs a patch",
        space.critical_orientations().len(),
        bytes / patches.max(1),
        1e6 * t.total / patches.max(1) as f64
    );
}
