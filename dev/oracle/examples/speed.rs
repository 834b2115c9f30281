//! How long one verdict takes.

use std::time::Instant;

use cspace::Configuration;
use cspace_oracle::{Oracle, shapes};

fn main() {
    for (name, fixed, moving, reach) in [
        (
            "20-gons",
            shapes::regular_polygon(20, 1.0),
            shapes::regular_polygon(20, 1.0),
            2.4,
        ),
        (
            "gears 10 and 9",
            shapes::gear(10, 1.0),
            shapes::gear(9, 1.0),
            14.0,
        ),
        (
            "ratchet 20 and pawl",
            shapes::ratchet(20),
            shapes::pawl(),
            8.0,
        ),
        (
            "gears 26 and 24",
            shapes::gear(26, 1.0),
            shapes::gear(24, 1.0),
            32.0,
        ),
    ] {
        let oracle = Oracle::new(&fixed, &moving);
        let n = 100_000;
        let (mut overlaps, begin) = (0, Instant::now());
        for i in 0..n {
            let s = f64::from(i);
            let c = Configuration::new(
                reach * (0.618_034 * s).fract() * (2.4 * s).cos(),
                reach * (0.618_034 * s).fract() * (2.4 * s).sin(),
                0.01 * s,
            );
            overlaps += u32::from(oracle.judge(c).overlap);
        }
        println!(
            "{name}: {:.2} µs, {:.0} % overlap",
            1e6 * begin.elapsed().as_secs_f64() / f64::from(n),
            100.0 * f64::from(overlaps) / f64::from(n)
        );
    }
}
