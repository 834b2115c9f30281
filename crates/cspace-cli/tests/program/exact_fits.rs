//! Parts that fit exactly, nominal on nominal: they touch, and do not overlap.

use serde_json::Value;

use crate::helpers::{classes, cspace, file, json, json_beside_notes, printed};

/// A slot and a key, a plate and a pin, and two pieces of one cut with a bulge: what is right of each is that of parts with a little play.
const FITS: [(&str, &str, &str, bool); 3] = [
    (
        "slot",
        "[[[-20,-20],[20,-20],[20,0],[5,0],[5,-10],[-5,-10],[-5,0],[-20,0]]]",
        "[[[-5,-10],[5,-10],[5,5],[-5,5]]]",
        true,
    ),
    (
        "pin",
        "[[[-20,-20],[20,-20],[20,20],[-20,20]],{circle=5,at=[0,0]}]",
        "[{circle=5,at=[0,0]}]",
        false,
    ),
    (
        "jigsaw",
        "[[[0,0],[20,0],[20,8,-2],[20,12],[20,20],[0,20]]]",
        "[[[20,0],[40,0],[40,20],[20,20],[20,12,2],[20,8]]]",
        false,
    ),
];

#[test]
fn exact_fits_touch_and_do_not_overlap() {
    for (name, fixed, moving, comes_out) in FITS {
        let text = format!(
            "unit = \"mm\"\n[[part]]\nname = \"plate\"\nloops = {fixed}\n[[part]]\nname = \"part\"\nloops = {moving}\n"
        );
        let (_folder, file) = file(&text);
        let file = file.as_str();
        let computed = printed(&["compute", file]);
        assert!(computed.contains("as drawn       exact-fit"), "{computed}");
        let here = [vec![0.0; 3], vec![0.0, -0.01, 0.0], vec![0.0, 50.0, 0.0]];
        let found = classes(&[file], "x,y,theta", &here);
        assert_eq!(found, ["blocked", "blocked", "free"], "{name}");
        let drawn = &json(&["compute", file])[0]["drawn"];
        assert_eq!(drawn["outcome"], "exact-fit", "{drawn}");
        let near = &json(&["play", file, "--at", "0,0,0"])[0];
        assert_eq!(near["outcome"], "exact-fit", "{near}");
        let touching = near["near"].as_array().unwrap();
        // Of the pin no place is nearer than another.
        assert_eq!(touching.is_empty(), name == "pin", "{near}");
        for near in touching {
            assert!(near["distance"].as_f64().unwrap().abs() < 1e-9, "{near}");
        }
        let play = &json(&["play", file])[0];
        assert_eq!(play["outcome"], "exact-fit", "{play}");
        let gap = play["gap"].as_f64().unwrap();
        assert!(gap > 1e-6 && gap < 1e-3, "{gap}");
        let up = (play["directions"].as_array().unwrap().iter())
            .find(|d| d["direction"] == "+y")
            .unwrap();
        let distance: Option<f64> = up["distance"].as_f64();
        assert!(distance.is_none() == comes_out && distance.is_none_or(|d| d < 10.0 * gap));
        let plan = json(&["plan", file]);
        let expected = if comes_out { "path" } else { "no-path" };
        assert_eq!(plan["verdict"], Value::from(expected), "{plan}");
        assert_eq!(plan["gap"].as_f64(), Some(gap));
        let moved = &json(&["play", file, "--at", "0,0,0", "--by", "0,9,0"])[0];
        let result = if comes_out { "free" } else { "contact" };
        assert_eq!(moved["motion"]["result"], result, "{moved}");
        assert_eq!(moved["gap"].as_f64(), Some(gap), "{moved}");
        let said = printed(&["plan", file]);
        assert!(
            said.starts_with("gap ") && said.contains("fit exactly"),
            "{said}"
        );
        let clearance = printed(&["clearance", file]);
        assert!(
            clearance.starts_with("2 parts, 1 pair: 1 touches\ntouches  "),
            "{clearance}"
        );
        assert_eq!(json(&["clearance", file])["outcome"], "touches");
    }
}

/// With a hundredth too little they overlap, and with a hundredth of play they are free.
#[test]
fn what_is_wider_overlaps_and_what_is_narrower_is_free() {
    for (half, result, code) in [(5.01, "blocked", 1), (4.99, "contact", 0)] {
        let text = format!(
            "[[part]]\nname = \"plate\"\nloops = {}\n[[part]]\nname = \"key\"\nloops = [[[-{half},-10],[{half},-10],[{half},5],[-{half},5]]]\n",
            FITS[0].1
        );
        let (_folder, file) = file(&text);
        let play = &json(&["play", &file])[0];
        assert_eq!(play["outcome"], result, "{play}");
        cspace(&["play", &file]).assert().code(code);
        let drawn = &json(&["compute", &file])[0]["drawn"];
        assert_eq!(drawn["outcome"], result, "{drawn}");
        assert!(play.get("gap").is_none());
    }
}

