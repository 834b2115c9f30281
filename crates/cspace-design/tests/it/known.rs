//! Quantities whose values are known in closed form, and requirements of models.

use cspace::{Point, Vector};
use cspace_design::{Checked, Sweep, Unmeasured, Value, Varied, check};
use cspace_model::model::{Coordinate, Setting};
use cspace_model::{Host, read_from_hosted};

use crate::common::{model, number, template};

#[track_caller]
fn truth(checked: &Checked) -> bool {
    match checked.measured.as_ref().unwrap().value {
        Value::Truth(b) => b,
        Value::Number(_) => panic!("{checked:?}"),
    }
}

const PEG: &str = r#"
[parameter]
slot = 10.1
high = 18

[[part]]
name = "slot"
loops = [[{ mirror = "y", path = [[0, -35], [30, -35], [30, 0], ["slot/2", 0], ["slot/2", -30]] }]]

[[part]]
name = "peg"
loops = [[[-5, "-high/2"], [5, "-high/2"], [5, "high/2"], [-5, "high/2"]]]

[[requirement]]
name = "tilt"
measure = "play"
of = "theta"
at = { y = -15 }
limits = ["0.5deg", "0.7deg"]

[[requirement]]
name = "sideways"
measure = "play"
of = "x"
at = { y = -15 }
limits = [0.2, 0.3]

[[requirement]]
name = "depth"
measure = "position"
at = { y = 20 }
along = [0, -60, 0]

[[requirement]]
name = "gap"
measure = "clearance"
at = { x = 0.02, y = -15 }

[[requirement]]
name = "comes out"
measure = "connected"
at = { y = -15 }
to = [0, 50, 0]
equals = true
"#;

#[test]
fn a_peg_in_a_slot() {
    for (slot, high) in [(10.1_f64, 18.0_f64), (10.003, 20.0), (10.5, 4.0)] {
        let set = [("slot", slot.to_string()), ("high", high.to_string())];
        let all = check(&model(PEG, &set));
        // 5 cos φ + h/2 sin φ = slot/2.
        let (half, across) = (high / 2.0, 5.0_f64.hypot(high / 2.0));
        let tilt = (slot / 2.0 / across).asin() - 5.0_f64.atan2(half);
        assert!(
            (number(&all[0]) - 2.0 * tilt).abs() < 1e-13,
            "{slot}: {:?}",
            all[0]
        );
        assert!(
            (number(&all[1]) - (slot - 10.0)).abs() < 1e-13,
            "{:?}",
            all[1]
        );
        assert!(
            (number(&all[2]) - (half - 30.0)).abs() < 1e-12,
            "{:?}",
            all[2]
        );
        if slot > 10.05 {
            assert!(
                (number(&all[3]) - (slot / 2.0 - 5.02)).abs() < 1e-12,
                "{:?}",
                all[3]
            );
        } else {
            assert_eq!(all[3].measured, Err(Unmeasured::Blocked));
        }
        assert!(truth(&all[4]));
    }
}

#[test]
fn limits_are_met_or_not_with_a_margin() {
    let all = check(&model(PEG, &[]));
    let met: Vec<_> = all.iter().map(Checked::is_met).collect();
    assert_eq!(met, [Some(true), Some(false), None, None, Some(true)]);
    assert!((all[1].margin().unwrap() + 0.1).abs() < 1e-12);
    let touching = &all[2].touching;
    assert_eq!(touching.len(), 2, "both corners: {touching:?}");
}

#[test]
fn a_roller_on_an_eccentric() {
    // Of radius 3 on a disc of 10, 4 off its axis.
    let text = r#"
[parameter]
angle = "60deg"
along = "0deg"

[[part]]
name = "eccentric"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 10, at = [4, 0] }]

[[part]]
name = "roller"
motion = { type = "prismatic", direction = ["cos(along)", "sin(along)"] }
loops = [{ circle = 3, at = [0, 0] }]

