//! Cam and follower, crank and slider.

use std::f64::consts::PI;

use super::helpers::{Blocked, Free, at, expect, near, space, stop, turned};

/// The lift of a flat face over a tangent cam: nose R8 at 24 from the axis until 60 deg, then base circle R20.
#[test]
fn the_follower_rises_by_twelve() {
    let cam = space("cam");
    for step in -36..36 {
        let u = f64::from(step) * PI / 36.0 + 0.01;
        let height = if u.abs() < PI / 3.0 {
            8.0 + 24.0 * u.cos()
        } else {
            20.0
        };
        // In the cam's frame the follower is turned about the cam's axis.
        let down = turned(0.0, -1.0, u);
        let from = at(turned(0.0, 60.0, u), u);
        let fall = stop(&cam, from, [down.x, down.y, 0.0], 60.0).unwrap();
        near(60.0 - fall, height, 1e-8);
        expect(&cam, at(turned(0.0, height + 1e-6, u), u), Free);
        expect(&cam, at(turned(0.0, height - 1e-6, u), u), Blocked);
    }
}

#[test]
fn the_block_slides_from_end_to_end_of_the_slot() {
    let crank = space("crank_slider");
    for theta in [0.0, PI] {
        let middle = at(turned(58.5, 0.0, 0.0), theta);
        near(
            stop(&crank, middle, [1.0, 0.0, 0.0], 90.0).unwrap(),
            82.0 - 58.5,
            1e-8,
        );
        near(
            stop(&crank, middle, [-1.0, 0.0, 0.0], 90.0).unwrap(),
            58.5 - 35.0,
            1e-8,
        );
        // It has 0.1 of play a side.
        for side in [1.0, -1.0] {
            near(
                stop(&crank, middle, [0.0, side, 0.0], 1.0).unwrap(),
                0.1,
                1e-8,
            );
        }
    }
}

/// The centres of the block's corners are 7.5 and 3.5 from its middle, the corners R2.5, half the slot 6.1.
#[test]
fn the_block_turns_with_the_crank() {
    let crank = space("crank_slider");
    let play = (3.6f64 / 7.5f64.hypot(3.5)).asin() - 3.5f64.atan2(7.5);
    for side in [1.0, -1.0] {
        let middle = at(turned(60.0, 0.0, 0.0), 0.0);
        near(
            stop(&crank, middle, [0.0, 0.0, side], 1.0).unwrap(),
            play,
            1e-8,
        );
    }
    // Between the slot and the open there is no way, nor from one way around to the other.
    assert_eq!(crank.free_regions().len(), 3);
}
