//! Every named pair and every family, degenerate ones among them: ways out and widest ways are judged, and none takes for ever.

use std::time::Instant;

use cspace::{Configuration, Coordinates, Location, Options, PairSpace, Part, Relation, Silent};
use cspace_oracle::{Oracle, families, pairs};
use cspace_plan::{Checked, Clearance, Path, PlanError, Planner, Verdict, Wishes, check};

/// Larger pairs are not asked about.
const MOST_FEATURES: usize = 320;

fn asked(name: &str, fixed: &Part, moving: &Part, at: Configuration) {
    let begin = Instant::now();
    let options = Options::default();
    let Ok(space) = PairSpace::compute(fixed, moving, Relation::Planar, &options) else {
        return;
    };
    let computed = begin.elapsed().as_secs_f64();
    let from = Coordinates::Planar(at);
    if matches!(space.locate(from), Ok(Location::Blocked) | Err(_)) {
        return;
    }
    let planner = Planner::new(&space).unwrap();
    for clearance in [Clearance::Quick, Clearance::Half, Clearance::Widest] {
        let begin = Instant::now();
        let wishes = Wishes {
            clearance,
            ..Wishes::default()
        };
        let answer = match planner.plan_out(from, &wishes, &Silent) {
            Ok((_, answer)) => answer,
            Err(PlanError::Grown(_)) => continue,
            Err(error) => panic!("{name}: {error}"),
        };
        let seconds = begin.elapsed().as_secs_f64();
        let verdict = match answer.verdict {
            Verdict::Path(path) => {
                let oracle = Oracle::new(fixed, moving);
                judged(&planner, &oracle, &path, name);
                format!("{} legs", path.configurations.len() - 1)
            }
            Verdict::NoPath(_) => "none".to_owned(),
            other => format!("{other:?}"),
        };
        if seconds > 1.0 {
            println!("{name}: {clearance:?} {seconds:.1} s after {computed:.1} s, {verdict}");
        }
    }
}

/// A path is free by the distances of its legs; brute force finds nothing deeper than what touches is drawn.
fn judged(planner: &Planner<'_>, oracle: &Oracle, path: &Path, name: &str) {
    const PLACES: u32 = 100;
    let scene = &planner.scene().clone().with_about(path.about);
    let path = &path.configurations;
    let checked = check(scene, path).unwrap();
    assert!(matches!(checked, Checked::Free(_)), "{name}: {checked:?}");
    for leg in path.windows(2) {
        let [from, to] = [leg[0], leg[1]].map(|c| scene.numbers(c).unwrap());
        for i in 0..=PLACES {
            let t = f64::from(i) / f64::from(PLACES);
            let at = core::array::from_fn(|k| from[k] + (to[k] - from[k]) * t);
            let Coordinates::Planar(c) = scene.coordinates(at) else {
                unreachable!("a planar pair")
            };
            let found = oracle.judge(c);
            let touches = found.margin < 1e-9 * oracle.size();
            assert!(!found.overlap || touches, "{name}: {c:?} {found:?}");
        }
    }
}

#[test]
#[ignore = "takes minutes"]
fn every_pair_is_answered() {
    let count = |part: &Part| 2 * part.edges().count();
    for pair in pairs() {
        if count(&pair.fixed) + count(&pair.moving) > MOST_FEATURES {
            continue;
        }
        for &at in pair.notable.iter().take(1) {
            asked(&pair.name, &pair.fixed, &pair.moving, at);
        }
    }
    for family in families() {
        for &value in &family.values {
            let Ok(case) = family.build(value) else {
                continue;
            };
            if count(&case.fixed) + count(&case.moving) > MOST_FEATURES {
                continue;
            }
            let name = format!("{} {value:e}", family.name);
            for &at in case.notable.iter().take(1) {
                asked(&name, &case.fixed, &case.moving, at);
            }
        }
    }
}
