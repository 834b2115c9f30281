//! First contacts of motions about points of the moving part other than its origin.

use core::f64::consts::PI;

use cspace::{
    Classification, Configuration, ContactSpace, Coordinates, MotionOutcome, Options, PairSpace,
    Part, Rotation, SmoothMotion, SmoothOutcome, Vector,
};
use cspace_oracle::shapes::gear;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A motion about a point, according to its definition.
#[derive(Clone, Copy)]
struct About {
    from: Configuration,
    rates: [f64; 3],
    about: Vector,
}

impl About {
    fn at(&self, t: f64) -> Configuration {
        let [dx, dy, turning] = self.rates;
        let theta = self.from.theta + turning * t;
        let start = self.from.position() + Rotation::by(self.from.theta) * self.about;
        let p = start + Vector::new(dx, dy) * t - Rotation::by(theta) * self.about;
        Configuration::new(p.x, p.y, theta)
    }
}

impl SmoothMotion for About {
    fn at(&self, t: f64) -> Coordinates {
        Coordinates::Planar(self.at(t))
    }

    fn rate_bounds(&self, _: f64, _: f64) -> [f64; 3] {
        let [dx, dy, turning] = self.rates.map(f64::abs);
        let swing = turning * self.about.length();
        [dx + swing, dy + swing, turning]
    }
}

/// A pin 6 long and 0.5 wide, drawn from its end, turns about its middle while this moves towards a wall: it extends 3 |cos θ| + 0.25 |sin
/// θ| ahead of its middle.
#[test]
fn a_pin_turns_about_its_middle_while_it_moves() {
    let wall = Part::rectangle("wall", (11.0, 0.0), 2.0, 60.0).unwrap();
    let pin = Part::rectangle("pin", (3.0, 0.0), 6.0, 0.5).unwrap();
    let space = ContactSpace::compute(&wall, &pin, &Options::default()).unwrap();
    let middle = Vector::new(3.0, 0.0);
    for (speed, turning) in [(1.0, -0.7), (0.5, -2.0), (3.0, -0.1)] {
        // Upright, its middle at (5, 1).
        let from = Configuration::new(5.0, 1.0 - 3.0, 0.5 * PI);
        let rates = [speed, 0.0, turning];
        let found = space
            .first_contact_about(from, rates, middle, 10.0)
            .unwrap();
        let contact = found.contact().unwrap();
        let ahead = |t: f64| {
            let theta = 0.5 * PI + turning * t;
            5.0 + speed * t + 3.0 * theta.cos().abs() + 0.25 * theta.sin().abs() - 10.0
        };
        let (mut lo, mut hi) = (0.0, 0.0);
        while ahead(hi) < 0.0 {
            lo = hi;
            hi += 1e-3;
        }
        for _ in 0..60 {
            let mid = 0.5 * (lo + hi);
            if ahead(mid) < 0.0 {
                lo = mid;
            } else {
                hi = mid;
            }
        }
        assert!((contact.time - lo).abs() < 1e-9, "{contact:?} {lo}");
        let theta = contact.configuration.theta;
        let there = contact.configuration.position() + Rotation::by(theta) * middle;
        assert!((there.x - 5.0 - speed * contact.time).abs() < 1e-9);
        assert!((there.y - 1.0).abs() < 1e-9);
    }
}

/// Compared with steps of the clearance, which do not use contact functions along a motion.
#[test]
fn motions_about_points_meet_what_steps_of_the_clearance_meet() {
    let fixed = gear(5, 1.0);
    let space = PairSpace::compute(
        &fixed,
        &gear(4, 1.0),
        cspace::Relation::Planar,
        &Options::default(),
    )
    .unwrap();
    let PairSpace::Planar(planar) = &space else {
        panic!("it is planar");
    };
    let reach = fixed.bounds().diagonal();
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let (mut touched, mut free) = (0, 0);
    while touched < 40 || free < 10 {
        let mut any = |r: f64| rng.random_range(-r..r);
        let from = Configuration::new(any(reach), any(reach), any(PI));
        if planar.classify(from) != Some(Classification::Free) {
            continue;
        }
        let motion = About {
            from,
            rates: [any(reach), any(reach), any(3.0)],
            about: Vector::new(any(reach), any(reach)),
        };
        let About { rates, about, .. } = motion;
        let found = planar.first_contact_about(from, rates, about, 1.0).unwrap();
        let steps = space.first_contact_along(&motion, 1.0, 1e-9).unwrap();
        match (found, steps) {
            (MotionOutcome::Free, SmoothOutcome::Free) => free += 1,
            (MotionOutcome::Contact(contact), SmoothOutcome::Contact { time, .. }) => {
                touched += 1;
                assert!((contact.time - time).abs() < 1e-6, "{contact:?} {time}");
                let (p, q) = (contact.configuration, motion.at(contact.time));
                assert!(p.position().distance(q.position()) < 1e-12 * reach);
            }
            // Steps end beside a contact that a motion passes at less than their tolerance.
            (_, SmoothOutcome::Grazes { .. }) => {}
            other => panic!("{other:?}"),
        }
    }
}

/// After many queries of contacts, configurations are classified by another method, with equal results.
#[test]
fn what_is_asked_often_is_classified_as_before() {
    let options = Options::default();
    for (fixed, moving) in [(gear(5, 1.0), gear(4, 1.0)), (gear(3, 1.0), gear(7, 0.6))] {
        let fresh = ContactSpace::compute(&fixed, &moving, &options).unwrap();
        let often = ContactSpace::from_data(fresh.data().clone()).unwrap();
        let reach = fixed.bounds().diagonal();
        let mut rng = ChaCha8Rng::seed_from_u64(8);
        let mut any = |r: f64| rng.random_range(-r..r);
        for _ in 0..600 {
            let _ = often.contacts(Configuration::new(any(reach), any(reach), any(PI)), 1e-9);
        }
        let mut counts = [0; 3];
        for k in 0..6000 {
            let mut c = Configuration::new(any(reach), any(reach), any(PI));
            // Half of them beside contact, at small distances or none.
            if k % 2 == 0 {
                let Some(near) = often.nearest_contact(c) else {
                    continue;
                };
                let off = (10.0_f64).powf(any(12.0) - 6.0);
                let at = near.configuration;
                let off = if k % 4 == 0 { 0.0 } else { off.min(0.1) };
                c = Configuration::new(at.x + off * any(1.0), at.y + off * any(1.0), at.theta);
            }
            let class = fresh.classify(c).unwrap();
            assert_eq!(often.classify(c), Some(class), "{c:?}");
            counts[class as usize] += 1;
        }
        assert!(counts.iter().all(|&n| n > 500), "{counts:?}");
    }
}
