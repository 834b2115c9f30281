//! Ratchet and pawl, Geneva drive, chain gear.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, SQRT_2};

use cspace::Configuration;

use super::helpers::{Blocked, Free, at, expect, near, space, stop, turned};

/// The wheel turned by `wheel` about its axis, the pawl by `pawl` about its pivot at (42, 56): degrees.
fn ratchet(wheel: f64, pawl: f64) -> Configuration {
    let (wheel, pawl) = (wheel.to_radians(), pawl.to_radians());
    at(turned(42.0, 56.0, -wheel), pawl - wheel)
}

#[test]
fn the_pawl_locks_the_wheel_one_way() {
    let space = space("ratchet_pawl");
    expect(&space, ratchet(0.0, 0.0), Free);
    // 0.05 at R50, and less than half a degree either way of the pawl.
    let gap = (0.05f64 / 50.0).to_degrees();
    for wheel in [1.2 * gap, 0.2, 0.5, 1.0, 2.0] {
        for pawl in [-0.5, 0.0] {
            expect(&space, ratchet(-wheel, pawl), Blocked);
        }
    }
    for wheel in [0.2, 0.5, 1.0] {
        expect(&space, ratchet(wheel, -0.7), Free);
    }
    // Every tooth locks as the first.
    for tooth in 0..20 {
        let wheel = 18.0 * f64::from(tooth);
        expect(&space, ratchet(wheel, 0.0), Free);
        expect(&space, ratchet(wheel - 0.2, 0.0), Blocked);
    }
}

/// In the other direction the released pawl lies on the back of a tooth, is lifted, and drops behind the next tooth
/// once its face has gone by far enough for the nose, which comes down on a circle. Then the face bears again.
#[test]
fn the_pawl_rides_over_the_teeth() {
    let space = space("ratchet_pawl");
    let (lifted, drop) = (-9.0, 1.2);
    let rest = |wheel: f64| {
        expect(&space, ratchet(wheel, lifted), Free);
        let turn = stop(&space, ratchet(wheel, lifted), [0.0, 0.0, 1.0], 0.3).unwrap();
        lifted + turn.to_degrees()
    };
    let angles: Vec<f64> = (0..=90).map(|i| rest(drop + 0.2 * f64::from(i))).collect();
    near(angles[0], angles[90], 1e-7);
    let highest = angles.iter().copied().fold(0.0, f64::min);
    let top = angles.iter().position(|&a| a == highest).unwrap();
    // The teeth are some 5 high and the nose is 43 from the pivot, which makes 6.6 deg.
    assert!((-7.0..-5.0).contains(&highest), "{highest}");
    // Up along the back over most of the pitch, then down by all of it.
    assert!(top > 75 && angles[..=top].windows(2).all(|w| w[1] < w[0]));
    assert!(angles[0] - highest > 5.0, "{angles:?}");
    for step in 0..=12 {
        expect(&space, ratchet(0.1 * f64::from(step), 0.0), Free);
    }
}

const CRANK: f64 = 40.0;

/// Configuration with the driver's pin at `pin` from half step, and the wheel at `off` from its position on the pin or
/// at rest.
fn geneva(pin: f64, off: f64) -> Configuration {
    let distance = CRANK * SQRT_2;
    let slot = (-CRANK * pin.sin()).atan2(distance - CRANK * pin.cos());
    let wheel = off
        + if pin.abs() < FRAC_PI_4 {
            slot - FRAC_PI_4
        } else {
            0.0
        };
    at(turned(distance, 0.0, -wheel), PI + pin - wheel)
}

#[test]
fn the_pin_indexes_the_wheel_and_the_disc_holds_it() {
    let space = space("geneva");
    for step in 0..1440 {
        let pin = (0.25 * f64::from(step) - 180.0).to_radians();
        expect(&space, geneva(pin, 0.0), Free);
        // Held to a degree, but for 12 deg about the places where disc and pin take over from each other: there the disc
        // ends near the line of the shafts, and holds the wheel on one side only.
        if (pin.abs() - FRAC_PI_4).abs() > 0.21 {
            for off in [-1f64, 1.0] {
                expect(&space, geneva(pin, off.to_radians()), Blocked);
            }
        }
    }
}

/// One turn of the driver takes the wheel back by a quarter, and every quarter is the same.
#[test]
fn every_slot_takes_the_pin() {
    let space = space("geneva");
    for quarter in 0..4 {
        let off = FRAC_PI_2 * f64::from(quarter);
        for pin in [-0.7, -0.3, 0.0, 0.5, 2.0] {
            expect(&space, geneva(pin, off), Free);
            expect(&space, geneva(pin, off + FRAC_PI_4), Blocked);
        }
    }
}

/// Pitch 12.7, rollers 7.92, 14 teeth; the seats' radius is 4.0198.
#[test]
fn the_link_seats_in_every_two_gaps() {
    let space = space("chain_gear");
    let seat = 12.7 / 2.0 / (PI / 14.0).tan();
    let play = 0.5025 * 7.92 + 0.04 - 3.96;
    let link =
        |out: f64, along: f64, turn: f64| at(turned(seat + out, along, turn), turn + FRAC_PI_2);
    for tooth in 0..14 {
        let turn = 2.0 * PI / 14.0 * f64::from(tooth);
        expect(&space, link(0.0, 0.0, turn), Free);
        expect(&space, link(-1.2 * play, 0.0, turn), Blocked);
        for side in [1.0, -1.0] {
            expect(&space, link(0.0, 2.0 * play * side, turn), Blocked);
            // End for end.
            expect(
                &space,
                at(
                    link(0.0, 0.0, turn).position().to_vector(),
                    turn + side * FRAC_PI_2,
                ),
                Free,
            );
        }
        // It is lifted straight out, but not laid in across.
        let out = turned(1.0, 0.0, turn);
        assert_eq!(
            stop(&space, link(0.0, 0.0, turn), [out.x, out.y, 0.0], 100.0),
            None
        );
        expect(&space, at(turned(seat, 0.0, turn), turn), Blocked);
    }
}

/// As the wheel turns away from a chain that leaves it straight, a link turns about the pin that is still seated.
#[test]
fn the_link_runs_off() {
    let space = space("chain_gear");
    let radius = 12.7 / 2.0 / (PI / 14.0).sin();
    for side in [1.0, -1.0] {
        let gap = side * PI / 14.0;
        let pin = turned(radius, 0.0, gap);
        for step in 0..=60 {
            // From along the chord to outward, seen from the seated pin.
            let direction =
                gap + side * (FRAC_PI_2 + PI / 14.0) - side * f64::from(step).to_radians();
            expect(
                &space,
                at(pin + turned(6.35, 0.0, direction), direction),
                Free,
            );
        }
    }
}
