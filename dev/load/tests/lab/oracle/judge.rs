//! The oracle on configurations whose answer is known by hand.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use cspace::{Configuration, Part, Point};
use cspace_oracle::shapes::*;
use cspace_oracle::{Oracle, Verdict, judge, near_contact};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn at(x: f64, y: f64, theta: f64) -> Configuration {
    Configuration::new(x, y, theta)
}

#[track_caller]
fn free(v: Verdict, clearance: f64) {
    assert!(!v.overlap, "{v:?}");
    assert!((v.clearance - clearance).abs() < 1e-12, "{v:?}");
    assert_eq!(v.margin, v.clearance);
}

#[track_caller]
fn blocked(v: Verdict, least: f64) {
    assert!(
        v.overlap && v.margin >= least && v.clearance == 0.0,
        "{v:?}"
    );
}

#[test]
fn squares_apart_touching_and_overlapping() {
    let s = square(2.0);
    free(judge(&s, &s, at(3.0, 0.0, 0.0)), 1.0);
    free(judge(&s, &s, at(3.0, 4.0, 0.0)), 5.0_f64.sqrt());
    free(judge(&s, &s, at(2.0, 0.0, 0.0)), 0.0);
    free(judge(&s, &s, at(2.0, 0.7, 0.0)), 0.0);
    free(judge(&s, &s, at(2.0, 2.0, 0.0)), 0.0);
    for k in 1..8 {
        free(judge(&s, &s, at(2.0, 0.3, FRAC_PI_2 * f64::from(k))), 0.0);
    }
    blocked(judge(&s, &s, at(2.0 - 1e-9, 0.7, 0.0)), 0.9e-9);
    blocked(judge(&s, &s, at(2.0 - 1e-13, 0.7, 0.0)), 0.9e-13);
    blocked(judge(&s, &s, at(0.5, 0.25, 0.3)), 0.1);
    blocked(judge(&s, &s, at(0.0, 0.0, FRAC_PI_4)), 0.1);
    // A corner in the middle of a side.
    free(
        judge(&s, &s, at(1.0 + 2.0_f64.sqrt() + 1e-9, 0.0, FRAC_PI_4)),
        1e-9,
    );
    blocked(
        judge(&s, &s, at(1.0 + 2.0_f64.sqrt() - 1e-9, 0.0, FRAC_PI_4)),
        0.7e-9,
    );
}

#[test]
fn equal_parts_overlap() {
    for p in [square(2.0), circle(1.0), gear(9, 1.0), annulus(2.0, 1.9)] {
        blocked(judge(&p, &p, at(0.0, 0.0, 0.0)), 1e-3);
        blocked(judge(&shifted(&p, 0.1, 0.2), &p, at(0.1, 0.2, 0.0)), 1e-3);
    }
    let g = gear(9, 1.0);
    for k in 0..9 {
        blocked(judge(&g, &g, at(0.0, 0.0, TAU * f64::from(k) / 9.0)), 1e-3);
    }
}

#[test]
fn the_square_that_fills_its_hole_is_free() {
    let p = plate(4.0, &[&square(2.0)]);
    let s = square(2.0);
    for k in 0..4 {
        free(judge(&p, &s, at(0.0, 0.0, FRAC_PI_2 * f64::from(k))), 0.0);
    }
    blocked(judge(&p, &s, at(1e-9, 0.0, 0.0)), 0.9e-9);
    blocked(judge(&p, &s, at(0.0, 0.0, 1e-9)), 1e-10);
    free(judge(&p, &square(1.0), at(0.25, 0.0, 0.0)), 0.25);
    blocked(judge(&p, &square(3.0), at(0.0, 0.0, 0.0)), 0.5);
    free(judge(&p, &s, at(3.0, 0.0, 0.0)), 0.0);
}

#[test]
fn the_pin_that_fills_its_hole_is_free() {
    let p = plate(4.0, &[&circle(1.0)]);
    for k in 0..20 {
        let v = judge(&p, &circle(1.0), at(0.0, 0.0, 0.3 * f64::from(k)));
        assert!(!v.overlap && v.clearance < 1e-15, "{v:?}");
    }
    free(judge(&p, &circle(1.0 - 1e-6), at(0.0, 5e-7, 1.0)), 5e-7);
    blocked(judge(&p, &circle(1.0), at(1e-10, 0.0, 1.0)), 0.9e-10);
}

