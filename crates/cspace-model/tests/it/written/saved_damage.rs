//! Errors for files that are no contact spaces, or damaged ones: an error, never a panic.

use cspace::{Configuration, ContactSpace, Options};
use cspace_model::write::mesh::{Mesh, MeshOptions};
use cspace_model::{Document, model, saved};
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

fn space() -> ContactSpace {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/ball_in_c.toml");
    let model = model::read(path).unwrap();
    let part = |i: usize| &model.parts[i].part;
    ContactSpace::compute(part(0), part(1), &Options::default()).unwrap()
}

/// Error message and help for the text.
fn refusal(text: &str) -> String {
    let e = saved::from_json(text, "space.json").unwrap_err();
    format!("{e} | {}", e.help().unwrap_or_default())
}

#[test]
fn other_versions_and_other_files_are_told_apart() {
    for (text, words) in [
        (
            r#"{"format": "contact-space", "version": 2}"#,
            ["version is 2", "reads version 1"],
        ),
        (
            r#"{"format": "contact-space", "version": "1"}"#,
            ["version is \"1\"", "cspace export"],
        ),
        (
            r#"{"format": "contact-space", "version": -1}"#,
            ["version is -1", "cspace export"],
        ),
        (
            r#"{"format": "contact-space"}"#,
            ["version is missing", "cspace export"],
        ),
        (
            r#"{"format": "contact-space", "version": 1}"#,
            ["space.json:1:41", "missing field"],
        ),
        (
            r#"{"format": "mesh", "version": 1}"#,
            ["\"mesh\"", "contact-space"],
        ),
        (r#"{"format": 3}"#, ["the format is 3", "contact-space"]),
        (r#"{"part": []}"#, ["no contact space", "\"format\""]),
        ("[1, 2]", ["not an object", "cspace export"]),
        ("", ["EOF", "is the file whole?"]),
    ] {
        let said = refusal(text);
        for word in words {
            assert!(said.contains(word), "{text}: no {word:?} in {said}");
        }
    }
}

#[test]
fn a_file_is_a_model_or_a_space_by_its_content() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.json");
    let write = |text: &str| std::fs::write(&path, text).unwrap();
    write(&saved::to_json(&space()));
    assert!(matches!(
        cspace_model::read(&path).unwrap(),
        Document::Space(_)
    ));
    // With a byte order mark, too.
    write(&format!("\u{feff}{}", saved::to_json(&space())));
    assert!(matches!(
        cspace_model::read(&path).unwrap(),
        Document::Space(_)
    ));
    write(r#"{"part": [{"name": "pin", "loops": [[[6, 0, 1], [8, 0, 1]]]}]}"#);
    assert!(matches!(
        cspace_model::read(&path).unwrap(),
        Document::Model(_)
    ));
    write(r#"{"format": "contact_space"}"#);
    let error = cspace_model::read(&path).unwrap_err();
    assert!(error.message().contains("contact_space"), "{error}");
    write(r#"{"format": "contact-space", "version": 1, "fi"#);
    let error = cspace_model::read(&path).unwrap_err();
    assert_eq!(error.line(), Some(1));
}

#[test]
fn what_does_not_fit_together_is_refused() {
    let good: Value = serde_json::from_str(&saved::to_json(&space())).unwrap();
    let far = json!(u32::MAX);
    for (pointer, to, word) in [
        ("/patches/0/region", far.clone(), "patch 0"),
        (
            "/patches/0/fixed/loop_index",
            far.clone(),
            "no such feature",
        ),
        ("/patches/1/moving/index", far.clone(), "no such feature"),
        ("/patches/2/lo", json!(100), "no interval"),
        ("/patches/2/hi", json!(1e300), "no interval"),
        ("/side_links/0/before", far.clone(), "side link 0"),
        ("/side_links/1/after", far.clone(), "side link 1"),
        ("/side_links/0/hi", json!(-50), "side link 0"),
        ("/vertical_links/0/lower", far.clone(), "vertical link 0"),
        ("/vertical_links/0/upper", far.clone(), "vertical link 0"),
        ("/free_regions/0/patches", far, "free region 0"),
        ("/window/hi", json!(1e9), "window"),
        ("/frame/scale", json!(0), "scale"),
        ("/frame/scale", json!(1e-310), "scale"),
        ("/frame/scale", json!(1), "scale"),
        ("/frame/fixed_center/y", json!(8), "centre"),
        ("/frame/moving_center/x", json!(1e-6), "centre"),
        ("/features/fixed", json!(1_000_000), "features"),
        ("/critical_orientations/0", json!(4), "critical"),
        ("/critical_orientations/1", json!(-3.2), "critical"),
        ("/doubtful_orientations", json!([[1, 0.5]]), "doubtful"),
        ("/doubtful_orientations", json!([[3, 7]]), "doubtful"),
        (
            "/doubtful_orientations",
            json!([[0, 1], [0.5, 2]]),
            "doubtful",
        ),
        ("/doubtful_orientations", json!([0.5]), "invalid type"),
        ("/fixed/loops", json!([]), "no loops"),
        ("/side_links/0/before", json!(-1), "invalid value"),
        ("/patches/0/left/kind", json!("middle"), "unknown variant"),
        ("/patches/0/lo", Value::Null, "invalid type: null"),
    ] {
        let mut bad = good.clone();
        *bad.pointer_mut(pointer).unwrap() = to;
        let said = refusal(&bad.to_string());
        assert!(said.contains(word), "{pointer}: {said}");
        assert!(said.contains("cspace export"), "{pointer}: {said}");
    }
    // A number beyond all doubles is refused by the reader of JSON.
    let text = good
        .to_string()
        .replacen("\"lo\":", "\"lo\":1e999, \"x\":", 1);
    assert!(refusal(&text).contains("out of range"));
}

/// Another place of one end of one patch, or another circle, is seen at its neighbours.
#[test]
fn patches_that_do_not_fit_are_refused() {
    let good: Value = serde_json::from_str(&saved::to_json(&space())).unwrap();
    let mut leaves = Vec::new();
    collect(&good, String::new(), &mut leaves);
    let parts = ["/left/spiral/", "/right/spiral/", "/function/center/"];
    let is_place = |at: &&String| parts.iter().any(|p| at.contains(p));
    let places: Vec<&String> = leaves
        .iter()
        .filter(|at| at.starts_with("/patches/"))
        .filter(is_place)
        .collect();
    assert!(places.len() > 100);
    for at in places {
        let mut bad = good.clone();
        let value = bad.pointer_mut(at).unwrap();
        *value = json!(value.as_f64().unwrap() + 0.1);
        let said = refusal(&bad.to_string());
        let is_told = ["patch ", "side link "].iter().any(|w| said.contains(w));
        assert!(is_told && said.contains("is damaged"), "{at}: {said}");
    }
}

#[test]
fn a_part_of_a_file_is_no_file() {
    let text = saved::to_json(&space());
    let last = text.trim_end().len();
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for _ in 0..300 {
        let end = rng.random_range(0..last);
        let said = refusal(&text[..end]);
        assert!(said.contains("the file is no JSON"), "{end}: {said}");
    }
}

/// Asks a space that was read all queries: whatever the answers, there are some.
fn use_it(space: &ContactSpace) {
    for theta in [-3.0, 0.0, 0.3, 2.0] {
        let slice = space.slice(theta);
        assert!(slice.loops.len() <= slice.curves.len());
        let c = Configuration::new(0.1, 0.2, theta);
        let _ = slice.is_free(c.position());
        let _ = space.classify(c);
    }
    for band in space.bands().into_iter().take(5) {
        let _ = space.loops(band);
    }
    let _ = space.resolution();
}

#[test]
fn flipped_bits_do_no_harm() {
    let text = saved::to_json(&space());
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    let mut read = 0;
    for _ in 0..500 {
        let mut bytes = text.clone().into_bytes();
        for _ in 0..rng.random_range(1..4) {
            let at = rng.random_range(0..bytes.len());
            bytes[at] ^= 1 << rng.random_range(0..8);
        }
        let Ok(damaged) = String::from_utf8(bytes) else {
            continue;
        };
        if let Ok(space) = saved::from_json(&damaged, "space.json") {
            use_it(&space);
            read += 1;
        }
    }
    // A digit far behind the point is a number all the same.
    assert!(read > 0);
}

#[test]
fn exchanged_values_do_no_harm() {
    let good: Value = serde_json::from_str(&saved::to_json(&space())).unwrap();
    let mut leaves = Vec::new();
    collect(&good, String::new(), &mut leaves);
    let values = [
        json!(0),
        json!(1),
        json!(-1),
        json!(2),
        json!(7),
        json!(0.5),
        json!(-3.0),
        json!(1e-300),
        json!(1e300),
        json!(-1e300),
        json!(4_294_967_295u32),
        json!(18_446_744_073_709_551_615u64),
        json!("line"),
        json!("contact-space"),
        json!(true),
        json!([]),
        json!({}),
        Value::Null,
    ];
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let (mut read, mut refused) = (0, 0);
    for _ in 0..500 {
        let mut bad = good.clone();
        for _ in 0..rng.random_range(1..3) {
            let at = leaves.choose(&mut rng).unwrap();
            let to = values.choose(&mut rng).unwrap();
            *bad.pointer_mut(at).unwrap() = to.clone();
        }
        match saved::from_json(&bad.to_string(), "space.json") {
            Ok(space) => {
                use_it(&space);
                // Meshes take longer.
                if read % 20 == 0 {
                    let _ = Mesh::new(&space, &MeshOptions { tolerance: 0.2 });
                }
                read += 1;
            }
            Err(e) => {
                assert!(!e.message().is_empty() && e.help().is_some());
                refused += 1;
            }
        }
    }
    assert!(read > 0 && refused > 0, "{read} {refused}");
}

fn collect(value: &Value, at: String, leaves: &mut Vec<String>) {
    match value {
        Value::Object(map) => map
            .iter()
            .for_each(|(k, v)| collect(v, format!("{at}/{k}"), leaves)),
        Value::Array(list) => list
            .iter()
            .enumerate()
            .for_each(|(i, v)| collect(v, format!("{at}/{i}"), leaves)),
        _ => leaves.push(at),
    }
}
