//! The published schema of models, held against what the reader takes and refuses.

use std::path::{Path, PathBuf};

use cspace_model::model;
use cspace_oracle::Schema;
use serde_json::{Value, json};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Published schema of models.
const SCHEMA: Schema = Schema::new("model");

/// `CSPACE_DOCS=write cargo test -p cspace-model schema` writes it.
#[test]
fn the_published_schema_has_the_keys_of_the_reader() {
    let path = Path::new(ROOT).join("docs/model.schema.json");
    let made = model::schema();
    if std::env::var("CSPACE_DOCS").is_ok_and(|v| v == "write") {
        std::fs::write(&path, &made).unwrap();
    }
    let published = std::fs::read_to_string(path).unwrap();
    let [made, published]: [Value; 2] =
        [made, published].map(|text| serde_json::from_str(&text).unwrap());
    assert_eq!(published, made, "write it anew by CSPACE_DOCS=write");
    references_resolve(&made, &made);
}

/// Every definition that is named is there.
fn references_resolve(value: &Value, schema: &Value) {
    if let Some(Value::String(name)) = value.get("$ref") {
        assert!(schema.pointer(&name[1..]).is_some(), "{name}");
    }
    match value {
        Value::Object(entries) => entries.values().for_each(|v| references_resolve(v, schema)),
        Value::Array(items) => items.iter().for_each(|v| references_resolve(v, schema)),
        _ => {}
    }
}

fn models(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(models(&path));
        } else if path.extension().is_some_and(|e| e == "toml") {
            found.push(path);
        }
    }
    found
}

#[test]
fn the_shipped_models_are_valid() {
    let folders = ["models", "tests/regression"];
    let all: Vec<PathBuf> = (folders.iter())
        .flat_map(|f| models(&Path::new(ROOT).join(f)))
        .collect();
    assert!(all.len() > 100, "{}", all.len());
    for path in all {
        let text = std::fs::read_to_string(&path).unwrap();
        // Regression cases have their expectations, which are no model's, in comments or files of their own.
        if model::from_toml(&text, "m.toml").is_err() {
            continue;
        }
        let value: Value = toml::from_str(&text).unwrap();
        SCHEMA.takes(&value, &path.display().to_string());
    }
}

