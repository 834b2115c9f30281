//! `cspace clearance`: what overlaps, touches and is clear, over all ranges, as drawn and along a record.

use serde_json::Value;

use crate::helpers::{cspace, fails, json, json_beside_notes, model, printed};

/// The row of a pair.
fn row<'a>(answer: &'a Value, first: &str, second: &str) -> &'a Value {
    let mut rows = answer["pairs"].as_array().unwrap().iter();
    rows.find(|r| r["fixed"] == first && r["moving"] == second)
        .unwrap()
}

#[track_caller]
fn is_near(value: &Value, expected: f64) {
    let found = value.as_f64().unwrap();
    assert!((found - expected).abs() < 1e-9, "{found} {expected}");
}

fn written(text: &str) -> (tempfile::TempDir, String) {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("model.toml");
    std::fs::write(&file, text).unwrap();
    let name = file.to_str().unwrap().to_owned();
    (dir, name)
}

const PARTS: &str = r#"
[[part]]
name = "plate"
loops = [[[-30, -10], [30, -10], [30, 0], [-30, 0]]]
motion = { type = "fixed" }
[[part]]
name = "block"
loops = [[[-10, 0], [10, 0], [10, 10], [-10, 10]]]
motion = { type = "prismatic", direction = [1, 0] }
[[part]]
name = "pin"
loops = [{ circle = 2, at = [15, 6] }]
[[part]]
name = "hand"
loops = [[[40, -1], [60, -1], [60, 1], [40, 1]]]
motion = { type = "revolute", center = [40, 0] }
[[part]]
name = "bump"
loops = [{ circle = 2, at = [20, 13] }]
[[joint]]
type = "revolute"
parts = ["pin", "hand"]
at = [40, 0]
"#;

#[test]
fn states_and_lengths_as_drawn() {
    let (_dir, file) = written(PARTS);
    let answer = json(&["clearance", &file, "--drawn"]);
    let states: Vec<&str> = (answer["pairs"].as_array().unwrap().iter())
        .map(|r| r["outcome"].as_str().unwrap())
        .collect();
    assert_eq!(
        states,
        [
            "touches", "clear", "clear", "clear", "clear", "clear", "clear", "clear", "clear",
            "joined"
        ]
    );
    assert_eq!(row(&answer, "plate", "block")["outcome"], "touches");
    is_near(&row(&answer, "block", "pin")["gap"], 3.0);
    let points = &row(&answer, "block", "pin")["points"];
    is_near(&points[0][0], 10.0);
    is_near(&points[1][0], 13.0);
    is_near(&row(&answer, "plate", "pin")["gap"], 4.0);
    is_near(&row(&answer, "plate", "hand")["gap"], 10.0);
    let near = json(&["clearance", &file, "--drawn", "--within", "3.5"]);
    assert_eq!(near["pairs"].as_array().unwrap().len(), 3);
    assert_eq!(near["beyond"], 7);
    let one = json(&["clearance", &file, "--drawn", "--pair", "pin,block"]);
    assert_eq!(one["pairs"].as_array().unwrap().len(), 1);
    is_near(&one["pairs"][0]["gap"], 3.0);
    let said = printed(&["clearance", &file, "--drawn"]);
    assert!(said.starts_with("5 parts, 10 pairs: 1 touches, 8 clear, 1 joined\n"));
}

/// The block passes through the pin and below the bump between two samples.
#[test]
fn the_least_gap_over_a_record() {
    let (dir, file) = written(PARTS);
    let record = dir.path().join("run.csv");
    let rows = "t,block.u,hand.u\n0,0,0\n1,40,0.5\n2,40,0\n";
    std::fs::write(&record, rows).unwrap();
    let answer = json(&["clearance", &file, "--along", record.to_str().unwrap()]);
    let through = row(&answer, "block", "pin");
    assert_eq!(through["outcome"], "meets");
    // It is met when the block has gone three of the forty.
    assert!((0.074..=0.5).contains(&through["at"].as_f64().unwrap()));
    assert_eq!(answer["along"], serde_json::json!([0.0, 2.0]));
    // It passes below the bump, of which it is clear by sqrt(109) - 2 at the samples.
    let below = row(&answer, "block", "bump");
    assert_eq!(below["outcome"], "clear");
    let gap = below["gap"].as_f64().unwrap();
    assert!((gap - 1.0).abs() < 2e-6, "{gap}");
    assert!((0.25..=0.75).contains(&below["at"].as_f64().unwrap()));
    assert_eq!(row(&answer, "plate", "block")["outcome"], "touches");
    // A compressed table says the same.
    let packed = dir.path().join("run.csv.gz");
    let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    std::io::Write::write_all(&mut gzip, rows.as_bytes()).unwrap();
    std::fs::write(&packed, gzip.finish().unwrap()).unwrap();
    let again = json(&["clearance", &file, "--along", packed.to_str().unwrap()]);
    assert_eq!(again["pairs"], answer["pairs"]);
    // JSON says the same.
    let record = dir.path().join("run.json");
    let samples = r#"{"status": "done", "parts": ["block", "hand"], "samples": [
        {"t": 0, "block": 0, "hand": 0}, {"t": 1, "block": 40, "hand": 0.5}, {"t": 2, "block": 40, "hand": 0}]}"#;
    std::fs::write(&record, samples).unwrap();
    let again = json(&["clearance", &file, "--along", record.to_str().unwrap()]);
    assert_eq!(again["pairs"], answer["pairs"]);
}

