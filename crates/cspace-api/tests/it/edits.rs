//! Parts that are edited.

use core::fmt::{Debug, Display};

use cspace::pair::Joint;
use cspace::{Classification, Configuration, Coordinates, Part, Point, Silent, Vector};
use cspace_api::scene::{Edits, Opened};
use cspace_model::{Drive, DriveMotion, JointEntry, Mechanism, PartEntry, SavedFile};
use serde_json::{Value, json};

/// A square table 4 wide, which does not move, a coin of radius 1 that moves freely, and a lid that turns on the table.
fn mechanism() -> Mechanism {
    let mut model = Mechanism::new("table and coin");
    model.unit = Some("mm".into());
    let part = |x: f64, y: f64, name: &str| Part::rectangle(name, (x, y), 4.0, 4.0).unwrap();
    model.parts.push(PartEntry::fixed(part(0.0, 0.0, "table")));
    model.parts.push(PartEntry::planar(
        Part::circle("coin", (0.0, 0.0), 1.0).unwrap(),
    ));
    model
        .parts
        .push(PartEntry::revolute(part(6.0, 0.0, "lid"), (6.0, 0.0)));
    model.pairs = model.every_two();
    model
}

fn table_and_coin() -> Opened {
    let model = mechanism();
    let pairs = model.pairs.clone();
    Opened::model(model, pairs, false)
}

/// A coin of this radius, and how much it is grown.
fn coin(radius: f64, offset: f64) -> Value {
    let vertex = |x: f64| json!({ "x": x, "y": 0.0, "bulge": 1.0 });
    json!({
        "index": 1,
        "loops": [[vertex(-radius), vertex(radius)]],
        "motion": { "type": "planar" },
        "offset": offset,
    })
}

/// Class of the moving part at (x, 0, 0) in a pair's space.
fn class_at(pair: &Value, x: f64) -> Classification {
    let file = SavedFile::from_json(pair["space"].as_str().unwrap(), "space.json").unwrap();
    let at = Coordinates::Planar(Configuration::new(x, 0.0, 0.0));
    file.space.classify(at).unwrap()
}

fn parts(edits: &[Value]) -> Edits {
    serde_json::from_value(json!({ "parts": edits })).unwrap()
}

/// First pair after an edit, as sent to the page.
fn edit(opened: &Opened, edits: &[Value]) -> Result<Value, String> {
    let answer = opened.edited_pair(0, &parts(edits), &|| 0.0, &Silent);
    answer.map(|a| json!(a)).map_err(|e| e.to_string())
}

/// Checks that something fails with these words.
#[track_caller]
fn fails<T: Debug, E: Display>(result: Result<T, E>, words: &[&str]) {
    let error = result.map_err(|e| e.to_string()).unwrap_err();
    for word in words {
        assert!(error.contains(word), "{word:?} in {error}");
    }
}

fn saved(opened: &Opened, edits: &[Value]) -> Mechanism {
    let (text, _) = opened.edited_text(&parts(edits)).unwrap();
    cspace_model::model::from_toml(&text, "answer.toml").unwrap()
}

#[test]
fn an_edited_part_has_the_space_of_its_new_outline() {
    let opened = table_and_coin();
    let answer = edit(&opened, &[coin(2.0, 0.0)]).unwrap();
    assert_eq!(class_at(&answer["pair"], 3.9), Classification::Blocked);
    assert_eq!(class_at(&answer["pair"], 4.1), Classification::Free);
    assert_eq!(answer["parts"][1]["loops"], coin(2.0, 0.0)["loops"]);
    assert_eq!(answer["parts"][1]["name"], "coin");
    // Edits replace parts of the model that was opened, and do not change it.
    let again = edit(&opened, &[]).unwrap();
    assert_eq!(class_at(&again["pair"], 3.1), Classification::Free);
    assert_eq!(
        class_at(&json!(opened.pair(0, &|| 0.0, &Silent)), 3.1),
        Classification::Free
    );
}

#[test]
fn a_part_can_be_grown_and_shrunk() {
    let opened = table_and_coin();
    for offset in [0.5, -0.5] {
        let answer = edit(&opened, &[coin(1.0, offset)]).unwrap();
        let touches = 3.0 + offset;
        assert_eq!(
            class_at(&answer["pair"], touches - 0.01),
            Classification::Blocked
        );
        assert_eq!(
            class_at(&answer["pair"], touches + 0.01),
            Classification::Free
        );
        // What comes back is the part as it is now.
        let vertices = answer["parts"][1]["loops"][0].as_array().unwrap();
        for v in vertices {
            let radius = v["x"].as_f64().unwrap().hypot(v["y"].as_f64().unwrap());
            assert!((radius - 1.0 - offset).abs() < 1e-9, "{v}");
        }
    }
    fails(
        edit(&opened, &[coin(1.0, -1.5)]),
        &["coin", "nothing is left", "1.5"],
    );
}

#[test]
fn motions_can_be_edited() {
    let opened = table_and_coin();
    let square = edit(&opened, &[]).unwrap();
    assert_eq!(square["pair"]["class"], "symmetric");
    let mut wheel = coin(1.0, 0.0);
    wheel["motion"] =
        json!({ "type": "prismatic", "direction": { "x": 1.0, "y": 0.0 }, "range": [0.0, 9.0] });
    let answer = edit(&opened, &[wheel]).unwrap();
    assert_eq!(answer["pair"]["class"], "fixed-axes");
    let file =
        SavedFile::from_json(answer["pair"]["space"].as_str().unwrap(), "space.json").unwrap();
    let at = |v: f64| {
        file.space
            .classify(Coordinates::Axes { u: 0.0, v })
            .unwrap()
    };
    assert_eq!(
        (at(2.9), at(3.1)),
        (Classification::Blocked, Classification::Free)
    );
}

