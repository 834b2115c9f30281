//! Measures over the ranges of parts on axes, in closed form.

use core::f64::consts::{FRAC_PI_2, PI};

use cspace::{Coordinates, Silent};
use cspace_design::{
    Checked, Goal, Relation, Span, ToleranceOptions, Unmeasured, Value, check, sensitivities,
    solve, tolerances,
};
use cspace_model::{Host, read_from_hosted};

use crate::common::{model, number, template};

#[track_caller]
fn truth(checked: &Checked) -> bool {
    match checked.measured.as_ref().unwrap().value {
        Value::Truth(b) => b,
        Value::Number(_) => panic!("{checked:?}"),
    }
}

/// A disc of radius 1 whose middle turns at 2 about the origin, from the y axis, and a disc of radius 0.5 on the x axis.
const ARM: &str = r#"
[parameter]
far = 5
swing = "30deg"

[[part]]
name = "arm"
motion = { type = "revolute", center = [0, 0], range = ["-swing", "swing"] }
loops = [{ circle = 1, at = [0, 2] }]

[[part]]
name = "post"
motion = { type = "fixed" }
loops = [{ circle = 0.5, at = ["far", 0] }]

[[requirement]]
name = "gap"
measure = "clearance"
over = "ranges"
limits = [1, 10]

[[requirement]]
name = "opens"
measure = "reaches"
of = "u"
equals = true
"#;

