//! `cspace plan`: paths by the formulas of the parts, what is no path, and paths that are judged.

use serde_json::Value;

use crate::helpers::{cspace, fails, framed, json, model, printed, unframed};

/// Answer of a run, whose outcome and verdict are this word; with its exit code.
#[track_caller]
fn answered(args: &[&str], outcome: &str) -> Value {
    let framed = framed(args);
    assert_eq!(framed["outcome"], outcome, "{args:?}");
    let code = i32::from(!matches!(outcome, "path" | "escapes"));
    cspace(args).assert().code(code);
    let answer = unframed("plan", framed);
    assert_eq!(answer["outcome"], outcome, "{args:?}");
    assert_eq!(answer["verdict"], outcome, "{args:?}");
    answer
}

fn numbers(at: &Value) -> Vec<f64> {
    ["x", "y", "theta", "u", "v"]
        .iter()
        .filter_map(|k| at.get(k)?.as_f64())
        .collect()
}

#[test]
fn a_peg_goes_into_its_hole_and_its_path_passes_the_check() {
    let peg = model("peg_hole");
    let folder = tempfile::tempdir().unwrap();
    let way = folder.path().join("way.csv");
    let way = way.to_str().unwrap();
    let ends = ["--from", "40,30,90deg", "--to", "0,2,0"];
    let told = printed(&[&["plan", &peg, "-o", way], &ends[..]].concat());
    assert!(told.starts_with("path: "), "{told}");
    let answer = json(&[&["plan", &peg], &ends[..]].concat());
    let path: Vec<Vec<f64>> = answer["path"]
        .as_array()
        .unwrap()
        .iter()
        .map(numbers)
        .collect();
    assert_eq!(path[0][..2], [40.0, 30.0]);
    let last = path.last().unwrap();
    let turns = last[2] / core::f64::consts::TAU;
    assert_eq!(last[..2], [0.0, 2.0]);
    assert!((turns - turns.round()).abs() < 1e-12);
    // The hole is 0.1 wider than the peg: the most there can be is half of that, and half of this is asked for.
    let clearance = answer["clearance"].as_f64().unwrap();
    assert!((0.025..=0.05).contains(&clearance), "{clearance}");
    // The file holds the same, and passes.
    let rows = std::fs::read_to_string(way).unwrap();
    assert_eq!(rows.lines().count(), path.len() + 1);
    let checked = answered(&["plan", &peg, "--verify", way], "path");
    assert!((checked["clearance"].as_f64().unwrap() - clearance).abs() < 1e-5 * clearance);
    let widest = json(&[&["plan", &peg, "--widest"], &ends[..]].concat());
    assert!((widest["bottleneck"]["most"].as_f64().unwrap() - 0.05).abs() < 1e-7);
    let more = [&["plan", &peg, "--clearance", "0.051"], &ends[..]].concat();
    answered(&more, "no-path");
}

#[test]
fn a_path_through_material_is_no_path() {
    let peg = model("peg_hole");
    let file = tempfile::Builder::new().suffix(".csv").tempfile().unwrap();
    let path = file.path().to_str().unwrap();
    std::fs::write(path, "x,y,theta\n0,60,0\n20,10,0\n0,5,0\n").unwrap();
    let answer = answered(&["plan", &peg, "--verify", path], "blocked");
    assert_eq!(answer["contact"]["leg"], 0);
    // The peg is 16 below its origin, and comes down by 50 on the first leg.
    let fraction = answer["contact"]["fraction"].as_f64().unwrap();
    assert!((fraction - 0.84).abs() < 1e-9, "{fraction}");
    let told = printed(&["plan", &peg, "--verify", path]);
    assert!(
        told.starts_with("blocked: the given path meets a contact on leg 1, after 84.0"),
        "{told}"
    );
    std::fs::write(path, "x,y\n0,60\n").unwrap();
    fails(cspace(&["plan", &peg, "--verify", path]), 2, &["theta"]);
    std::fs::write(path, "x,y,theta\n").unwrap();
    fails(
        cspace(&["plan", &peg, "--verify", path]),
        2,
        &["no configuration"],
    );
}

#[test]
fn what_is_caged_has_no_path() {
    let ball = model("ball_in_c");
    let asked = ["plan", &ball, "--from", "0,0,0", "--to", "60,0,0"];
    let answer = answered(&asked, "no-path");
    assert_eq!(answer["regions"]["from"], 1);
    assert_eq!(answer["regions"]["to"], 0);
    assert_eq!(answer["enclosed"]["region"], 1);
    assert!(
        !answer["enclosed"]["touching"]
            .as_array()
            .unwrap()
            .is_empty()
    );
}

