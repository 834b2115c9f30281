//! Results do not depend on which part is called the fixed one, where frames lie, in which direction loops are drawn, or how many threads
//! there are.

use core::f64::consts::{PI, TAU};

use cspace::space::StageSeconds;
use cspace::{Configuration, ContactSpace, Options, Part, Point};
use cspace_oracle::shapes::{backwards, shifted, turned};
use cspace_oracle::{Oracle, Pair, near_contact_about, pair};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const PAIRS: [&str; 10] = [
    "squares",
    "triangle and pentagon",
    "peg in chamfered hole",
    "ball caged in a C",
    "half discs",
    "nearly full arcs",
    "island in a hole",
    "random 1",
    "random 3",
    "random 5",
];

fn space(fixed: &Part, moving: &Part) -> ContactSpace {
    ContactSpace::compute(fixed, moving, &Options::default()).unwrap()
}

fn is_free(space: &ContactSpace, c: Configuration) -> bool {
    space.slice(c.theta).is_free(c.position())
}

/// Configurations near contact and far from it, each certain.
fn configurations(pair: &Pair, n: usize) -> Vec<(Configuration, bool)> {
    let oracle = Oracle::new(&pair.fixed, &pair.moving);
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut all: Vec<_> = near_contact_about(&oracle, &pair.notable, &mut rng, n)
        .into_iter()
        .filter(|near| near.verdict.margin > 1e-9 * oracle.size())
        .map(|near| (near.configuration, near.free))
        .collect();
    for _ in 0..n {
        let mut share = || oracle.size() * rng.random_range(-1.0..1.0);
        let (x, y) = (share(), share());
        let c = Configuration::new(x, y, rng.random_range(-PI..PI));
        let verdict = oracle.judge(c);
        if verdict.margin > 1e-9 * oracle.size() {
            all.push((c, !verdict.overlap));
        }
    }
    all
}

/// Whether two lists of orientations are the same modulo turns.
fn same_orientations(a: &[f64], b: &[f64], tolerance: f64) -> bool {
    let near = |t: f64, all: &[f64]| {
        all.iter().any(|u| {
            let d = (t - u).rem_euclid(TAU);
            d.min(TAU - d) <= tolerance
        })
    };
    a.iter().all(|&t| near(t, b)) && b.iter().all(|&t| near(t, a))
}

#[test]
fn exchanging_the_parts_gives_the_inverse_space() {
    for name in PAIRS {
        let pair = pair(name);
        let (there, back) = (
            space(&pair.fixed, &pair.moving),
            space(&pair.moving, &pair.fixed),
        );
        let negated: Vec<f64> = back.critical_orientations().iter().map(|t| -t).collect();
        assert!(
            same_orientations(there.critical_orientations(), &negated, 1e-10),
            "{name}: {:?} and {negated:?}",
            there.critical_orientations()
        );
        assert_eq!(
            there.free_regions().len(),
            back.free_regions().len(),
            "{name}"
        );
        for (c, free) in configurations(&pair, 60) {
            assert_eq!(is_free(&there, c), free, "{name}: {c:?}");
            assert_eq!(
                is_free(&back, c.inverse()),
                free,
                "{name}: inverse of {c:?}"
            );
        }
    }
}

#[test]
fn frames_change_nothing_but_the_frame() {
    let angle = 0.7;
    for name in PAIRS {
        let pair = pair(name);
        let moving = turned(&shifted(&pair.moving, 3.0, -2.0), angle);
        let plain = space(&pair.fixed, &pair.moving);
        let framed = space(&pair.fixed, &moving);
        let back: Vec<f64> = framed
            .critical_orientations()
            .iter()
            .map(|t| t + angle)
            .collect();
        assert!(
            same_orientations(plain.critical_orientations(), &back, 1e-9),
            "{name}"
        );
        assert_eq!(
            plain.free_regions().len(),
            framed.free_regions().len(),
            "{name}"
        );
        for (c, free) in configurations(&pair, 60) {
            // A point q is now at R_α (q + v): the same place of the part is θ − α, less the turned shift.
            let theta = c.theta - angle;
            let v = Configuration::new(0.0, 0.0, c.theta).fixed_from_moving(Point::new(3.0, -2.0));
            let framed_c = Configuration::new(c.x - v.x, c.y - v.y, theta);
            assert_eq!(is_free(&framed, framed_c), free, "{name}: {c:?}");
        }
    }
}

#[test]
fn the_direction_of_loops_does_not_matter() {
    for name in PAIRS {
        let pair = pair(name);
        let plain = space(&pair.fixed, &pair.moving);
        let drawn = space(&backwards(&pair.fixed), &backwards(&pair.moving));
        assert!(
            same_orientations(
                plain.critical_orientations(),
                drawn.critical_orientations(),
                1e-10
            ),
            "{name}"
        );
        assert_eq!(plain.patches().len(), drawn.patches().len(), "{name}");
        assert_eq!(plain.free_regions().len(), drawn.free_regions().len());
        for (c, free) in configurations(&pair, 30) {
            assert_eq!(is_free(&drawn, c), free, "{name}: {c:?}");
        }
    }
}

#[test]
fn a_window_has_what_the_full_turn_has_there() {
    for name in PAIRS {
        let pair = pair(name);
        let full = space(&pair.fixed, &pair.moving);
        for (lo, hi) in [(-0.43, 0.61), (2.9, 3.7), (-3.0, 2.95)] {
            let options = Options {
                window: Some((lo, hi)),
                ..Options::default()
            };
            let part = ContactSpace::compute(&pair.fixed, &pair.moving, &options).unwrap();
            let within: Vec<f64> = full
                .critical_orientations()
                .iter()
                .flat_map(|&t| [t - TAU, t, t + TAU])
                .filter(|&t| lo < t && t < hi)
                .collect();
            assert!(
                same_orientations(part.critical_orientations(), &within, 1e-10),
                "{name}: {:?}, not {within:?}",
                part.critical_orientations()
            );
            for k in 0..20 {
                let theta = lo + (f64::from(k) + 0.5) / 20.0 * (hi - lo);
                let (a, b) = (full.slice(theta), part.slice(theta));
                assert_eq!(a.curves.len(), b.curves.len(), "{name} at {theta}");
                assert_eq!(a.loops.len(), b.loops.len(), "{name} at {theta}");
            }
            assert!(part.slice(hi + 0.1).curves.is_empty(), "{name}");
        }
    }
}

#[test]
fn the_number_of_threads_does_not_matter() {
    for name in ["random 5", "bar in maze", "ratchet 8 and pawl"] {
        let pair = pair(name);
        let saved = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let mut saved = pool
                .install(|| space(&pair.fixed, &pair.moving))
                .data()
                .clone();
            saved.statistics.seconds = StageSeconds::default();
            saved
        };
        assert_eq!(saved(1), saved(2), "{name}");
    }
}
