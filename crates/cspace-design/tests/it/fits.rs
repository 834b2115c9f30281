//! The most room of a part within a box, in closed form and beside samples.

use cspace::{Configuration, Coordinates, PairSpace, Relation, Silent};
use cspace_design::{Checked, Goal, Span, Unmeasured, Value, check, solve};
use cspace_model::{Host, read_from_hosted};

use crate::common::{model, number, template};

/// A plate with two holes at ±a, and one with two pins at ±b that is placed off by a little.
const PLATES: &str = r#"
[parameter]
a = 10
b = 10.05
hole = 3.1
pin = 3

[[part]]
name = "holes"
loops = [[[-20, -8], [20, -8], [20, 8], [-20, 8]], { circle = "hole", at = ["a", 0] }, { circle = "hole", at = ["-a", 0] }]

[[part]]
name = "pins"
loops = [{ circle = "pin", at = ["b", 0] }, { circle = "pin", at = ["-b", 0] }]

[[requirement]]
name = "as placed"
measure = "clearance"
at = { x = 0.02, y = 0.03, theta = "0.1deg" }

[[requirement]]
name = "somewhere"
measure = "fits"
at = { x = 0.02, y = 0.03, theta = "0.1deg" }
within = [0.2, 0.2, "1deg"]
limits = [0, 1]
"#;

#[track_caller]
fn is_about(checked: &Checked, expected: f64, error: f64) {
    let found = number(checked);
    assert!((found - expected).abs() < error, "{found} {expected}");
    let (lo, hi) = checked.measured.as_ref().unwrap().range.unwrap();
    assert!((lo..=hi).contains(&found) && hi - lo < 1e-6, "{lo} {hi}");
}

#[test]
fn pins_in_holes() {
    let found = check(&model(PLATES, &[]));
    is_about(&found[1], 0.1 - 0.05, 1e-10);
    assert_eq!(found[1].is_met(), Some(true));
    assert!(number(&found[0]) < 0.05);
    let stop = &found[1].measured.as_ref().unwrap().stops[0];
    let Coordinates::Planar(at) = stop.at else {
        panic!("{stop:?}");
    };
    assert!(at.x.abs() < 1e-3 && at.y.abs() < 1e-3 && at.theta.abs() < 1e-3);
    // Farther apart than the holes let them be: smaller by so much they fit.
    let found = check(&model(PLATES, &[("b", "10.13".to_owned())]));
    is_about(&found[1], -0.03, 1e-10);
    assert_eq!(found[1].is_met(), Some(false));
    assert_eq!(found[0].measured, Err(Unmeasured::Blocked));
}

#[test]
fn the_size_at_which_they_fit() {
    let goal = Goal {
        requirement: "somewhere".into(),
        relation: cspace_design::Relation::Equal,
        value: Value::Number(0.0),
    };
    let spans = [Span {
        parameter: "hole".into(),
        lo: 3.0,
        hi: 3.2,
    }];
    let found = solve(&template(PLATES), &[], &spans, &goal, 3, &Silent);
    assert!((found.solutions[0][0] - 3.05).abs() < 1e-6, "{found:?}");
}

/// A square of 2 in a square hole of 2.2.
const PEG: &str = r#"
[[part]]
name = "plate"
motion = { type = "fixed" }
loops = [[[-3, -3], [3, -3], [3, 3], [-3, 3]], [[-1.1, -1.1], [1.1, -1.1], [1.1, 1.1], [-1.1, 1.1]]]

[[part]]
name = "peg"
loops = [[[-1, -1], [1, -1], [1, 1], [-1, 1]]]

[[requirement]]
name = "room"
measure = "fits"
at = { x = 0.2 }
within = [0.15, 0.1, "5deg"]
"#;