#[test]
fn blocked_ends_are_told_with_the_way_out() {
    let peg = model("peg_hole");
    let from = ["plan", &peg, "--from=0,-10,0", "--to", "0,60,0"];
    let from = answered(&from, "from-blocked");
    assert!((from["blocked"]["depth"].as_f64().unwrap() - 10.0).abs() < 1e-6);
    let to = ["plan", &peg, "--from", "0,60,0", "--to=0,-10,0"];
    answered(&to, "to-blocked");
}

#[test]
fn gears_turn_together_and_not_past_each_other() {
    let gears = model("gears_on_shafts");
    // 12 teeth on 10: half a turn back is 0.6 of a turn on.
    let half = ["plan", &gears, "--from", "0,0", "--to", "180deg,-216deg"];
    let answer = answered(&half, "path");
    for at in answer["path"].as_array().unwrap() {
        let c = numbers(at);
        assert!((c[1] + 1.2 * c[0]).abs() < 0.02, "{c:?}");
    }
    let next = ["plan", &gears, "--from", "0,0", "--to", "75deg,18deg"];
    answered(&next, "no-path");
}

#[test]
fn pictures_of_ways_and_limits_of_legs() {
    let peg = model("peg_hole");
    let folder = tempfile::tempdir().unwrap();
    let ends = ["--from", "40,30,90deg", "--to", "0,2,0"];
    let plain = printed(&[&["plan", &peg], &ends[..]].concat());
    for name in ["way.svg", "way.png", "way.pdf"] {
        let file = folder.path().join(name);
        let file = file.to_str().unwrap();
        let told = printed(&[&["plan", &peg, "-o", file], &ends[..]].concat());
        assert_eq!(told, plain);
        assert!(std::fs::metadata(file).unwrap().len() > 1000);
    }
    let steps = ["--turn", "5deg", "--travel", "4"];
    let answer = json(&[&["plan", &peg], &ends[..], &steps[..]].concat());
    let path: Vec<Vec<f64>> = answer["path"]
        .as_array()
        .unwrap()
        .iter()
        .map(numbers)
        .collect();
    for leg in path.windows(2) {
        assert!((leg[1][0] - leg[0][0]).abs() <= 4.0 + 1e-9);
        assert!((leg[1][1] - leg[0][1]).abs() <= 4.0 + 1e-9);
        assert!((leg[1][2] - leg[0][2]).abs() <= 5f64.to_radians() + 1e-9);
    }
}

#[test]
fn what_is_no_question_is_refused() {
    let peg = model("peg_hole");
    for (from, word) in [
        ("0,60", "3 numbers"),
        ("0,60,nan", "finite"),
        ("0,x,0", "\"x\""),
    ] {
        fails(
            cspace(&["plan", &peg, "--from", from, "--to", "0,2,0"]),
            2,
            &["--from", word],
        );
    }
    let ends = ["--from", "0,60,0", "--to", "0,2,0"];
    for (option, value) in [
        ("--clearance", "-1"),
        ("--clearance", "nan"),
        ("--turn", "0"),
        ("--travel", "-2"),
        ("--travel", "1e-12"),
    ] {
        let given = format!("{option}={value}");
        let args = [&["plan", &peg, &given], &ends[..]].concat();
        fails(cspace(&args), 2, &[option]);
    }
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for name in ["way.foo", "way.txt", "way"] {
        let other = at(name);
        let args = [&["plan", &peg, "-o", &other], &ends[..]].concat();
        fails(cspace(&args), 2, &[name, ".csv, .json, .svg, .png, .pdf"]);
        assert!(!std::path::Path::new(&other).exists());
    }
    let far = at("far.csv");
    std::fs::write(&far, "x,y,theta\n1e300,60,0\n0,60,0\n").unwrap();
    fails(
        cspace(&["plan", &peg, "--verify", &far]),
        2,
        &["far.csv", "farther"],
    );
    let gears = model("gears_on_shafts");
    fails(
        cspace(&[
            "plan",
            &gears,
            "--general",
            "--from",
            "0,0",
            "--to",
            "0,0,0",
        ]),
        2,
        &["--from", "by the general method takes 3 numbers"],
    );
}

#[test]
fn a_way_that_is_too_narrow_is_not_proved_to_be_none() {
    let peg = model("peg_hole");
    let ends = ["--from", "0,60,0", "--to", "0,2,0"];
    let folder = tempfile::tempdir().unwrap();
    let (file, proof) = (
        folder.path().join("narrow.json"),
        folder.path().join("proof.json"),
    );
    let asked = [
        "plan",
        &peg,
        "--clearance",
        "5",
        "-o",
        file.to_str().unwrap(),
        "--proof",
        proof.to_str().unwrap(),
    ];
    let told = printed(&[&asked[..], &ends[..]].concat());
    assert!(told.contains("\nno proof: there is a way"), "{told}");
    assert!(!proof.exists());
    let answer: Value = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    let answer = unframed("plan", answer);
    assert_eq!(answer["verdict"], "no-path");
    assert!(answer["bottleneck"]["most"].as_f64().unwrap() < 5.0);
    assert!(answer.get("proof").is_none());
    assert!(
        answer["unproved"]
            .as_str()
            .unwrap()
            .contains("there is a way")
    );
}

