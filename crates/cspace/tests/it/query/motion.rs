//! First contacts along motions, compared with closed forms and with brute force.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, SQRT_2, TAU};

use cspace::{
    Classification, Configuration, ContactSpace, FirstContact, MotionError, MotionOutcome, Options,
    Part, PatchId,
};
use cspace_oracle::shapes::{circle, rectangle, square};
use cspace_oracle::{Oracle, Pair, effort, pairs};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Displacement of contacts by growth, some 2⁻⁴⁰ of the pair's frame: contacts come that much earlier.
const GROWN: f64 = 2e-11;

fn space(fixed: &Part, moving: &Part) -> ContactSpace {
    ContactSpace::compute(fixed, moving, &Options::default()).unwrap()
}

fn at(x: f64, y: f64, theta: f64) -> Configuration {
    Configuration::new(x, y, theta)
}

fn first(space: &ContactSpace, from: Configuration, rates: [f64; 3], t: f64) -> FirstContact {
    let outcome = space.first_contact(from, rates, t).unwrap();
    outcome.contact().unwrap()
}

#[test]
fn a_square_meets_a_square() {
    let space = space(&square(2.0), &square(2.0));
    // Sides at ±1, so they meet at x = 2.
    let c = first(&space, at(7.0, 0.3, 0.0), [-2.0, 0.0, 0.0], 10.0);
    assert!((c.time - 2.5).abs() < GROWN, "{c:?}");
    // Turned by an eighth of a turn, its corner leads, √2 from its middle.
    let c = first(&space, at(7.0, 0.3, FRAC_PI_4), [-1.0, 0.0, 0.0], 10.0);
    assert!((c.time - (7.0 - 1.0 - SQRT_2)).abs() < GROWN, "{c:?}");
    // The motion ends before.
    let stops = space.first_contact(at(7.0, 0.3, 0.0), [-2.0, 0.0, 0.0], 2.4);
    assert_eq!(stops, Ok(MotionOutcome::Free));
    // The motion passes by.
    let passes = space.first_contact(at(7.0, 2.1, 0.0), [-2.0, 0.0, 0.0], 10.0);
    assert_eq!(passes, Ok(MotionOutcome::Free));
}

#[test]
fn a_disc_meets_a_corner() {
    let space = space(&square(2.0), &circle(0.5));
    let c = first(&space, at(4.0, 1.3, 0.0), [-1.0, 0.0, 0.0], 10.0);
    // The corner is (1, 1); the disc's middle is then 0.3 above it and √(0.25 − 0.09) beside it.
    assert!((c.time - (4.0 - 1.4)).abs() < GROWN, "{c:?}");
    let patch = space.patches()[c.patch.index()];
    assert_eq!(patch.fixed.kind, cspace::FeatureKind::Vertex);
}

#[test]
fn a_bar_turns_to_a_wall() {
    // A wall with its face at x = 1, and a bar of 4 × 0.2 whose middle is at x = 2.5, at first upright.
    let space = space(&rectangle(2.0, 40.0), &rectangle(4.0, 0.2));
    let from = at(2.5, 0.0, FRAC_PI_2);
    // Its corner (−2, ±0.1) is √4.01 from the middle and meets the face when it is 1.5 to the left.
    let reach = 4.01_f64.sqrt();
    let turned = (1.5 / reach).acos() + (0.1_f64 / 2.0).atan();
    // Turning by φ from upright, the leading corner is at −2 sin φ − 0.1 cos φ = −reach · cos(π/2 − φ − atan …).
    let expected = FRAC_PI_2 - turned;
    let grown = space.resolution();
    for sign in [1.0, -1.0] {
        for rate in [0.1, 1.0, 50.0] {
            let c = first(&space, from, [0.0, 0.0, sign * rate], 1e3);
            let angle = c.time * rate;
            assert!((angle - expected).abs() < grown, "{angle} {expected}");
        }
    }
    // Farther away the bar turns without contact.
    let free = space.first_contact(at(4.0, 0.0, 1.0), [0.0, 0.0, 3.0], 1e6);
    assert_eq!(free, Ok(MotionOutcome::Free));
}