#[test]
fn records_that_are_wrong_are_told() {
    let (dir, file) = written(PARTS);
    let record = dir.path().join("run.csv");
    let name = record.to_str().unwrap();
    for (rows, words) in [
        ("x,y\n0,0\n", &["first column", "help: "][..]),
        ("t,nut.u\n0,0\n", &["nut", "does not have"]),
        ("t,pin.u\n0,0\n", &["pin", "does not move"]),
        ("t,block.u\n0,a\n", &["sample 0", "no number"]),
        ("t,block.u\n1,0\n0,0\n", &["sample 1", "earlier"]),
        ("t,block.u\n", &["no sample"]),
        ("t,block.u\n0\n", &["run.csv"]),
    ] {
        std::fs::write(&record, rows).unwrap();
        fails(cspace(&["clearance", &file, "--along", name]), 2, words);
    }
    fails(
        cspace(&["clearance", &file, "--pair", "plate,none"]),
        2,
        &["none", "the parts are"],
    );
}

/// A shaft that is pressed into its hub: a hundredth all around, though no short way leads out.
#[test]
fn the_interference_of_a_press_fit_is_told() {
    let hub = "[[part]]\nname = \"hub\"\nloops = [[[-20, -20], [20, -20], [20, 20], [-20, 20]], { circle = 10, at = [0, 0] }]\n";
    for (shape, by) in [
        ("{ circle = 10.01425, at = [0, 0] }", 0.01425),
        // The corners of a square reach to 10.1.
        (
            "[[10.1, 0], [0, 10.1], [-10.1, 0], [0, -10.1]]",
            0.1 / 2.0_f64.sqrt(),
        ),
    ] {
        let (_dir, file) = written(&format!(
            "{hub}[[part]]\nname = \"shaft\"\nloops = [{shape}]\n"
        ));
        let found = json(&["clearance", &file]);
        let row = row(&found, "hub", "shaft");
        let offset = row["offset"].as_f64().unwrap();
        // An inset polygon keeps its corners: they come in by more than its sides.
        assert!((offset - by).abs() < 1e-6, "{offset} {by}");
        let said = printed(&["clearance", &file]);
        assert!(said.contains("smaller all around"), "{said}");
    }
}

const DOOR: &str = r#"
unit = "mm"
[[part]]
name = "wall"
loops = [[[-10, -30], [-6, -30], [-6, 30], [-10, 30]]]
motion = { type = "fixed" }
[[part]]
name = "door"
loops = [[[0, -1], [10, -1], [10, 1], [0, 1]]]
motion = { type = "revolute", center = [0, 0], range = [0, "270deg"] }
[[part]]
name = "post"
loops = [{ circle = 2, at = [0, -20] }]
motion = { type = "fixed" }
[[part]]
name = "vase"
loops = [{ circle = 1, at = [30, 0] }]
"#;

