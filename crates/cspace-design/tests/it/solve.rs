//! Values of parameters that are known in closed form, and goals of several parameters.

use core::f64::consts::PI;

use cspace::{Configuration, Coordinates, Silent};
use cspace_design::{ContactGoal, Goal, Relation, Solved, Span, Value, check, put_contact, solve};
use cspace_model::Host;
use cspace_model::model::{Coordinate, Setting};

use crate::common::template;

fn span(parameter: &str, lo: f64, hi: f64) -> Span {
    Span {
        parameter: parameter.into(),
        lo,
        hi,
    }
}

fn solved(
    text: &str,
    spans: &[Span],
    requirement: &str,
    relation: Relation,
    value: Value,
) -> Solved {
    let goal = Goal {
        requirement: requirement.into(),
        relation,
        value,
    };
    solve(&template(text), &[], spans, &goal, 65, &Silent)
}

#[track_caller]
fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance, "{found:?} {expected:?}");
    }
}

fn of_one(solved: &Solved) -> Vec<f64> {
    solved.solutions.iter().map(|s| s[0]).collect()
}

const PEG: &str = r#"
[parameter]
slot = 10.1
high = 18
low = -15

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
at = { y = "low" }

[[requirement]]
name = "sideways"
measure = "play"
of = "x"
at = { y = "low" }

[[requirement]]
name = "free"
measure = "connected"
at = { y = "low" }
to = [0, 50, 0]
"#;

/// 5 cos φ + h/2 sin φ = slot/2.
#[test]
fn a_peg_in_a_slot() {
    for tilt in [0.004_f64, 0.011, 0.03] {
        let found = solved(
            PEG,
            &[span("slot", 10.001, 11.0)],
            "tilt",
            Relation::Equal,
            Value::Number(tilt),
        );
        let (sin, cos) = (0.5 * tilt).sin_cos();
        near(&of_one(&found), &[2.0 * (5.0 * cos + 9.0 * sin)], 1e-11);
    }
    let none = solved(
        PEG,
        &[span("slot", 10.001, 11.0)],
        "tilt",
        Relation::Equal,
        Value::Number(0.9),
    );
    assert!(none.solutions.is_empty() && none.none.unwrap().contains("off the value"));
    // A slot that is too narrow has no play.
    let found = solved(
        PEG,
        &[span("slot", 9.0, 11.0)],
        "sideways",
        Relation::Equal,
        Value::Number(0.25),
    );
    near(&of_one(&found), &[10.25], 1e-11);
    let most = solved(
        PEG,
        &[span("slot", 9.0, 11.0)],
        "sideways",
        Relation::AtMost,
        Value::Number(0.25),
    );
    near(&of_one(&most), &[10.1], 0.0);
    near(&[most.ranges[0].0, most.ranges[0].1], &[10.0, 10.25], 1e-7);
    let least = solved(
        PEG,
        &[span("slot", 9.0, 11.0)],
        "sideways",
        Relation::AtLeast,
        Value::Number(0.25),
    );
    near(&of_one(&least), &[10.25], 1e-11);
    let free = solved(
        PEG,
        &[span("slot", 9.0, 11.0)],
        "free",
        Relation::Equal,
        Value::Truth(true),
    );
    near(&[free.ranges[0].0, free.ranges[0].1], &[10.0, 11.0], 1e-7);
}

/// A roller of radius 3 on a disc of 10, 4 off its axis: as high at two angles, as high as it comes at one.
#[test]
fn a_roller_on_an_eccentric() {
    let text = r#"
[parameter]
angle = 1

[[part]]
name = "eccentric"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 10, at = [4, 0] }]

[[part]]
name = "roller"
motion = { type = "prismatic", direction = [0, 1] }
loops = [{ circle = 3, at = [0, 0] }]

[[requirement]]
name = "lift"
measure = "position"
at = { u = "angle", v = 40 }
along = [0, -60]
"#;
    let range = [span("angle", 0.0, 2.0 * PI)];
    let lift = |angle: f64| 4.0 * angle.sin() + (169.0 - (4.0 * angle.cos()).powi(2)).sqrt();
    for angle in [0.3, 1.2, 1.5, 1.56] {
        let found = solved(
            text,
            &range,
            "lift",
            Relation::Equal,
            Value::Number(lift(angle)),
        );
        let near_top = (0.5 * PI - angle).abs().max(1e-4);
        near(&of_one(&found), &[angle, PI - angle], 1e-13 / near_top);
    }
    let top = solved(text, &range, "lift", Relation::Equal, Value::Number(17.0));
    assert!(!top.solutions.is_empty());
    assert!(
        of_one(&top).iter().all(|a| (a - 0.5 * PI).abs() < 1e-6),
        "{top:?}"
    );
    let above = solved(
        text,
        &range,
        "lift",
        Relation::Equal,
        Value::Number(17.0 + 1e-9),
    );
    assert!(above.solutions.is_empty());
}