#[test]
fn no_path_is_proved_to_who_does_not_believe_it() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("proof.json");
    let path = file.to_str().unwrap();
    let ball = model("ball_in_c");
    let asked = ["plan", &ball, "--from", "0,0,0", "--to", "60,0,0"];
    let plain = json(&asked);
    assert!(
        plain.get("proof").is_none(),
        "it is made where it is asked for"
    );
    let told = printed(&[&asked[..], &["--proof", path]].concat());
    assert!(told.contains("\nproof: ") && told.contains(" triangles at a depth of "));
    let proof = cspace_check::read(&std::fs::read(&file).unwrap()).unwrap();
    assert_eq!(proof.check(), Ok(()));
    assert_eq!((proof.start, proof.goal), ([0.0; 3], [60.0, 0.0, 0.0]));
    // The same by another program in another language, where that is there.
    let python = |path: &str| {
        let script = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../cspace-check/examples/check.py"
        );
        std::process::Command::new("python3")
            .args([script, path])
            .output()
    };
    let Ok(checked) = python(path) else {
        println!("python3 is not there: its checker is not run");
        return;
    };
    let said = String::from_utf8(checked.stdout).unwrap();
    assert!(said.starts_with("proved: no motion of ball"), "{said}");
    let mut open = proof;
    open.triangles.pop();
    std::fs::write(&file, serde_json::to_vec(&open).unwrap()).unwrap();
    let refused = python(path).unwrap();
    assert!(!refused.status.success());
    assert!(String::from_utf8(refused.stderr).unwrap().contains("open"));
}

/// A pin in a slot that goes down, to the left and up, drawn 20 beside its origin, with a flat that makes it no disc.
const SLOT: &str = r#"
name = "slot"
unit = "mm"

[[part]]
name = "plate"
loops = [[[-30, -40, 0], [30, -40, 0], [30, 0, 0], [3, 0, 0], [3, -20, 0], [9, -20, 0], [9, -12, 0], [15, -12, 0], [15, -26, 0], [-3, -26, 0], [-3, 0, 0], [-30, 0, 0]]]

[[part]]
name = "pin"
loops = [[[18, -2, 0], [22, -2, 0], [22, 2, 0], [18, 2, 0]]]

[[pair]]
fixed = "plate"
moving = "pin"
"#;

fn slot() -> tempfile::NamedTempFile {
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), SLOT).unwrap();
    file
}

#[test]
fn legs_are_few_and_told_in_words() {
    let file = slot();
    let slot = file.path().to_str().unwrap();
    let out = json(&["plan", slot, "--from=-8,-16,0"]);
    let words: Vec<&str> = (out["words"].as_array().unwrap().iter())
        .map(|w| w.as_str().unwrap())
        .collect();
    let [down, left, up] = &words[..] else {
        panic!("{words:?}");
    };
    assert!(down.starts_with("down ") && left.starts_with("left ") && up.starts_with("up "));
    assert!(words.iter().all(|w| w.ends_with(" mm")), "{words:?}");
    assert_eq!(out["about"], serde_json::json!([20.0, 0.0]));
    let text = printed(&["plan", slot, "--from=-8,-16,0", "--widest"]);
    assert!(
        text.contains("    left ") && text.contains("so much may pin grow all round"),
        "{text}"
    );
}

/// Legs that turn are about the middle of the part: about its origin, 20 away, it would go through the plate. Rows of a file are free
/// as they stand.
#[test]
fn rows_are_free_as_they_stand() {
    let file = slot();
    let slot = file.path().to_str().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let way = folder.path().join("way.csv");
    let way = way.to_str().unwrap();
    let ends = ["--from=-20,-23,0", "--to=20,-23,180deg"];
    let answer = answered(&[&["plan", slot, "-o", way], &ends[..]].concat(), "path");
    let rows = std::fs::read_to_string(way).unwrap();
    assert!(rows.starts_with("x,y,theta\n-20.0,-23.0,0.0\n"), "{rows}");
    let checked = answered(&["plan", slot, "--verify", way], "path");
    let clearance = |answer: &Value| answer["clearance"].as_f64().unwrap();
    assert!(clearance(&checked) >= 0.89 * clearance(&answer));
    // A turn on the spot in the slot.
    std::fs::write(way, "x,y,theta\n-20,-23,0\n20,-23,180deg\n").unwrap();
    let about = ["plan", slot, "--verify", way, "--about", "20,0"];
    answered(&about, "path");
    answered(&["plan", slot, "--verify", way], "blocked");
    // The same turn as a motion: about the middle it is free, about the origin it is not.
    let turn = |about: &str| {
        let args = [
            "play",
            slot,
            "--at=-20,-23,0",
            "--by=0,0,1.5",
            "--about",
            about,
        ];
        json(&args)[0]["motion"]["result"].clone()
    };
    assert_eq!(turn("20,0"), "free");
    assert_eq!(turn("0,0"), "contact");
}