#[test]
fn a_spinning_bar_comes_nearer() {
    // The bar moves so slowly that it turns hundreds of times before it touches.
    let space = space(&rectangle(2.0, 40.0), &rectangle(4.0, 0.2));
    let (from, rates) = (at(3.5, 0.0, 0.0), [-0.001, 0.0, 10.0]);
    let c = first(&space, from, rates, 1e4);
    let reach = 4.01_f64.sqrt();
    let x = c.configuration.x - 1.0;
    assert!(x <= reach && x > reach - 0.001 * TAU / 10.0, "{x}");
    let oracle = Oracle::new(space.fixed(), space.moving());
    assert!(oracle.judge(c.configuration).clearance < 1e-9);
    assert!(c.configuration.theta > 100.0 * TAU);
}

#[test]
fn starts_in_contact() {
    let space = space(&square(2.0), &square(2.0));
    let patch = space.nearest_contact(at(2.0, 0.3, 1e-3)).unwrap();
    let start = patch.configuration;
    assert_eq!(space.classify(start), Some(Classification::Contact));
    let go = |rates, t| space.first_contact(start, rates, t).unwrap();
    // Into the wall, at once.
    let c = go([-1.0, 0.0, 0.0], 1.0).contact().unwrap();
    assert_eq!((c.time, c.configuration), (0.0, start));
    // Away from the wall, and along it.
    assert_eq!(go([1.0, 0.2, 0.0], 1.0), MotionOutcome::Free);
    assert_eq!(go([0.0, 1.0, 0.0], 1.0), MotionOutcome::Free);
    assert_eq!(go([0.0, 0.0, 0.0], 1.0), MotionOutcome::Free);
}

#[test]
fn slides_along_a_wall_to_the_next() {
    // A square of side 1 in a hole of side 3: it is in contact at the right and slides up to the upper wall.
    let plate = cspace_oracle::shapes::plate(6.0, &[&square(3.0)]);
    let space = space(&plate, &square(1.0));
    let start = space
        .nearest_contact(at(0.99, 0.0, 0.0))
        .unwrap()
        .configuration;
    assert!((start.x - 1.0).abs() < GROWN);
    let c = first(&space, start, [0.0, 0.5, 0.0], 10.0);
    assert!((c.time - 2.0).abs() < 2.0 * GROWN, "{c:?}");
}

#[test]
fn what_cannot_be_followed() {
    let space = space(&square(2.0), &square(2.0));
    let free = at(5.0, 0.0, 0.0);
    let go = |from, rates, t| space.first_contact(from, rates, t);
    let still = [0.0; 3];
    for (from, rates, t) in [
        (at(f64::NAN, 0.0, 0.0), still, 1.0),
        (free, [0.0, f64::INFINITY, 0.0], 1.0),
        (free, [0.0, 0.0, f64::NAN], 1.0),
        (free, still, f64::INFINITY),
        (free, still, -1.0),
        (free, [1e200, 0.0, 0.0], 1.0),
    ] {
        assert_eq!(go(from, rates, t), Err(MotionError::NotFinite));
    }
    assert_eq!(
        go(at(0.5, 0.0, 0.0), still, 1.0),
        Err(MotionError::StartsBlocked)
    );
    assert_eq!(go(free, still, 1.0), Ok(MotionOutcome::Free));
    assert_eq!(go(free, [-1.0, 0.0, 0.0], 0.0), Ok(MotionOutcome::Free));
}

