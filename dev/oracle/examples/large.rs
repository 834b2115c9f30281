//! Pairs of thousands of features: their cost, and which are refused.
//!
//! `cargo run --release -p cspace-oracle --example large` runs them all; with a name only that pair, so that
//! `/usr/bin/time -v` reports its peak memory.

use core::f64::consts::TAU;
use std::time::Instant;

use cspace::{ContactSpace, Options, Part, PartError, Vertex};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn main() -> Result<(), PartError> {
    let asked = std::env::args().nth(1);
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
        if asked.as_ref().is_some_and(|a| a != name) {
            continue;
        }
        let begin = Instant::now();
        let space = ContactSpace::compute(&fixed, &moving, &Options::default());
        let seconds = begin.elapsed().as_secs_f64();
        match space {
            Ok(space) => println!(
                "{name}: {seconds:.1} s, {} patches, {} pairs of sheets, {} cells",
                space.patches().len(),
                space.statistics().pairs,
                space.statistics().cells
            ),
            Err(error) => println!("{name}: {seconds:.1} s, {error}"),
        }
    }
    Ok(())
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
