//! Blocks, fixture, fastener.

use std::collections::BTreeSet;
use std::f64::consts::{PI, SQRT_2};

use cspace::Configuration;

use super::helpers::{Blocked, Contact, Free, expect, near, space, stop};

#[test]
fn the_block_seats_with_its_rounded_corner() {
    let blocks = space("blocks");
    let seated = |x, y| Configuration::new(x, y, 0.0);
    expect(&blocks, seated(0.0, 0.0), Contact);
    for (x, y) in [(-1e-6, 1e-6), (1e-6, -1e-6), (-1e-6, -1e-6)] {
        expect(&blocks, seated(x, y), Blocked);
    }
    expect(&blocks, seated(1e-6, 1e-6), Free);
    // Along the bed it comes to the fence, along the fence to the bed.
    near(
        stop(&blocks, seated(9.0, 0.1), [-1.0, 0.0, 0.0], 20.0).unwrap(),
        9.0,
        1e-8,
    );
    near(
        stop(&blocks, seated(0.1, 7.0), [0.0, -1.0, 0.0], 20.0).unwrap(),
        7.0,
        1e-8,
    );
}

/// A square corner comes no nearer than the middle of the fillet R2.
#[test]
fn a_square_corner_does_not_seat() {
    let blocks = space("blocks");
    let clear = 2.0 - SQRT_2;
    for (theta, corner) in [
        (PI / 2.0, [18.0, 0.0]),
        (PI, [25.0, 18.0]),
        (-PI / 2.0, [0.0, 25.0]),
    ] {
        let pushed = |by: f64| Configuration::new(corner[0] + by, corner[1] + by, theta);
        expect(&blocks, pushed(0.0), Blocked);
        expect(&blocks, pushed(clear - 1e-6), Blocked);
        expect(&blocks, pushed(clear + 1e-6), Free);
    }
}

#[test]
fn three_pads_locate_the_workpiece() {
    let fixture = space("fixture");
    let seat = Configuration::new(0.0, 0.0, 0.0);
    expect(&fixture, seat, Contact);
    let touches = |c| -> BTreeSet<u32> {
        (fixture.contacts(c, 1e-6).iter())
            .map(|&(patch, _)| fixture.patches()[patch.index()].fixed.loop_index)
            .collect()
    };
    // The long side lies on two pads, in one line: tilted a little, it stands on the first or on the second.
    let tilt = 1e-3f64;
    for (turn, x, pad) in [(tilt, 10.0, 0), (-tilt, 70.0, 1)] {
        let on = Configuration::new(1.0, -(x - 1.0) * turn.tan(), turn);
        assert_eq!(touches(on), BTreeSet::from([pad]));
    }
    assert!(touches(seat).contains(&2));
    // It is stopped by the pads of either side, wherever it comes from.
    let away = Configuration::new(7.0, 5.0, 0.0);
    near(
        stop(&fixture, away, [0.0, -1.0, 0.0], 20.0).unwrap(),
        5.0,
        1e-8,
    );
    near(
        stop(&fixture, away, [-1.0, 0.0, 0.0], 20.0).unwrap(),
        7.0,
        1e-8,
    );
    assert_eq!(stop(&fixture, seat, [1.0, 1.0, 0.0], 200.0), None);
    // Pressed against the pads it has one direction: lifted by 0.1, one corner of a pad 48 away stops it at once.
    for turn in [1e-6, -1e-6] {
        expect(&fixture, Configuration::new(0.0, 0.0, turn), Blocked);
    }
    let turn = (0.1f64 / 70.0).atan();
    let lifted = Configuration::new(0.2, 0.1, 0.0);
    let free = stop(&fixture, lifted, [0.0, 0.0, -1.0], 1.0).unwrap();
    assert!((0.9 * turn..1.1 * turn).contains(&free), "{free} {turn}");
}

#[test]
fn the_fastener_holds() {
    let fastener = space("fastener");
    let snapped = Configuration::new(0.0, 0.0, 0.0);
    expect(&fastener, snapped, Free);
    // 0.15 to the lip and to the floor, 0.2 to the mouth's sides.
    for (way, play) in [
        ([0.0, 1.0], 0.15),
        ([0.0, -1.0], 0.15),
        ([1.0, 0.0], 0.2),
        ([-1.0, 0.0], 0.2),
    ] {
        let stopped = stop(&fastener, snapped, [way[0], way[1], 0.0], 10.0).unwrap();
        near(stopped, play, 1e-8);
    }
    // Parts that do not bend do not come apart, however they are turned: the play is a region of its own.
    let regions = fastener.free_regions();
    assert_eq!(regions.len(), 2);
    assert_eq!(regions.iter().filter(|r| r.unbounded).count(), 1);
    // Pushed in from above, the lead-in comes to bear on the mouth's edge: it reaches x = 4 at 3/5 of its height.
    let above = Configuration::new(0.0, 30.0, 0.0);
    let lead_in = -14.0 + (14.0 - 8.15) * (4.0 - 2.2) / (5.2 - 2.2);
    let fall = stop(&fastener, above, [0.0, -1.0, 0.0], 30.0).unwrap();
    near(30.0 - fall, -lead_in, 1e-8);
}