/// Motions that turn farther than an orientation is known give a result if the parts touch before, otherwise an error.
#[test]
fn motions_that_turn_too_far_end() {
    let space = space(&square(2.0), &square(2.0));
    let too_far = Err(MotionError::TurnsTooFar);
    let near = at(2.2, 0.0, 0.0);
    for theta in [1e17, -1e17, 1e300_f64.sqrt(), 1.1e6] {
        let from = at(5.0, 0.0, theta);
        assert_eq!(
            space.first_contact(at(2.6, 0.0, theta), [0.0; 3], 1.0),
            too_far
        );
        assert_eq!(
            space.crossings(at(2.6, 0.0, theta), [0.0; 3], 1.0),
            Err(MotionError::TurnsTooFar)
        );
        // Out of reach of contact the orientation does not matter.
        let away = space.first_contact(from, [1.0, 0.0, 0.0], 1.0);
        assert_eq!(away, Ok(MotionOutcome::Free));
    }
    for rates in [[0.0, 1e-12, 1e8], [0.0, 1e-12, -1e12], [0.0, 1e-150, 1.0]] {
        // A few turns are left.
        let far = at(2.6, 0.0, 999_980.0_f64.copysign(rates[2]));
        assert_eq!(space.first_contact(far, rates, 1e150), too_far, "{rates:?}");
        assert_eq!(
            space.crossings(far, rates, 1e150),
            Err(MotionError::TurnsTooFar)
        );
        // The motion touches within the first turn.
        let touching = space.first_contact(near, rates, 1e150).unwrap().contact();
        assert!(
            touching.is_some_and(|c| c.configuration.theta.abs() < 1.6),
            "{rates:?}"
        );
    }
    // For a motion that turns in place only the first turn matters.
    assert_eq!(
        space.first_contact(at(2.6, 0.0, 0.0), [0.0, 0.0, 1e12], 1e100),
        Ok(MotionOutcome::Free)
    );
    // There is no such patch, and it has no links.
    let none = space.patches().len() as u32;
    for patch in [none, u32::MAX].map(PatchId) {
        assert_eq!(
            space.links_after(patch).count() + space.links_before(patch).count(),
            0
        );
        assert_eq!(
            space.links_above(patch).count() + space.links_below(patch).count(),
            0
        );
    }
}

#[test]
fn leaves_the_window() {
    let options = Options {
        window: Some((-0.5, 1.0)),
        ..Options::default()
    };
    let space = ContactSpace::compute(&square(2.0), &square(2.0), &options).unwrap();
    let go = |x, rates, t| space.first_contact(at(x, 0.0, 0.0), rates, t);
    let outcome = go(5.0, [0.0, 0.0, 2.0], 3.0);
    assert_eq!(outcome, Ok(MotionOutcome::LeavesWindow { time: 0.5 }));
    let outcome = go(5.0, [0.0, 0.0, -2.0], 3.0);
    assert_eq!(outcome, Ok(MotionOutcome::LeavesWindow { time: 0.25 }));
    assert_eq!(go(5.0, [0.0, 0.0, -2.0], 0.2), Ok(MotionOutcome::Free));
    // The motion touches before it leaves.
    let c = go(2.2, [0.0, 0.0, 0.4], 9.0).unwrap().contact().unwrap();
    let theta = c.configuration.theta;
    assert!((theta.cos() + theta.sin() - 1.2).abs() < GROWN);
    let outside = space.first_contact(at(5.0, 0.0, 2.0), [0.0; 3], 1.0);
    assert_eq!(outside, Err(MotionError::StartsOutside));
}

/// Outcomes of random motions of a pair.
#[derive(Default)]
struct Tally {
    contacts: usize,
    free: usize,
    grazes: usize,
}

