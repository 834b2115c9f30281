//! What is said of bad model files, and that good ones are read.

#![allow(clippy::unwrap_used)]

use cspace_io::{Model, ModelError, PairClass};

const SQUARE: &str = "[[0, 0], [1, 0], [1, 1], [0, 1]]";

fn error(toml: &str) -> ModelError {
    Model::from_toml(toml, "m.toml").unwrap_err()
}

/// Asserts that an error, with its help, has all the words.
fn says(error: &ModelError, words: &[&str]) {
    let all = format!("{error} | {}", error.help().unwrap_or_default());
    for w in words {
        assert!(all.contains(w), "{w:?} is not in: {all}");
    }
}

fn part(name: &str, rest: &str) -> String {
    format!("[[part]]\nname = \"{name}\"\n{rest}\n")
}

#[test]
fn the_shipped_models_are_read() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models");
    let mut read = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "toml") {
            let model = Model::read(&path).unwrap();
            assert!(!model.pairs.is_empty(), "{path:?}");
            read += 1;
        }
    }
    assert!(read >= 6);
}

#[test]
fn toml_and_json_are_the_same() {
    let toml = format!(
        "name = \"n\"\nunit = \"mm\"\n{}{}[[pair]]\nfixed = \"b\"\nmoving = \"a\"\ntheta = [\"-10deg\", 0.5]\n",
        part(
            "a",
            &format!("loops = [{SQUARE}]\nmotion = {{ type = \"revolute\", center = [0, 0] }}")
        ),
        part("b", &format!("loops = [{SQUARE}]")),
    );
    let json = format!(
        r#"{{"name": "n", "unit": "mm", "part": [
            {{"name": "a", "loops": [{SQUARE}], "motion": {{"type": "revolute", "center": [0, 0]}}}},
            {{"name": "b", "loops": [{SQUARE}]}}],
            "pair": [{{"fixed": "b", "moving": "a", "theta": ["-10deg", 0.5]}}]}}"#
    );
    let a = Model::from_toml(&toml, "m.toml").unwrap();
    assert_eq!(a, Model::from_json(&json, "m.json").unwrap());
    assert_eq!(a.pair_class(&a.pairs[0]), PairClass::General);
    assert!((a.pairs[0].window.unwrap().0 + 10f64.to_radians()).abs() < 1e-15);
}

#[test]
fn errors_name_the_place_and_say_what_to_do() {
    says(&error(""), &["m.toml", "no parts", "[[part]]"]);
    says(&error("[[part]\n"), &["m.toml", "line 1"]);
    says(&error("x = = 2"), &["line 1, column 5"]);
    says(
        &error(&part("a", &format!("loop = [{SQUARE}]"))),
        &["part 0 \"a\"", "unknown key \"loop\"", "`loops`"],
    );
    says(
        &error(&part("a", "")),
        &["part 0 \"a\"", "`loops` is missing"],
    );
    says(
        &error(&part("a", "loops = 3")),
        &["`loops` is the number 3", "a list"],
    );
    says(&error(&part("a", "dxf = \"a.dxf\"")), &["DXF", "loops"]);
    says(&error(&part("a", "loops = []")), &["part 0 \"a\""]);
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 0], [1]]]")),
        &["loop 0, vertex 2", "[x, y, bulge]"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 0], [1, 1, 0, 0]]]")),
        &["loop 0, vertex 2"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, \"0\"], [1, 1]]]")),
        &["loop 0, vertex 1", "\"0\""],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, nan], [1, 1]]]")),
        &["loop 0, vertex 1", "finite"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 0]]]")),
        &["part 0 \"a\"", "loop 0"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 0], [1, 0], [0, 1]]]")),
        &["loop 0", "vert"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 1], [1, 0], [0, 1]]]")),
        &["loop 0"],
    );
    let two = format!(
        "{}{}",
        part("a", &format!("loops = [{SQUARE}]")),
        part("a", &format!("loops = [{SQUARE}]"))
    );
    says(&error(&two), &["part 1 \"a\"", "part 0"]);
    says(
        &error(&part(" ", &format!("loops = [{SQUARE}]"))),
        &["part 0", "empty"],
    );
    let motion = |m: &str| part("a", &format!("loops = [{SQUARE}]\nmotion = {m}"));
    says(
        &error(&motion("{ type = \"revolut\", center = [0, 0] }")),
        &["motion", "`revolute`"],
    );
    says(
        &error(&motion("{ type = \"revolute\" }")),
        &["`center` is missing"],
    );
    says(
        &error(&motion("{ type = \"prismatic\", direction = [0, 0] }")),
        &["direction is zero"],
    );
    says(
        &error(&motion(
            "{ type = \"revolute\", center = [0, 0], range = [1, -1] }",
        )),
        &["reversed"],
    );
    says(
        &error(&part("a", &format!("loops = [{SQUARE}]\nsymmetry = 0"))),
        &["`symmetry`"],
    );
}

#[test]
fn errors_in_pairs_and_joints() {
    let parts = format!(
        "{}{}",
        part("wheel", &format!("loops = [{SQUARE}]")),
        part("pawl", &format!("loops = [{SQUARE}]"))
    );
    let pair = |p: &str| error(&format!("{parts}[[pair]]\n{p}\n"));
    says(
        &pair("fixed = \"wheal\"\nmoving = \"pawl\""),
        &["pair 0", "\"wheal\"", "`wheel`"],
    );
    says(
        &pair("fixed = \"pawl\"\nmoving = \"pawl\""),
        &["pair 0", "itself"],
    );
    says(&pair("fixed = \"wheel\""), &["`moving` is missing"]);
    says(
        &pair("fixed = \"wheel\"\nmoving = \"pawl\"\ntheta = [1, 0]"),
        &["pair 0", "reversed"],
    );
    says(
        &pair("fixed = \"wheel\"\nmoving = \"pawl\"\ntheta = [0, 7]"),
        &["more than a turn"],
    );
    says(
        &pair("fixed = \"wheel\"\nmoving = \"pawl\"\ntheta = [0, inf]"),
        &["theta"],
    );
    says(
        &pair(
            "fixed = \"wheel\"\nmoving = \"pawl\"\n[[pair]]\nfixed = \"pawl\"\nmoving = \"wheel\"",
        ),
        &["pair 1", "pair 0"],
    );
    let joint = |j: &str| error(&format!("{parts}[[joint]]\n{j}\n"));
    says(
        &joint("type = \"rigid\"\nparts = [\"wheel\"]"),
        &["joint 0", "two"],
    );
    says(
        &joint("type = \"rigit\"\nparts = [\"wheel\", \"pawl\"]"),
        &["joint 0", "`rigid`"],
    );
    says(
        &joint("type = \"revolute\"\nparts = [\"wheel\", \"pawl\"]"),
        &["`at` is missing"],
    );
}

#[test]
fn errors_of_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    };
    let read = |p: &std::path::Path| Model::read(p).unwrap_err();
    says(
        &read(&folder.path().join("none.toml")),
        &["none.toml", "cannot be read"],
    );
    says(&read(&path("a.txt", b"")), &["a.txt", ".toml"]);
    says(
        &read(&path("b.toml", &[0x66, 0xff, 0x00])),
        &["b.toml", "not text"],
    );
    says(
        &read(&path("c.json", b"{\"part\": [}")),
        &["c.json", "line 1"],
    );
    std::fs::create_dir(folder.path().join("d.toml")).unwrap();
    says(&read(&folder.path().join("d.toml")), &["folder"]);
}
