//! Sites. What is in them is tested beside the command, where the page may be missing.

use serde_json::Value;

use crate::helpers::{cspace, fails, model, printed};
use crate::page::{WITHOUT, is_bundled};

/// A page without its scene, and the scene without how long it took to compute, which is not the same twice.
fn without_seconds(page: &str) -> (String, Value) {
    let (before, rest) = page.split_once(r#"id="scene">"#).unwrap();
    let (scene, after) = rest.split_once("</script>").unwrap();
    let mut scene: Value = serde_json::from_str(scene).unwrap();
    for pair in scene["pairs"].as_array_mut().unwrap() {
        let mut space: Value = serde_json::from_str(pair["space"].as_str().unwrap()).unwrap();
        space["statistics"]["seconds"] = Value::Null;
        space["checksum"] = Value::Null;
        pair["space"] = space;
        pair["seconds"] = Value::Null;
    }
    (format!("{before}{after}"), scene)
}

#[test]
fn a_site_has_the_pages_that_export_writes() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let args = ["site", &model("latch_box"), "-o", &place("site")];
    if !is_bundled() {
        fails(cspace(&args), 1, WITHOUT);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
        return;
    }
    assert_eq!(printed(&args), "");
    printed(&["export", &model("latch_box"), "-o", &place("page.html")]);
    let read = |name: &str| std::fs::read_to_string(place(name)).unwrap();
    let pages = ["page.html", "site/latch_box.html"].map(|name| without_seconds(&read(name)));
    assert!(pages[0] == pages[1]);
    assert!(read("site/playground.html").contains("id=\"scene\""));
    assert!(read("site/index.html").contains("href=\"latch_box.html\""));
}

/// Wrong arguments are reported before anything is computed, also by programs built without the page.
#[test]
fn what_is_not_there_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (latch, out) = (model("latch_box"), place("site"));
    let no_model = cspace(&["site", &place("no.toml"), "-o", &out]);
    fails(no_model, 2, &["no.toml", "cannot be read"]);
    let no_docs = cspace(&["site", &latch, "-o", &out, "--docs", &place("no")]);
    fails(no_docs, 2, &["/no: it cannot be read"]);
    let nothing = cspace(&["site", &place(""), "-o", &out]);
    fails(nothing, 2, &["there is no .toml file"]);
    std::fs::write(place("mine.txt"), "").unwrap();
    let taken = cspace(&["site", &latch, "-o", &place("")]);
    fails(taken, 2, &["not empty", "a new or empty folder"]);
    fails(cspace(&["site", &latch]), 2, &["--output <DIR>"]);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}
