//! Parts that are edited.

use std::time::Duration;

use cspace::mechanism::{Drive, DriveMotion};
use cspace::pair::Joint;
use cspace::{Classification, Coordinates, JointEntry, Mechanism, Point, Vector};
use cspace_view::Opened;
use serde_json::{Value, json};

use crate::client::{Client, class_at, coin, mechanism};

#[test]
fn an_edited_part_has_the_space_of_its_new_outline() {
    let client = Client::new();
    let answer = client.edit(1, &[coin(2.0, 0.0)]);
    assert_eq!(answer.status, 200, "{answer:?}");
    let answer = answer.json();
    assert_eq!(answer["sequence"], 1);
    assert!(answer["total_seconds"].as_f64() >= answer["seconds"].as_f64());
    assert_eq!(answer["pair"]["seconds"], answer["seconds"]);
    assert_eq!(class_at(&answer["pair"], 3.9), Classification::Blocked);
    assert_eq!(class_at(&answer["pair"], 4.1), Classification::Free);
    assert_eq!(answer["parts"][0]["loops"], coin(2.0, 0.0)["loops"]);
    assert_eq!(answer["parts"][0]["name"], "coin");
    // Edits replace parts of the model that was opened, and do not change it.
    let again = client.edit(2, &[]).json();
    assert_eq!(class_at(&again["pair"], 3.1), Classification::Free);
    assert_eq!(
        class_at(&client.get("pair/0").json(), 3.1),
        Classification::Free
    );
}

#[test]
fn a_part_can_be_grown_and_shrunk() {
    let client = Client::new();
    for (sequence, offset) in [(1, 0.5), (2, -0.5)] {
        let answer = client.edit(sequence, &[coin(1.0, offset)]).json();
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
        let vertices = answer["parts"][0]["loops"][0].as_array().unwrap();
        for v in vertices {
            let radius = v["x"].as_f64().unwrap().hypot(v["y"].as_f64().unwrap());
            assert!((radius - 1.0 - offset).abs() < 1e-9, "{v}");
        }
    }
    client
        .edit(3, &[coin(1.0, -1.5)])
        .fails(422, &["coin", "nothing is left", "1.5"]);
}

