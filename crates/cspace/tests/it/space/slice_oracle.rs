//! Slices computed from scratch, compared with brute force.

use cspace::{Slice, Slicer};
use cspace_oracle::{Oracle, effort, near_contact_about, pairs};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::SPACES;

#[test]
fn slices_agree_with_brute_force() {
    let mut checked = 0;
    let mut bad = Vec::new();
    for pair in pairs() {
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let before = bad.len();
        let mut n = 0;
        for near in near_contact_about(&oracle, &pair.notable, &mut rng, effort(10, 200)) {
            let c = near.configuration;
            let slice = Slice::compute(&pair.fixed, &pair.moving, c.theta);
            checked += 1;
            n += 1;
            if slice.is_free(c.position()) != near.free {
                bad.push(format!(
                    "{}: {c:?} free={} step={} margin={:?}",
                    pair.name, near.free, near.step, near.verdict
                ));
            }
        }
        println!("{:40} {:5} wrong of {n}", pair.name, bad.len() - before);
    }
    for b in bad.iter().take(60) {
        println!("{b}");
    }
    assert!(bad.is_empty(), "{} of {checked} wrong", bad.len());
}

#[test]
fn prepared_pairs_give_the_same_slices() {
    /// Length below which curves may be missing, and tolerance of ends, as a share of the size.
    const NEAR: f64 = 1e-9;
    for pair in pairs().into_iter().step_by(effort(3, 1)) {
        let size = pair.fixed.size().max(pair.moving.size());
        let far = pair.fixed.bounds().center().to_vector().length()
            + pair.moving.bounds().center().to_vector().length();
        let near = NEAR * size + 1e-14 * far;
        let described = |slice: &Slice| {
            let mut all: Vec<_> = slice
                .curves
                .iter()
                .filter(|c| c.geometry.length() > near)
                .map(|c| {
                    let (p, q) = (c.geometry.point(0.0), c.geometry.point(1.0));
                    (format!("{:?} {:?}", c.fixed, c.moving), p, q)
                })
                .collect();
            all.sort_by(|a, b| {
                (a.0.cmp(&b.0))
                    .then(a.1.x.total_cmp(&b.1.x))
                    .then(a.1.y.total_cmp(&b.1.y))
            });
            all
        };
        let slicer = Slicer::new(&pair.fixed, &pair.moving);
        // The last ones are near the orientation at which the turn for slices of a prepared pair begins.
        let cut = -core::f64::consts::PI;
        let even = (0..12).map(|k| -3.0 + 0.7123 * f64::from(k));
        for theta in even.chain([-3e-7, -1e-9, 0.0, 1e-9].map(|d| cut + d)) {
            let made = described(&Slice::compute(&pair.fixed, &pair.moving, theta));
            let prepared = described(&slicer.slice(theta));
            assert_eq!(made.len(), prepared.len(), "{} at {theta}", pair.name);
            for (a, b) in made.iter().zip(&prepared) {
                assert_eq!(a.0, b.0, "{} at {theta}", pair.name);
                let off = a.1.distance(b.1).max(a.2.distance(b.2));
                assert!(off <= near, "{} at {theta}: {off:e}", pair.name);
            }
        }
        assert!(slicer.slice(f64::NAN).curves.is_empty());
    }
}

/// At orientations at which lines are parallel, corners pass edges and curves begin or end, the slice is that just above.
#[test]
fn slices_at_ties_agree_with_brute_force() {
    use cspace::Point;
    use rand::Rng;
    /// Distance from contact, as a share of the size, below which the difference of the orientation may matter.
    const CLEAR: f64 = 1e-6;
    let (mut checked, mut free, mut blocked) = (0, 0, 0);
    let mut bad = Vec::new();
    for (pair, space) in SPACES.iter().step_by(effort(3, 1)) {
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let slicer = Slicer::new(&pair.fixed, &pair.moving);
        let mut rng = ChaCha8Rng::seed_from_u64(17);
        let critical = space
            .critical_orientations()
            .iter()
            .step_by(7)
            .take(effort(1, 20));
        let beside = critical.flat_map(|c| [0.0, 1e-10, -1e-9, 1e-7].map(|d| c + d));
        let even = (-12..=12)
            .step_by(effort(6, 1))
            .map(|k| f64::from(k) * core::f64::consts::PI / 12.0);
        for theta in even.chain(beside) {
            let slices = [
                Slice::compute(&pair.fixed, &pair.moving, theta),
                slicer.slice(theta),
            ];
            let near = near_contact_about(&oracle, &pair.notable, &mut rng, 3);
            for c in near.iter().map(|n| n.configuration) {
                let step = oracle.size() * 10f64.powf(rng.random_range(-5.0..0.0));
                let p = Point::new(
                    c.x + step * rng.random_range(-1.0..1.0),
                    c.y + step * rng.random_range(-1.0..1.0),
                );
                let verdict = oracle.judge(cspace::Configuration {
                    x: p.x,
                    y: p.y,
                    theta,
                });
                if verdict.margin < CLEAR * oracle.size() {
                    continue;
                }
                checked += 1;
                *(if verdict.overlap {
                    &mut blocked
                } else {
                    &mut free
                }) += 1;
                for slice in &slices {
                    if slice.is_free(p) == verdict.overlap {
                        bad.push(format!("{} at {theta}: {p:?} {verdict:?}", pair.name));
                    }
                }
            }
        }
    }
    for b in bad.iter().take(60) {
        println!("{b}");
    }
    assert!(bad.is_empty(), "{} of {checked} wrong", bad.len());
    let least = effort(50, 2000);
    assert!(
        free > least && blocked > least,
        "{free} free, {blocked} blocked"
    );
}
