//! Parameters that are given other values.

use cspace::{Classification, Configuration, Coordinates, Silent};
use cspace_api::scene::{Edits, Opened, SceneSource};
use cspace_model::model::{Setting, Template};
use cspace_model::{Document, Host};
use serde_json::{Value, json};

/// A coin of a parameter's radius beside a table; tabs that are counted; a gap that follows.
const TEXT: &str = r#"
name = "coin"
[parameter]
r = 1          # of the coin
tabs = 4
gap = "r/2"
tilt = "10deg"
[[part]]
name = "table"
loops = [[[-2, -2], [2, -2], [2, 2], [-2, 2]]]
motion = { type = "fixed" }
[[part]]
name = "coin"
loops = [{ circle = "r", at = [0, 0] }]
[[part]]
name = "wheel"
loops = [[{ repeat = "tabs", about = [0, 0], path = [[3, "gap/4"], [4, "gap/4*tilt"]] }]]
[[pair]]
fixed = "table"
moving = "coin"
[[requirement]]
name = "apart"
measure = "clearance"
pair = ["table", "coin"]
at = { x = 4 }
limits = [0.5, 2]
"#;

fn opened(set: &[Setting]) -> Opened {
    let template = Template::from_text(TEXT.to_owned(), "coin.toml").unwrap();
    let host = Host {
        set,
        ..Host::default()
    };
    let model = template.model(&host).unwrap().mechanism;
    let pairs = model.pairs.clone();
    Opened::model(model, pairs, false).with_text(template, set.to_vec())
}

/// Copy by way of the page: sent as JSON and opened again.
fn sent(opened: &Opened) -> Opened {
    let scene = json!(opened.scene());
    let source: SceneSource = serde_json::from_value(scene["source"].clone()).unwrap();
    Opened::from_source(&source).unwrap()
}

fn edits(set: &[(&str, &str)], parts: &Value) -> Edits {
    let set: Vec<Value> = (set.iter())
        .map(|(name, value)| json!({ "name": name, "value": value }))
        .collect();
    serde_json::from_value(json!({ "set": set, "parts": parts })).unwrap()
}

fn class(opened: &Opened, edits: &Edits, x: f64) -> Classification {
    let (_, space) = opened.edited_space(0, edits, &Silent).unwrap();
    let at = Coordinates::Planar(Configuration::new(x, 0.0, 0.0));
    space.classify(at).unwrap()
}

#[test]
fn a_scene_lists_parameters_and_requirements() {
    let design = json!(opened(&[]).scene())["design"].clone();
    assert_eq!(design["requirements"], json!(["apart"]));
    let parameters = design["parameters"].as_array().unwrap();
    let of = |name: &str| parameters.iter().find(|p| p["name"] == name).unwrap();
    assert_eq!(of("r")["range"], json!([0.75, 1.25]));
    assert_eq!(of("r")["is_count"], false);
    assert_eq!(of("tabs")["is_count"], true);
    assert_eq!(of("tabs")["range"], json!([2.0, 8.0]));
    assert_eq!(of("gap")["expression"], "r/2");
    assert_eq!(of("tilt")["is_angle"], true);
}

#[test]
fn a_model_without_them_has_no_design() {
    let text = "[[part]] # of steel\nname = \"pin\"\nloops = [[[6, 0, 1], [8, 0, 1]]]\n";
    let template = Template::from_text(text.to_owned(), "pin.toml").unwrap();
    let model = template.model(&Host::default()).unwrap().mechanism;
    let opened = Opened::model(model, Vec::new(), false).with_text(template, Vec::new());
    assert_eq!(json!(opened.scene())["design"], Value::Null);
    // It can still be edited, and keeps its text, but not set.
    let saved = opened.edited_text(&Edits::default()).unwrap();
    assert_eq!(saved, (text.to_owned(), true));
    let error = opened
        .edited(&edits(&[("r", "2")], &json!([])))
        .unwrap_err();
    assert!(error.to_string().contains("\"r\""), "{error}");
}

#[test]
fn a_parameter_that_is_set_moves_its_contacts() {
    for opened in [opened(&[]), sent(&opened(&[]))] {
        assert_eq!(class(&opened, &Edits::default(), 3.1), Classification::Free);
        let larger = edits(&[("r", "1.5")], &json!([]));
        assert_eq!(class(&opened, &larger, 3.1), Classification::Blocked);
        assert_eq!(class(&opened, &larger, 3.6), Classification::Free);
        // The answer has all parts, and what follows.
        let answer = json!(opened.edited_pair(0, &larger, &|| 0.0, &Silent).unwrap());
        let gap = &answer["design"]["parameters"][0];
        assert_eq!((&gap["name"], &gap["value"]), (&json!("gap"), &json!(0.75)));
        assert_eq!(answer["parts"].as_array().unwrap().len(), 3);
        assert_eq!(answer["parts"][1]["loops"][0][0]["x"], -1.5);
    }
}

