//! Pairs of thousands of features: their cost, and which are refused.
//!
//! `cargo run --release -p cspace-oracle --example large` runs them all; with a name only that pair, so that
//! `/usr/bin/time -v` reports its peak memory. `gears N`, `gears-slab N` and `wavy N` run gears of N and N − 1 teeth with
//! symmetry unused, the same gears with symmetry used, and two wavy outlines of N lines.

use core::f64::consts::TAU;
use std::time::Instant;

use cspace::{
    ComputeError, ContactSpace, Options, Part, PartError, Progress, Stage, Symmetry, Vertex,
};
use cspace_oracle::shapes::gear;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn main() -> Result<(), PartError> {
    let asked = std::env::args().nth(1);
    let count = (std::env::args().nth(2)).and_then(|n| n.parse().ok().filter(|n| *n > 4));
    let ignored = Options {
        symmetry: Symmetry::Ignore,
        ..Options::default()
    };
    match (asked.as_deref(), count) {
        (Some(name @ "gears"), Some(n)) => run(name, &gear(n, 1.0), &gear(n - 1, 1.0), &ignored),
        (Some(name @ "gears-slab"), Some(n)) => {
            run(name, &gear(n, 1.0), &gear(n - 1, 1.0), &Options::default());
        }
        (Some(name @ "wavy"), Some(n)) => run(name, &wavy(n, 0.0)?, &wavy(n, 1.0)?, &ignored),
        (Some("gears" | "gears-slab" | "wavy"), None) => {
            println!("give the number of teeth or lines");
        }
        _ => return all(asked.as_deref()),
    }
    Ok(())
}

fn all(asked: Option<&str>) -> Result<(), PartError> {
    for (name, fixed, moving) in [
        ("saw-3000", saw(3_000, 0.5)?, wedge(1.0)?),
        ("saw-10000", saw(10_000, 0.1)?, wedge(1.0)?),
        ("saw-100000", saw(100_000, 0.1)?, wedge(1.0)?),
        ("saw-1000000", saw(1_000_000, 0.001)?, wedge(1.0)?),
        ("comb", comb(1250)?, wedge(0.4)?),
        ("comb-large", comb(1250)?, wedge(90.0)?),
        ("plate", plate(45, false)?, wedge(0.4)?),
        ("plate-round", plate(45, true)?, wedge(0.4)?),
        ("saws-300", saw(300, 1.0)?, saw(300, 2.0)?),
    ] {
        if asked.is_some_and(|a| a != name) {
            continue;
        }
        run(name, &fixed, &moving, &Options::default());
    }
    Ok(())
}

/// Computes a pair and prints the time of the whole, and of each stage.
fn run(name: &str, fixed: &Part, moving: &Part, options: &Options) {
    let begin = Instant::now();
    let space = ContactSpace::compute_with(fixed, moving, options, &Timed(begin));
    let seconds = begin.elapsed().as_secs_f64();
    match space {
        Ok(space) => {
            let s = space.statistics();
            println!(
                "{name}: {seconds:.3} s, {} patches, {:.1} µs each; {} sheets, {} pairs of sheets, {} cells, {} conflicts",
                space.patches().len(),
                1e6 * seconds / space.patches().len() as f64,
                s.sheets,
                s.pairs,
                s.cells,
                s.conflicts,
            );
            println!("{:.3?}", s.seconds);
        }
        Err(error) => println!("{name}: {seconds:.1} s, {error}"),
    }
}

/// Progress that only reads the clock.
struct Timed(Instant);

impl Progress for Timed {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        Ok(())
    }

    fn seconds(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}

fn corners(points: impl Iterator<Item = (f64, f64)>) -> Vec<Vertex> {
    points.map(|(x, y)| Vertex::line(x, y)).collect()
}

/// A round saw of radius 10 with uneven teeth, as deep as `depth` at most.
fn saw(vertices: usize, depth: f64) -> Result<Part, PartError> {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let outline = corners((0..vertices).map(|i| {
        let (sin, cos) = (TAU * i as f64 / vertices as f64).sin_cos();
        let r = 10.0 - rng.random_range(0.0..depth);
        (r * cos, r * sin)
    }));
    Part::new("saw", vec![outline])
}

/// An irregular closed curve with three, five and seven waves, drawn in lines.
fn wavy(vertices: usize, phase: f64) -> Result<Part, PartError> {
    let outline = corners((0..vertices).map(|i| {
        let t = TAU * i as f64 / vertices as f64;
        let r = 1.0
            + 0.2 * (3.0 * t + phase).sin()
            + 0.1 * (5.0 * t + 2.0 * phase).sin()
            + 0.05 * (7.0 * t + 3.0 * phase).sin();
        (r * t.cos(), r * t.sin())
    }));
    Part::new("wavy", vec![outline])
}

fn wedge(size: f64) -> Result<Part, PartError> {
    let outline = [(0.0, 0.0), (1.0, 0.0), (0.3, 0.9)];
    let outline = corners(outline.into_iter().map(|(x, y)| (size * x, size * y)));
    Part::new("wedge", vec![outline])
}

/// A bar with leaning teeth, one beside the other.
fn comb(teeth: u32) -> Result<Part, PartError> {
    let tooth = [(0.0, 0.0), (0.45, 0.0), (0.5, 2.0), (0.95, 2.0)];
    let end = f64::from(teeth);
    let teeth = (0..teeth).flat_map(|i| tooth.map(|(x, y)| (f64::from(i) + x, y)));
    let outline = corners(teeth.chain([(end, 0.0), (end, -3.0), (0.0, -3.0)]));
    Part::new("comb", vec![outline])
}

/// A plate with rows of holes, so many in each.
fn plate(side: u32, round: bool) -> Result<Part, PartError> {
    let square = |x: f64, y: f64, r: f64| {
        corners(
            [(-r, -r), (r, -r), (r, r), (-r, r)]
                .map(|(u, v)| (x + u, y + v))
                .into_iter(),
        )
    };
    let middle = 0.5 * f64::from(side - 1);
    let mut loops = vec![square(middle, middle, middle + 1.0)];
    for i in 0..side * side {
        let (x, y) = (f64::from(i % side), f64::from(i / side));
        loops.push(if round {
            vec![Vertex::new(x - 0.3, y, 1.0), Vertex::new(x + 0.3, y, 1.0)]
        } else {
            square(x, y, 0.3)
        });
    }
    Part::new("plate", loops)
}
