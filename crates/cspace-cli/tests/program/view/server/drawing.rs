//! Server of a drawing: the page has its faces and all data from which a model is made, and there are no other routes.

use cspace::Point;
use cspace_api::scene::{DrawingSource, OpenedDrawing, PickedPart};
use cspace_cli::view::Server;
use serde_json::Value;

use crate::view::server::client::{Answer, Client, page};

/// A square of side 4 in which a circle of radius 0.5 is, divided by a line that goes beyond the square.
const SQUARE: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 -4 8 8" fill="none" stroke="black">
    <path d="M0 0h4v-4h-4z"/><circle cx="1" cy="-2" r="0.5"/><path d="M2.5 1v-6"/></svg>"#;

fn client() -> Client {
    let opened = OpenedDrawing::of_file("square.svg", SQUARE.into()).unwrap();
    Client::serving(Server::bind_drawing(&opened.scene().unwrap(), &page(), 0).unwrap())
}

/// The JSON in a page.
fn scene(answer: &Answer) -> Value {
    let (_, rest) = answer
        .body
        .split_once(r#"<script type="application/json" id="scene">"#)
        .unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
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
fn a_model_is_made_of_the_page_alone() {
    let served = scene(&client().get(""));
    let source: DrawingSource = serde_json::from_value(served["source"].clone()).unwrap();
    assert_eq!(source.data, SQUARE.as_bytes());
    let opened = OpenedDrawing::from_source(source).unwrap();
    let picked = |name: &str, face: usize| PickedPart {
        name: name.to_owned(),
        at: vec![serde_json::from_value::<Point>(served["faces"][face]["inside"].clone()).unwrap()],
    };
    let text = opened
        .toml(&[picked("left", 0), picked("right", 1)])
        .unwrap();
    let model = cspace_model::model::from_toml(&text, "model.toml").unwrap();
    let areas: Vec<f64> = model.parts.iter().map(|p| p.part.area()).collect();
    assert!(areas[0] < 10.0 && areas[1] == 6.0, "{areas:?}");
    assert_eq!(model.name, "square");
}

#[test]
fn nothing_else_is_there() {
    let client = client();
    for path in ["pair/0", "model", "open", "opened/", "square.svg"] {
        client.get(path).fails(404, &["nothing here"]);
        client.post(path, &1.into()).fails(404, &["nothing here"]);
    }
    let post = client.post("", &1.into());
    post.fails(405, &["method"]);
}