[[requirement]]
name = "lift"
pair = ["eccentric", "roller"]
measure = "position"
at = { u = "angle", v = 40 }
along = [0, -60]
"#;
    for (degrees, along) in [
        (60.0_f64, 0.0_f64),
        (60.0, 90.0),
        (200.0, 10.0),
        (-31.0, 77.0),
    ] {
        let set = [
            ("angle", format!("{degrees}deg")),
            ("along", format!("{along}deg")),
        ];
        let found = number(&check(&model(text, &set))[0]);
        let angle = (degrees - along).to_radians();
        let expected = 4.0 * angle.cos() + (169.0 - (4.0 * angle.sin()).powi(2)).sqrt();
        assert!(
            (found - expected).abs() < 1e-12,
            "{degrees}, {along}: {found} {expected}"
        );
    }
    let found = number(&check(&model(text, &[]))[0]);
    assert!((found - 14.529_964_09).abs() < 1e-8);
}

/// A ball in a C-shaped clip is caged exactly as long as the mouth is narrower than the ball.
#[test]
fn a_ball_in_a_clip() {
    let text = r#"
[parameter]
ball = 5
mouth = 9
up = "sqrt(36 - (mouth/2)^2)"

[[part]]
name = "clip"
loops = [[[-12, -12], [12, -12], [12, 12], ["mouth/2", 12], ["mouth/2", "up"], { arc_to = ["-mouth/2", "up"], center = [0, 0], direction = "cw" }, ["-mouth/2", 12], [-12, 12]]]

[[part]]
name = "ball"
loops = [{ circle = "ball", at = [0, 0] }]

[[requirement]]
name = "held"
measure = "caged"
equals = true

[[requirement]]
name = "way out"
measure = "connected"
to = [0, 40, 0]
equals = false
"#;
    for (mouth, held) in [
        (9.0, true),
        (10.0 - 1e-7, true),
        (10.0 + 1e-7, false),
        (11.0, false),
    ] {
        let all = check(&model(text, &[("mouth", format!("{mouth:?}"))]));
        assert_eq!(truth(&all[0]), held, "{mouth}");
        assert_eq!(truth(&all[1]), !held, "{mouth}");
        assert_eq!(all.iter().all(|c| c.is_met() == Some(true)), held);
    }
}

#[test]
fn what_cannot_be_measured_says_why() {
    let with = |from: &str, to: &str| {
        assert!(PEG.contains(from), "{from}");
        check(&model(&PEG.replacen(from, to, 1), &[]))
    };
    let unlimited = with("at = { y = -15 }\nlimits = [0.2, 0.3]", "at = { y = 40 }");
    assert_eq!(unlimited[1].measured, Err(Unmeasured::Unlimited));
    assert_eq!(unlimited[1].is_met(), None);
    let blocked = with(
        "at = { y = -15 }\nlimits = [0.2, 0.3]",
        "at = { x = 3, y = -15 }\nlimits = [0.2, 0.3]",
    );
    assert_eq!(blocked[1].measured, Err(Unmeasured::Blocked));
    assert_eq!(blocked[1].is_met(), Some(false));
    let missed = with("along = [0, -60, 0]", "along = [0, 60, 0]");
    assert_eq!(missed[2].measured, Err(Unmeasured::NoContact));
}

