//! `cspace play`, against arithmetic done by hand.

use core::f64::consts::FRAC_PI_2;

use serde_json::Value;

use crate::helpers::{cspace, fails, json, mechanism, model, printed};

/// A ring, 4 wide inside, and a block of 3 by 3 whose lower left corner is its origin.
fn ring() -> tempfile::NamedTempFile {
    write(
        "unit = \"mm\"\n[[part]]\nname = \"ring\"\n\
        loops = [[[-3, -3], [3, -3], [3, 3], [-3, 3]], [[-2, -2], [2, -2], [2, 2], [-2, 2]]]\n\
        [[part]]\nname = \"block\"\nloops = [[[0, 0], [3, 0], [3, 3], [0, 3]]]\n",
    )
}

fn write(text: &str) -> tempfile::NamedTempFile {
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    std::fs::write(file.path(), text).unwrap();
    file
}

/// The one answer, and the distance in a direction.
fn play(args: &[&str]) -> Value {
    let answers = json(args);
    assert_eq!(answers.as_array().unwrap().len(), 1);
    answers[0].clone()
}

#[track_caller]
fn direction<'a>(answer: &'a Value, name: &str) -> &'a Value {
    let all = answer["directions"].as_array().unwrap();
    let found = all.iter().find(|d| d["direction"] == name);
    found.unwrap_or_else(|| panic!("no {name} in {all:?}"))
}

#[track_caller]
fn goes(answer: &Value, name: &str, far: f64) {
    let found = direction(answer, name)["distance"].as_f64().unwrap();
    assert!((found - far).abs() < 2e-8, "{name}: {found}, not {far}");
}

#[test]
fn a_block_in_a_ring() {
    let file = ring();
    let path = file.path().to_str().unwrap();
    // Its middle is at the middle of the ring, but for 0.1 and −0.2.
    let answer = play(&["play", path, "--at=-1.4,-1.7,0"]);
    assert_eq!(answer["outcome"], "free");
    assert!(answer["region"].is_u64());
    for (name, far) in [("+x", 0.4), ("-x", 0.6), ("+y", 0.7), ("-y", 0.3)] {
        goes(&answer, name, far);
        assert_eq!(direction(&answer, name)["stopped_by"], "contact");
    }
    assert!((answer["clearance"].as_f64().unwrap() - 0.3).abs() < 1e-9);
    // About its origin, counter-clockwise: (3, 0) reaches no wall, but (0, 3) the left one: 1.4 + 3 sin a = 2.
    goes(&answer, "turn + about its origin", (0.6_f64 / 3.0).asin());
    // Clockwise, (3, 0) the floor: 1.7 + 3 sin a = 2.
    goes(&answer, "turn - about its origin", (0.3_f64 / 3.0).asin());
    // About its middle, at (0.1, −0.2): a corner reaches the floor where 1.5 (sin a + cos a) = 1.8.
    let turned = (1.8_f64 / (1.5 * 2.0_f64.sqrt())).asin() - FRAC_PI_2 / 2.0;
    goes(&answer, "turn + about its middle", turned);
    goes(&answer, "turn - about its middle", turned);
    let text = printed(&["play", path, "--at=-1.4,-1.7,0"]);
    assert!(text.contains("caged: block cannot leave it"), "{text}");
    assert!(
        text.contains("+x                       0.400000 mm, to where line 1 of loop 1 of ring (")
    );
}

#[test]
fn from_contact_and_from_where_the_parts_overlap() {
    let file = ring();
    let path = file.path().to_str().unwrap();
    // On the floor, and 5 beside the ring.
    let answer = play(&["play", path, "--at=-1.4,-2,0"]);
    assert_eq!(answer["outcome"], "contact");
    goes(&answer, "-y", 0.0);
    goes(&answer, "+y", 1.0);
    goes(&answer, "+x", 0.4);
    let outside = play(&["play", path, "--at", "8,0,0"]);
    goes(&outside, "-x", 5.0);
    assert_eq!(direction(&outside, "+x")["stopped_by"], "nothing");
    assert!(direction(&outside, "+x")["distance"].is_null());
    cspace(&["play", path, "--at", "1,0,0"]).assert().code(1);
    let blocked = play(&["play", path, "--at", "1,0,0"]);
    assert_eq!(blocked["outcome"], "blocked");
    assert_eq!(blocked["directions"].as_array().unwrap().len(), 0);
    // In a window a turn ends with it.
    let window = play(&["play", path, "--at", "8,8,0", "--window=-0.2,0.5"]);
    goes(&window, "turn + about its origin", 0.5);
    assert_eq!(
        direction(&window, "turn - about its origin")["stopped_by"],
        "limit"
    );
}