/// The door meets the wall before the end of its range: 10 cos t - sin t = -6 at its first corner.
#[test]
fn what_stops_a_part_within_its_range() {
    let (_dir, file) = written(DOOR);
    let found = json_beside_notes(&["clearance", &file]);
    assert_eq!(found["outcome"], "stopped");
    let stop = (-6.0 / 101.0_f64.sqrt()).acos() - 0.1_f64.atan();
    let wall = row(&found, "wall", "door");
    assert_eq!(
        (&wall["over"], &wall["outcome"]),
        (&"ranges".into(), &"touches".into())
    );
    is_near(&wall["gap"], 0.0);
    is_near(&wall["reach"]["door"][0], 0.0);
    is_near(&wall["reach"]["door"][1], stop);
    let stopped = &wall["stopped"][0];
    assert_eq!(
        (&stopped["part"], &stopped["end"]),
        (&"door".into(), &"hi".into())
    );
    is_near(&stopped["at"]["v"], stop);
    is_near(&stopped["of"], 1.5 * std::f64::consts::PI);
    assert_eq!(
        stopped["touching"],
        serde_json::json!([["line 1 of loop 0", "vertex 2 of loop 0"]])
    );
    // A corner comes nearest to the post, which is at 20 below the hinge.
    let post = row(&found, "door", "post");
    assert_eq!(post["outcome"], "clear");
    is_near(&post["gap"], 18.0 - 101.0_f64.sqrt());
    let there = post["at"]["u"].as_f64().unwrap();
    assert!((there - 1.5 * std::f64::consts::PI + 0.1_f64.atan()).abs() < 1e-6);
    // Others are as drawn: two that stand still, and what is free in the plane.
    assert_eq!(row(&found, "wall", "post")["over"], "drawn");
    assert_eq!(row(&found, "door", "vase")["over"], "drawn");
    let output = cspace(&["clearance", &file]).assert().code(1);
    let said = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    let line = said.lines().nth(1).unwrap();
    assert!(
        line.starts_with("touches") && line.contains("door cannot pass 120.9"),
        "{said}"
    );
    assert!(
        line.ends_with(
            " of 270.0000 deg: vertex 2 of loop 0 of door touches line 1 of loop 0 of wall"
        ),
        "{said}"
    );
    let notes = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    assert!(
        notes.contains("vase") && notes.contains("motion = { type = \"fixed\" }"),
        "{notes}"
    );
    // As drawn nothing is wrong.
    let drawn = json(&["clearance", &file, "--drawn"]);
    assert_eq!(drawn["outcome"], "clear");
    assert!(
        drawn["pairs"]
            .as_array()
            .unwrap()
            .iter()
            .all(|r| r["over"] == "drawn")
    );
    is_near(&row(&drawn, "wall", "door")["gap"], 6.0);
}

/// Gears turn together as their teeth have it, also where one of them is pushed away by an open play.
#[test]
fn gears_mesh() {
    let file = model("gears_on_shafts");
    let found = json(&["clearance", &file]);
    let pair = &found["pairs"][0];
    assert_eq!(
        (&found["outcome"], &pair["outcome"]),
        (&"meshes".into(), &"meshes".into())
    );
    assert_eq!(pair["ratio"].as_f64(), Some(-1.2));
    let play = |key: &str| 20.0 * pair["backlash"][key].as_f64().unwrap();
    assert!(0.2 < play("least") && play("least") < play("most") && play("most") < 0.35);
    let said = printed(&["clearance", &file]);
    assert!(
        said.contains("pinion turns -1.2 times as gear turns once, with a backlash of"),
        "{said}"
    );
}

/// A block that lies on a plate slides along it, and is not stopped by it.
#[test]
fn what_lies_on_another_slides_along_it() {
    let (_dir, file) = written(PARTS);
    let found = json_beside_notes(&["clearance", &file, "--pair", "plate,block"]);
    let pair = row(&found, "plate", "block");
    assert_eq!(
        (&pair["over"], &pair["outcome"]),
        (&"ranges".into(), &"touches".into())
    );
    assert!(pair.get("stopped").is_none(), "{pair}");
    assert_eq!(pair["reach"]["block"], serde_json::json!([null, null]));
    assert!((0.0..1e-4).contains(&pair["room"].as_f64().unwrap()));
}

/// A pair whose space cannot be computed leaves the others their answers, and the question open.
#[test]
fn what_cannot_be_computed_is_undecided() {
    let (_dir, file) = written(
        r#"
[[part]]
name = "wall"
loops = [[[-1, -1], [1, -1], [1, 1], [-1, 1]]]
motion = { type = "fixed" }
[[part]]
name = "far"
loops = [[[4, -1], [6, -1], [6, 1], [4, 1]]]
motion = { type = "revolute", center = [9000, 0] }
[[part]]
name = "near"
loops = [[[14, -1], [16, -1], [16, 1], [14, 1]]]
motion = { type = "revolute", center = [15, 0] }
"#,
    );
    let output = cspace(&["clearance", &file, "--json"]).assert().code(2);
    let found: Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
    assert_eq!(found["outcome"], "undecided");
    assert_eq!(row(&found, "wall", "far")["outcome"], "undecided");
    let near = row(&found, "wall", "near");
    assert_eq!(near["outcome"], "clear");
    is_near(&near["gap"], 14.0 - 2.0_f64.sqrt());
    assert!(near["gap"].as_f64() >= near["least"].as_f64());
    let said = String::from_utf8(output.get_output().stderr.clone()).unwrap();
    assert!(
        said.contains("far") && said.contains("the parts' size away"),
        "{said}"
    );
}