/// A ball is caged exactly as long as the mouth of the clip is narrower than it.
#[test]
fn a_ball_in_a_clip() {
    let text = r#"
[parameter]
mouth = 9
up = "sqrt(36 - (mouth/2)^2)"

[[part]]
name = "clip"
loops = [[[-12, -12], [12, -12], [12, 12], ["mouth/2", 12], ["mouth/2", "up"], { arc_to = ["-mouth/2", "up"], center = [0, 0], direction = "cw" }, ["-mouth/2", 12], [-12, 12]]]

[[part]]
name = "ball"
loops = [{ circle = 5, at = [0, 0] }]

[[requirement]]
name = "held"
measure = "caged"
"#;
    let held = solved(
        text,
        &[span("mouth", 8.0, 11.5)],
        "held",
        Relation::Equal,
        Value::Truth(true),
    );
    near(&[held.ranges[0].0, held.ranges[0].1], &[8.0, 10.0], 1e-7);
    near(&of_one(&held), &[9.0], 0.0);
}

/// The solution meets the goal when it is measured, and no smaller change does.
#[test]
fn several_parameters_change_as_little_as_they_can() {
    let spans = [span("slot", 9.5, 11.0), span("high", 8.0, 28.0)];
    for tilt in [0.004, 0.02, 0.05] {
        let found = solved(PEG, &spans, "tilt", Relation::Equal, Value::Number(tilt));
        let values = found.solutions[0].clone();
        let measured = |values: &[f64]| {
            let set: Vec<Setting> = (spans.iter().zip(values))
                .map(|(s, v)| Setting::number(&s.parameter, *v))
                .collect();
            let host = Host {
                set: &set,
                ..Host::default()
            };
            let model = template(PEG).model(&host).unwrap();
            match check(&model)[0].measured.as_ref().unwrap().value {
                Value::Number(x) => x,
                Value::Truth(_) => panic!("it is a number"),
            }
        };
        assert!((measured(&values) - tilt).abs() < 1e-12, "{values:?}");
        let change = |v: &[f64]| ((v[0] - 10.1) / 1.5).hypot((v[1] - 18.0) / 20.0);
        // Along the curve on which the tilt is this: 5 cos φ + h/2 sin φ = slot/2.
        let (sin, cos) = (0.5 * tilt).sin_cos();
        for i in 0..=2000 {
            let high = 8.0 + 0.01 * f64::from(i);
            let other = [10.0 * cos + high * sin, high];
            let is_inside = (9.5..=11.0).contains(&other[0]);
            assert!(
                !is_inside || change(&other) > change(&values) - 1e-6,
                "{other:?} {values:?}"
            );
        }
    }
    let met = solved(PEG, &spans, "tilt", Relation::AtMost, Value::Number(0.02));
    near(&met.solutions[0], &[10.1, 18.0], 0.0);
    // A bound holds one of them.
    let held = [span("slot", 10.05, 10.15), span("low", -16.0, -14.0)];
    let none = solved(PEG, &held, "sideways", Relation::Equal, Value::Number(0.2));
    assert!(none.solutions.is_empty(), "{none:?}");
    let found = solved(PEG, &held, "sideways", Relation::Equal, Value::Number(0.14));
    near(&found.solutions[0], &[10.14, -15.0], 1e-11);
}

/// A half circle by its radius has the derivatives of one by its centre.
const HALF: &str = r#"
[parameter]
w = 3
wide = 5

[[part]]
name = "walls"
loops = [[["wide", -20], ["wide", 20], ["wide + 3", 20], ["wide + 3", -20]], [["-wide", -20], ["-wide - 3", -20], ["-wide - 3", 20], ["-wide", 20]]]

[[part]]
name = "round"
loops = [[["-w", 0], ["w", 0], { arc_to = ["-w", 0], radius = "w" }]]

[[requirement]]
name = "play"
measure = "play"
of = "x"
at = { y = -3 }
"#;

#[test]
fn half_circles_by_their_radius() {
    let found = solved(
        HALF,
        &[span("w", 0.5, 4.5)],
        "play",
        Relation::Equal,
        Value::Number(5.1234),
    );
    near(&of_one(&found), &[2.4383], 1e-11);
    // The smallest change relative to the ranges, 4 and 3.4, of wide − w.
    let spans = [span("w", 0.5, 4.5), span("wide", 4.6, 8.0)];
    let found = solved(HALF, &spans, "play", Relation::Equal, Value::Number(5.1234));
    let (off, a, b) = (2.5617 - 2.0, 16.0, 3.4 * 3.4);
    near(
        &found.solutions[0],
        &[3.0 - off * a / (a + b), 5.0 + off * b / (a + b)],
        1e-11,
    );
}