/// H7 and g6 are drawn nominal on nominal: there is no play, and the way out is open.
#[test]
fn requirements_hold_at_an_exact_fit() {
    let text = r#"
unit = "mm"
[parameter]
bore = { value = 20, tol = "H7" }
tail = { value = 20, tol = "g6" }
[[part]]
name = "bed"
loops = [[{ mirror = "y", path = [[0, -20], [30, -20], [30, 0], ["bore/2", 0], ["bore/2", -8]] }]]
[[part]]
name = "slide"
loops = [[["-tail/2", -8], ["tail/2", -8], ["tail/2", 10], ["-tail/2", 10]]]
[[requirement]]
name = "comes out"
measure = "connected"
to = [0, 40, 0]
equals = true
[[requirement]]
name = "free"
measure = "caged"
equals = false
[[requirement]]
name = "play x"
measure = "play"
of = "x"
limits = [0, 0.05]
[[requirement]]
name = "tilt"
measure = "play"
of = "theta"
limits = [0, 0.05]
[[requirement]]
name = "gap"
measure = "clearance"
limits = [0, 1]
"#;
    let (_folder, file) = file(text);
    let file = file.as_str();
    let checked = |tail: &str| json_beside_notes(&["check", file, "--set", tail]);
    let fits = checked("tail=20");
    for row in fits.as_array().unwrap() {
        assert_eq!(row["met"], true, "{row}");
        assert_eq!(row["outcome"], "met", "{row}");
        assert!(row["gap"].as_f64().unwrap() < 1e-4, "{row}");
        if row["limits"].is_array() {
            assert_eq!(row["value"], 0.0, "{row}");
        }
    }
    // It stands on the bottom, in contact, and has its play.
    let plays = checked("tail=19.99");
    assert!(
        (plays[2]["value"].as_f64().unwrap() - 0.01).abs() < 1e-9,
        "{plays}"
    );
    for row in plays.as_array().unwrap() {
        assert_eq!((&row["met"], row.get("gap")), (&true.into(), None), "{row}");
    }
    // It overlaps.
    let output = cspace(&["check", file, "--set", "tail=20.01"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
}

/// A gap is no part of what is measured: a slider that is flush with its floor goes 20 and touches both ends, as one a little higher does.
#[test]
fn values_at_an_exact_fit_are_without_the_gap() {
    let text = r#"
[parameter]
floor = 0
[[part]]
name = "rail"
motion = { type = "fixed" }
loops = [[[-20, -5], [20, -5], [20, 10], [15, 10], [15, "floor"], [-15, "floor"], [-15, 10], [-20, 10]]]
[[part]]
name = "slider"
motion = { type = "prismatic", direction = [1, 0] }
loops = [[[-5, 0], [5, 0], [5, 5], [-5, 5]]]
[[requirement]]
name = "way"
measure = "play"
of = "v"
limits = [0, 20]
[[requirement]]
name = "end"
measure = "extreme"
of = "v"
limits = [9, 10]
"#;
    let (_folder, file) = file(text);
    let file = file.as_str();
    for floor in ["floor=0", "floor=-0.001"] {
        let rows = json_beside_notes(&["check", file, "--set", floor]);
        for (row, value) in rows.as_array().unwrap().iter().zip([20.0, 10.0]) {
            assert_eq!(row["met"], true, "{floor}: {row}");
            assert!(
                (row["value"].as_f64().unwrap() - value).abs() < 1e-9,
                "{row}"
            );
            assert_eq!(row.get("gap").is_some(), floor == "floor=0", "{row}");
        }
    }
}

/// A slot that is drawn as wide as its key, and made up to 0.021 wider: the play goes from 0 to 0.021, and the way as drawn is none that
/// overlaps.
#[test]
fn tolerances_begin_at_an_exact_fit() {
    let text = r#"
[parameter]
wider = { value = 0, plus = 0.021, minus = 0 }
[[part]]
name = "hub"
loops = [[[-20, -20], [20, -20], [20, 20], ["5 + wider/2", 20], ["5 + wider/2", 0], ["-5 - wider/2", 0], ["-5 - wider/2", 20], [-20, 20]]]
[[part]]
name = "key"
loops = [[[-5, 0], [5, 0], [5, 20], [-5, 20]]]
[[requirement]]
name = "play"
measure = "play"
of = "x"
at = { y = 1 }
limits = [0, 0.03]
"#;
    let (_folder, file) = file(text);
    let found = json_beside_notes(&["tolerances", &file]);
    let of = &found[0];
    assert_eq!(of["nominal"], 0.0, "{of}");
    for (end, value) in [("lo", 0.0), ("hi", 0.021)] {
        assert!(
            (of["exact"][end]["value"].as_f64().unwrap() - value).abs() < 1e-9,
            "{of}"
        );
    }
    assert!(of["margin"].as_f64().unwrap() > 1.0, "{of}");
}