#[test]
fn rings_and_discs() {
    let ring = annulus(2.0, 1.5);
    free(judge(&ring, &circle(1.0), at(0.25, 0.0, 0.0)), 0.25);
    free(judge(&circle(1.0), &ring, at(0.25, 0.0, 0.0)), 0.25);
    free(judge(&ring, &circle(1.0), at(0.3, 0.4, 1.0)), 0.0);
    blocked(judge(&ring, &circle(1.0), at(0.6, 0.0, 0.0)), 0.05);
    blocked(judge(&ring, &circle(1.75), at(0.0, 0.0, 0.0)), 0.25);
    blocked(judge(&circle(1.75), &ring, at(0.0, 0.0, 0.0)), 0.25);
    // Over the hole and all of the ring.
    blocked(judge(&ring, &circle(3.0), at(0.0, 0.0, 0.0)), 0.5);
    blocked(judge(&circle(3.0), &ring, at(0.0, 0.0, 0.0)), 0.5);
    free(judge(&ring, &circle(1.0), at(3.5, 0.0, 0.0)), 0.5);
    // A ring within a ring.
    free(judge(&ring, &annulus(1.4, 1.0), at(0.0, 0.0, 0.0)), 0.1);
    // Sharing an outer circle.
    blocked(judge(&ring, &circle(2.0), at(0.0, 0.0, 0.7)), 1e-3);
    blocked(judge(&ring, &annulus(2.0, 1.9), at(0.0, 0.0, 0.7)), 1e-3);
}

#[test]
fn nearly_full_arcs() {
    let d = flatted_disc(1.0, 350f64.to_radians());
    let flat = (5f64.to_radians()).cos();
    let half = half_disc(1.0);
    free(judge(&d, &half, at(flat + 0.5, 0.0, -FRAC_PI_2)), 0.5);
    free(judge(&d, &half, at(flat, 0.0, -FRAC_PI_2)), 0.0);
    blocked(judge(&d, &half, at(flat - 1e-8, 0.0, -FRAC_PI_2)), 0.9e-8);
    free(judge(&d, &d, at(2.0 * flat, 0.0, PI)), 0.0);
    free(judge(&d, &d, at(-2.5, 0.0, 0.0)), flat.mul_add(-1.0, 1.5));
}

#[test]
fn far_from_the_origin() {
    let p = shifted(&plate(4.0, &[&square(2.0)]), 1e6, -2e6);
    let s = shifted(&square(1.0), -3e6, 1e6);
    let oracle = Oracle::new(&p, &s);
    let theta = 0.7;
    // The square's centre is to come to the hole's centre.
    let place = |x: f64, y: f64| {
        let q = at(0.0, 0.0, theta).fixed_from_moving(Point::new(-3e6, 1e6));
        at(1e6 + x - q.x, -2e6 + y - q.y, theta)
    };
    let reach = 0.5 * (theta.sin() + theta.cos());
    let v = oracle.judge(place(0.1, 0.0));
    assert!(
        !v.overlap && (v.clearance - (0.9 - reach)).abs() < 1e-8,
        "{v:?}"
    );
    assert!(oracle.judge(place(0.5, 0.0)).overlap);
    let tiny = |p: &Part| scaled(p, 1e-6);
    free(
        judge(
            &tiny(&square(2.0)),
            &tiny(&square(2.0)),
            at(2.5e-6, 0.0, 0.0),
        ),
        5e-7,
    );
    blocked(
        judge(
            &tiny(&square(2.0)),
            &tiny(&square(2.0)),
            at(2e-6 - 1e-15, 0.0, 0.0),
        ),
        0.9e-15,
    );
}

