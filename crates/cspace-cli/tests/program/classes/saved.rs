//! Files of every class, written and read again.

use serde_json::Value;

use crate::helpers::{PAIRS, classes, cspace, fails, json, mechanism, printed};

#[test]
fn slices_and_pictures_of_fixed_axes_show_the_plane_of_the_motions() {
    let file = mechanism();
    let dir = tempfile::tempdir().unwrap();
    let pair = ["--pair", "driver,link"];
    let text = printed(&["slice", &file, pair[0], pair[1]]);
    assert!(
        text.starts_with("driver (fixed, u), link (moving, v): 4 contact curves"),
        "{text}"
    );
    let plane = json(&["slice", &file, pair[0], pair[1]]);
    assert_eq!(plane["space"]["patches"].as_array().unwrap().len(), 4);
    let by = |command: &str, name: &str| {
        let out = dir.path().join(name);
        printed(&[
            command,
            &file,
            pair[0],
            pair[1],
            "-o",
            out.to_str().unwrap(),
        ]);
        std::fs::read_to_string(out).unwrap()
    };
    let picture = by("slice", "a.svg");
    assert!(
        picture.starts_with("<svg") || picture.starts_with("<?xml"),
        "{picture}"
    );
    assert!(picture.contains(">ratchet mechanism: link relative to driver, lengths in mm<"));
    assert_eq!(picture, by("export", "b.svg"));
}

/// A summary without what depends on the clock, and on whether the space was read.
fn timeless(mut value: Value) -> Value {
    value[0]["seconds"] = Value::Null;
    value[0]["cached"] = Value::Null;
    value
}

#[test]
fn saved_spaces_of_every_class_answer_as_their_models_do() {
    let dir = tempfile::tempdir().unwrap();
    let file = mechanism();
    for (pair, class) in PAIRS {
        let saved = dir.path().join(format!("{class}.json"));
        let saved = saved.to_str().unwrap();
        let model = [file.as_str(), "--pair", pair];
        printed(&[&["export"], &model[..], &["-o", saved]].concat());
        // Writing it again changes nothing.
        let again = dir.path().join("again.json");
        printed(&["export", saved, "-o", again.to_str().unwrap()]);
        assert!(
            std::fs::read(saved).unwrap() == std::fs::read(again).unwrap(),
            "{pair}"
        );

        let info = json(&["info", saved]);
        assert_eq!(info["pairs"][0]["class"], class, "{pair}");
        // What the model says of itself is there again.
        assert_eq!(info["name"], "ratchet mechanism");
        assert_eq!(info["unit"], "mm");
        let text = printed(&["compute", saved]);
        assert!(
            text.contains("  model          ratchet mechanism\n"),
            "{text}"
        );
        assert!(text.contains(" mm; a clearance below "), "{text}");
        let summary = |args: &[&str]| timeless(json(&[&["compute"], args].concat()));
        assert_eq!(summary(&[saved]), summary(&model), "{pair}");

        let (header, rows) = if class == "fixed-axes" {
            (
                "u,v",
                vec![vec![0.0, 0.0], vec![1.0, 0.3], vec![3.2, -0.0141]],
            )
        } else {
            let rows = [[0.0, 0.0, 0.0], [3.0, 200.0, 0.4], [0.0, 1.0, 0.1]];
            ("x,y,theta", rows.map(|r| r.to_vec()).into())
        };
        let classified = classes(&[saved], header, &rows);
        assert_eq!(classified, classes(&model, header, &rows), "{pair}");

        match class {
            "lower" => {
                assert_eq!(classified, ["contact", "blocked", "blocked"], "{pair}");
                fails(cspace(&["slice", saved]), 2, &["lower", "--general"]);
                let joint = &info["joints"][0];
                assert_eq!(joint["type"], "revolute");
            }
            "fixed-axes" => {
                assert_eq!(classified, ["free", "blocked", "free"]);
                assert_eq!(
                    printed(&["slice", saved]),
                    printed(&[&["slice"], &model[..]].concat())
                );
                let motion = &info["parts"][1]["motion"];
                assert_eq!(motion["type"], "revolute");
                assert!(motion["range"].is_array());
                fails(cspace(&["slice", saved, "--theta", "1"]), 2, &["--theta"]);
            }
            _ => {
                assert_eq!(classified[..2], ["free", "free"]);
                let slice = |args: &[&str]| json(&[&["slice", "--theta", "0.3"], args].concat());
                let (a, b) = (slice(&[saved]), slice(&model));
                let curves = |s: &Value| s["curves"].as_array().unwrap().len();
                assert_eq!(curves(&a), curves(&b));
            }
        }
        fails(
            cspace(&["compute", saved, "--general"]),
            2,
            &["--general", class, "saved", "model"],
        );
        fails(
            cspace(&["compute", saved, "--window", "0,1"]),
            2,
            &["--window", "saved"],
        );
        fails(cspace(&["compute", saved, "--pair", "a,b"]), 2, &[pair]);
    }
    // Files of earlier versions have neither name nor unit.
    let saved = dir.path().join("lower.json");
    let mut old: Value = serde_json::from_slice(&std::fs::read(&saved).unwrap()).unwrap();
    for key in ["name", "unit"] {
        assert!(old.as_object_mut().unwrap().remove(key).is_some());
    }
    std::fs::write(&saved, old.to_string()).unwrap();
    let info = json(&["info", saved.to_str().unwrap()]);
    assert_eq!(info["name"], "link and pawl");
    assert_eq!(info.get("unit"), None);
    // What the general method made stays general.
    let saved = dir.path().join("general.json");
    let saved = saved.to_str().unwrap();
    printed(&[
        "export",
        &file,
        "--pair",
        "driver,link",
        "--general",
        "-o",
        saved,
    ]);
    for args in [&["info", saved][..], &["info", saved, "--general"]] {
        assert_eq!(json(args)["pairs"][0]["class"], "general");
    }
    assert_eq!(
        json(&["compute", saved, "--general"])[0]["class"],
        "general"
    );
    printed(&["slice", saved, "--theta", "0.1"]);
}
