//! Random pairs with random starts and goals: every path by brute force, every "no" by a flood fill in boxes.

use cspace::{Configuration, Coordinates, Options, PairSpace, Relation, Window};
use cspace_load::draw::Source;
use cspace_oracle::{Case, Fill, Oracle, effort};
use cspace_plan::{Clearance, Planner, Verdict, Wishes};
use rand::Rng;

use crate::ways::judge::is_free;

/// Boxes of a flood fill are divided so often, and larger pairs take it too long.
const DEPTH: u32 = 5;
const MOST_EDGES: usize = 24;

/// How many verdicts of each kind there were.
#[derive(Debug, Default, Clone, Copy)]
struct Seen {
    paths: usize,
    none: usize,
    /// Number of these that a flood fill found.
    filled: usize,
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
        // Where it is drawn one part often is within the other: a third of the starts is near there.
        let mut free = |near: bool| {
            let somewhere = || {
                let close = 10f64.powf(rng.random_range(-6.0..-0.5));
                let (half, turn) = if near { (close, close) } else { (0.6, 4.0) };
                let mut at = |half: f64| rng.random_range(-half..half) * size;
                let (x, y) = (at(half), at(half));
                let (lo, hi) = (lo.max(-turn), hi.min(turn));
                (lo < hi).then(|| Configuration::new(x, y, rng.random_range(lo..hi)))
            };
            let tries = core::iter::repeat_with(somewhere).take(50).flatten();
            tries.into_iter().find(|&c| !oracle.judge(c).overlap)
        };
        let (Some(from), Some(to)) = (free(number % 3 == 0), free(number % 6 == 0)) else {
            continue;
        };
        let planner = Planner::new(&space).unwrap();
        let wishes = Wishes {
            clearance: [Clearance::Quick, Clearance::Half][(number % 2) as usize],
            ..Wishes::default()
        };
        let name = &drawn.name;
        let answer = planner
            .plan(Coordinates::Planar(from), Coordinates::Planar(to), &wishes)
            .unwrap();
        match answer.verdict {
            Verdict::Path(path) => {
                seen.paths += 1;
                assert_eq!(path.configurations[0], Coordinates::Planar(from));
                let name = format!("pair {number} of {seed} ({name})");
                is_free(planner.scene(), &oracle, &path, places, &name);
            }
            Verdict::NoPath(_) => {
                seen.none += 1;
                if fixed.edges().count() + moving.edges().count() <= MOST_EDGES {
                    seen.filled += 1;
                    filled(&case, &space, &format!("pair {number} of {seed} ({name})"));
                }
            }
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

/// The free regions are those of a flood fill in boxes that brute force proves to be free or blocked.
fn filled(case: &Case, space: &PairSpace, name: &str) {
    let PairSpace::Planar(space) = space else {
        unreachable!("a planar pair")
    };
    let Window { lo, hi, full_turn } = space.window();
    let fill = Fill::new(case, (lo, hi), full_turn, DEPTH);
    let compared = fill.compare(space.free_regions().len(), |c| {
        Some(space.locate(c).region()?.0)
    });
    assert!(compared.wrong.is_empty(), "{name}: {:?}", compared.wrong);
}

#[test]
fn random_ways_are_free() {
    let seen = asked(2411, effort(100, 500), 300);
    assert!(seen.paths > effort(60, 300) && seen.filled > 0, "{seen:?}");
}

#[test]
#[ignore = "takes minutes"]
fn two_thousand_random_ways_are_free() {
    let seen = asked(2412, 2000, 10_000);
    println!("{seen:?}");
    assert!(seen.paths > 1000, "{seen:?}");
}