/// The rows of a sweep are what single models give, in any number together.
#[test]
fn sweeps_are_rows_of_checks() {
    let template = template(PEG);
    let varied = [
        Varied::Parameter("slot".into()),
        Varied::Coordinate(Coordinate::Y),
    ];
    let measures = ["sideways", "tilt", "gap"].map(str::to_owned);
    let mut rows = Vec::new();
    for slot in [9.5, 10.02, 10.2, 10.4] {
        rows.extend([-15.0, -3.0, 0.0].map(|y| vec![slot, y]));
    }
    let set = [Setting {
        name: "high".into(),
        value: "16".into(),
    }];
    let sweep = Sweep::new(&template, &set, &varied, &measures);
    let all = sweep.rows(&rows);
    for together in [1, 2, 5] {
        let again: Vec<_> = rows.chunks(together).flat_map(|r| sweep.rows(r)).collect();
        assert_eq!(again, all);
    }
    let mut measured = 0;
    for (values, row) in rows.iter().zip(&all) {
        let text = PEG
            .replace("at = { y = -15 }", &format!("at = {{ y = {} }}", values[1]))
            .replace(
                "at = { x = 0.02, y = -15 }",
                &format!("at = {{ x = 0.02, y = {} }}", values[1]),
            );
        let set = [("slot", values[0].to_string()), ("high", "16".to_owned())];
        let checked = check(&model(&text, &set));
        for (i, name) in measures.iter().enumerate() {
            let one = checked
                .iter()
                .find(|c| c.requirement.name == *name)
                .unwrap();
            match (&row.measured[i], &one.measured) {
                (Ok(a), Ok(b)) => {
                    assert_eq!(*a, b.value);
                    measured += 1;
                }
                (Err(a), Err(b)) => assert_eq!(*a, b.to_string()),
                other => panic!("{name} at {values:?}: {other:?}"),
            }
        }
    }
    assert!(measured >= 20, "{measured}");
    // A slot that is no outline is a reason, not an end.
    let bad = sweep.rows(&[vec![-10.0, 0.0]]);
    let reason = bad[0].measured[0].as_ref().unwrap_err();
    assert!(reason.contains("part 0 \"slot\""), "{reason}");
}

/// A peg that is higher than the slot is deep tilts about its lower corners alone; a slot narrower than it lets it not in.
#[test]
fn changes_along_a_sweep_are_located() {
    let template = template(PEG);
    let line = |name: &str, values: [f64; 4], measure: &str| {
        let varied = [Varied::Parameter(name.into())];
        let measures = [measure.to_owned()];
        let sweep = Sweep::new(&template, &[], &varied, &measures);
        sweep.changes(&values.map(|v| vec![v]))
    };
    let free = line("slot", [9.0, 9.7, 10.3, 11.0], "comes out");
    assert_eq!(free.len(), 1, "{free:?}");
    assert!((free[0].values[0] - 10.0).abs() < 1e-7, "{free:?}");
    assert!(free[0].before.contains("overlap") && free[0].after.contains("yes"));
    // The slot is 30 deep, and the middle of the peg 15 above its bottom: from there on its end is in the way first.
    let tilt = line("high", [8.0, 16.0, 24.0, 29.9999], "tilt");
    assert_eq!(tilt.len(), 1, "{tilt:?}");
    let high = tilt[0].values[0];
    assert!(tilt[0].after.contains("line 4"), "{tilt:?}");
    let touching = |high: f64| {
        let all = check(&model(PEG, &[("high", high.to_string())]));
        all[0]
            .touching
            .iter()
            .flatten()
            .any(|t| t.starts_with("line 4"))
    };
    assert!(!touching(high - 1e-4) && touching(high + 1e-4), "{high}");
    assert!(line("slot", [10.1, 10.2, 10.3, 10.4], "sideways").is_empty());
}

/// An arm with a roller of 3 on a disc of 10 that turns 4 off its axis: the normal is from centre to centre, and the contact turns about the
/// arm's pivot.
#[test]
fn pressure_angle_of_a_swinging_follower() {
    let text = r#"
[parameter]
angle = "60deg"

[[part]]
name = "eccentric"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 10, at = [4, 0] }]

[[part]]
name = "arm"
motion = { type = "revolute", center = [22, -15] }
loops = [{ circle = 3, at = [22, 9] }]