#[test]
fn motions_can_be_edited() {
    let client = Client::new();
    let square = client.edit(1, &[]).json();
    assert_eq!(square["pair"]["class"], "symmetric");
    let mut wheel = coin(1.0, 0.0);
    wheel["motion"] =
        json!({ "type": "prismatic", "direction": { "x": 1.0, "y": 0.0 }, "range": [0.0, 9.0] });
    let answer = client.edit(2, &[wheel]).json();
    assert_eq!(answer["pair"]["class"], "fixed-axes");
    let file = cspace_io::SavedFile::from_json(&answer["pair"]["space"].to_string(), "space.json")
        .unwrap();
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
    let client = Client::new();
    let vertex = |x: f64, y: f64| json!({ "x": x, "y": y, "bulge": 0.0 });
    let crossing = json!([[
        vertex(0.0, 0.0),
        vertex(1.0, 1.0),
        vertex(1.0, 0.0),
        vertex(0.0, 1.0)
    ]]);
    let mut sequence = 0;
    let mut refuses = |change: &dyn Fn(&mut Value), words: &[&str]| {
        sequence += 1;
        let mut part = coin(1.0, 0.0);
        change(&mut part);
        client.edit(sequence, &[part]).fails(422, words);
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
    client
        .edit(100, &[coin(1.0, 0.0), coin(1.0, 0.0)])
        .fails(422, &["twice"]);
}

#[test]
fn what_is_no_edit_is_refused() {
    let client = Client::new();
    let path = format!("{}edit", client.root);
    for body in [
        "",
        "{",
        "[]",
        "null",
        "{\"sequence\": 1}",
        "{\"sequence\": -1, \"pair\": 0, \"parts\": []}",
        "\u{0}",
    ] {
        client
            .ask("POST", &path, "", body)
            .fails(400, &["not what is expected"]);
    }
    let deep = "[".repeat(100_000);
    client.ask("POST", &path, "", &deep).fails(400, &[]);
    let mut part = coin(1.0, 0.0);
    part["motion"]["type"] = "flying".into();
    client.edit(1, &[part]).fails(400, &["flying"]);
    let huge = coin(1.0, 0.0).to_string().replace("-1.0", "1e999");
    let body = format!("{{\"sequence\": 2, \"pair\": 0, \"parts\": [{huge}]}}");
    client
        .ask("POST", &path, "", &body)
        .fails(400, &["number out of range"]);
    client
        .post("edit", &json!({ "sequence": 3, "pair": 9, "parts": [] }))
        .fails(400, &["no pair 9"]);
}

#[test]
fn long_bodies_are_not_read() {
    const LIMIT: usize = 8 << 20;
    let client = Client::new();
    for path in ["edit", "model"] {
        let path = format!("{}{path}", client.root);
        let answer = client.ask("POST", &path, "", &" ".repeat(LIMIT + 1));
        answer.fails(413, &["more than"]);
        client
            .ask("POST", &path, "", &" ".repeat(LIMIT))
            .fails(400, &[]);
        // A length that is only promised is not waited for.
        let head = format!(
            "POST {path} HTTP/1.1\r\nHost: localhost:{}\r\nContent-Length: 99999999999\r\n\r\n",
            client.port
        );
        client.send(head.as_bytes()).fails(413, &[]);
        // Nor is one without a length.
        let chunk = format!("100000\r\n{}\r\n", " ".repeat(1 << 20));
        let head = format!(
            "POST {path} HTTP/1.1\r\nHost: localhost:{}\r\nConnection: close\r\nTransfer-Encoding: chunked\r\n\r\n",
            client.port
        );
        let request = head + &chunk.repeat(9) + "0\r\n\r\n";
        client.send(request.as_bytes()).fails(413, &[]);
    }
}

#[test]
fn only_the_newest_edit_counts() {
    let client = Client::new();
    assert_eq!(client.edit(5, &[]).status, 200);
    for sequence in [0, 4, 5] {
        client
            .edit(sequence, &[coin(2.0, 0.0)])
            .fails(409, &["newer edit"]);
    }
    assert_eq!(client.edit(6, &[]).status, 200);
    // Another page counts for itself.
    let other = json!({ "session": "other", "sequence": 1, "pair": 0, "parts": [] });
    assert_eq!(client.post("edit", &other).status, 200);
    client.post("edit", &other).fails(409, &[]);
    // So does one that is loaded again.
    client.get("");
    assert_eq!(client.edit(1, &[]).status, 200);
}

/// A polygon whose corners are far out and farther in by turns, none like another.
fn star(index: usize, size: f64) -> Value {
    const CORNERS: usize = 80;
    let corner = |i: usize| {
        let radius = size * (if i % 2 == 1 { 1.0 } else { 0.7 }) + 0.01 * ((i * 37) % 11) as f64;
        let at = Vector::from_angle(core::f64::consts::TAU * i as f64 / CORNERS as f64) * radius;
        json!({ "x": at.x, "y": at.y, "bulge": 0.0 })
    };
    let corners: Vec<Value> = (0..CORNERS).map(corner).collect();
    json!({ "index": index, "loops": [corners], "motion": { "type": "planar" } })
}

/// Edits are computed one at a time: a newer one waits only until the older one has seen that nobody wants it.
#[test]
fn an_edit_that_is_computed_stops_for_a_newer_one() {
    let client = Client::new();
    let parts = [star(0, 5.0), star(1, 3.0)];
    std::thread::scope(|scope| {
        let slow = scope.spawn(|| client.edit(1, &parts));
        std::thread::sleep(Duration::from_millis(100));
        assert!(!slow.is_finished(), "it is too fast to be stopped");
        let fast = client.edit(2, &[coin(2.0, 0.0)]).json();
        assert_eq!(class_at(&fast["pair"], 3.9), Classification::Blocked);
        slow.join().unwrap().fails(409, &["newer edit"]);
        let whole = client.edit(3, &parts).json();
        let [waited, alone] = [&fast, &whole].map(|a| a["total_seconds"].as_f64().unwrap());
        assert!(waited < 0.7 * alone, "{waited} of {alone} s");
    });
}

fn saved(client: &Client, parts: &[Value]) -> Mechanism {
    let answer = client.post("model", &json!({ "parts": parts }));
    assert_eq!(answer.status, 200, "{answer:?}");
    assert_eq!(
        answer.header("content-type"),
        Some("application/toml; charset=utf-8")
    );
    cspace_io::model::from_toml(&answer.body, "answer.toml").unwrap()
}

#[test]
fn the_edited_model_is_answered_as_a_file() {
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
    let client = Client::of(Opened::model(model.clone(), pairs, false));
    assert_eq!(saved(&client, &[]), model);

    let after = saved(&client, &[coin(2.0, 0.0)]);
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
    let after = saved(&client, &[table, lid]);
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
    let answer = client.post("model", &json!({ "parts": [planar] }));
    answer.fails(422, &["joint 0"]);
    client.post("model", &json!({ "parts": 1 })).fails(400, &[]);
}
