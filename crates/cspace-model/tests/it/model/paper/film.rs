//! The film advance: what the cam does to the claw, and the claw to a film.

use std::f64::consts::{FRAC_PI_2, PI};

use cspace::{ContactSpace, Options, Part, Vector, Vertex};

use super::helpers::{Blocked, Contact, Free, at, expect, near, parts, space, turned};

const PULL: f64 = 19.0;
const CORNER: f64 = 3.0;
const PLAY: f64 = 0.05;

/// Extent of a triangle of arcs with rounded corners, one of them at +y, from its middle in a direction.
fn reach(direction: f64) -> f64 {
    let corner = |k: f64| PULL / 3f64.sqrt() * (direction - FRAC_PI_2 - 2.0 * PI / 3.0 * k).cos();
    let corners = [0.0, 1.0, 2.0].map(corner);
    let highest = corners.into_iter().fold(f64::MIN, f64::max);
    let lowest = corners.into_iter().fold(f64::MAX, f64::min);
    // A corner is ahead if it is within 30 deg, otherwise the arc about the corner behind.
    if highest >= PULL / 3f64.sqrt() * (PI / 6.0).cos() {
        highest + CORNER
    } else {
        lowest + PULL + CORNER
    }
}

/// The middle of the cam in the middle of its play in the window.
fn seat(theta: f64) -> Vector {
    let middle = |d: f64| 0.5 * (reach(d + PI - theta) - reach(d - theta));
    Vector::new(middle(0.0), middle(FRAC_PI_2))
}

/// Position of the frame when the shaft, in the cam's corner, is the origin.
fn frame(theta: f64) -> Vector {
    let shaft = seat(theta) + turned(0.0, PULL / 3f64.sqrt(), theta);
    Vector::new(-shaft.x, -shaft.y)
}

#[test]
fn the_cam_fills_the_window_at_every_angle() {
    let space = space("film_advance");
    for step in 0..120 {
        let theta = (3.0 * f64::from(step) - 179.5).to_radians();
        let c = seat(theta);
        expect(&space, at(c, theta), Free);
        for side in [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)] {
            for sign in [1.0, -1.0] {
                expect(&space, at(c + side * (sign * (PLAY - 1e-6)), theta), Free);
                expect(
                    &space,
                    at(c + side * (sign * (PLAY + 1e-6)), theta),
                    Blocked,
                );
            }
        }
    }
    // In the window it goes around for ever, and cannot leave.
    assert_eq!(space.free_regions().len(), 2);
}

/// The shaft turns clockwise: the claw is in while it goes down, and out while it goes up.
#[test]
fn the_claw_draws_a_square() {
    // In degrees: the direction from the middle of the cam to the shaft.
    let claw = |degrees: f64| frame(degrees.to_radians() - FRAC_PI_2);
    let half = PULL / 2.0;
    // While it rests up or down, it has come within 30 deg from the middle to here.
    let near_in = half - PULL * (1.0 - (PI / 6.0).cos());
    for (degrees, x, y) in [
        (330.0, -half, near_in),
        (300.0, -near_in, half),
        (270.0, 0.0, half),
        (240.0, near_in, half),
        (210.0, half, near_in),
        (180.0, half, 0.0),
        (150.0, half, -near_in),
        (120.0, near_in, -half),
        (90.0, 0.0, -half),
        (60.0, -near_in, -half),
        (0.0, -half, 0.0),
    ] {
        near(claw(degrees).x, x, 1e-9);
        near(claw(degrees).y, y, 1e-9);
    }
}

/// A film in section: perforations 1.98 high, 4.75 apart. The claw enters one, pulls the film by one picture and leaves it.
#[test]
fn the_claw_pulls_the_film_by_one_picture() {
    let (frame_part, _) = parts("film_advance");
    let (pitch, hole, thick) = (4.75, 1.98, 0.15);
    // The claw, 1.6 high, reaches to 39.6 from the frame's middle, its face is 20.4 above it.
    let (tip, face) = (39.6, 20.4);
    let below = 0.05; // between the claw's face and the perforation's edge when it enters
    let plane = tip - 2.0;
    let edge = face + PULL / 2.0 - below;
    let webs = (-8..8).map(|k| {
        let (low, high) = (
            edge + pitch * f64::from(k - 1) + hole,
            edge + pitch * f64::from(k),
        );
        let corners = [
            (plane - thick, low),
            (plane, low),
            (plane, high),
            (plane - thick, high),
        ];
        corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
    });
    let film = Part::new("film", webs.collect()).unwrap();
    let space = ContactSpace::compute(&film, &frame_part, &Options::default()).unwrap();
    let (mut drawn, mut pulling) = (0.0f64, 0);
    for step in 0..=720 {
        let claw = frame((270.0 - 0.5 * f64::from(step)).to_radians() - FRAC_PI_2);
        let inside = claw.x + tip > plane;
        if inside {
            drawn = drawn.min(claw.y - PULL / 2.0 + below);
        }
        let class = space.classify(at(claw - Vector::new(0.0, drawn), 0.0));
        assert!(matches!(class, Some(Free | Contact)), "{step} {class:?}");
        // Were the film held, the claw would meet it.
        if inside && drawn < -1e-3 && drawn > -1.5 {
            expect(&space, at(claw, 0.0), Blocked);
            pulling += 1;
        }
    }
    assert!(pulling > 5, "{pulling}");
    near(drawn, -PULL + below, 1e-6);
}