#[test]
fn what_is_no_part_is_refused_with_its_place() {
    let opened = table_and_coin();
    let vertex = |x: f64, y: f64| json!({ "x": x, "y": y, "bulge": 0.0 });
    let crossing = json!([[
        vertex(0.0, 0.0),
        vertex(1.0, 1.0),
        vertex(1.0, 0.0),
        vertex(0.0, 1.0)
    ]]);
    let refuses = |change: &dyn Fn(&mut Value), words: &[&str]| {
        let mut part = coin(1.0, 0.0);
        change(&mut part);
        fails(edit(&opened, &[part]), words);
    };
    refuses(
        &|p| p["loops"] = crossing.clone(),
        &["part 1 \"coin\"", "loop 0, edge 0", "crosses", "edge 2"],
    );
    refuses(&|p| p["loops"] = json!([]), &["coin", "no loops"]);
    refuses(
        &|p| p["loops"][0][1]["x"] = (-1.0).into(),
        &["coin", "loop 0, vertex 0", "same place"],
    );
    refuses(&|p| p["index"] = 7.into(), &["no part 7"]);
    let motion =
        json!({ "type": "revolute", "center": { "x": 0.0, "y": 0.0 }, "range": [1.0, -1.0] });
    refuses(&|p| p["motion"] = motion.clone(), &["range", "empty"]);
    fails(edit(&opened, &[coin(1.0, 0.0), coin(1.0, 0.0)]), &["twice"]);
}

#[test]
fn the_edited_model_is_a_file() {
    let mut model = mechanism();
    model.parts[0].symmetry = Some(4);
    let at = Point::new(6.0, 0.0);
    model.joints.push(JointEntry {
        joint: Joint::Revolute { at },
        parts: (0, 2),
    });
    model.dynamics.gravity = Vector::new(0.0, -9810.0);
    model.dynamics.drives.push(Drive {
        part: 2,
        motion: DriveMotion::Rate(1.0),
    });
    model.check().unwrap();
    let pairs = model.pairs.clone();
    let opened = Opened::model(model.clone(), pairs, false);
    assert_eq!(saved(&opened, &[]), model);

    let after = saved(&opened, &[coin(2.0, 0.0)]);
    assert_eq!(after.parts[1].part.loops()[0].vertices()[1].x, 2.0);
    model.parts[1] = after.parts[1].clone();
    assert_eq!(after, model);

    // The pivot's joint goes with it, and a symmetry that is no more is not declared.
    let vertex = |x: f64, y: f64| json!({ "x": x, "y": y, "bulge": 0.0 });
    let table = json!({
        "index": 0,
        "loops": [[vertex(-2.0, -2.0), vertex(2.0, -2.0), vertex(2.0, 2.0), vertex(-2.0, 3.0)]],
        "motion": { "type": "fixed" },
    });
    let lid = json!({
        "index": 2,
        "loops": [[vertex(5.0, -1.0), vertex(7.0, -1.0), vertex(6.0, 2.0)]],
        "motion": { "type": "revolute", "center": { "x": 6.5, "y": 0.5 }, "range": null },
    });
    let after = saved(&opened, &[table, lid]);
    assert_eq!(
        after.joints[0].joint,
        Joint::Revolute {
            at: Point::new(6.5, 0.5)
        }
    );
    assert_eq!(after.parts[0].symmetry, None);
    assert_eq!(after.dynamics, model.dynamics);

    let planar =
        json!({ "index": 2, "loops": coin(1.0, 0.0)["loops"], "motion": { "type": "fixed" } });
    fails(opened.edited_text(&parts(&[planar])), &["joint 0"]);
}

/// Each loop of a body is that of the same number: a vertex that is dragged is its member's.
#[test]
fn loops_of_a_body_stay_those_of_its_members() {
    let square = |x: f64, name: &str| Part::rectangle(name, (x, 0.0), 4.0, 4.0).unwrap();
    let entry = |part| PartEntry::on(part, cspace::Axis::FIXED);
    let mut model = Mechanism::new("body");
    // The two overlap, so that together they are no outline.
    let members = [square(0.0, "left"), square(3.0, "right")].map(entry);
    model.parts.push(PartEntry::body(&members).unwrap());
    let coin = Part::circle("coin", (0.0, 9.0), 1.0).unwrap();
    model.parts.push(PartEntry::planar(coin));
    model.pairs = model.every_two();
    let corners = |part: &Part| -> Vec<Value> {
        let vertices = part.loops()[0].vertices().iter();
        vertices
            .map(|v| json!({ "x": v.x, "y": v.y, "bulge": v.bulge }))
            .collect()
    };
    let moved = square(3.5, "right");
    let edit = |loops: Value| {
        let edit = json!({ "index": 0, "loops": loops, "motion": { "type": "fixed" } });
        let edit = serde_json::from_value(edit).unwrap();
        cspace_api::scene::edited(&model, &[edit])
    };
    let left = corners(&members[0].part);
    let edited = edit(json!([left, corners(&moved)])).unwrap();
    assert_eq!(edited.parts[0].drawn(), [members[0].part.clone(), moved]);
    let refused = edit(json!([left])).unwrap_err().to_string();
    assert!(
        refused.contains("left + right") && refused.contains("2 loops"),
        "{refused}"
    );
}
