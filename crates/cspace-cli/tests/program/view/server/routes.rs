//! Paths that exist, and paths that do not.

use cspace::Classification;
use cspace_api::scene::Opened;
use cspace_cli::view::{ServeError, Server};
use serde_json::Value;

use crate::view::server::client::{Client, class_at, mechanism, page};

#[test]
fn the_page_is_there_at_once_and_its_pairs_when_they_are_asked_for() {
    let client = Client::new();
    let answer = client.get("");
    assert_eq!(
        answer.header("content-type"),
        Some("text/html; charset=utf-8")
    );
    let (_, rest) = answer
        .body
        .split_once(r#"<script type="application/json" id="scene">"#)
        .unwrap();
    let scene: Value = serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap();
    let pairs = scene["pairs"].as_array().unwrap();
    assert_eq!(pairs.len(), 3);
    assert!(
        pairs
            .iter()
            .all(|p| p["space"].is_null() && p["error"].is_null())
    );

    let answer = client.get("pair/0");
    let pair = answer.json();
    assert_eq!((&pair["fixed"], &pair["moving"]), (&0.into(), &1.into()));
    // The table ends at 2 and the coin has a radius of 1.
    assert_eq!(class_at(&pair, 2.9), Classification::Blocked);
    assert_eq!(class_at(&pair, 3.1), Classification::Free);
    // It is kept: computed again it would have taken another time.
    assert_eq!(client.get("pair/0").body, answer.body);
    assert_eq!(client.get("pair/1").json()["class"], "fixed-axes");
}

#[test]
fn a_pair_that_cannot_be_computed_says_why() {
    let mut model = mechanism();
    model.parts[2] = cspace_model::PartEntry::prismatic(model.parts[2].part.clone(), (0.0, 0.0));
    let pairs = model.pairs.clone();
    let client = Client::of(Opened::model(model, pairs, false));
    let pair = client.get("pair/1").json();
    assert!(pair["space"].is_null());
    assert!(
        pair["error"].as_str().unwrap().contains("direction"),
        "{pair}"
    );
    assert!(client.get("pair/0").json()["error"].is_null());
}

#[test]
fn nothing_else_is_there() {
    let client = Client::new();
    for path in [
        "pair",
        "pair/",
        "pair/3",
        "pair/-1",
        "pair/+0",
        "pair/00",
        "pair/%ff",
        "pair/x",
        "pair/0/",
        "pair/0/1",
        "pair/99999999999999999999",
        "index.html",
        "..",
        "../..",
        "../../../../../../etc/passwd",
        "%2e%2e/%2e%2e/etc/passwd",
        "pair/..%2f..%2fetc%2fpasswd",
        "file:///etc/passwd",
        "health",
        "edit",
        "model",
    ] {
        client.get(path).fails(404, &["nothing here"]);
    }
}

#[test]
fn other_methods_are_refused() {
    let client = Client::new();
    for (path, methods) in [
        ("", &["POST", "PUT", "DELETE", "PATCH", "OPTIONS"][..]),
        ("pair/0", &["POST", "PUT", "DELETE", "OPTIONS"]),
    ] {
        for method in methods {
            let answer = client.ask(method, &format!("{}{path}", client.root), "", "");
            answer.fails(405, &["method"]);
        }
    }
}

#[test]
fn a_taken_port_is_told() {
    let client = Client::new();
    let bound = Server::bind(
        Opened::model(mechanism(), Vec::new(), false),
        &page(),
        client.port,
    );
    assert!(matches!(bound, Err(ServeError::PortInUse { port }) if port == client.port));
}
