//! Random pairs with random starts and goals: every path by brute force, every "no" by a flood fill in boxes.

use cspace::{Configuration, Coordinates, Options, PairSpace, Relation};
use cspace_load::draw::Source;
use cspace_oracle::Oracle;
use cspace_plan::{Checked, Clearance, Planner, Verdict, Wishes, check};
use rand::Rng;

/// How many verdicts of each kind there were.
#[derive(Debug, Default, Clone, Copy)]
struct Seen {
    paths: usize,
    none: usize,
    blocked: usize,
    unknown: usize,
}

/// Asks for ways in random pairs, and judges each path at so many places.
fn asked(seed: u64, pairs: u64, places: usize) -> Seen {
    let source = Source::new(seed, None).unwrap();
    let mut seen = Seen::default();
    for number in 0..pairs {
        let drawn = source.draw(number);
        let (Ok(case), mut rng) = (drawn.case, drawn.rng) else {
            continue;
        };
        let options = Options {
            window: case.window,
            ..Options::default()
        };
        let (fixed, moving) = (&case.fixed, &case.moving);
        let Ok(space) = PairSpace::compute(fixed, moving, Relation::Planar, &options) else {
            continue;
        };
        let oracle = Oracle::new(fixed, moving);
        let size = oracle.size();
        let (lo, hi) = case.window.unwrap_or((-4.0, 4.0));
        let mut somewhere = || {
            let mut at = |half: f64| rng.random_range(-half..half) * size;
            let (x, y) = (at(0.6), at(0.6));
            Configuration::new(x, y, rng.random_range(lo..hi))
        };
        // Half of them are to be free.
        let mut free = || {
            let tries = (0..50).map(|_| somewhere());
            tries.into_iter().find(|&c| !oracle.judge(c).overlap)
        };
        let (Some(from), Some(to)) = (free(), free()) else {
            continue;
        };
        let planner = Planner::new(&space).unwrap();
        let wishes = Wishes {
            clearance: [Clearance::Quick, Clearance::Half][(number % 2) as usize],
            ..Wishes::default()
        };
        let name = &drawn.name;
        let t0 = std::time::Instant::now();
        let answer = planner
            .plan(Coordinates::Planar(from), Coordinates::Planar(to), &wishes)
            .unwrap();
        if std::env::var("DBG").is_ok() {
            eprintln!("{number} {name} {:?} {:?}", t0.elapsed(), wishes.clearance);
        }
        match answer.verdict {
            Verdict::Path(path) => {
                seen.paths += 1;
                let found = path.configurations;
                assert_eq!(found[0], Coordinates::Planar(from));
                let checked = check(planner.scene(), &found).unwrap();
                let Checked::Free(narrow) = checked else {
                    panic!("pair {number} of {seed} ({name}): {checked:?}");
                };
                assert!(narrow.clearance >= 0.0);
                judged(
                    &oracle,
                    &found,
                    places,
                    &format!("pair {number} of {seed} ({name})"),
                );
            }
            Verdict::NoPath(_) => seen.none += 1,
            Verdict::FromBlocked(_) | Verdict::ToBlocked(_) => {
                // Brute force calls a contact free.
                seen.blocked += 1;
                let least = [from, to].map(|c| oracle.judge(c).margin);
                assert!(
                    least[0].min(least[1]) < 1e-9 * size,
                    "pair {number} of {seed} ({name})"
                );
            }
            Verdict::Unknown(doubtful) => {
                seen.unknown += 1;
                assert!(
                    !doubtful.is_empty(),
                    "pair {number} of {seed} ({name}): {from:?} {to:?}"
                );
            }
            Verdict::TooNarrow => panic!("no clearance was asked for"),
        }
    }
    seen
}

/// No configuration along a path overlaps.
fn judged(oracle: &Oracle, path: &[Coordinates], places: usize, name: &str) {
    let at = |c: &Coordinates| match *c {
        Coordinates::Planar(c) => [c.x, c.y, c.theta],
        Coordinates::Axes { .. } => unreachable!("a planar pair"),
    };
    let each = places / path.len().max(2) + 1;
    for leg in path.windows(2) {
        let (from, to) = (at(&leg[0]), at(&leg[1]));
        for i in 0..=each {
            let t = i as f64 / each as f64;
            let [x, y, theta] = core::array::from_fn(|k| from[k] + (to[k] - from[k]) * t);
            let c = Configuration::new(x, y, theta);
            let judged = oracle.judge(c);
            assert!(!judged.overlap, "{name}: {c:?} {judged:?}");
        }
    }
}

#[test]
fn random_ways_are_free() {
    let seen = asked(2411, 150, 500);
    assert!(seen.paths > 60 && seen.none > 3, "{seen:?}");
}

#[test]
#[ignore = "takes minutes"]
fn two_thousand_random_ways_are_free() {
    let seen = asked(2412, 2000, 10_000);
    println!("{seen:?}");
    assert!(seen.paths > 1000, "{seen:?}");
}
