//! Slips are reported, and nothing else is.

use cspace_model::model::{self, slips};

fn told(text: &str) -> Vec<String> {
    let model = model::from_toml(text, "m.toml").unwrap();
    slips(&model).iter().map(ToString::to_string).collect()
}

fn part(name: &str, loops: &str, motion: &str) -> String {
    format!("[[part]]\nname = \"{name}\"\nloops = {loops}\nmotion = {motion}\n")
}

const SQUARE: &str = "[[[0, 0], [2, 0], [2, 2], [0, 2]]]";
const SMALL: &str = "[[[0.5, 0.5], [1, 0.5], [1, 1], [0.5, 1]]]";

#[test]
fn degrees_without_their_unit() {
    let turning = |range: &str| {
        told(&part(
            "a",
            SQUARE,
            &format!("{{ type = \"revolute\", center = [0, 0], range = {range} }}"),
        ))
    };
    assert_eq!(turning("[-90, 90]").len(), 1);
    for sound in ["[-1, 1]", "[\"-720deg\", \"720deg\"]", "[-6.5, 7.5]"] {
        assert!(turning(sound).is_empty(), "{sound}");
    }
    let sliding = "{ type = \"prismatic\", direction = [1, 0], range = [-90, 90] }";
    assert!(told(&part("a", SQUARE, sliding)).is_empty());
}

#[test]
fn bulges_that_are_radii() {
    let planar = "{ type = \"planar\" }";
    assert_eq!(
        told(&part("a", "[[[0, 0, 5], [2, 0], [1, 1]]]", planar)).len(),
        1
    );
    let drawn = "[[[0, 0, 2.4142135623730951], [2, 0]]]";
    assert!(told(&part("a", drawn, planar)).is_empty());
}

#[test]
fn arcs_that_miss_their_lines() {
    // A slot of radius 1: the end's arc is a half circle, and a bulge of 0.9998 misses it by 4 atan(1) / 2 − 4 atan(0.9998) / 2.
    let slot = |b: f64| {
        let loops = format!("[[[0, -1], [4, -1, {b}], [4, 1], [0, 1, 1]]]");
        told(&part("slot", &loops, "{ type = \"planar\" }"))
    };
    assert!(slot(1.0).is_empty());
    let miss = 2.0 * (1.0_f64.atan() - 0.9998_f64.atan());
    let told = slot(0.9998);
    assert_eq!(told.len(), 2, "{told:?}");
    for (line, vertex) in told.iter().zip([1, 2]) {
        let words =
            format!("loop 0, vertex {vertex}: a line and an arc miss tangency by {miss:.1e} rad");
        assert!(line.contains(&words), "{line}");
    }
    // The same loop the other way around.
    let back = "[[[0, 1, 0], [4, 1, -0.9998], [4, -1, 0], [0, -1, -1]]]";
    let model = part("slot", back, "{ type = \"planar\" }");
    let model = model::from_toml(&model, "m.toml").unwrap();
    let found: Vec<String> = slips(&model).iter().map(ToString::to_string).collect();
    assert!(
        found.len() == 2
            && found.iter().any(|s| s.contains("vertex 1"))
            && found.iter().any(|s| s.contains("vertex 2")),
        "{found:?}"
    );
    // A corner of a degree is meant.
    assert!(slot(0.99).is_empty());
}

#[test]
fn parts_within_each_other_and_of_other_units() {
    let fixed = "{ type = \"fixed\" }";
    let turns = "{ type = \"revolute\", center = [1, 1] }";
    let both =
        |a: &str, b: &str, motion: &str| told(&(part("a", a, fixed) + &part("b", b, motion)));
    assert!(both(SQUARE, SMALL, turns)[0].contains("\"b\" lies in the material of \"a\""));
    assert!(both(SMALL, SQUARE, turns)[0].contains("\"a\" lies in the material of \"b\""));
    assert!(both(SQUARE, SMALL, "{ type = \"planar\" }").is_empty());
    let ring =
        "[[[0, 0], [2, 0], [2, 2], [0, 2]], [[0.4, 0.4], [1.1, 0.4], [1.1, 1.1], [0.4, 1.1]]]";
    assert!(both(ring, SMALL, turns).is_empty());
    let tiny = "[[[0, 0], [0.001, 0], [0, 0.001]]]";
    assert!(both(SQUARE, tiny, "{ type = \"planar\" }")[0].contains("2000 times as large"));
}

#[test]
fn no_shipped_model_has_any() {
    for folder in ["models", "models/paper"] {
        let folder = format!("{}/../../{folder}", env!("CARGO_MANIFEST_DIR"));
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|e| e == "toml") {
                let found = slips(&model::read(&path).unwrap());
                assert!(found.is_empty(), "{}: {found:?}", path.display());
            }
        }
    }
}
