//! Classification and nearest contacts, compared with brute force and dense sampling.

use core::f64::consts::TAU;

use cspace::{Classification, Configuration, ContactSpace, Options, PatchId, Point};
use cspace_oracle::{Oracle, effort, near_contact_about, pair};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const NAMES: [&str; 6] = [
    "peg in chamfered hole",
    "ball caged in a C",
    "ratchet 8 and pawl",
    "random 5",
    "random rings",
    "half discs",
];

#[test]
fn classification_agrees_with_brute_force() {
    for name in NAMES {
        let p = pair(name);
        let space = ContactSpace::compute(&p.fixed, &p.moving, &Options::default()).unwrap();
        let saved = ContactSpace::from_data(space.data().clone()).unwrap();
        let oracle = Oracle::new(&p.fixed, &p.moving);
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        for near in near_contact_about(&oracle, &p.notable, &mut rng, 100) {
            let expected = if near.free {
                Classification::Free
            } else {
                Classification::Blocked
            };
            let c = near.configuration;
            assert_eq!(space.classify(c), Some(expected), "{name} at {c:?}");
            assert_eq!(saved.classify(c), Some(expected), "{name}, saved, at {c:?}");
        }
    }
}

#[test]
fn nearest_contacts_are_nearest_of_densely_sampled_ones() {
    for name in NAMES {
        let p = pair(name);
        let space = ContactSpace::compute(&p.fixed, &p.moving, &Options::default()).unwrap();
        let size = p.fixed.size().max(p.moving.size());
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        for _ in 0..50 {
            let mut at = || rng.random_range(-1.0..1.0) * size;
            let c = Configuration::new(at(), at(), rng.random_range(-3.0..3.0));
            let nearest = space.nearest_contact(c).unwrap();
            let slice = space.slice(c.theta);
            let sampled = slice
                .curves
                .iter()
                .flat_map(|g| (0..=200).map(move |i| g.geometry.point(f64::from(i) / 200.0)))
                .map(|q| q.distance(c.position()))
                .fold(f64::INFINITY, f64::min);
            assert!(
                nearest.distance <= sampled + 1e-12 * size,
                "{name} at {c:?}"
            );
            assert!(nearest.distance >= sampled - 0.02 * size, "{name} at {c:?}");
            let function = space
                .patch(nearest.patch)
                .unwrap()
                .contact_function(nearest.configuration);
            assert!(function.abs() < 1e-10 * size, "{name} at {c:?}: {function}");
            assert_eq!(
                space.classify(nearest.configuration),
                Some(Classification::Contact)
            );
        }
    }
}

/// Turns added to orientations, and distances from critical ones.
const TURNS: [f64; 4] = [0.0, 1.0, -3.0, 100.0];
const BESIDE: [f64; 9] = [-1e-3, -1e-7, -1e-10, -1e-15, 0.0, 1e-15, 1e-10, 1e-7, 1e-3];

/// Near contacts found by examining every curve of the slice, equal to the last bit.
fn by_slice(space: &ContactSpace, c: Configuration) -> Vec<(f64, PatchId, Point)> {
    let slice = space.slice(c.theta);
    let mut all: Vec<(f64, PatchId, Point)> = (slice.curves.iter())
        .map(|curve| {
            let p = curve.geometry.nearest(c.position());
            (p.distance(c.position()), curve.patch.unwrap(), p)
        })
        .collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    all
}

/// Orientations at which patches begin and end, are doubtful or the window ends, just beside these, and others.
fn orientations(space: &ContactSpace, rng: &mut ChaCha8Rng) -> Vec<f64> {
    let window = space.window();
    let doubtful = space.doubtful_orientations().iter();
    let mut at: Vec<f64> = doubtful
        .flat_map(|d| [d.0, 0.5 * (d.0 + d.1), d.1])
        .collect();
    at.extend([window.lo, window.hi]);
    for _ in 0..30 {
        if let Some(i) = space.patches().len().checked_sub(1) {
            let patch = &space.patches()[rng.random_range(0..=i)];
            at.extend([patch.lo, patch.hi]);
        }
        at.push(rng.random_range(window.lo..window.hi));
    }
    at.truncate(100);
    at
}

fn is_as_by_slice(name: &str, space: &ContactSpace) -> usize {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    let size = space.fixed().size().max(space.moving().size());
    let mut touching = 0;
    for base in orientations(space, &mut rng) {
        let turned = TURNS[rng.random_range(0..TURNS.len())] * TAU;
        let theta = base + BESIDE[rng.random_range(0..BESIDE.len())] + turned;
        let curves = space.slice(theta).curves;
        for k in 0..6 {
            let mut off = |by: f64| by * size * rng.random_range(-1.0..1.0);
            // Near a curve, at it, or anywhere.
            let by = [0.0, 1e-9, 1e-4, 0.05, 1.0, 30.0][k];
            let (dx, dy) = (off(by), off(by));
            let near = match curves.len() {
                0 => Point::ORIGIN,
                n => curves[rng.random_range(0..n)]
                    .geometry
                    .point(rng.random_range(0.0..1.0)),
            };
            let c = Configuration::new(near.x + dx, near.y + dy, theta);
            let expected = by_slice(space, c);
            let nearest = space.nearest_contact(c);
            let told = nearest.map(|n| (n.distance, n.patch, n.configuration.position()));
            assert_eq!(told, expected.first().copied(), "{name} at {c:?}");
            for tolerance in [0.0, 1e-9 * size, 0.1 * size, f64::INFINITY] {
                let mut within = expected.iter().filter(|e| e.0 <= tolerance);
                let within: Vec<(PatchId, f64)> = within.by_ref().map(|e| (e.1, e.0)).collect();
                assert_eq!(space.contacts(c, tolerance), within, "{name} at {c:?}");
                // Queries of single patches: one of those within, and any other.
                let any = PatchId(rng.random_range(0..=space.patches().len() as u32));
                for patch in within.first().map(|w| w.0).into_iter().chain([any]) {
                    let is_within = within.iter().any(|w| w.0 == patch);
                    assert_eq!(
                        space.is_on(patch, c, tolerance),
                        is_within,
                        "{name} at {c:?}"
                    );
                }
                touching += within.len();
            }
        }
    }
    touching
}

#[test]
fn near_contacts_are_those_of_a_look_at_every_curve() {
    const NAMES: [&str; 16] = [
        "peg in chamfered hole",
        "ball caged in a C",
        "ratchet 8 and pawl",
        "gears 10 and 9",
        "random 5",
        "random 10",
        "random rings",
        "random pieces and random ring",
        "half discs",
        "discs",
        "lens and crescent",
        "nearly full arcs",
        "nearly straight arcs",
        "square in its square hole",
        "sector in a groove of the same arcs",
        "peg in hole drawn far away",
    ];
    let mut touching = 0;
    let windows = [Some((-0.4, 0.9)), None, Some((1002.0, 1007.0))];
    for name in NAMES {
        let p = pair(name);
        for window in windows.into_iter().take(effort(2, 3)) {
            let options = Options {
                window,
                ..Options::default()
            };
            let space = ContactSpace::compute(&p.fixed, &p.moving, &options).unwrap();
            touching += is_as_by_slice(name, &space);
        }
    }
    assert!(touching > 30_000, "{touching}");
}