#[test]
fn the_smallest_gap_and_what_it_depends_on() {
    let text = ARM.replace(r#", range = ["-swing", "swing"]"#, "");
    let found = check(&model(&text, &[]));
    assert!((number(&found[0]) - 1.5).abs() < 1e-11, "{found:?}");
    assert_eq!(found[0].is_met(), Some(true));
    assert!((found[0].margin().unwrap() - 0.5).abs() < 1e-11);
    let stop = &found[0].measured.as_ref().unwrap().stops[0];
    let Coordinates::Axes { u, .. } = stop.at else {
        panic!("{stop:?}");
    };
    assert!((u + FRAC_PI_2).abs() < 1e-5, "{u}");
    assert!(truth(&found[1]));

    // Within 30 degrees it comes as near as at the end of them.
    let turn = PI / 6.0;
    let distance = |far: f64, turn: f64| (far * far + 4.0 - 4.0 * far * turn.sin()).sqrt();
    let far = 5.0;
    let template = template(ARM);
    let model = template.model(&Host::default()).unwrap();
    let found = sensitivities(&template, &Host::default(), &model, &Silent).unwrap();
    let (gap, by) = &found[0];
    let d = distance(far, turn);
    assert!((number(gap) - (d - 1.5)).abs() < 1e-11, "{gap:?}");
    let of = |name: &str| by.iter().find(|s| s.parameter == name).unwrap();
    let [_, by_far] = of("far").derivative.clone().unwrap();
    let [_, by_turn] = of("swing").derivative.clone().unwrap();
    assert!((by_far - (far - 2.0 * turn.sin()) / d).abs() < 1e-6);
    assert!((by_turn + 2.0 * far * turn.cos() / d).abs() < 1e-6);
    assert!(found[1].1.is_empty(), "yes and no have no derivatives");
}

#[test]
fn a_value_that_is_solved_for() {
    let template = template(ARM);
    let spans = |lo, hi| {
        [Span {
            parameter: "far".into(),
            lo,
            hi,
        }]
    };
    let goal = |requirement: &str, value| Goal {
        requirement: requirement.into(),
        relation: Relation::Equal,
        value,
    };
    // √(far² + 4 − 2 far) − 1.5 = 1.
    let wanted = goal("gap", Value::Number(1.0));
    let found = solve(&template, &[], &spans(2.0, 9.0), &wanted, 9, &Silent);
    let far = 1.0 + (1.0 + 2.25_f64).sqrt();
    assert!((found.solutions[0][0] - far).abs() < 1e-9, "{found:?}");
    // Where the arm turns half around it must pass the post.
    let text = ARM.replace("\"30deg\"", "\"180deg\"");
    let wanted = goal("opens", Value::Truth(true));
    let template = crate::common::template(&text);
    let found = solve(&template, &[], &spans(1.9, 6.0), &wanted, 9, &Silent);
    assert!((found.ranges[0].0 - 3.5).abs() < 1e-9, "{found:?}");
}

#[test]
fn what_stops_a_part() {
    let set = |far: &str, turn: &str| {
        let set = [("far", far.to_owned()), ("swing", turn.to_owned())];
        check(&model(ARM, &set))
    };
    let found = set("2", "180deg");
    assert!(!truth(&found[1]));
    assert_eq!(found[1].is_met(), Some(false));
    assert_eq!(found[1].touching.len(), 1, "{found:?}");
    // The middles are 1.5 apart.
    let at = FRAC_PI_2 - 2.0 * (0.75_f64 / 2.0).asin();
    let stop = &found[1].measured.as_ref().unwrap().stops[0];
    let Coordinates::Axes { u, .. } = stop.at else {
        panic!("{stop:?}");
    };
    assert!((u + at).abs() < 1e-9, "{u} {at}");
    // Parts that touch have no gap.
    assert_eq!(number(&found[0]), 0.0);
    assert_eq!(found[0].is_met(), Some(false));
    // Short of the post it reaches both ends.
    assert!(truth(&set("2", "45deg")[1]));
    // Where it is drawn in the post nothing is measured.
    let text = ARM.replace("far\", 0]", "0.5\", 2]");
    let found = check(&model(&text, &[]));
    assert_eq!(found[0].measured, Err(Unmeasured::Blocked));
    assert_eq!(found[0].is_met(), Some(false));
}

#[test]
fn tolerances_of_a_smallest_gap() {
    let text = ARM.replace("far = 5", "far = { value = 5, tol = 0.1 }");
    let template = template(&text);
    let model = template.model(&Host::default()).unwrap();
    let options = ToleranceOptions {
        requirements: vec!["gap".into()],
        ..ToleranceOptions::default()
    };
    let found = tolerances(&template, &[], &model, &options, &Silent).unwrap();
    let [lo, hi] = found[0].exact.clone().unwrap();
    let gap = |far: f64| (far * far + 4.0 - 2.0 * far).sqrt() - 1.5;
    assert!((lo.value.unwrap() - gap(4.9)).abs() < 1e-9);
    assert!((hi.value.unwrap() - gap(5.1)).abs() < 1e-9);
}

/// Two discs of radius 0.2 at 2 from the origin, 0.5 rad to both sides of the x axis, and one on an arm about (e, 0) between them.
const FORK: &str = r#"
[parameter]
e = 0.1
arm = 2

[[part]]
name = "fork"
motion = { type = "revolute", center = [0, 0] }
loops = [
  { circle = 0.2, at = ["2*cos(0.5)", "2*sin(0.5)"] },
  { circle = 0.2, at = ["2*cos(0.5)", "-2*sin(0.5)"] },
]

[[part]]
name = "hand"
motion = { type = "revolute", center = ["e", 0] }
loops = [{ circle = 0.2, at = ["e + arm", 0] }]

[[requirement]]
name = "ratio"
measure = "follows"
of = "v"
limits = [1, 1]

[[requirement]]
name = "together"
measure = "follows"
of = "u"
equals = true

[[requirement]]
name = "backlash"
measure = "backlash"
of = "v"
limits = [0.5, 0.7]

[[requirement]]
name = "backlash of the fork"
measure = "backlash"
of = "u"
"#;

/// The play of the hand in the fork that is turned by u.
fn play_of_hand(e: f64, u: f64) -> f64 {
    let side = |angle: f64| {
        let (y, x) = (u + angle).sin_cos();
        let (x, y) = (2.0 * x - e, 2.0 * y);
        let d = x.hypot(y);
        (y.atan2(x), ((4.0 + d * d - 0.16) / (4.0 * d)).acos())
    };
    let ((p, a), (q, b)) = (side(0.5), side(-0.5));
    (p - q).rem_euclid(2.0 * PI) - a - b
}

#[test]
fn parts_that_turn_together() {
    let found = check(&model(FORK, &[]));
    assert_eq!(number(&found[0]), 1.0);
    assert_eq!(found[0].is_met(), Some(true));
    assert!(truth(&found[1]));
    let (near, far) = (play_of_hand(0.1, 0.0), play_of_hand(0.1, PI));
    let (least, most) = (near.min(far), near.max(far));
    let backlash = found[2].measured.as_ref().unwrap();
    assert!((number(&found[2]) - most).abs() < 2e-9, "{found:?} {most}");
    let range = backlash.range.unwrap();
    assert!((range.0 - least).abs() < 2e-9 && (range.1 - most).abs() < 2e-9);
    assert_eq!(found[2].touching.len(), 2, "{found:?}");
    // Limits hold for the least and for the largest.
    let margin = (least - 0.5).min(0.7 - most);
    assert!((found[2].margin().unwrap() - margin).abs() < 2e-9);
    let lower = FORK.replace("[0.5, 0.7]", &format!("[{}, 9]", 0.5 * (least + most)));
    assert_eq!(check(&model(&lower, &[]))[2].is_met(), Some(false));
    // About one axis both have the same play.
    let found = check(&model(FORK, &[("e", "0".to_owned())]));
    assert!((number(&found[2]) - number(&found[3])).abs() < 1e-9);
}

#[test]
fn parts_that_do_not_turn_together() {
    // The hand passes the pins.
    let found = check(&model(FORK, &[("arm", "3".to_owned())]));
    assert_eq!(found[0].measured, Err(Unmeasured::TurnsAlone));
    assert_eq!(found[0].is_met(), Some(false));
    assert!(!truth(&found[1]));
    assert_eq!(found[2].measured, Err(Unmeasured::TurnsAlone));
    // About one axis it does where it is 0.4 farther out.
    let text = FORK.replace("e = 0.1", "e = 0");
    let goal = Goal {
        requirement: "together".into(),
        relation: Relation::Equal,
        value: Value::Truth(true),
    };
    let spans = [Span {
        parameter: "arm".into(),
        lo: 1.0,
        hi: 3.0,
    }];
    let found = solve(&template(&text), &[], &spans, &goal, 9, &Silent);
    let (lo, hi) = found.ranges[0];
    assert!(
        (lo - 1.6).abs() < 1e-9 && (hi - 2.4).abs() < 1e-9,
        "{found:?}"
    );
}

/// The pair must be on axes, both parts must turn where that is asked for, and words are known ones.
#[test]
fn what_is_wrong_is_told() {
    let read = |text: &str| read_from_hosted(text.as_bytes(), "m.toml", &Host::default());
    let follows = ARM.replace("\"reaches\"", "\"follows\"");
    let planar = ARM.replace("motion = { type = \"fixed\" }", "");
    for (text, message, help) in [
        (
            ARM.replace("\"ranges\"", "\"rnges\""),
            "unknown extent \"rnges\"",
            "did you mean `ranges`?",
        ),
        (
            ARM.replace("measure = \"reaches\"\nof = \"u\"", "measure = \"reaches\""),
            "`of` is missing",
            "of = \"u\"",
        ),
        (
            ARM.replace("of = \"u\"", "of = \"v\""),
            "does not move",
            "other part",
        ),
        (follows.clone(), "one does not", "revolute"),
        (
            FORK.replace("equals = true", "equals = true\nlimits = [1, 1]"),
            "beside `limits`",
            "limits of the ratio",
        ),
        (
            FORK.replace("limits = [0.5, 0.7]", "equals = true"),
            "`equals` is given of the measure backlash",
            "limits",
        ),
        (planar, "no ranges", "motion on an axis"),
    ] {
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

/// Gears of 12 and 10 teeth, whose tips are at 28 and 24 from their axes, at a distance of 44 and some more.
fn gears() -> String {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../models/gears_on_shafts.toml"
    );
    let cspace_model::Document::Model(model) =
        cspace_model::read(std::path::Path::new(file)).unwrap()
    else {
        unreachable!()
    };
    let mut text = "[parameter]\nmore = 0\n".to_owned();
    for (part, (name, by)) in model
        .mechanism
        .parts
        .iter()
        .zip([("gear", ""), ("pinion", " + more")])
    {
        let center = if by.is_empty() { "0" } else { "\"44 + more\"" };
        text += &format!(
            "[[part]]\nname = \"{name}\"\nmotion = {{ type = \"revolute\", center = [{center}, 0] }}\nloops = ["
        );
        for outline in part.part.loops() {
            text += "[";
            for v in outline.vertices() {
                text += &format!("[\"{}{by}\", {}, {}],", v.x, v.y, v.bulge);
            }
            text += "],";
        }
        text += "]\n";
    }
    text + r#"
[[requirement]]
name = "ratio"
measure = "follows"
of = "v"
limits = ["-12/10", "-12/10"]

[[requirement]]
name = "together"
measure = "follows"
of = "v"
equals = true

[[requirement]]
name = "backlash"
measure = "backlash"
of = "v"
"#
}

/// Gears that are pulled apart have more backlash, by twice the tangent of the pressure angle, until one turns without the other: exactly
/// where the gear's tips pass those of the two teeth of the pinion that it is between.
#[test]
fn gears_that_are_pulled_apart() {
    let text = gears();
    let found = check(&model(&text, &[]));
    assert_eq!(number(&found[0]), -1.2);
    assert_eq!(found[0].is_met(), Some(true));
    let (near, far) = (number(&found[2]), {
        let found = check(&model(&text, &[("more", "0.1".to_owned())]));
        number(&found[2])
    });
    let pressure = 20_f64.to_radians();
    let more = 0.1 * 2.0 * pressure.tan() / 20.0;
    assert!(
        (far - near - more).abs() < 0.3 * more,
        "{near} {far} {more}"
    );
    let found = check(&model(&text, &[("more", "9".to_owned())]));
    assert_eq!(found[0].measured, Err(Unmeasured::TurnsAlone));
    assert!(!truth(&found[1]));
    let goal = Goal {
        requirement: "together".into(),
        relation: Relation::Equal,
        value: Value::Truth(true),
    };
    let spans = [Span {
        parameter: "more".into(),
        lo: 5.0,
        hi: 8.0,
    }];
    let found = solve(&template(&text), &[], &spans, &goal, 3, &Silent);
    // A corner of the tip of a tooth of the pinion, from its axis towards the gear.
    let (x, y) = (23.047_493_590_355_59_f64, 6.694_254_193_150_862_f64);
    let apart = x + (28.0 * 28.0 - y * y).sqrt() - 44.0;
    assert!(
        (found.ranges[0].1 - apart).abs() < 1e-9,
        "{found:?} {apart}"
    );
}
