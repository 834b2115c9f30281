//! The page of a drawing: its faces, the model of picked ones, and that model's page.

use cspace::Classification;
use cspace_drawing::{Format, Settings, Source, from_bytes};
use cspace_scene::OpenedDrawing;
use cspace_view::{Pages, Server};
use serde_json::{Value, json};

use crate::client::{Answer, Client, class_at, page};

/// A square of side 4 in which a circle of radius 0.5 is, divided by a line that goes beyond the square.
const SQUARE: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 -4 8 8" fill="none" stroke="black">
    <path d="M0 0h4v-4h-4z"/><circle cx="1" cy="-2" r="0.5"/><path d="M2.5 1v-6"/></svg>"#;

fn drawing() -> OpenedDrawing {
    OpenedDrawing {
        name: "square".into(),
        unit: Some("mm".into()),
        drawing: from_bytes(SQUARE.as_bytes(), Format::Svg, &Source::default()).unwrap(),
        settings: Settings::default(),
        command: "cspace import square.svg".into(),
    }
}

fn client() -> Client {
    let pages = Pages {
        drawing: page(),
        model: page(),
    };
    Client::serving(Server::bind_drawing(drawing(), pages, 0).unwrap())
}

/// The JSON in a page.
fn scene(answer: &Answer) -> Value {
    let (_, rest) = answer
        .body
        .split_once(r#"<script type="application/json" id="scene">"#)
        .unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

/// A part of the faces at points.
fn part(name: &str, at: &[(f64, f64)]) -> Value {
    let at: Vec<Value> = at.iter().map(|(x, y)| json!({ "x": x, "y": y })).collect();
    json!({ "name": name, "at": at })
}

#[test]
fn the_page_has_the_faces_and_all_that_is_drawn() {
    let client = client();
    let scene = scene(&client.get(""));
    assert_eq!(scene["format"], "cspace-drawing");
    assert_eq!(scene["count"], 3);
    let hole = core::f64::consts::PI / 4.0;
    let areas: Vec<f64> = (scene["faces"].as_array().unwrap().iter())
        .map(|f| f["area"].as_f64().unwrap())
        .collect();
    for (area, right) in areas.iter().zip([10.0 - hole, 6.0, hole]) {
        assert!((area - right).abs() < 1e-9, "{areas:?}");
    }
    // The outline and the circle, closed, and the line.
    let mut ends: Vec<usize> = (scene["curves"].as_array().unwrap().iter())
        .map(|c| c.as_array().unwrap().len())
        .collect();
    ends.sort_unstable();
    assert_eq!(ends, [2, 3, 5]);
}

#[test]
fn picked_faces_are_a_model() {
    let client = client();
    let answer = client.post(
        "model",
        &json!({ "parts": [part("left", &[(2.0, 2.0)]), part("right", &[(3.0, 2.0)])] }),
    );
    assert_eq!(answer.status, 200, "{answer:?}");
    let model = cspace_io::model::from_toml(&answer.body, "model.toml").unwrap();
    let areas: Vec<f64> = model.parts.iter().map(|p| p.part.area()).collect();
    assert!(areas[0] < 10.0 && areas[1] == 6.0, "{areas:?}");
    assert_eq!((model.unit.as_deref(), model.pairs.len()), (Some("mm"), 1));
}

#[test]
fn picks_that_make_no_model_are_refused() {
    let client = client();
    let parts = |parts: &[Value]| json!({ "parts": parts });
    let left = part("left", &[(2.0, 2.0)]);
    for (request, words) in [
        (parts(&[]), "no face is picked"),
        (parts(&[part("none", &[])]), "no face is picked"),
        (parts(&[part("beside", &[(9.0, 9.0)])]), "no face is at"),
        (
            parts(&[left.clone(), part("again", &[(2.0, 3.0)])]),
            "twice",
        ),
        (parts(&[left.clone(), part("left", &[(3.0, 2.0)])]), "name"),
        (parts(&[part("", &[(3.0, 2.0)])]), "name"),
    ] {
        for route in ["model", "open"] {
            client.post(route, &request).fails(422, &[words]);
        }
    }
    client
        .post("model", &json!({ "parts": 1 }))
        .fails(400, &["body"]);
    client.get("opened/").fails(404, &["nothing here"]);
}

/// Two squares that touch at a corner within a circle: what is between them and the circle touches itself there.
#[test]
fn faces_that_are_no_part_say_why() {
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="-8 -8 16 16" fill="none" stroke="black">
        <circle r="6"/><path d="M0 0h3v3h-3z"/><path d="M0 0h-3v-3h3z"/></svg>"#;
    let drawing = from_bytes(text.as_bytes(), Format::Svg, &Source::default()).unwrap();
    let settings = Settings::default();
    let found = drawing.reading(&settings).unwrap().faces().unwrap();
    let refused: Vec<bool> = found.faces.iter().map(|f| f.refusal.is_some()).collect();
    assert_eq!(refused, [true, false, false]);
}

#[test]
fn the_model_is_opened_below_the_drawing() {
    let client = client();
    client.get("opened/pair/0").fails(404, &["nothing here"]);
    let open = |name: &str| {
        let parts = [part(name, &[(3.0, 2.0)]), part("disc", &[(1.0, 2.0)])];
        let answer = client.post("open", &json!({ "parts": parts }));
        assert_eq!(answer.json(), json!({ "address": "opened/" }));
        scene(&client.get("opened/"))["parts"][0]["name"].clone()
    };
    assert_eq!(open("right"), "right");
    let pair = client.get("opened/pair/0").json();
    // From x = 2.5 on is the one, up to x = 1.5 the other.
    assert_eq!(class_at(&pair, 0.99), Classification::Free);
    assert_eq!(class_at(&pair, 1.01), Classification::Blocked);
    // Another choice takes its place.
    assert_eq!(open("other"), "other");
    for path in ["opened", "opened/x", "opened/pair/1", "pair/0", "edit"] {
        client.get(path).fails(404, &["nothing here"]);
    }
    let delete = client.ask("DELETE", &format!("{}opened/", client.root), "", "");
    delete.fails(405, &["method"]);
}

#[test]
fn long_bodies_are_not_read() {
    const LIMIT: usize = 8 << 20;
    let client = client();
    for path in ["open", "model"] {
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
