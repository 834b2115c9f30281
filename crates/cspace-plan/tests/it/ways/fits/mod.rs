//! Random fits with little play, each with a known answer.
//!
//! A path is shown to exist by one in the drawing: the part is moved along its slot. No path exists where a disc
//! inside the moving part is wider than the only opening.

mod drawn;
mod fit;

use cspace::{Coordinates, Options, PairSpace, Relation};
use cspace_oracle::{Oracle, effort};
use cspace_plan::{Clearance, Planner, Verdict, Wishes};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::ways::judge::{is_free, places};
use fit::Fit;

/// The play is between these, where the parts are some lengths wide; evenly over the powers of ten.
const PLAYS: [f64; 2] = [1e-6, 1e-2];
/// Draws a pair with a play, which lets the part go or not.
type Family = fn(&mut ChaCha8Rng, f64, bool) -> Fit;

/// Half of the possible clearance is asked for every second time.
const FAMILIES: [(&str, Family); 9] = [
    ("peg with chamfers in a throat", drawn::peg),
    ("round key in a keyhole", drawn::key),
    ("dovetail", drawn::dovetail),
    ("T in a T-slot", drawn::tee),
    ("block in an L-shaped channel", drawn::block),
    ("arc in an annular slot", drawn::arc),
    ("ball with a handle in a socket", drawn::ball),
    ("cross in a cross", drawn::cross),
    ("notched hook out of an eye", drawn::notch),
];

/// Half of the possible clearance takes long where arcs turn about each other on a whole way: only ways are asked for.
const SLOW: (&str, Family) = ("hook out of an eye", drawn::hook);

/// Clearances are right to this share.
const EXACT: f64 = 1e-4;

/// How many verdicts of each kind there were, and what was wrong.
#[derive(Debug, Default)]
struct Seen {
    paths: usize,
    none: usize,
    /// Another verdict than the drawing tells.
    wrong: Vec<String>,
    /// More clearance than is possible, or less than was asked for.
    off: Vec<String>,
}

/// Asks for ways in so many pairs of a family: every second one lets its part go.
fn asked(
    (seed, pairs): (u64, u64),
    (name, family): (&str, Family),
    clearances: [Clearance; 2],
) -> Seen {
    let mut seen = Seen::default();
    for number in 0..pairs {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        rng.set_stream(number);
        let [least, most] = PLAYS.map(f64::log10);
        let play = 10f64.powf(rng.random_range(least..most));
        let opens = number % 2 == 0;
        let fit = family(&mut rng, play, opens);
        let fit = if number % 4 < 2 {
            fit
        } else {
            fit.moved(&mut rng)
        };
        let name = format!("{name}, pair {number} of {seed}, play {play:e}");
        let (fixed, moving) = (&fit.fixed, &fit.moving);
        let space =
            PairSpace::compute(fixed, moving, Relation::Planar, &Options::default()).unwrap();
        let planner = Planner::new(&space).unwrap();
        let wishes = Wishes {
            clearance: clearances[(number / 4 % 2) as usize],
            ..Wishes::default()
        };
        let [from, to] = [fit.from, fit.to].map(Coordinates::Planar);
        match planner.plan(from, to, &wishes).unwrap().verdict {
            Verdict::Path(path) if opens => {
                seen.paths += 1;
                let oracle = Oracle::new(fixed, moving);
                is_free(planner.scene(), &oracle, &path, places(), &name);
                let ends = [fit.from, fit.to].map(|c| oracle.judge(c).clearance);
                let most = fit.most.min(ends[0]).min(ends[1]);
                let found = path.narrowest.clearance;
                let least = if wishes.clearance == Clearance::Half {
                    0.5 * most
                } else {
                    0.0
                };
                if found > most * (1.0 + EXACT) || found < least * (1.0 - EXACT) {
                    seen.off.push(format!("{name}: {found:e} of {most:e}"));
                }
            }
            Verdict::NoPath(_) if !opens => seen.none += 1,
            other => seen.wrong.push(format!("{name}: {other:?}")),
        }
    }
    seen
}

/// Asks in so many pairs of each family, and in a quarter of that of the slow one.
fn all(seed: u64, pairs: u64) {
    let mut sum = Seen::default();
    let both = [Clearance::Quick, effort(Clearance::Quick, Clearance::Half)];
    let families = FAMILIES.map(|family| (family, pairs, both));
    let slow = (SLOW, pairs.div_ceil(4), [Clearance::Quick; 2]);
    let all = families.into_iter().chain([slow]);
    for (family, pairs, clearances) in all.step_by(effort(2, 1)) {
        let seen = asked((seed, pairs), family, clearances);
        println!("{}: {seen:?}", family.0);
        sum.paths += seen.paths;
        sum.none += seen.none;
        sum.wrong.extend(seen.wrong);
        sum.off.extend(seen.off);
    }
    println!("{} paths, {} none", sum.paths, sum.none);
    assert!(sum.wrong.is_empty() && sum.off.is_empty(), "{sum:#?}");
}

#[test]
fn parts_with_little_play_go_where_they_can() {
    all(2413, effort(1, 8));
}

#[test]
#[ignore = "takes minutes"]
fn a_thousand_parts_with_little_play_go_where_they_can() {
    all(2414, 100);
}