/// A model with everything a model may have.
fn whole() -> Value {
    json!({
        "$schema": "model.schema.json",
        "name": "all of it",
        "unit": "mm",
        "parameter": {
            "width": {"value": 20, "tol": 0.1}, "play": {"value": 0.1, "plus": 0.05, "minus": 0}, "n": 6,
            "half": "width/2 + 0*play*n", "turned": "18deg",
        },
        "part": [
            {"name": "plate", "motion": {"type": "fixed"}, "profile": {"line 4 of loop 0": 0.01, "line 0 of loop 8": "play/10"},
             "names": {"line 0 of loop 0": "floor", "vertex 0 of loop 0": "corner", "convex arc 1 of loop 0": "edge"},
             "loops": [
                [[-20, -20], [20, -20], {"fillet": 2}, {"at": ["2*half", 20], "fillet": "3"}, [-20, 20]],
                {"circle": 2.5, "at": [0, 0]},
                {"circle": 0.5, "at": [10, 0], "pattern": {"count": "n", "about": [0, 0]}},
                {"path": [[14, -1], [16, -1], [15, 1]], "pattern": {"count": 3, "about": [0, 0]}},
            ]},
            {"name": "cam", "symmetry": 1, "profile": 0.02,
             "start": "15deg", "motion": {"type": "revolute", "center": [0, 0], "range": ["-10deg", 0.5]},
             "loops": [[[0, 0, 0.25], [4, 0], {"arc_to": [0, 4], "radius": 4, "direction": "ccw", "large": false}]]},
            {"name": "slider", "density": 0.5, "inertia": 2.5, "start": -2.5, "rate": 4, "motion": {"type": "prismatic", "direction": [0, 1], "range": [-3, 4.5]},
             "loops": [[[0, 0], {"arc_to": [4, 0], "through": [2, 1], "fillet": 0.1}, [9, -9]]]},
            {"name": "link", "motion": {"type": "planar"}, "offset": -0.01, "split": true, "mass": 3, "center_of_mass": [1, 2.5],
             "start": [1, 2, " 30 deg"], "rate": [0, 0, "2turn"],
             "loops": [[[4, 0], {"arc_to": [0, 4], "center": [0, 0]}, {"fillet": 0.5}, [0, 0]]]},
            {"name": "slider2", "motion": {"type": "prismatic", "direction": [0, 1]},
             "loops": [{"circle": 1, "at": [9, 9]}]},
            {"name": "lug", "place": {"at": ["2*half", 0], "turn": "30deg + turned", "mirror": "y"}, "union": [[[[0, 0], [4, 0], [4, 4]], {"circle": 0.5, "at": [3, 1]}], [{"circle": 1, "at": [0, 0]}]]},
            {"name": "star", "symmetry": "n", "loops": [[{"repeat": "n", "about": [0, 0], "path": [{"mirror": "y", "path": [[1, 5], ["1/2", 6]]}]}]]},
        ],
        "joint": [
            {"type": "revolute", "parts": ["plate", "cam"], "at": [0, 0]},
            {"type": "prismatic", "parts": ["plate", "slider"], "direction": [0, 1], "at": [1, 2]},
            {"type": "rigid", "parts": ["lug", "star"]},
        ],
        "pair": [
            {"fixed": "plate", "moving": "link", "theta": ["-0.5 turn", " 90 ° "]},
            {"fixed": "cam", "moving": "link", "friction": 0.5, "restitution": 1},
        ],
        "requirement": [
            {"name": "play", "pair": ["plate", "link"], "measure": "play", "of": "theta", "at": {"x": 50, "theta": "10deg"}, "limits": ["0deg", "2*turned"]},
            {"name": "lift", "pair": ["cam", "slider2"], "measure": "position", "along": [0, -5], "at": {"u": "20deg"}},
            {"name": "gap", "pair": ["cam", "link"], "measure": "clearance", "limits": [0, 1]},
            {"name": "held", "pair": ["cam", "link"], "measure": "caged", "at": {"y": 3}, "equals": false},
            {"name": "meets", "measure": "event", "event": "touch", "time": "2*turned", "pair": ["cam", "slider2"], "number": 2},
            {"name": "stroke", "measure": "stroke", "part": "cam", "time": 1, "limits": [0, "1turn"]},
            {"name": "ratio", "measure": "ratio", "part": "slider2", "by": "cam", "time": 1},
            {"name": "way", "pair": ["cam", "link"], "measure": "connected", "to": [90, 0, "1turn"], "equals": true},
        ],
        "gravity": [0, -9810],
        "friction": 0.1,
        "restitution": 0,
        "drive": [
            {"part": "cam", "rate": "-360deg"},
            {"part": "slider2", "table": [[0, 0], [0.5, 1], [2, -1.5]]},
        ],
        "load": [
            {"part": "link", "force": [0, -3], "at": [1, 1]},
            {"part": "link", "force": [0, -3]},
            {"part": "cam", "torque": -0.5},
        ],
        "spring": [
            {"parts": ["link", "cam"], "at": [[0, 0], [1, 1]], "stiffness": 2, "length": 3, "damping": 0.5},
            {"parts": ["link"], "type": "linear", "at": [[0, 0], [1, 1]], "damping": 0.5},
            {"parts": ["cam"], "type": "torsion", "stiffness": 2, "angle": "-20deg"},
        ],
    })
}

#[track_caller]
fn agree(value: &Value, is_good: bool, what: &str) {
    SCHEMA.case(value, is_good, what);
    let read = model::from_json(&value.to_string(), "m.json");
    assert_eq!(read.is_ok(), is_good, "reader, {what}: {read:?}");
}

