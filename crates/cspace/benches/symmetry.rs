//! Speed-up of a symmetric pair compared with the general method, and the number of its periods.

#![allow(clippy::unwrap_used, missing_docs)]

use std::hint::black_box;
use std::time::Instant;

use cspace::{ContactSpace, Options, Part, Symmetry};
use cspace_oracle::shapes::{gear, pawl, ratchet, regular_polygon};

fn main() {
    println!(
        "{:<24} {:>9} {:>11} {:>11} {:>7} {:>8} {:>8} {:>9}",
        "pair", "features", "general", "symmetric", "slabs", "ratio", "bands", "computed"
    );
    for n in [5, 10, 20, 40, 80] {
        report(&format!("ratchet {n}, pawl"), &ratchet(n), &pawl());
    }
    report("pawl, ratchet 20", &pawl(), &ratchet(20));
    report("gears 10, 9", &gear(10, 1.0), &gear(9, 1.0));
    report("gears 18, 12", &gear(18, 1.0), &gear(12, 1.0));
    report("gear 24, pawl", &gear(24, 1.0), &pawl());
    report(
        "polygons 12, 7",
        &regular_polygon(12, 2.0),
        &regular_polygon(7, 1.0),
    );
}

/// Time in seconds of the fastest of some computations, at most about three seconds in all; and the space.
fn fastest(fixed: &Part, moving: &Part, symmetry: Symmetry) -> (f64, ContactSpace) {
    let options = Options {
        symmetry,
        ..Options::default()
    };
    let begin = Instant::now();
    let mut best = f64::INFINITY;
    loop {
        let start = Instant::now();
        let space = black_box(ContactSpace::compute(fixed, moving, &options).unwrap());
        best = best.min(start.elapsed().as_secs_f64());
        if begin.elapsed().as_secs_f64() > 1.5 {
            return (best, space);
        }
    }
}

fn report(name: &str, fixed: &Part, moving: &Part) {
    let (general, _) = fastest(fixed, moving, Symmetry::Ignore);
    let (symmetric, space) = fastest(fixed, moving, Symmetry::Detect);
    let features = space.features();
    println!(
        "{name:<24} {:>9} {:>8.2} ms {:>8.2} ms {:>7} {:>8.1} {:>8} {:>9}",
        features.fixed + features.moving,
        1e3 * general,
        1e3 * symmetric,
        space.symmetry().slabs,
        general / symmetric,
        space.bands().len(),
        space.computed_bands(),
    );
}