[[requirement]]
name = "pressure angle"
measure = "angle"
of = "v"
at = { u = "angle", v = 0 }
along = [0, "90deg"]
"#;
    let pivot = Point::new(22.0, -15.0);
    for degrees in [0.0_f64, 60.0, 90.0, 133.0, -70.0] {
        let all = check(&model(text, &[("angle", format!("{degrees}deg"))]));
        let disc = Point::ORIGIN + Vector::from_angle(degrees.to_radians()) * 4.0;
        // The triangle of pivot, disc and roller has the sides 24, 13 and the distance of the first two.
        let far = disc.distance(pivot);
        let corner = ((576.0 + far * far - 169.0) / (48.0 * far)).acos();
        let to_disc = disc - pivot;
        let turned = to_disc.y.atan2(to_disc.x) - corner;
        let roller = pivot + Vector::from_angle(turned) * 24.0;
        let normal = (roller - disc) * (1.0 / 13.0);
        let lever = disc + normal * 10.0 - pivot;
        let expected = (normal.cross(lever).abs() / lever.length()).acos();
        let found = number(&all[0]);
        assert!(
            (found - expected).abs() < 1e-9,
            "{degrees}: {found} for {expected}"
        );
    }
}

/// A roller of 3 on a disc of 10 that turns 4 off its axis: the normal is from centre to centre, 13 apart.
#[test]
fn pressure_angles_bottlenecks_and_extremes() {
    let text = r#"
[parameter]
angle = "60deg"

[[part]]
name = "eccentric"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 10, at = [4, 0] }]

[[part]]
name = "roller"
motion = { type = "prismatic", direction = [1, 0] }
loops = [{ circle = 3, at = [0, 0] }]

[[requirement]]
name = "pressure angle"
measure = "angle"
of = "v"
at = { u = "angle", v = 40 }
along = [0, -60]

[[requirement]]
name = "of the cam"
measure = "angle"
of = "u"
at = { u = "angle", v = 40 }

[[requirement]]
name = "lowest"
measure = "extreme"
of = "v"
end = "lower"
at = { u = "angle", v = 40 }

[[requirement]]
name = "highest"
measure = "extreme"
of = "v"
at = { v = 40 }
"#;
    for degrees in [60.0_f64, 90.0, 133.0, 0.5] {
        let all = check(&model(text, &[("angle", format!("{degrees}deg"))]));
        let (sin, cos) = degrees.to_radians().sin_cos();
        let expected = (4.0 * sin / 13.0).asin();
        assert!(
            (number(&all[0]) - expected).abs() < 1e-9,
            "{degrees}: {:?}",
            all[0]
        );
        // Nearest as drawn: on the line from the centre of the disc to that of the roller.
        let (x, y) = (40.0 - 4.0 * cos, -4.0 * sin);
        let far = x.hypot(y);
        let at = [4.0 * cos + 10.0 * x / far, 4.0 * sin + 10.0 * y / far];
        let moves = [-at[1], at[0]];
        let along = (moves[0] * x + moves[1] * y) / far / moves[0].hypot(moves[1]);
        assert!(
            (number(&all[1]) - along.abs().acos()).abs() < 1e-9,
            "{degrees}: {:?}",
            all[1]
        );
        assert!((number(&all[2]) - 9.0).abs() < 1e-9, "{:?}", all[2]);
        assert_eq!(all[3].measured, Err(Unmeasured::Endless));
    }
    let wide = PEG
        .replace("measure = \"connected\"", "measure = \"bottleneck\"")
        .replace("equals = true", "");
    for slot in [10.1, 10.4] {
        let all = check(&model(&wide, &[("slot", slot.to_string())]));
        let found = number(&all[4]);
        assert!((found - 0.5 * (slot - 10.0)).abs() < 1e-6, "{found}");
    }
    let planar = PEG.replace(
        "measure = \"play\"\nof = \"x\"",
        "measure = \"extreme\"\nof = \"x\"",
    );
    let error = read_from_hosted(planar.as_bytes(), "m.toml", &Host::default()).unwrap_err();
    assert!(error.to_string().contains("no extremes"), "{error}");
}