fn random_motions(pair: &Pair, n: usize, tally: &mut Tally) {
    let (name, space) = (&pair.name, space(&pair.fixed, &pair.moving));
    let oracle = Oracle::new(&pair.fixed, &pair.moving);
    let size = oracle.size();
    let mut rng = ChaCha8Rng::seed_from_u64(17);
    let (center, drawn) = (oracle.fixed_center(), oracle.moving_center());
    // Coordinates of parts that are drawn far away are rounded, and where these turn, speeds are large.
    let coordinates = [center, drawn].map(|p| p.x.abs() + p.y.abs());
    let touching_gap = 1e-9 * size + 1e-14 * (coordinates[0] + coordinates[1]);
    for i in 0..n {
        let theta = rng.random_range(-PI..PI);
        let turned = at(0.0, 0.0, theta).fixed_from_moving(drawn);
        let mut share = |s: f64| size * rng.random_range(-s..s);
        let x = center.x - turned.x + share(1.0);
        let y = center.y - turned.y + share(1.0);
        let (vx, vy) = (share(1.0), share(1.0));
        let from = at(x, y, theta);
        let spin = [0.0, 0.3, 3.0, 30.0][i % 4] * rng.random_range(-1.0..1.0);
        let rates = if i % 5 == 4 {
            [0.0, 0.0, spin]
        } else {
            [vx, vy, spin]
        };
        let judged = oracle.judge(from);
        if judged.overlap || judged.clearance < 1e-6 * size {
            continue;
        }
        let outcome = space.first_contact(from, rates, 1.0).unwrap();
        let moved = |t: f64| at(x + t * rates[0], y + t * rates[1], theta + t * spin);
        let contact = outcome.contact();
        let until = contact.map_or(1.0, |c| c.time);
        // No overlap before the contact.
        for k in 0..200 {
            let t = until * f64::from(k) / 200.0;
            let v = oracle.judge(moved(t));
            assert!(
                !v.overlap || v.margin < touching_gap,
                "{name}: {from:?} {rates:?} overlaps at {t} before {until}: {v:?}"
            );
        }
        let Some(contact) = contact else {
            tally.free += 1;
            continue;
        };
        tally.contacts += 1;
        // The parts touch there, and overlap after; or it grazes.
        let v = oracle.judge(contact.configuration);
        assert!(
            v.margin < touching_gap,
            "{name}: {from:?} {rates:?} {contact:?} {v:?}"
        );
        let after = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7]
            .map(|d| oracle.judge(moved(until + d)))
            .iter()
            .any(|v| v.overlap);
        tally.grazes += usize::from(!after);
        let touching = space.contacts(contact.configuration, touching_gap);
        assert!(
            touching.iter().any(|t| t.0 == contact.patch),
            "{name}: {contact:?}"
        );
    }
}

#[test]
fn agrees_with_brute_force() {
    let mut tally = Tally::default();
    for pair in pairs() {
        let skipped = [
            // Slow.
            "gears 26 and 24",
            // The space itself is wrong in a few places.
            "crescents of equal arcs",
            "nearly straight arcs",
        ];
        if !skipped.contains(&pair.name.as_str()) {
            random_motions(&pair, effort(24, 60), &mut tally);
        }
    }
    assert!(
        tally.contacts > 120 && tally.free > 120,
        "{} {}",
        tally.contacts,
        tally.free
    );
    assert!(
        tally.grazes * 50 < tally.contacts,
        "{} grazes",
        tally.grazes
    );
}

/// Motions that begin far away find the same contacts: the rounding at far beginnings hides no contact.
#[test]
fn motions_from_afar() {
    let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0).unwrap();
    let coin = Part::circle("coin", (0.0, 0.0), 1.0).unwrap();
    let space = ContactSpace::compute(&table, &coin, &Options::default()).unwrap();
    for far in [1e2, 1e5, 1e6, 1e7, 1e9, 1e12] {
        for k in 0..50 {
            let y = -1.9 + 3.8 * f64::from(k) / 49.0;
            let from = Configuration::new(far, y, 0.1 * f64::from(k));
            let found = space
                .first_contact(from, [-2.0 * far, 0.0, 1.0], 1.0)
                .unwrap();
            let contact = found.contact().unwrap();
            assert!(
                (contact.configuration.x - 3.0).abs() < 1e-9 + 1e-14 * far,
                "{far} {y}: {contact:?}"
            );
            let all = space.crossings(from, [-2.0 * far, 0.0, 1.0], 1.0).unwrap();
            let ends = [all[0], all[all.len() - 1]].map(|c| far * (1.0 - 2.0 * c.0));
            assert!(
                (ends[0] - 3.0).abs() < 1e-9 + 1e-14 * far
                    && (ends[1] + 3.0).abs() < 1e-9 + 1e-14 * far
            );
            let beside = Configuration::new(far, 3.01, 0.0);
            let passes = space
                .first_contact(beside, [-2.0 * far, 0.0, 1.0], 1.0)
                .unwrap();
            assert_eq!(passes.contact(), None);
            let away = space.first_contact(from, [far, 0.0, 1.0], 1.0).unwrap();
            assert_eq!(away.contact(), None);
        }
    }
}