/// A pin above a floor with a ridge, and above a step: kinks, and a stretch over which nothing changes.
#[test]
fn kinks_and_stretches() {
    let text = r#"
[parameter]
p = 0

[[part]]
name = "floor"
loops = [[[-40, -60], [40, -60], [40, -30], [10, -30], [0, -30], [-10, -26], [-20, -30], [-40, -30]]]

[[part]]
name = "pin"
loops = [[["p", 0], ["p + 1", 5], ["p - 1", 5]]]

[[requirement]]
name = "y"
measure = "position"
along = [0, -50, 0]
"#;
    let range = [span("p", -30.0, 30.0)];
    let find = |relation, value| solved(text, &range, "y", relation, Value::Number(value));
    near(&of_one(&find(Relation::Equal, -28.0)), &[-15.0, -5.0], 1e-9);
    near(&of_one(&find(Relation::Equal, -26.0)), &[-10.0], 1e-9);
    assert!(find(Relation::Equal, -25.9).solutions.is_empty());
    let low = find(Relation::AtMost, -30.0);
    let ends: Vec<f64> = low.ranges.iter().flat_map(|r| [r.0, r.1]).collect();
    near(&ends, &[-30.0, -20.0, 0.0, 30.0], 1e-6);
    near(&of_one(&low), &[0.0], 1e-6);
    let level = find(Relation::Equal, -30.0);
    assert_eq!(level.ranges.len(), 2, "{level:?}");
}

/// Where the model's own values are the middle of a symmetric design, derivatives lead nowhere.
#[test]
fn solutions_are_sought_from_other_places_too() {
    let text = r#"
[parameter]
p = 0
q = 0

[[part]]
name = "hump"
loops = [{ circle = 6, at = [0, -36] }]

[[part]]
name = "ball"
loops = [{ circle = 6, at = ["p", "q"] }]

[[requirement]]
name = "y"
measure = "position"
along = [0, -50, 0]
"#;
    // (p, y + q) is 12 from (0, -36).
    let height = |p: f64| (144.0 - p * p).sqrt() - 36.0;
    let spans = [span("p", -10.0, 10.0), span("q", -1e-9, 1e-9)];
    let found = solved(
        text,
        &spans,
        "y",
        Relation::Equal,
        Value::Number(height(5.0)),
    );
    assert!(
        (found.solutions[0][0].abs() - 5.0).abs() < 1e-6,
        "{found:?}"
    );
}

/// A disc of radius a + b beside the wall x = c: it touches at x = c - a - b.
const DISC: &str = r#"
[parameter]
a = 1
b = 2
c = 10

[[part]]
name = "wall"
loops = [[["c", -20], ["c + 5", -20], ["c + 5", 20], ["c", 20]]]

[[part]]
name = "disc"
loops = [{ circle = "a + b", at = [0, 0] }]
"#;

/// The values that put the contact of the disc at a place, as those parameters may change.
fn dragged(x: f64, spans: &[Span]) -> Solved {
    let template = template(DISC);
    let pair = template.model(&Host::default()).unwrap().mechanism.pairs[0];
    let at = |x: f64| Coordinates::Planar(Configuration::new(x, 3.0, 0.5));
    let goal = ContactGoal {
        pair,
        from: at(-10.0),
        along: Coordinates::Planar(Configuration::new(40.0, 0.0, 0.0)),
        of: Coordinate::X,
        value: x,
    };
    put_contact(&template, &[], spans, &goal, &Silent)
}

#[test]
fn a_dragged_contact_takes_the_least_change_relative_to_the_ranges() {
    // x = c - a - b goes from 7 to 7.6. Minimal is the sum of (Δ/w)² over the parameters, with ranges of width w, where
    // Δc - Δa - Δb = 0.6: every Δ is in proportion to w².
    let spans = [
        span("a", 0.5, 1.5),
        span("b", 1.0, 3.0),
        span("c", 9.0, 12.0),
    ];
    let share = 0.6 / (1.0 + 4.0 + 9.0);
    near(
        &dragged(7.6, &spans).solutions[0],
        &[1.0 - share, 2.0 - 4.0 * share, 10.0 + 9.0 * share],
        1e-9,
    );
    // One alone does all of it.
    near(&dragged(7.6, &spans[1..2]).solutions[0], &[1.4], 1e-9);
}

#[test]
fn a_contact_that_cannot_be_dragged_there_says_why() {
    let solved = dragged(9.0, &[span("a", 0.9, 1.1)]);
    assert!(solved.solutions.is_empty());
    assert!(solved.none.unwrap().contains("not enough"));
    assert!(dragged(7.6, &[]).none.is_some());
}

/// The root and the place at which the quantity ends lie within one step of the search.
#[test]
fn a_solution_just_before_the_quantity_ends_is_found() {
    let corners = r#"[-5, "-high/2"], [5, "-high/2"], [5, "high/2"], [-5, "high/2"]"#;
    let wide = r#"["-w/2", "-high/2"], ["w/2", "-high/2"], ["w/2", "high/2"], ["-w/2", "high/2"]"#;
    assert!(PEG.contains(corners) && PEG.contains("slot = 10.1"));
    let text = PEG
        .replace("slot = 10.1", "slot = 10\nw = 9.5")
        .replace(corners, wide);
    let w = [span("w", 9.0, 11.0)];
    let found = solved(&text, &w, "sideways", Relation::Equal, Value::Number(0.001));
    near(&of_one(&found), &[9.999], 1e-9);
}
