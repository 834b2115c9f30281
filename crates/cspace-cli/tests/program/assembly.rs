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
    let answer = json(&["assembly", &file]);
    assert_eq!(answer["verdict"], "apart");
    assert_eq!(moved(&answer), [["bolt"], ["lid"], ["block"]]);
    // The gap is what all steps begin with.
    let gap = answer["gap"].as_f64().unwrap();
    for step in answer["steps"].as_array().unwrap() {
        let clearance = step["clearance"].as_f64().unwrap();
        assert!(clearance > 0.0 && clearance < 1.5 * gap, "{clearance}");
    }
    let wider = json(&["assembly", &file, "--gap", "0.01"]);
    assert_eq!(wider["gap"], 0.01);
    assert_eq!(moved(&wider), moved(&answer));
    // Threads change nothing.
    let one = json(&["assembly", &file, "--threads", "1"]);
    assert_eq!(one["steps"], answer["steps"]);
    assert!(printed(&["assembly", &file]).starts_with("apart: 3 steps"));
}

#[test]
fn a_ball_in_a_c_is_locked() {
    let answer = json(&["assembly", &model("ball_in_c")]);
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
        cspace(&["assembly", &model("gears")]),
        2,
        &["gear", "pinion", "overlap"],
    );
    fails(
        cspace(&["assembly", &model("ratchet_mechanism")]),
        2,
        &["nothing to take apart"],
    );
    let file = model("latch_box");
    for gap in ["-1", "nan", "1e9", "0"] {
        fails(
            cspace(&["assembly", &file, &format!("--gap={gap}")]),
            2,
            &["gap"],
        );
    }
}