#[test]
fn gears_mesh() {
    for (a, b) in [(10, 9), (26, 24), (10, 10)] {
        let (g, h) = (gear(a, 1.0), gear(b, 1.0));
        let distance = 0.5 * (a + b) as f64;
        // A tooth of one on the line of centres, a gap of the other.
        let theta = if b % 2 == 0 { PI / b as f64 } else { 0.0 };
        let v = judge(&g, &h, at(distance, 0.0, theta));
        assert!(!v.overlap && v.clearance > 1e-3, "{a} {b} {v:?}");
        blocked(
            judge(&g, &h, at(distance, 0.0, theta + PI / b as f64)),
            1e-2,
        );
    }
}

#[test]
fn direction_of_drawing_does_not_matter() {
    let (g, r) = (gear(9, 1.0), plate(8.0, &[&circle(3.0)]));
    for i in 0..50 {
        let c = at(0.2 * f64::from(i), 0.1 * f64::from(i), f64::from(i));
        assert_eq!(
            judge(&g, &r, c).overlap,
            judge(&backwards(&g), &backwards(&r), c).overlap
        );
    }
}

#[test]
fn contact_is_found_where_it_is_known_to_be() {
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    let (a, b) = (circle(1.0), shifted(&circle(0.7), 0.5, 0.0));
    for n in near_contact(&Oracle::new(&a, &b), &mut rng, 200) {
        let center = n.contact.fixed_from_moving(Point::new(0.5, 0.0));
        let distance = center.to_vector().length();
        assert!((distance - 1.7).abs() < 2e-14, "{distance}");
        let moved = n.configuration.fixed_from_moving(Point::new(0.5, 0.0));
        assert_eq!(n.free, moved.to_vector().length() > 1.7);
        assert!((n.verdict.clearance - (moved.to_vector().length() - 1.7).max(0.0)).abs() < 1e-14);
    }
    // Squares: their centres' difference is on an octagon, the sum of the one and the other turned.
    let s = square(2.0);
    for n in near_contact(&Oracle::new(&s, &s), &mut rng, 400) {
        let beyond = |c: Configuration| {
            let reach = 1.0 + c.theta.sin().abs() + c.theta.cos().abs();
            let (sin, cos) = c.theta.sin_cos();
            let seen = [c.x, c.y, cos * c.x + sin * c.y, cos * c.y - sin * c.x];
            seen.iter()
                .map(|s| s.abs() - reach)
                .fold(f64::MIN, f64::max)
        };
        assert!(beyond(n.contact).abs() < 3e-14, "{n:?}");
        assert_eq!(n.free, beyond(n.configuration) > 0.0, "{n:?}");
    }
}

/// A square of side 1 whose lower and upper sides are arcs of a radius, and how high these are.
fn curved(radius: f64) -> (Part, f64) {
    let half = 0.5 / radius;
    let bulge = half / (1.0 + ((1.0 - half) * (1.0 + half)).sqrt());
    let corners = [
        (-0.5, -0.5, bulge),
        (0.5, -0.5, 0.0),
        (0.5, 0.5, bulge),
        (-0.5, 0.5, 0.0),
    ];
    let vertices = corners
        .map(|(x, y, b)| cspace::Vertex::new(x, y, b))
        .to_vec();
    let part = Part::new("curved", vec![vertices]).unwrap();
    (part, 0.5 * bulge)
}

/// Arcs up to a billion sizes of radius: at the middle of their sides, beside their corners, and parts one within the other.
#[test]
fn flat_arcs() {
    for k in 1..=9 {
        let (a, h) = curved(10_f64.powi(k));
        let (b, g) = curved(2.0 * 10_f64.powi(k));
        free(judge(&a, &b, at(0.0, 2.0, 0.0)), 1.0 - h - g);
        let touching = 1.0 + h + g;
        for d in [1e-4, 1e-8, 1e-11] {
            assert!(
                !judge(&a, &b, at(0.0, touching + d, 0.0)).overlap,
                "{k} {d}"
            );
            assert!(judge(&a, &b, at(0.0, touching - d, 0.0)).overlap, "{k} {d}");
        }
        blocked(judge(&a, &b, at(-0.09, 0.9566, 1e-4)), 1e-2);
        blocked(judge(&a, &b, at(0.0, 0.0, 0.3)), 1e-2);
    }
}