#[test]
fn the_box_limits_the_room() {
    let set = |from: &str, to: &str| check(&model(&PEG.replace(from, to), &[]))[0].clone();
    is_about(&set("", ""), 0.05, 1e-8);
    // Farther off it is free nowhere.
    is_about(&set("[0.15,", "[0.05,"), -0.05, 1e-7);
    // A box of no extent is the configuration itself.
    is_about(&set("[0.15, 0.1, \"5deg\"]", "[0, 0, 0]"), -0.1, 1e-7);
    is_about(
        &set(
            "{ x = 0.2 }\nwithin = [0.15, 0.1, \"5deg\"]",
            "{ x = 0.02 }\nwithin = [0, 0, 0]",
        ),
        0.08,
        1e-7,
    );
    // A square is the same after each quarter of a turn.
    for (theta, extent) in [
        ("90deg", "5deg"),
        ("183deg", "5deg"),
        ("-450deg", "0deg"),
        ("40deg", "400deg"),
    ] {
        let turned = PEG
            .replace("x = 0.2", &format!("x = 0.2, theta = \"{theta}\""))
            .replace("5deg", extent);
        is_about(&check(&model(&turned, &[]))[0], 0.05, 1e-8);
    }
    // In the window of the pair alone: a square that is turned is wider.
    let window = "[[pair]]\nfixed = \"plate\"\nmoving = \"peg\"\ntheta = [\"2deg\", \"20deg\"]\n";
    let (sin, cos) = 2_f64.to_radians().sin_cos();
    let found = check(&model(
        &format!("{PEG}{window}").replace("x = 0.2", "x = 0.1"),
        &[],
    ));
    is_about(&found[0], 1.1 - (sin + cos), 1e-8);
    // Far from the plate the room is the distance.
    is_about(&set("{ x = 0.2 }", "{ x = 9 }"), 9.15 - 4.0, 1e-6);
}

/// No sampled configuration has more room than is told, and the one that is told has it.
#[test]
fn no_sample_has_more() {
    let plate = PEG.replace(
        "[1.1, -1.1], [1.1, 1.1], [-1.1, 1.1]]",
        "[1.2, -1.0], [1.0, 1.3], [-0.4, 1.1, 0.2]]",
    );
    let model = model(&plate.replace("{ x = 0.2 }", "{ x = 0.05, y = 0.02 }"), &[]);
    let found = &check(&model)[0];
    let measured = found.measured.as_ref().unwrap();
    let (least, most) = measured.range.unwrap();
    let [fixed, moving] = [0, 1].map(|i| &model.mechanism.parts[i].part);
    let space =
        PairSpace::compute(fixed, moving, Relation::Planar, &cspace::Options::default()).unwrap();
    if least > 0.0 {
        let there = space.clearance(measured.stops[0].at).unwrap();
        assert!((there - least).abs() < 1e-9, "{there} {least}");
    }
    let n = 12;
    let part = |i: i32, half: f64| half * f64::from(2 * i - n) / f64::from(n);
    for i in 0..=n {
        for j in 0..=n {
            for k in 0..=n {
                let at = Configuration::new(
                    0.05 + part(i, 0.15),
                    0.02 + part(j, 0.1),
                    part(k, 5_f64.to_radians()),
                );
                if let Ok(clearance) = space.clearance(Coordinates::Planar(at)) {
                    assert!(clearance <= most + 1e-9, "{at:?} {clearance} {most}");
                }
            }
        }
    }
}

#[test]
fn what_is_wrong_is_told() {
    let read = |text: &str| read_from_hosted(text.as_bytes(), "m.toml", &Host::default());
    for (from, to, message, help) in [
        (
            "[0.15, 0.1,",
            "[-0.15, 0.1,",
            "less than 0",
            "how far x, y and theta",
        ),
        (
            "within = [0.15, 0.1, \"5deg\"]",
            "",
            "`within` is missing",
            "within = [",
        ),
        (
            "name = \"peg\"",
            "name = \"peg\"\nmotion = { type = \"prismatic\", direction = [1, 0] }",
            "moves on axes",
            "over = \"ranges\"",
        ),
    ] {
        let text = PEG.replace(from, to).replace("at = { x = 0.2 }\n", "");
        let Err(e) = read(&text) else {
            panic!("it was read: {message}");
        };
        assert!(e.to_string().contains(message), "{e}");
        assert!(
            e.help().unwrap_or_default().contains(help),
            "{:?}",
            e.help()
        );
    }
}