/// A slider between two walls of a frame, 3 from one and 1 from the other; another with a limit before the wall.
#[test]
fn slides_go_to_the_wall_or_to_the_limit() {
    let text = |range: &str| {
        format!(
            "[[part]]\nname = \"frame\"\nloops = [[[-5, -1], [-4, -1], [-4, 1], [-5, 1]], [[2, -1], [3, -1], [3, 1], [2, 1]]]\n\
            motion = {{ type = \"fixed\" }}\n\
            [[part]]\nname = \"slider\"\nloops = [[[-1, -1], [1, -1], [1, 1], [-1, 1]]]\n\
            motion = {{ type = \"prismatic\", direction = [2, 0]{range} }}\n"
        )
    };
    let file = write(&text(""));
    let answer = play(&["play", file.path().to_str().unwrap()]);
    goes(&answer, "+v (slider slides)", 1.0);
    goes(&answer, "-v (slider slides)", 3.0);
    assert_eq!(answer["directions"].as_array().unwrap().len(), 2);
    let file = write(&text(", range = [-2.5, 4]"));
    let answer = play(&["play", file.path().to_str().unwrap()]);
    goes(&answer, "-v (slider slides)", 2.5);
    assert_eq!(
        direction(&answer, "-v (slider slides)")["stopped_by"],
        "limit"
    );
    goes(&answer, "+v (slider slides)", 1.0);
    let far = play(&["play", file.path().to_str().unwrap(), "--at", "0,0.25"]);
    goes(&far, "+v (slider slides)", 0.75);
}

#[test]
fn every_pair_of_a_mechanism_is_told() {
    let text = printed(&["play", &mechanism()]);
    assert_eq!(
        text.matches("joined: their play is that of the joint")
            .count(),
        4
    );
    assert!(text.contains("link relative to driver") && text.contains("pawl relative to ratchet"));
    for name in ["gears_on_shafts", "peg_hole", "cam_tappet", "rack_pinion"] {
        assert!(
            printed(&["play", &model(name)]).contains(" relative to "),
            "{name}"
        );
    }
    fails(
        cspace(&["play", &mechanism(), "--at", "0,0"]),
        2,
        &["--pair driver,link"],
    );
}

/// Lengths of large parts end above the resolution: a pin of a kilometre's radius in its hole, drawn in millimetres, goes 500 m.
#[test]
fn large_parts_have_fewer_digits() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pin.toml");
    let text = "unit = \"mm\"\n[[part]]\nname = \"plate\"\nloops = [[[-4e6, -4e6], [4e6, -4e6], [4e6, 4e6], [-4e6, 4e6]], { circle = 1.5e6, at = [0, 0] }]\n\
        [[part]]\nname = \"pin\"\nloops = [{ circle = 1e6, at = [0, 0] }]\n";
    std::fs::write(&file, text).unwrap();
    let said = printed(&["play", file.to_str().unwrap()]);
    assert!(said.contains(" 500000.00 mm"), "{said}");
}

/// A pin of ten micrometres in its hole, drawn in metres: its play of 50 nm is seen.
#[test]
fn small_parts_have_more_digits() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("pin.toml");
    let text = "unit = \"m\"\n[[part]]\nname = \"plate\"\nloops = [[[-20e-6, -20e-6], [20e-6, -20e-6], [20e-6, 20e-6], [-20e-6, 20e-6]], { circle = 5.05e-6, at = [0, 0] }]\n\
        [[part]]\nname = \"pin\"\nloops = [{ circle = 5e-6, at = [0, 0] }]\n";
    std::fs::write(&file, text).unwrap();
    let said = printed(&["play", file.to_str().unwrap()]);
    assert!(said.contains("0.0000000500 m"), "{said}");
}

/// A bar that fits exactly between two walls is told as one that is smaller, whose regions are those of another space.
#[test]
fn an_exact_fit_on_axes_is_described() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("slot.toml");
    let text = r#"
[[part]]
name = "slot"
motion = { type = "fixed" }
loops = [[[0, 0], [30, 0], [30, 5], [20, 5], [20, 2], [0, 2]], [[0, 6], [30, 6], [30, 8], [0, 8]]]
[[part]]
name = "bar"
motion = { type = "prismatic", direction = [1, 0], range = [0, 10] }
loops = [[[4, 2], [10, 2], [10, 6], [4, 6]]]
"#;
    std::fs::write(&file, text).unwrap();
    let told = printed(&["play", file.to_str().unwrap()]);
    assert!(
        told.contains("exact-fit") && told.contains("10.000000, its limit"),
        "{told}"
    );
}
