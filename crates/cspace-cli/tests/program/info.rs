//! Masses, forces and drives in the answer of `cspace info`.

use serde_json::{Value, json};

use crate::helpers::{cspace, fails, json, json_beside_notes, model, printed};

/// A lever on a pivot, a slide with limits and a ball, in mm.
pub(crate) const MODEL: &str = r#"
name = "lever and ball"
unit = "mm"
gravity = [0, -9810]
friction = 0.1
restitution = 0.25

[[part]]
name = "frame"
loops = [[[-10, -10], [30, -10], [30, -5], [-10, -5]]]
motion = { type = "fixed" }

[[part]]
name = "lever"
loops = [[[0, 0], [6, 0], [6, 1], [0, 1]]]
motion = { type = "revolute", center = [0, 0.5] }
density = 0.5
start = "-30deg"

[[part]]
name = "slide"
loops = [[[10, 0], [14, 0], [14, 2], [10, 2]]]
motion = { type = "prismatic", direction = [1, 0], range = [-1, 3] }
center_of_mass = [12, 1.5]

[[part]]
name = "ball"
loops = [{ circle = 2, at = [0, 9] }]
mass = 0.5
start = [1, 2, "90deg"]
rate = [3, -4, "180deg"]

[[pair]]
fixed = "lever"
moving = "ball"
friction = 0.5

[[pair]]
fixed = "frame"
moving = "ball"

[[drive]]
part = "lever"
rate = "360deg"

[[drive]]
part = "slide"
table = [[0, 0], [0.5, 2], [1.5, -1]]

[[load]]
part = "ball"
force = [0, -3]

[[load]]
part = "ball"
force = [1, 0]
at = [0, 11]

[[load]]
part = "lever"
torque = 0.5

[[spring]]
parts = ["ball", "lever"]
at = [[0, 9], [3, 1]]
stiffness = 2.5
length = 8
damping = 0.1

[[spring]]
parts = ["lever"]
type = "torsion"
stiffness = 5
angle = "-90deg"
"#;

fn in_file(text: &str) -> (tempfile::TempDir, String) {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("model.toml");
    std::fs::write(&file, text).unwrap();
    let name = file.to_str().unwrap().to_owned();
    (dir, name)
}

#[track_caller]
fn near(value: &Value, expected: f64) {
    let x = value.as_f64().unwrap();
    assert!(
        (x - expected).abs() <= 1e-12 * expected.abs(),
        "{x}, {expected}"
    );
}

#[test]
fn masses_and_forces_are_data() {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};
    let (_dir, file) = in_file(MODEL);
    let info = json(&["info", &file]);
    assert_eq!(info["gravity"], json!([0.0, -9810.0]));
    assert_eq!(
        (&info["friction"], &info["restitution"]),
        (&json!(0.1), &json!(0.25))
    );
    let part = |i: usize| &info["parts"][i];
    for key in ["mass", "center_of_mass", "inertia", "start", "rate"] {
        assert_eq!(part(0).get(key), None, "{key}");
    }
    near(&part(1)["mass"], 3.0);
    near(&part(1)["inertia"], 3.0 * 37.0 / 12.0);
    near(&part(1)["center_of_mass"][0], 3.0);
    near(&part(1)["start"], -FRAC_PI_6);
    assert_eq!(part(2)["center_of_mass"], json!([12.0, 1.5]));
    assert_eq!(part(2).get("mass"), None);
    near(&part(3)["mass"], 0.5);
    near(&part(3)["inertia"], 1.0);
    near(&part(3)["start"][2], FRAC_PI_2);
    near(&part(3)["rate"][2], PI);
    assert_eq!(info["pairs"][0]["friction"], json!(0.5));
    assert_eq!(info["pairs"][0].get("restitution"), None);
    assert_eq!(info["pairs"][1].get("friction"), None);
    assert_eq!(info["drives"][0]["part"], "lever");
    near(&info["drives"][0]["rate"], 2.0 * PI);
    assert_eq!(
        info["drives"][1]["table"],
        json!([[0.0, 0.0], [0.5, 2.0], [1.5, -1.0]])
    );
    assert_eq!(
        info["loads"],
        json!([
            {"part": "ball", "force": [0.0, -3.0]},
            {"part": "ball", "force": [1.0, 0.0], "at": [0.0, 11.0]},
            {"part": "lever", "torque": 0.5},
        ])
    );
    assert_eq!(
        info["springs"],
        json!([
            {"type": "linear", "parts": ["ball", "lever"], "at": [[0.0, 9.0], [3.0, 1.0]],
             "stiffness": 2.5, "length": 8.0, "damping": 0.1},
            {"type": "torsion", "parts": ["lever"], "stiffness": 5.0, "angle": -FRAC_PI_2, "damping": 0.0},
        ])
    );
}

