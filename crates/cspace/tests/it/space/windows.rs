//! Windows that end at critical orientations, or just beside them: all properties must hold also at the very end.

use cspace::{
    Classification, Classifier, Configuration, ContactSpace, Options, Point, Slicer, Vector,
};
use cspace_oracle::{Oracle, Pair, effort, pair};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

const PAIRS: [&str; 8] = [
    "random 5",
    "bar in maze",
    "ratchet 8 and pawl",
    "square in its square hole",
    "lens and crescent",
    "peg in hole, clearance 1e-3",
    "three pegs in three holes",
    "hexagon in a hexagonal hole",
];

/// Distance from a critical orientation to the end of the window, radians.
const BESIDE: [f64; 13] = [
    -3e-6, -3e-7, -1e-9, -1e-11, -1e-13, -1e-16, 0.0, 1e-16, 1e-13, 1e-11, 1e-9, 3e-7, 3e-6,
];

/// Minimum margin of an oracle's verdict for it to count, as a share of the size.
const CERTAIN: f64 = 1e-9;

fn wrong_at_the_end(
    pair: &Pair,
    end: f64,
    window: (f64, f64),
    rng: &mut ChaCha8Rng,
) -> Vec<String> {
    let options = Options {
        window: Some(window),
        ..Options::default()
    };
    let space = ContactSpace::compute(&pair.fixed, &pair.moving, &options).unwrap();
    let classifier = Classifier::new(&space);
    let oracle = Oracle::new(&pair.fixed, &pair.moving);
    let size = oracle.size();
    let slice = Slicer::new(&pair.fixed, &pair.moving).slice(end);
    let mut positions: Vec<Point> = Vec::new();
    // A piece that has just begun may be too short to have a direction.
    for c in slice
        .curves
        .iter()
        .filter(|c| c.geometry.length() > 1e-12 * size)
    {
        let t = rng.random_range(0.01..0.99);
        let (p, n) = (c.geometry.point(t), c.geometry.free_normal(t));
        positions.extend([-1e-3, -1e-6, 1e-6, 1e-3].map(|d| p + n * (d * size)));
    }
    for _ in 0..30 {
        let middle = slice
            .curves
            .first()
            .map_or(Point::ORIGIN, |c| c.geometry.point(0.5));
        let mut share = || 0.5 * size * rng.random_range(-1.0..1.0);
        positions.push(middle + Vector::new(share(), share()));
    }
    let mut wrong = Vec::new();
    for p in positions {
        let c = Configuration::new(p.x, p.y, end);
        let verdict = oracle.judge(c);
        if verdict.margin <= CERTAIN * size {
            continue;
        }
        let expected = if verdict.overlap {
            Classification::Blocked
        } else {
            Classification::Free
        };
        for (by, answer) in [
            ("graph", space.classify(c)),
            ("grid", classifier.classify(c)),
        ] {
            if answer != Some(expected) {
                wrong.push(format!("{}: {window:?} {c:?} {by} {answer:?}", pair.name));
            }
        }
    }
    let read = space.slice(end);
    if read.curves.iter().any(|c| c.next == u32::MAX) {
        wrong.push(format!("{}: {window:?} open chain at {end}", pair.name));
    }
    wrong
}

#[test]
fn the_end_of_a_window_beside_a_critical_orientation() {
    let wrong: Vec<String> = PAIRS
        .par_iter()
        .step_by(effort(2, 1))
        .flat_map_iter(|name| {
            let mut rng = ChaCha8Rng::seed_from_u64(7);
            let pair = pair(name);
            let full = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default());
            let full = full.unwrap();
            let all = full.critical_orientations();
            // Number of critical orientations tested for each pair, and of ends at each.
            let (tried, ends) = effort((1, 12), (7, 1));
            let mut wrong = Vec::new();
            for c in all.iter().step_by(all.len().div_ceil(tried).max(1)) {
                for end in BESIDE.iter().step_by(ends).map(|d| c + d) {
                    wrong.extend(wrong_at_the_end(&pair, end, (end - 0.2, end), &mut rng));
                    wrong.extend(wrong_at_the_end(&pair, end, (end, end + 0.2), &mut rng));
                }
            }
            wrong
        })
        .collect();
    assert!(
        wrong.is_empty(),
        "{}: {:#?}",
        wrong.len(),
        &wrong[..wrong.len().min(12)]
    );
}
