//! The shipped mechanisms work as their drawings say.

use cspace::{Configuration, Point, Rotation};
use serde_json::json as value;

use crate::helpers::{classes, json, mechanism, model};

/// The driver turns for ever. The link follows the direction of the eccentric's centre as the fork's clearance lets it:
/// thrown by 19.5 at a distance of 100, with 0.1 to either side.
#[test]
fn the_driver_goes_around_and_rocks_the_link() {
    let file = mechanism();
    let pair = ["--pair", "driver,link"];
    let all = json(&["compute", &file, pair[0], pair[1]]);
    let region = &all[0]["regions"][0];
    assert_eq!(
        (&region["around_u"], &region["around_v"]),
        (&value!(true), &value!(false))
    );
    let (throw, shaft, play) = (19.5f64, 100.0f64, 0.1f64);
    let mut rows = Vec::new();
    let mut expected = Vec::new();
    for i in 0..72 {
        let u = 0.1 + 5f64.to_radians() * f64::from(i);
        // The centre of the eccentric, seen from the link's pivot.
        let (x, y) = (throw * u.sin(), shaft + throw * u.cos());
        let (direction, distance) = (x.atan2(y), x.hypot(y));
        let clearance = (play / distance).asin();
        for (part, class) in [
            (-1.001, "blocked"),
            (-0.999, "free"),
            (0.0, "free"),
            (0.999, "free"),
            (1.001, "blocked"),
        ] {
            rows.push(vec![u, direction + part * clearance]);
            expected.push(class);
        }
    }
    assert_eq!(classes(&[&file, pair[0], pair[1]], "u,v", &rows), expected);
    // The reach of the link: where the line from its pivot touches the throw's circle, nearly.
    let most = region["v"][1].as_f64().unwrap();
    let swing = (throw / shaft).asin();
    assert!(
        most > swing && most < swing + 1.1 * play / (shaft - throw),
        "{most}"
    );
}

/// On the way counter-clockwise the pawl bears on the tooth; on the way back it is lifted over the next one.
#[test]
fn the_pawl_catches_and_rides_over() {
    let pivot = Point::new(42.0, 56.0);
    // The link turned about the wheel's axis, the pawl about its pivot on the link.
    let pose = |link: f64, pawl: f64| {
        let (link, pawl) = (link.to_radians(), pawl.to_radians());
        let arm = pivot.to_vector();
        let at = Rotation::by(link) * arm - Rotation::by(link + pawl) * arm;
        vec![at.x, at.y, link + pawl]
    };
    let file = mechanism();
    let args = [file.as_str(), "--pair", "ratchet,pawl"];
    let ask = |rows: &[Vec<f64>]| classes(&args, "x,y,theta", rows);
    let engaged: Vec<Vec<f64>> = [0.0, 0.2, -18.0, -17.8].map(|a| pose(a, 0.0)).into();
    assert_eq!(ask(&engaged), ["free", "blocked", "free", "blocked"]);
    // Turned onto the wheel it is stopped, and so it is on the way if it does not lift.
    assert_eq!(ask(&[pose(0.0, 4.0), pose(-9.0, 0.0)]), ["blocked"; 2]);
    // Lifted by 7 deg it passes, all the way to the next tooth.
    let back: Vec<Vec<f64>> = (0..=36).map(|i| pose(-0.5 * f64::from(i), -7.0)).collect();
    assert!(ask(&back).iter().all(|c| c == "free"));
}

/// Dead beat: while the anchor swings on, the wheel rests, at one and the same angle.
#[test]
fn the_escape_wheel_rests_while_the_anchor_swings_on() {
    let file = model("escapement");
    let at = |v: f64, u: f64| vec![u.to_radians(), v.to_radians()];
    let rests = |deg: f64, side: f64| {
        let ask = |u: &[f64]| {
            let rows: Vec<Vec<f64>> = u.iter().map(|&u| at(side * deg, u)).collect();
            classes(&[&file], "u,v", &rows)
        };
        // From a free angle on, clockwise, until the wheel is stopped.
        let (mut free, mut blocked) = if side > 0.0 {
            (-9.5, -12.0)
        } else {
            (-3.5, -6.0)
        };
        assert_eq!(ask(&[free, blocked]), ["free", "blocked"], "{deg} {side}");
        // Six times, each narrower by the number of steps.
        const STEPS: usize = 64;
        for _ in 0..6 {
            let step = (blocked - free) / STEPS as f64;
            let tried: Vec<f64> = (0..=STEPS).map(|k| free + step * k as f64).collect();
            let classes = ask(&tried);
            let stopped = classes.iter().position(|c| c != "free").unwrap();
            assert!(stopped > 0, "{deg} {side}");
            (free, blocked) = (tried[stopped - 1], tried[stopped]);
        }
        free
    };
    for side in [1.0, -1.0] {
        let angles = [2.5, 4.0, 5.9].map(|deg| rests(deg, side));
        assert!((angles[0] - angles[1]).abs() < 1e-7, "{angles:?}");
        assert!((angles[2] - angles[1]).abs() < 1e-7, "{angles:?}");
    }
    // From one side to the other it steps by half a pitch.
    let step = rests(4.0, -1.0) - rests(4.0, 1.0);
    assert!((step - 6.0).abs() < 0.1, "{step}");
}

/// Where the link is in the driver's frame, by the motions written down anew.
fn relative(u: f64, v: f64) -> Configuration {
    let shaft = Point::new(0.0, -100.0);
    // q -> R_v q in the assembly, which the driver sees turned back about its shaft.
    let back = Rotation::by(-u);
    let at = shaft + back * (Point::ORIGIN - shaft);
    Configuration::new(at.x, at.y, v - u)
}

#[test]
fn classes_by_u_and_v_are_those_of_the_general_method() {
    let file = mechanism();
    let mut axes = Vec::new();
    let mut planar = Vec::new();
    for i in 0..60 {
        for j in -20..=20 {
            let (u, v) = (0.017 + 0.105 * f64::from(i), 0.017 * f64::from(j) + 0.0004);
            axes.push(vec![u, v]);
            let c = relative(u, v);
            planar.push(vec![c.x, c.y, c.theta]);
        }
    }
    // In the model's file the link is kept within 20 deg, and rows beyond would be refused.
    let pair = [file.as_str(), "--pair", "driver,link"];
    let by_axes = classes(&pair, "u,v", &axes);
    let general = classes(&[&pair[..], &["--general"]].concat(), "x,y,theta", &planar);
    assert!(by_axes == general);
    for class in ["free", "blocked"] {
        assert!(by_axes.iter().any(|c| c == class), "{class}");
    }
}
