//! `cspace assembly`: what comes apart in the order that the drawing shows, and what does not.

use serde_json::Value;

use crate::helpers::{cspace, fails, json, model, printed};

fn moved(answer: &Value) -> Vec<Vec<&str>> {
    let steps = answer["steps"].as_array().unwrap();
    let names = |step: &'_ Value| -> Vec<String> {
        let moving = step["moving"].as_array().unwrap();
        moving
            .iter()
            .map(|n| n.as_str().unwrap().to_owned())
            .collect()
    };
    assert!(steps.iter().all(|s| !names(s).is_empty()));
    (steps.iter())
        .map(|s| {
            s["moving"]
                .as_array()
                .unwrap()
                .iter()
                .map(|n| n.as_str().unwrap())
                .collect()
        })
        .collect()
}

#[test]
fn a_latch_box_comes_apart_in_order() {
    let file = model("latch_box");
    let answer = json(&["disassemble", &file]);
    assert_eq!(answer["verdict"], "apart");
    assert_eq!(moved(&answer), [["bolt"], ["lid"], ["block"]]);
    // The gap is what all steps begin with.
    let gap = answer["gap"].as_f64().unwrap();
    for step in answer["steps"].as_array().unwrap() {
        let clearance = step["clearance"].as_f64().unwrap();
        assert!(clearance > 0.0 && clearance < 1.5 * gap, "{clearance}");
    }
    let wider = json(&["disassemble", &file, "--gap", "0.01"]);
    assert_eq!(wider["gap"], 0.01);
    assert_eq!(moved(&wider), moved(&answer));
    // Threads change nothing.
    let one = json(&["disassemble", &file, "--threads", "1"]);
    assert_eq!(one["steps"], answer["steps"]);
    assert!(printed(&["disassemble", &file]).starts_with("apart: 3 steps"));
}

#[test]
fn a_ball_in_a_c_is_locked() {
    let answer = json(&["disassemble", &model("ball_in_c")]);
    assert_eq!(answer["verdict"], "locked");
    assert!(answer["steps"].as_array().unwrap().is_empty());
    assert_eq!(
        answer["locked"]["parts"],
        serde_json::json!(["clip", "ball"])
    );
}

#[test]
fn what_is_no_assembly_is_refused() {
    // The gears are drawn one over the other, the ratchet is on axes.
    fails(
        cspace(&["disassemble", &model("gears")]),
        2,
        &["gear", "pinion", "overlap"],
    );
    fails(
        cspace(&["disassemble", &model("ratchet_mechanism")]),
        2,
        &["nothing to take apart"],
    );
    let file = model("latch_box");
    for gap in ["-1", "nan", "1e9", "0"] {
        fails(
            cspace(&["disassemble", &file, &format!("--gap={gap}")]),
            2,
            &["gap"],
        );
    }
}

/// A tray, a block in it, and a door over both that opens up to 100 degrees.
const DOOR: &str = r#"
unit = "mm"
[[part]]
name = "tray"
motion = { type = "fixed" }
loops = [[[-1, -1], [5, -1], [5, 4], [4, 4], [4, 0], [0, 0], [0, 4], [-1, 4]]]
[[part]]
name = "block"
loops = [[[1, 0], [3, 0], [3, 3], [1, 3]]]
[[part]]
name = "door"
motion = { type = "revolute", center = [0, 4], range = ["0deg", "100deg"] }
loops = [[[0, 4], [4, 4], [4, 4.3], [0, 4.3]]]
"#;

#[test]
fn a_door_is_opened_first() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("door.toml");
    std::fs::write(&file, DOOR).unwrap();
    let file = file.to_str().unwrap();
    let answer = json(&["disassemble", file]);
    assert_eq!(answer["verdict"], "apart");
    let steps = answer["steps"].as_array().unwrap();
    assert_eq!(moved(&answer), [["door"], ["block"]]);
    assert_eq!(
        (&steps[0]["kind"], &steps[1]["kind"]),
        (&"moves".into(), &"leaves".into())
    );
    // Its end is left of the block at an angle of acos 1/4; it goes on, up to a margin before the wall.
    let opened = steps[0]["path"][1]["v"].as_f64().unwrap();
    assert!(opened > 0.25_f64.acos() + 0.1 && opened < 1.55, "{opened}");
    assert!(steps[0].get("onward").is_none() && steps[1]["onward"].is_array());
    assert!(steps[0].get("about").is_none());
    assert!(steps[1]["about"].is_array());
    assert!(steps[1]["words"][0].as_str().unwrap().starts_with("up "));
    let tree = &answer["tree"];
    assert_eq!(tree["out"], serde_json::json!([{ "room": [0], "step": 1 }]));
    assert_eq!(tree["left"], serde_json::json!(["tray", "door"]));
    let text = printed(&["disassemble", file]);
    let room = "  1. door turns +85.5\u{b0} about (0, 4) (makes room)\n  2. block\n";
    assert!(text.contains(room), "{text}");
}

#[test]
fn a_frame_for_each_step() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("door.toml");
    std::fs::write(&file, DOOR).unwrap();
    let file = file.to_str().unwrap();
    for name in ["steps.svg", "steps.png", "steps.pdf"] {
        let picture = dir.path().join(name);
        let text = printed(&["disassemble", file, "-o", picture.to_str().unwrap()]);
        assert!(text.starts_with("apart: 2 steps"));
        let bytes = std::fs::read(&picture).unwrap();
        let begin: &[u8] = match name {
            "steps.png" => b"\x89PNG",
            "steps.pdf" => b"%PDF",
            _ => b"<svg",
        };
        assert!(bytes.windows(begin.len()).take(200).any(|w| w == begin));
        if name == "steps.svg" {
            let svg = String::from_utf8(bytes).unwrap();
            for said in ["as drawn", "1. door aside", "2. block out"] {
                assert!(svg.contains(&format!(">{said}</text>")), "{said}");
            }
        }
    }
    // Without a picture, what is about one is refused.
    fails(
        cspace(&["disassemble", file, "--size", "400x300"]),
        2,
        &["--size"],
    );
}