#[test]
fn values_given_to_the_command_stay_with_the_page() {
    let set = [Setting::number("r", 2.0)];
    let opened = sent(&opened(&set));
    assert_eq!(
        class(&opened, &Edits::default(), 3.9),
        Classification::Blocked
    );
    let back = edits(&[("r", "1")], &json!([]));
    assert_eq!(class(&opened, &back, 3.9), Classification::Free);
}

#[test]
fn parts_edited_by_hand_keep_their_outline() {
    let opened = opened(&[]);
    let square = json!([{ "index": 1, "motion": { "type": "planar" }, "loops": [[
        { "x": -1, "y": -1, "bulge": 0 }, { "x": 1, "y": -1, "bulge": 0 },
        { "x": 1, "y": 1, "bulge": 0 }, { "x": -1, "y": 1, "bulge": 0 },
    ]] }]);
    let both = edits(&[("r", "1.5"), ("gap", "0.2")], &square);
    let model = opened.edited(&both).unwrap();
    assert_eq!(model.mechanism.parts[1].part.loops()[0].vertices().len(), 4);
    assert_eq!(model.requirements.len(), 1);
    let error = opened.template(&both).err().unwrap();
    assert!(error.to_string().contains("\"coin\""), "{error}");
    // All else is saved as it is written.
    let (text, is_whole) = opened.edited_text(&both).unwrap();
    assert!(
        is_whole && text.contains("r = 1.5          # of the coin"),
        "{text}"
    );
    assert!(
        text.contains("path = [[3, \"gap/4\"]") && !text.contains("circle"),
        "{text}"
    );
    let read = cspace_model::model::from_toml(&text, "coin.toml").unwrap();
    assert_eq!(read, model.mechanism);
    // Not where more differs than outlines and motions: a pivot takes its joint along.
    let jointed = TEXT.replace(
        "[[pair]]",
        "[[joint]]\ntype = \"revolute\"\nparts = [\"table\", \"wheel\"]\nat = [0, 0]\n[[pair]]",
    );
    let jointed = jointed.replace(
        "name = \"wheel\"\n",
        "name = \"wheel\"\nmotion = { type = \"revolute\", center = [0, 0] }\n",
    );
    let template = Template::from_text(jointed, "coin.toml").unwrap();
    let model = template.model(&Host::default()).unwrap().mechanism;
    let wheel = &model.parts[2].part.loops()[0];
    let turned = json!([{ "index": 2, "loops": [wheel.vertices()], "motion": { "type": "revolute", "center": { "x": 0.5, "y": 0 }, "range": null } }]);
    let pairs = model.pairs.clone();
    let opened = Opened::model(model, pairs, false).with_text(template, Vec::new());
    let (text, is_whole) = opened.edited_text(&edits(&[], &turned)).unwrap();
    assert!(!is_whole && text.contains("center = [0.5, 0.0]"), "{text}");
}

#[test]
fn the_text_of_the_file_is_saved_with_the_values() {
    let opened = opened(&[]);
    let (text, is_whole) = opened
        .edited_text(&edits(&[("r", "1.25"), ("tilt", "12deg")], &json!([])))
        .unwrap();
    assert!(is_whole);
    assert!(text.contains("r = 1.25          # of the coin"), "{text}");
    assert!(text.contains("tilt = \"12deg\"") && text.contains("gap = \"r/2\""));
    let Document::Model(read) = cspace_model::read_from(text.as_bytes(), "coin.toml").unwrap()
    else {
        panic!("a model")
    };
    let r = read.parameters.iter().find(|p| p.name == "r").unwrap();
    assert_eq!(r.value, 1.25);
}

#[test]
fn values_without_a_model_say_why() {
    let opened = opened(&[]);
    for (name, value, word) in [
        ("r", "-1", "radius"),
        ("tabs", "2.5", "repeat"),
        ("nothing", "1", "nothing"),
    ] {
        let error = opened.edited(&edits(&[(name, value)], &json!([])));
        let error = error.unwrap_err().to_string();
        assert!(error.contains(word), "{word} in {error}");
    }
}