#[test]
fn masses_and_forces_are_text() {
    let (_dir, file) = in_file(MODEL);
    let text = printed(&["info", &file]);
    for line in [
        "    mass       3 kg",
        "    centre     of mass at (3, 0.5)",
        "    inertia    9.25 kg·mm² about it",
        "    start      at -0.523599 rad (-30.0000 deg)",
        "    centre     of mass at (12, 1.5)",
        "    start      at (1, 2), 1.570796 rad (90.0000 deg)",
        "    rate       (3, -4) mm/s, 3.141593 rad/s (180 deg/s)",
        "  lever (fixed), ball (moving): symmetric, 10 features, friction 0.5",
        "everywhere",
        "  gravity (0, -9810) mm/s²",
        "  friction 0.1",
        "  restitution 0.25",
        "  lever: 6.283185 rad/s (360 deg/s)",
        "  slide: a table of 3 points, 0 s to 1.5 s",
        "  ball: force (0, -3) mN at its centre of mass",
        "  ball: force (1, 0) mN at (0, 11)",
        "  lever: torque 500 µN·mm",
        "  ball at (0, 9) and lever at (3, 1): at rest at 8 mm, stiffness 2.5 N/m, damping 100 mN·s/m",
        "  lever and the ground: torsion, at rest at -1.570796 rad (-90.0000 deg), stiffness 5 mN·mm/rad",
    ] {
        assert!(text.lines().any(|l| l == line), "no {line:?} in:\n{text}");
    }
}

#[test]
fn models_without_forces_show_none() {
    let file = model("ball_in_c");
    let text = printed(&["info", &file]);
    for word in [
        "mass",
        "everywhere",
        "drives",
        "loads",
        "springs",
        "start",
        "rate ",
    ] {
        assert!(!text.contains(word), "{word} in:\n{text}");
    }
    let info = json(&["info", &file]);
    let keys: Vec<&String> = info.as_object().unwrap().keys().collect();
    let frame = ["answer", "outcome", "units", "version"];
    let keys: Vec<&String> = (keys.into_iter())
        .filter(|k| !frame.contains(&k.as_str()))
        .collect();
    assert_eq!(keys, ["joints", "name", "pairs", "parts", "unit"]);
    assert_eq!(info["units"]["length"], info["unit"]);
    assert_eq!(info["outcome"], "done");
}

/// Masses and drives do not change what is computed.
#[test]
fn spaces_do_not_depend_on_it() {
    let (_dir, file) = in_file(MODEL);
    let bare: String = MODEL
        .lines()
        .filter(|l| {
            ![
                "mass",
                "density",
                "start",
                "rate =",
                "gravity",
                "friction",
                "restitution",
                "center_of",
            ]
            .iter()
            .any(|k| l.starts_with(k))
        })
        .take_while(|l| *l != "[[drive]]")
        .map(|l| format!("{l}\n"))
        .collect();
    let (_other, other) = in_file(&bare);
    let computed = |file: &str| {
        let mut all = json_beside_notes(&["compute", file]);
        for pair in all.as_array_mut().unwrap() {
            pair.as_object_mut().unwrap().remove("seconds");
        }
        all
    };
    assert_eq!(computed(&file), computed(&other));
}

#[test]
fn what_is_wrong_is_told_with_its_line() {
    let (_dir, file) = in_file(&MODEL.replace("density = 0.5", "density = 0"));
    fails(
        cspace(&["info", &file]),
        2,
        &[
            "model.toml:17:11: part 1 \"lever\": `density`: 0.0 is not positive",
            "help: give a number above 0",
        ],
    );
}