#[test]
fn a_point_that_says_nothing_is_refused() {
    let axes = cspace(&[
        "play",
        &model("geneva"),
        "--at",
        "0,0",
        "--by",
        "0,0.1",
        "--about",
        "1,2",
    ]);
    fails(axes, 2, &["--about", "axes"]);
}

/// A table with a square slot in it, open upwards, and a square pin that turns outside alone.
fn pin_and_slot(folder: &std::path::Path) -> String {
    let path = folder.join("pin.toml");
    let text = r#"
[[part]]
name = "slot"
loops = [[[-10, -5], [10, -5], [10, 5], [-10, 5]], [[-2, -2], [2, -2], [2, 2], [-2, 2]]]

[[part]]
name = "pin"
loops = [[[-1.9, -1.9], [1.9, -1.9], [1.9, 1.9], [-1.9, 1.9]]]
"#;
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn a_square_pin_that_cannot_turn_looks_the_same_where_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let pin = pin_and_slot(folder.path());
    let asked = ["plan", &pin, "--from", "0,0,0", "--to", "0.05,0,90deg"];
    let answer = answered(&asked, "no-path");
    let at = numbers(&answer["twin"]["at"]);
    assert!((at[0] - 0.05).abs() < 1e-9 && at[1].abs() < 1e-9 && at[2].abs() < 1e-9);
    let told = printed(&asked);
    assert!(
        told.contains("hint: pin looks the same turned by -90"),
        "{told}"
    );
    // Out of the slot no turn leads.
    let away = json(&["plan", &pin, "--from", "0,0,0", "--to", "50,0,90deg"]);
    assert!(away.get("twin").is_none());
}

#[test]
fn a_path_that_starts_in_contact_has_a_clearance_off_it() {
    let folder = tempfile::tempdir().unwrap();
    let pin = pin_and_slot(folder.path());
    let way = folder.path().join("way.csv");
    let way = way.to_str().unwrap();
    std::fs::write(way, "x,y,theta\n0.1,0,0\n0.05,0,0\n0,0,0\n").unwrap();
    let answer = json(&["plan", &pin, "--verify", way]);
    assert_eq!(answer["rest"]["from_contact"], true);
    assert_eq!(answer["rest"]["to_contact"], false);
    let clearance = answer["rest"]["clearance"].as_f64().unwrap();
    assert!((clearance - 0.05).abs() < 1e-6, "{clearance}");
    let told = printed(&["plan", &pin, "--verify", way]);
    assert!(told.contains("the path starts in contact; 0.05"), "{told}");
    std::fs::write(way, "x,y,theta\n0,0,0\n0.1,0,0\n").unwrap();
    let told = printed(&["plan", &pin, "--verify", way]);
    assert!(told.contains("ends in contact; 0.1"), "{told}");
    std::fs::write(way, "x,y,theta\n0,0,0\n1,0,0\n").unwrap();
    let told = printed(&["plan", &pin, "--verify", way]);
    assert!(told.starts_with("to-blocked"), "{told}");
    assert!(told.contains("  overlap  "), "{told}");
    answered(&["plan", &pin, "--verify", way], "to-blocked");
}

#[test]
fn a_way_begins_where_the_parts_are_drawn() {
    let peg = model("peg_hole");
    let answer = answered(&["plan", &peg], "path");
    let same = json(&["plan", &peg, "--from", "0,0,0"]);
    assert_eq!(answer["path"], same["path"]);
    // The start is in contact: the way goes on where the leg leaves it, and not there and back.
    let near = printed(&["plan", &peg, "--to", "0,2,0"]);
    assert!(
        near.contains("path: 1 leg") && near.contains("    up 2 mm"),
        "{near}"
    );
}

#[test]
fn staying_needs_the_clearance_too() {
    let peg = model("peg_hole");
    let ends = ["--from", "0,2,0", "--to", "0,2,0", "--clearance"];
    let stays = [&["plan", &peg], &ends[..]].concat();
    // The peg is 0.05 from the sides of its hole.
    answered(&[&stays[..], &["0.049"]].concat(), "path");
    let told = answered(&[&stays[..], &["0.051"]].concat(), "no-path");
    let most = told["bottleneck"]["most"].as_f64().unwrap();
    assert!((most - 0.05).abs() < 1e-9, "{most}");
}
