//! The knee.

use std::f64::consts::FRAC_PI_2;

use cspace::{Configuration, Vector};

use super::helpers::{Blocked, Contact, Free, at, expect, near, space, stop, turned};

/// The arcs of the condyle from its lowest point to the back: radius, and degrees that it turns by.
const BACK: [(f64, f64); 5] = [
    (40.0, 16.0),
    (33.0, 20.0),
    (27.0, 26.0),
    (23.0, 36.0),
    (20.0, 40.0),
];

/// The femur flexed by theta whose condyle bears on the lowest point of the plateau: centre of the arc there above it.
fn flexed(theta: f64) -> Vector {
    let (mut joint, mut center, mut before) = (-FRAC_PI_2, Vector::new(0.0, 0.0), 0.0);
    let mut left = theta;
    for (radius, degrees) in BACK {
        center = center + turned(before - radius, 0.0, joint);
        before = radius;
        if left <= degrees.to_radians() {
            break;
        }
        left -= degrees.to_radians();
        joint -= degrees.to_radians();
    }
    Vector::new(0.0, before) - turned(center.x, center.y, theta)
}

/// One arc of the condyle after the other bears; nothing else of the bones is in the way.
#[test]
fn the_femur_slides_on_the_tibia_while_it_is_flexed() {
    let knee = space("tibia_femur");
    expect(&knee, Configuration::new(0.0, 0.0, 0.0), Contact);
    for degrees in 0..=115 {
        let theta = f64::from(degrees).to_radians();
        let seat = flexed(theta);
        expect(&knee, at(seat, theta), Contact);
        expect(&knee, at(seat + Vector::new(0.0, 1e-6), theta), Free);
        expect(&knee, at(seat - Vector::new(0.0, 1e-6), theta), Blocked);
        // The dish holds it: to the front and to the back the way is up.
        for side in [3.0, -3.0] {
            expect(&knee, at(seat + Vector::new(side, 0.0), theta), Blocked);
        }
    }
    // Farther the back of the femur's shaft comes down on the rim.
    expect(&knee, at(flexed(2.2), 2.2), Blocked);
}

/// Lifted off it comes away; laid on from above, it comes to rest on the plateau.
#[test]
fn the_femur_lifts_off() {
    let knee = space("tibia_femur");
    let up = stop(&knee, at(flexed(0.5), 0.5), [0.0, 1.0, 0.0], 500.0);
    assert_eq!(up, None);
    let above = at(flexed(0.5) + Vector::new(0.0, 30.0), 0.5);
    near(
        stop(&knee, above, [0.0, -1.0, 0.0], 60.0).unwrap(),
        30.0,
        1e-8,
    );
}

#[test]
fn the_groove_holds_the_patella() {
    let knee = space("patella_femur");
    let bone = |x: f64, y: f64, theta: f64| Configuration::new(x, y, theta);
    expect(&knee, bone(0.0, 0.0, 0.0), Contact);
    expect(&knee, bone(0.0, 1e-6, 0.0), Free);
    // Not deeper, not to a side, and not tilted.
    for c in [
        (0.0, -1e-6, 0.0),
        (1e-3, 0.0, 0.0),
        (-1e-3, 0.0, 0.0),
        (0.0, 0.0, 1e-3),
        (0.0, 0.0, -1e-3),
    ] {
        expect(&knee, bone(c.0, c.1, c.2), Blocked);
    }
    // Shifted by one, it rides up on the side it is pushed to: by 7/20 to the medial, by 11/22 to the lateral side.
    for (x, rise) in [(1.0, 0.35), (-1.0, 0.5)] {
        expect(&knee, bone(x, rise + 1e-6, 0.0), Free);
        expect(&knee, bone(x, rise - 1e-6, 0.0), Blocked);
    }
    // Out of the groove it slides off to either side, but not over a lower ridge without rising.
    for side in [1.0, -1.0] {
        let rate = [side, 0.0, 0.0];
        assert!(stop(&knee, bone(0.0, 2.0, 0.0), rate, 100.0).is_some());
        assert_eq!(stop(&knee, bone(0.0, 20.0, 0.0), rate, 100.0), None);
    }
}