/// Whatever is changed, the schema and the reader agree that it is wrong.
#[test]
fn broken_models_are_not() {
    agree(&whole(), true, "whole");
    let loops = |entries: Value| json!([entries]);
    for (at, value) in [
        ("/name", json!(3)),
        ("/name", json!("a\nb")),
        ("/unit", json!(["mm"])),
        ("/$schema", json!(1)),
        ("/nmae", json!("x")),
        ("/part", json!([])),
        ("/part", json!({})),
        ("/part/0/name", json!(" ")),
        ("/part/0/name", json!("a\u{1b}b")),
        ("/part/0/colour", json!("red")),
        ("/parameter", json!([1])),
        ("/parameter/width", json!([20])),
        ("/parameter/width", json!({"tol": 1})),
        ("/parameter/width", json!({"value": 20, "tol": -1})),
        (
            "/parameter/width",
            json!({"value": 20, "tol": 1, "plus": 1}),
        ),
        ("/parameter/width", json!({"value": 20, "spread": 1})),
        ("/parameter/sin", json!(1)),
        ("/part/0/loops/2/pattern", json!({"count": 6})),
        (
            "/part/0/loops/2/pattern",
            json!({"count": 0, "about": [0, 0]}),
        ),
        ("/part/0/loops/2/pattern", json!(6)),
        ("/part/0/loops/3/path", json!([])),
        ("/part/0/loops/3/circle", json!(1)),
        (
            "/part/1/loops",
            loops(json!([{"repeat": 6, "path": [[1, 5], [0, 6]]}])),
        ),
        ("/part/1/loops", loops(json!([{"path": [[1, 5], [0, 6]]}]))),
        (
            "/part/1/loops",
            loops(json!([{"mirror": "z", "path": [[1, 5], [0, 6]]}])),
        ),
        (
            "/part/1/loops",
            loops(json!([{"mirror": "y", "about": [0, 0], "path": [[1, 5], [0, 6]]}])),
        ),
        (
            "/part/1/loops",
            loops(json!([{"mirror": "y", "fillet": 1, "path": [[1, 5], [0, 6]]}])),
        ),
        ("/part/0/loops", json!([])),
        ("/part/5/place/mirror", json!("z")),
        ("/part/5/place/mirror", json!(true)),
        ("/part/5/place/at", json!([1])),
        ("/part/5/place/turn", json!([1])),
        ("/part/5/place/by", json!(1)),
        ("/part/5/place", json!([1, 2])),
        ("/part/5/union", json!([])),
        ("/part/5/union", json!([[]])),
        ("/part/5/union/1", json!({"circle": 1, "at": [0, 0]})),
        ("/part/5/loops", json!([{"circle": 1, "at": [0, 0]}])),
        ("/part/0/loops", json!([[0, 0], [1, 0], [1, 1]])),
        ("/part/0/loops/1", json!({"circle": -1, "at": [0, 0]})),
        ("/part/0/loops/1", json!({"circle": 1})),
        (
            "/part/0/loops/1",
            json!({"circle": 1, "at": [0, 0], "radius": 2}),
        ),
        ("/part/0/layer", json!("0")),
        ("/part/0/scale", json!(2)),
        ("/part/0/hatches", json!(true)),
        ("/part/0/trace", json!(true)),
        ("/part/0/offset", json!("1!")),
        ("/part/0/profile", json!(-0.1)),
        ("/part/0/profile", json!([0.1])),
        ("/part/0/profile", json!({"line 0 of loop 0": [1]})),
        ("/part/0/split", json!(true)),
        ("/part/0/split", json!(1)),
        ("/part/0/dxf", json!("a.dxf")),
        ("/part/0/names", json!(["floor"])),
        ("/part/0/names", json!({"floor": "line 0 of loop 0"})),
        ("/part/0/names", json!({"line 0 of loop 0": 1})),
        ("/part/0/names", json!({"line 0 of loop 0": " "})),
        ("/part/0/symmetry", json!(0)),
        ("/part/0/symmetry", json!("2?")),
        ("/part/0/motion", json!({"type": "fixt"})),
        ("/part/0/motion", json!({"type": "fixed", "center": [0, 0]})),
        ("/part/1/motion", json!({"type": "revolute"})),
        ("/part/1/motion/range", json!(["10 %", 1])),
        ("/part/1/motion/range", json!([0])),
        ("/part/1/motion/range", json!([0, 2e6])),
        (
            "/part/2/motion",
            json!({"type": "prismatic", "range": [0, 1]}),
        ),
        ("/part/2/motion/range", json!(["0deg", "1deg"])),
        ("/part/1/loops", loops(json!([[0, 0], [4, 0], [0]]))),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], [0, 4, 1, 1]])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, "0 = 0"], [0, 4]])),
        ),
        ("/part/1/loops", loops(json!([[0, 0], [4, 0], {}]))),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"fillet": 0}, [0, 4]])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"filet": 1}, [0, 4]])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"arc_to": [0, 4]}])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"arc_to": [0, 4], "radius": -4}])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"arc_to": [0], "radius": 4}])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"arc_to": [0, 4], "radius": 4, "center": [0, 0]}])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"arc_to": [0, 4], "radius": 4, "direction": "left"}])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"arc_to": [0, 4], "radius": 4, "large": 1}])),
        ),
        (
            "/part/1/loops",
            loops(
                json!([[0, 0], [4, 0], {"arc_to": [0, 4], "through": [3, 3], "direction": "cw"}]),
            ),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"radius": 4}])),
        ),
        (
            "/part/1/loops",
            loops(json!([[0, 0], [4, 0], {"at": [0, 4], "radius": 4}])),
        ),
        ("/requirement/0/name", json!(" ")),
        ("/requirement/0/measure", json!("plya")),
        ("/requirement/0/of", json!(1)),
        ("/requirement/0/to", json!([0, 0, 0])),
        ("/requirement/0/equals", json!(true)),
        ("/requirement/0/limits", json!([1])),
        ("/requirement/0/at", json!([0, 0, 0])),
        ("/requirement/0/at", json!({"z": 0})),
        ("/requirement/0/pair", json!(["plate"])),
        ("/requirement/0/pair", json!(["plate", "plate"])),
        ("/requirement/1/along", json!([0])),
        ("/requirement/2/of", json!("x")),
        ("/requirement/3/limits", json!([0, 1])),
        ("/requirement/4/event", json!("tuch")),
        ("/requirement/4/time", json!(0)),
        ("/requirement/4/number", json!(0)),
        ("/requirement/4/part", json!("cam")),
        ("/requirement/4/at", json!({"u": 0})),
        ("/requirement/5/pair", json!(["cam", "slider2"])),
        ("/requirement/6/of", json!("x")),
        ("/requirement/6/by", json!(1)),
        ("/requirement/0/time", json!(1)),
        ("/requirement/7/equals", json!("yes")),
        ("/requirement/7/from", json!([0, 0, 0])),
        ("/joint/0/type", json!("hinge")),
        ("/joint/0/parts", json!(["plate"])),
        ("/joint/0/parts", json!(["plate", "plate"])),
        ("/joint/0/direction", json!([0, 1])),
        ("/joint/2/at", json!([0, 1])),
        ("/joint/1/at", json!([0])),
        ("/pair/0/theta", json!(["0;", "1"])),
        ("/pair/0/theta", json!(0.5)),
        ("/pair/0/fixed", json!(0)),
        ("/pair/0/friction_", json!(0.1)),
        ("/pair/0/friction", json!(-0.1)),
        ("/pair/0/restitution", json!(1.5)),
        ("/gravity", json!(9.81)),
        ("/gravity", json!([0, 0, 1])),
        ("/friction", json!("{0.1}")),
        ("/friction", json!(-1)),
        ("/restitution", json!(2)),
        ("/part/3/mass", json!(0)),
        ("/part/3/mass", json!([1])),
        ("/part/3/density", json!(1)),
        ("/part/0/inertia", json!(1)),
        ("/part/2/density", json!(-1)),
        ("/part/2/inertia", json!(0)),
        ("/part/3/center_of_mass", json!([1])),
        ("/part/3/start", json!([1, 2])),
        ("/part/3/start", json!([1, "2deg", 0])),
        ("/part/3/start", json!([1, 2, 2e6])),
        ("/part/3/rate", json!([1, 2, "3:"])),
        ("/part/1/start", json!("15'")),
        ("/drive", json!({})),
        ("/drive/0/part", json!(1)),
        ("/drive/0/rate", json!("fast!")),
        ("/drive/0/table", json!([[0, 0], [1, 1]])),
        ("/drive/1/table", json!([[0, 0]])),
        ("/drive/1/table", json!([[0, 0], [1]])),
        ("/drive/0/speed", json!(1)),
        ("/load/0/torque", json!(1)),
        ("/load/0/force", json!(1)),
        ("/load/2/torque", json!("1&")),
        ("/load/2/at", json!([0, 0])),
        ("/spring/0/parts", json!(["link", "link"])),
        ("/spring/0/parts", json!([])),
        ("/spring/0/parts", json!("link")),
        ("/spring/0/at", json!([[0, 0]])),
        ("/spring/0/at", json!([[0, 0], [1]])),
        ("/spring/0/stiffness", json!(-1)),
        ("/spring/0/length", json!(-1)),
        ("/spring/0/damping", json!(-1)),
        ("/spring/0/angle", json!(1)),
        ("/spring/1/damping", json!(0)),
        ("/spring/2/type", json!("twist")),
        ("/spring/2/at", json!([[0, 0], [1, 1]])),
        ("/spring/2/length", json!(1)),
        ("/spring/2/angle", json!("1#")),
    ] {
        let mut broken = whole();
        let (parent, key) = at.rsplit_once('/').unwrap();
        match broken.pointer_mut(parent).unwrap() {
            Value::Object(map) => {
                map.insert(key.to_owned(), value);
            }
            Value::Array(list) => list[key.parse::<usize>().unwrap()] = value,
            _ => panic!("{at}"),
        }
        agree(&broken, false, at);
    }
    for at in [
        "/part",
        "/part/0/name",
        "/part/0/loops",
        "/requirement/0/of",
        "/requirement/0/name",
        "/requirement/1/along",
        "/requirement/7/to",
        "/requirement/7/measure",
        "/part/1/motion/center",
        "/part/2/motion/direction",
        "/joint/0/at",
        "/joint/1/direction",
        "/joint/2/parts",
        "/joint/2/type",
        "/pair/1/fixed",
        "/pair/1/moving",
        "/part/2/density",
        "/drive/0/part",
        "/drive/0/rate",
        "/drive/1/table",
        "/load/0/part",
        "/load/2/torque",
        "/load/0/force",
        "/spring/0/parts",
        "/spring/0/at",
        "/spring/1/damping",
        "/spring/2/stiffness",
        "/spring/2/type",
    ] {
        let mut broken = whole();
        let (parent, key) = at.rsplit_once('/').unwrap();
        let parent = broken.pointer_mut(parent).unwrap();
        parent.as_object_mut().unwrap().remove(key).unwrap();
        agree(&broken, false, at);
    }
}
