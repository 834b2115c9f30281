//! Distances along legs, by contact spaces and by sampling.

use cspace::{Coordinates, Options, PairSpace, Relation};
use cspace_load::draw::Source;
use cspace_oracle::Oracle;
use cspace_plan::legs::Scene;
use rand::Rng;

/// So many configurations of a leg are sampled.
const SAMPLES: usize = 400;

#[test]
fn clearances_and_least_distances_are_those_of_brute_force() {
    let source = Source::new(24, None).unwrap();
    let mut apart = 0;
    for number in 0..200 {
        let drawn = source.draw(number);
        let (Ok(case), mut rng) = (drawn.case, drawn.rng) else {
            continue;
        };
        let oracle = Oracle::new(&case.fixed, &case.moving);
        let scene = Scene::new(&case.fixed, &case.moving, None);
        let size = oracle.size();
        let mut somewhere = || -> [f64; 3] {
            [
                rng.random_range(-1.5..1.5) * size,
                rng.random_range(-1.5..1.5) * size,
                rng.random_range(-4.0..4.0),
            ]
        };
        let (from, to) = (somewhere(), somewhere());
        let along = |t: f64| core::array::from_fn::<f64, 3, _>(|k| from[k] + (to[k] - from[k]) * t);
        let planar = |at: [f64; 3]| match scene.coordinates(at) {
            Coordinates::Planar(c) => c,
            Coordinates::Axes { .. } => unreachable!("a planar pair"),
        };
        let least = scene.least(from, to);
        let at_least = scene.nearest(along(least.time));
        assert!(
            (at_least.distance - least.distance).abs() < 1e-9 * size,
            "pair {number} ({}): {least:?} {at_least:?}",
            drawn.name
        );
        // By another kernel; it measures what is free alone.
        let mut nearest = f64::INFINITY;
        let mut free = true;
        for i in 0..=SAMPLES {
            let at = along(i as f64 / SAMPLES as f64);
            let judged = oracle.judge(planar(at));
            let own = scene.clearance(at);
            free &= !judged.overlap;
            if !judged.overlap {
                let off = (own - judged.clearance).abs();
                assert!(off < 1e-12 * size, "pair {number} {at:?}: {own} {judged:?}");
                assert!(own == 0.0 || !scene.overlaps(at), "pair {number} {at:?}");
            } else if own > 1e-9 * size {
                assert!(scene.overlaps(at), "pair {number} {at:?}");
            }
            nearest = nearest.min(own);
        }
        assert!(
            least.distance <= nearest * (1.0 + 1e-6),
            "pair {number}: {least:?}, sampled {nearest}"
        );
        if free && nearest > 1e-3 * size {
            apart += 1;
            let d = least.distance;
            assert!(scene.is_apart(from, to, d * (1.0 - 1e-5)), "pair {number}");
            assert!(!scene.is_apart(from, to, d * (1.0 + 1e-5)), "pair {number}");
        }
    }
    assert!(apart > 20, "{apart} legs are free");
}

#[test]
fn gradients_are_those_of_distances() {
    let source = Source::new(25, None).unwrap();
    let mut checked = 0;
    for number in 0..100 {
        let drawn = source.draw(number);
        let (Ok(case), mut rng) = (drawn.case, drawn.rng) else {
            continue;
        };
        let scene = Scene::new(&case.fixed, &case.moving, None);
        let size = scene.size();
        let at = [
            rng.random_range(-1.5..1.5) * size,
            rng.random_range(-1.5..1.5) * size,
            rng.random_range(-4.0..4.0),
        ];
        let nearest = scene.nearest(at);
        let near = scene.near(at, nearest.distance * (1.0 + 1e-9) + 1e-9 * size);
        let [one] = &near[..] else {
            continue;
        };
        for k in 0..3 {
            let step = 1e-6 * if k == 2 { 1.0 } else { size };
            let moved = |by: f64| {
                let mut to = at;
                to[k] += by;
                scene.clearance(to)
            };
            let rate = (moved(step) - moved(-step)) / (2.0 * step);
            // Where another pair becomes the nearest within the step, the rates are not those of this one.
            if scene
                .near(at, nearest.distance + 8.0 * step * (1.0 + size))
                .len()
                == 1
            {
                checked += 1;
                let scale = if k == 2 { size } else { 1.0 };
                assert!(
                    (rate - one.gradient[k]).abs() < 1e-3 * scale,
                    "pair {number}, coordinate {k}: {rate} {}",
                    one.gradient[k]
                );
            }
        }
    }
    assert!(checked > 100, "{checked}");
}

#[test]
fn parts_on_axes_are_where_their_motions_put_them() {
    let mechanisms = cspace_oracle::shapes::mechanisms::mechanisms();
    for mechanism in mechanisms {
        let (fixed, moving) = (mechanism.fixed_axis, mechanism.moving_axis);
        let relation = Relation::Axes { fixed, moving };
        let (a, b) = (&mechanism.fixed, &mechanism.moving);
        let space = PairSpace::compute(a, b, relation, &Options::default()).unwrap();
        let PairSpace::FixedAxes(on_axes) = &space else {
            unreachable!("a pair on axes")
        };
        let scene = Scene::of(&space).unwrap();
        let oracle = Oracle::new(a, b);
        for i in 0..50 {
            let (u, v) = (0.37 * f64::from(i), 0.73 * f64::from(i));
            let at = scene.within_limits([u, v, 0.0]);
            let judged = oracle.judge(on_axes.configuration(at[0], at[1]));
            if !judged.overlap {
                let own = scene.clearance(at);
                assert!((own - judged.clearance).abs() < 1e-11 * oracle.size());
            }
        }
    }
}
