//! Texts that are names stay names, whatever parameters are called.

use cspace_model::model::Template;
use cspace_model::{Host, Model};
use serde_json::{Value, json};

/// A rectangle on a layer, in a colour and with a line type, and a circle in another.
const DXF: &str = "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nouter\n6\nsolid\n62\n1\n90\n4\n70\n1\n10\n0\n20\n0\n10\n4\n20\n0\n10\n4\n20\n3\n10\n0\n20\n3\n0\nENDSEC\n0\nEOF\n";
const SVG: &str = r#"<svg xmlns="http://www.w3.org/2000/svg"><rect id="body" width="4" height="3" stroke="red"/><circle id="hole" cx="2" cy="1" r="0.5"/></svg>"#;

/// A model in which every key stands whose value is a name, or a list or table of names.
fn model() -> Value {
    let square = json!([[[0, 0], [2, 0], [2, 2], [0, 2]]]);
    json!({
        "$schema": "schema", "name": "whole", "unit": "mm",
        "parameter": {
            "size": {"value": 3, "tol": "H7"},
            "right": {"value": 1, "position": 0.1, "with": "up"},
            "up": 1,
            "round": {"value": 0.5, "tol": 0.1, "distribution": "normal"},
        },
        "part": [
            {"name": "frame", "dxf": "drawing.dxf", "layer": "outer", "linetype": "solid", "color": "red",
             "without_sheet": false, "hatches": false, "trace": false, "motion": {"type": "fixed"}},
            {"name": "cover", "dxf": "drawing.dxf", "layer": ["outer"], "linetype": ["solid"], "color": ["red"]},
            {"name": "lid", "svg": "drawing.svg", "id": "body"},
            {"name": "plate", "svg": "drawing.svg", "id": ["body", "hole"]},
            {"name": "cam", "motion": {"type": "revolute", "center": ["right", "up"]}, "names": {"line 0 of loop 0": "floor"},
             "loops": [[[0, 0], ["size", 0], {"arc_to": [0, 3], "radius": 3, "direction": "ccw", "large": false}]]},
            {"name": "tappet", "motion": {"type": "prismatic", "direction": [0, 1]}, "offset": 0.1, "split": true,
             "loops": [[{"mirror": "y", "path": [[0, 5], ["round", 6], [0, 7]]}]]},
            {"name": "free", "motion": {"type": "planar"}, "loops": square},
            {"name": "other", "loops": square},
        ],
        "joint": [
            {"type": "rigid", "parts": ["free", "other"]},
            {"type": "revolute", "parts": ["frame", "free"], "at": [0, 0]},
        ],
        "pair": [{"fixed": "cam", "moving": "tappet"}, {"fixed": "frame", "moving": "lid"}, {"fixed": "frame", "moving": "plate"}],
        "requirement": [
            {"name": "held", "pair": ["frame", "lid"], "measure": "caged", "equals": true},
            {"name": "lift", "pair": ["cam", "tappet"], "measure": "play", "of": "v"},
            {"name": "top", "pair": ["cam", "tappet"], "measure": "extreme", "of": "v", "end": "lower"},
            {"name": "meets", "measure": "event", "event": "touch", "time": 1, "pair": ["cam", "tappet"]},
            {"name": "way", "measure": "ratio", "part": "tappet", "by": "cam", "time": 1},
        ],
        "drive": [{"part": "cam", "rate": 1}],
        "load": [{"part": "tappet", "force": [0, -3]}],
        "spring": [{"parts": ["cam", "tappet"], "type": "linear", "at": [[0, 0], [1, 1]], "stiffness": 2}],
    })
}

/// All texts of a value that could be the name of a parameter.
fn names(value: &Value, found: &mut Vec<String>) {
    match value {
        Value::String(text) if text.chars().all(char::is_alphanumeric) => found.push(text.clone()),
        Value::Array(items) => items.iter().for_each(|item| names(item, found)),
        Value::Object(entries) => entries.values().for_each(|entry| names(entry, found)),
        _ => {}
    }
}

#[test]
fn a_name_is_never_taken_for_a_parameter() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("drawing.dxf"), DXF).unwrap();
    std::fs::write(folder.path().join("drawing.svg"), SVG).unwrap();
    let read = |model: &Value| -> Model {
        let path = folder.path().join("model.json");
        let template = Template::from_text(model.to_string(), path).unwrap();
        template.model(&Host::default()).unwrap()
    };
    let plain = model();
    let mut called = plain.clone();
    let mut found = Vec::new();
    names(&plain, &mut found);
    let parameters = called["parameter"].as_object_mut().unwrap();
    for name in found {
        parameters.entry(name).or_insert(json!(7));
    }
    assert!(parameters.len() > 40, "{}", parameters.len());
    let (plain, called) = (read(&plain), read(&called));
    assert_eq!(called.mechanism, plain.mechanism);
    assert_eq!(called.requirements, plain.requirements);
    // What is a number depends on them, and nothing else.
    let used = called.parameters.iter().filter(|p| !p.used_by.is_empty());
    let used: Vec<&str> = used.map(|p| p.name.as_str()).collect();
    assert_eq!(used, ["right", "round", "size", "up"]);
}
