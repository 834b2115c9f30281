//! The command, as a user runs it.

use std::path::PathBuf;

use serde_json::Value;

use crate::helpers::{cspace, fails, file, framed, json, model, printed, unframed};
use crate::page;

const MODELS: [&str; 15] = [
    "ball_in_c",
    "cam_follower",
    "cam_plate",
    "cam_tappet",
    "escapement",
    "fixture_plate",
    "gears",
    "gears_on_shafts",
    "geneva",
    "knee",
    "peg_hole",
    "rack_pinion",
    "ratchet_mechanism",
    "ratchet_pawl",
    "snap_fastener",
];

#[test]
fn info_counts_features_as_the_computation_does() {
    for name in MODELS {
        let file = model(name);
        let info = json(&["info", &file]);
        let part = |i: usize| info["parts"][i]["features"]["total"].clone();
        if name == "gears_on_shafts" {
            assert_eq!(info["pairs"][0]["class"], "fixed-axes");
            continue;
        }
        let result = &json(&["compute", &file])[0];
        assert_eq!(result["class"], info["pairs"][0]["class"], "{name}");
        for (of, i) in [("fixed", 0), ("moving", 1)] {
            let fold = &info["parts"][i]["symmetry"];
            assert_eq!(&result["symmetry"][of], fold, "{name}");
        }
        assert_eq!(result["features"]["fixed"], part(0), "{name}");
        assert_eq!(result["features"]["moving"], part(1), "{name}");
        assert_eq!(
            result["features"]["total"], info["pairs"][0]["features"],
            "{name}"
        );
        assert!(printed(&["info", &file]).contains("pairs\n"), "{name}");
    }
}

#[test]
fn models_have_the_regions_that_their_readme_tells() {
    let regression = format!(
        "{}/../../tests/regression/disc_in_annulus.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    for (file, regions) in [
        (model("ball_in_c"), 2),
        (model("cam_follower"), 1),
        (model("fixture_plate"), 8),
        (model("knee"), 1),
        (model("peg_hole"), 1),
        (model("ratchet_pawl"), 1),
        (model("snap_fastener"), 2),
        (regression, 2),
    ] {
        let r = &json(&["compute", &file])[0];
        assert_eq!(r["free_regions"], regions, "{file}");
    }
}

#[test]
fn compute_has_the_keys_of_the_contract() {
    let file = model("ratchet_pawl");
    let all = json(&["compute", &file]);
    assert_eq!(all.as_array().unwrap().len(), 1);
    let r = &all[0];
    assert_eq!(r["fixed"], "ratchet");
    assert_eq!(r["moving"], "pawl");
    assert_eq!(r["class"], "symmetric");
    assert_eq!(
        r["features"],
        serde_json::json!({"fixed": 80, "moving": 7, "total": 87})
    );
    assert_eq!(r["symmetry"], serde_json::json!({"fixed": 20, "moving": 1}));
    let critical = r["critical_orientations"].as_array().unwrap();
    assert_eq!(r["bands"].as_u64().unwrap() as usize, critical.len());
    assert_eq!(
        r["slices"].as_u64().unwrap() * 20,
        r["bands"].as_u64().unwrap()
    );
    for key in [
        "/patches",
        "/links/side",
        "/links/vertical",
        "/free_regions",
    ] {
        assert!(r.pointer(key).unwrap().as_u64().unwrap() > 0, "{key}");
    }
    assert!(r["seconds"]["total"].as_f64().unwrap() > 0.0);
}

#[test]
fn the_general_method_can_be_asked_for() {
    let file = model("ratchet_pawl");
    let symmetric = json(&["compute", &file]);
    let general = json(&["compute", &file, "--general"]);
    let (s, g) = (&symmetric[0], &general[0]);
    assert_eq!(g["class"], "general");
    assert_eq!(g["symmetry"], serde_json::json!({"fixed": 1, "moving": 1}));
    assert_eq!(g["slices"], g["bands"]);
    for key in ["bands", "patches", "links", "free_regions", "features"] {
        assert_eq!(s[key], g[key], "{key}");
    }
    let text = printed(&["compute", &file]);
    assert!(text.contains("symmetry       20-fold, none"), "{text}");
    assert!(text.contains("were computed"), "{text}");
    let text = printed(&["info", &file]);
    assert!(text.contains("symmetry   20-fold"), "{text}");
    assert!(text.contains("symmetric"), "{text}");
}

#[test]
fn compute_takes_a_window_and_any_number_of_threads() {
    let file = model("ratchet_pawl");
    let run = |threads: &str| {
        let mut value = json(&[
            "compute",
            &file,
            "--window",
            "-10deg,10deg",
            "--general",
            "--threads",
            threads,
        ]);
        value[0]["seconds"] = Value::Null;
        value
    };
    let one = run("1");
    assert_eq!(one, run("4"));
    assert_eq!(one[0]["window"]["full_turn"], false);
    let lo = one[0]["window"]["lo"].as_f64().unwrap();
    assert!((lo + 10f64.to_radians()).abs() < 1e-15);
    let text = printed(&["compute", &file, "--window=-10deg,10deg"]);
    assert!(
        text.contains("orientations   from -0.174533 rad (-10.0000 deg)"),
        "{text}"
    );
}

#[test]
fn compute_tells_caged_regions() {
    let text = printed(&["compute", &model("ball_in_c")]);
    assert!(text.contains("2 connected regions, 1 caged"), "{text}");
}

#[test]
fn a_pair_may_be_exchanged() {
    let result = &json(&["compute", &model("ball_in_c"), "--pair", "ball,clip"]);
    assert_eq!(result[0]["fixed"], "ball");
    assert_eq!(result[0]["moving"], "clip");
}

#[test]
fn slice_names_features_and_draws() {
    let dir = tempfile::tempdir().unwrap();
    let file = model("ratchet_pawl");
    let text = printed(&["slice", &file, "--theta", "5deg"]);
    assert!(
        text.contains("loop 0:") && text.contains("of ratchet"),
        "{text}"
    );
    let slice = json(&["slice", &file, "--theta=-0.1"]);
    assert_eq!(slice["theta"], -0.1);
    assert!(!slice["curves"].as_array().unwrap().is_empty());
    let out = dir.path().join("slice.svg");
    printed(&["slice", &file, "--theta", "0", "-o", out.to_str().unwrap()]);
    assert!(std::fs::read_to_string(out).unwrap().starts_with("<svg"));
}

/// A disc in a slot of its own width slides along a line: that is free if exact fits are asked for, in every form of the answer.
#[test]
fn slices_have_exact_fits() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let file = path("slot.toml");
    let text = r#"
[[part]]
name = "plate"
loops = [[[-9, -9], [9, -9], [9, 9], [-9, 9]], [[-4, -2], [4, -2], [4, 2], [-4, 2]]]
[[part]]
name = "disc"
loops = [{ circle = 2, at = [0, 0] }]
"#;
    std::fs::write(&file, text).unwrap();
    let at = ["slice", &file, "--theta", "0.3"];
    assert!(printed(&at).contains("1 loop, "));
    let exact = [&at[..], &["--exact"]].concat();
    let text = printed(&exact);
    assert!(text.contains("2 loops, "), "{text}");
    let slice = json(&exact);
    let slit = slice["loops"].as_array().unwrap().iter();
    let slit = slit.map(|l| l.as_array().unwrap()).find(|l| l.len() == 2);
    let mut ends: Vec<f64> = (slit.unwrap().iter())
        .map(|i| {
            let start =
                &slice["curves"][i.as_u64().unwrap() as usize]["geometry"]["segment"]["start"];
            assert!(start["y"].as_f64().unwrap().abs() < 1e-12);
            start["x"].as_f64().unwrap()
        })
        .collect();
    ends.sort_by(f64::total_cmp);
    assert!(
        (ends[0] + 2.0).abs() < 1e-12 && (ends[1] - 2.0).abs() < 1e-12,
        "{ends:?}"
    );
    for out in [path("slice.svg"), path("slice.dxf"), path("slice.png")] {
        printed(&[&exact[..], &["-o", &out]].concat());
        assert!(std::fs::metadata(out).unwrap().len() > 500);
    }
    // A saved space has its parts; two motions have a plane and no slices.
    let saved = path("space.json");
    printed(&["export", &file, "-o", &saved]);
    assert!(printed(&["slice", &saved, "--theta", "0.3", "--exact"]).contains("2 loops, "));
    let plane = cspace(&["slice", &model("cam_tappet"), "--exact"]);
    fails(plane, 2, &["--exact", "--general"]);
}

/// Where the patches of a space are in doubt, a slice of them says so; that of the model itself need not be.
#[test]
fn slices_say_that_they_are_doubtful() {
    let dir = tempfile::tempdir().unwrap();
    let file = format!(
        "{}/../../tests/regression/half_disc_in_a_socket_of_its_radius.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    let space = dir.path().join("space.json");
    let space = space.to_str().unwrap();
    printed(&["export", &file, "-o", space]);
    let doubtful = |file: &str, theta: &str| {
        let slice = json(&["slice", file, "--theta", theta]);
        let doubtful = slice["doubtful"].as_bool().unwrap();
        let text = printed(&["slice", file, "--theta", theta]);
        assert_eq!(text.contains("\ndoubtful: "), doubtful, "{text}");
        doubtful
    };
    assert!(doubtful(space, "1") && !doubtful(space, "2"));
    assert!(!doubtful(&file, "1") && !doubtful(&file, "2"));
}

const CONFIGURATIONS: &str = "theta,name,x,y\n0,engaged,42,56\n0,inside,0,0\n1,far,1000,0\n";

#[test]
fn classify_repeats_the_columns() {
    let answer =
        "theta,name,x,y,class\n0,engaged,42,56,free\n0,inside,0,0,blocked\n1,far,1000,0,free\n";
    let file = model("ratchet_pawl");
    cspace(&["classify", &file])
        .write_stdin(CONFIGURATIONS)
        .assert()
        .success()
        .stdout(answer);
    let dir = tempfile::tempdir().unwrap();
    let saved = dir.path().join("space.json");
    let saved = saved.to_str().unwrap();
    printed(&["export", &file, "-o", saved]);
    cspace(&["classify", saved])
        .write_stdin(CONFIGURATIONS)
        .assert()
        .success()
        .stdout(answer);
}

#[test]
fn classify_tells_contact() {
    // A corner of a slice is in contact; the distance within which it is, is the resolution.
    let file = model("peg_hole");
    let slice = json(&["slice", &file, "--theta", "0.3"]);
    let segment = (slice["curves"].as_array().unwrap().iter())
        .find_map(|c| c["geometry"].get("segment"))
        .unwrap();
    let rows = format!(
        "x,y,theta\n{},{},0.3\n",
        segment["start"]["x"], segment["start"]["y"]
    );
    let output = cspace(&["classify", &file])
        .write_stdin(rows)
        .assert()
        .success();
    let text = String::from_utf8(output.get_output().stdout.clone()).unwrap();
    assert!(text.trim_end().ends_with(",contact"), "{text}");
}

/// Thousands of rows are answered in another way than a few; the answers are the same, of models, of saved graphs and in
/// windows, where orientations count modulo a turn.
#[test]
fn classify_answers_many_rows_as_it_does_few() {
    let file = model("ratchet_pawl");
    let directory = tempfile::tempdir().unwrap();
    let saved = directory.path().join("space.json");
    let saved = saved.to_str().unwrap();
    let window = "--window=-0.3,0.4";
    cspace(&["export", &file, "-o", saved, window])
        .assert()
        .success();
    // A low-discrepancy sequence, on both sides of the window's turn.
    let rows: Vec<String> = (0..5000)
        .map(|i| {
            let share = |a: f64| (f64::from(i) * a).fract();
            let (x, y) = (200.0 * share(0.7548) - 100.0, 200.0 * share(0.5698) - 100.0);
            let turn = core::f64::consts::TAU * f64::from(i % 3 - 1);
            format!("{x},{y},{}", -0.29 + 0.68 * share(0.3247) + turn)
        })
        .collect();
    let classes = |args: &[&str], rows: &[String]| -> Vec<String> {
        let input = format!("x,y,theta\n{}\n", rows.join("\n"));
        let output = cspace(args).write_stdin(input).assert().success();
        let text = String::from_utf8(output.get_output().stdout.clone()).unwrap();
        text.lines().skip(1).map(str::to_owned).collect()
    };
    let model = ["classify", &file, window];
    let graph = ["classify", saved];
    let many = classes(&model, &rows);
    assert_eq!(many.len(), rows.len());
    let few: Vec<String> = rows
        .chunks(2500)
        .flat_map(|chunk| classes(&model, chunk))
        .collect();
    assert_eq!(many, few);
    assert_eq!(many, classes(&graph, &rows));
    for word in [",free", ",blocked"] {
        assert!(many.iter().any(|row| row.ends_with(word)), "{word}");
    }
}

#[test]
fn classify_takes_motions_on_fixed_axes() {
    // The Geneva drive as drawn is at dwell, the parts apart.
    let output = cspace(&["classify", &model("geneva"), "--format", "json"])
        .write_stdin("u,v\n0,0\n0.5236,0\n")
        .assert()
        .success();
    let answer = serde_json::from_slice(&output.get_output().stdout).unwrap();
    let rows = unframed("classify", answer);
    assert_eq!(rows[0]["class"], "free");
    assert_eq!(rows[1]["class"], "blocked");
}

#[test]
fn bad_rows_are_named() {
    let file = model("ratchet_pawl");
    for (rows, words) in [
        ("x,y,theta\n1,2,3\n1,two,3\n", ["line 3", "column y"]),
        ("x,y,theta\n1,2\n", ["line 2", "2 values"]),
        ("x,y\n1,2\n", ["line 1", "\"x,y\""]),
        ("x,x,y,theta\n1,1,2,3\n", ["line 1", "twice"]),
        ("u,v\n1,2\n", ["line 1", "fixed axes"]),
        ("x,y,theta\nnan,0,0\n", ["line 2", "column x"]),
    ] {
        let mut command = cspace(&["classify", &file]);
        command.write_stdin(rows);
        fails(command, 2, &words);
    }
    let mut command = cspace(&["classify", &file, "--window", "-0.1,0.1"]);
    command.write_stdin("x,y,theta\n0,0,0\n0,0,0.2\n");
    fails(command, 2, &["line 3", "outside"]);
}

#[test]
fn export_writes_every_format() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let file = model("ball_in_c");
    let (saved, picture, mesh, text) =
        (path("a.json"), path("a.svg"), path("a.ply"), path("b.PLY"));
    printed(&["export", &file, "-o", &saved]);
    printed(&["export", &file, "-o", &picture, "--slices", "4"]);
    cspace(&["export", &saved, "-o", &mesh])
        .assert()
        .success()
        .stdout("");
    cspace(&["export", &file, "-o", &text, "--ascii"])
        .assert()
        .success()
        .stdout("");
    let space: Value = serde_json::from_slice(&std::fs::read(&saved).unwrap()).unwrap();
    assert_eq!(space["format"], "contact-space");
    assert_eq!(
        std::fs::read_to_string(picture)
            .unwrap()
            .matches("θ =")
            .count(),
        4
    );
    check_sizes(&std::fs::read(mesh).unwrap(), 24, 17);
    let text = std::fs::read_to_string(text).unwrap();
    let (vertices, faces) = counts(&text);
    assert_eq!(text.lines().count(), 11 + vertices + faces);
    assert!(text.contains("property int patch\n"));
    // What was saved is what was computed.
    let summary = &json(&["compute", &saved])[0];
    assert_eq!(
        summary["patches"].as_u64().unwrap() as usize,
        space["patches"].as_array().unwrap().len()
    );
}

fn counts(header: &str) -> (usize, usize) {
    let of = |what: &str| {
        let line = header.lines().find_map(|l| l.strip_prefix(what)).unwrap();
        line.trim().parse().unwrap()
    };
    (of("element vertex "), of("element face "))
}

fn check_sizes(ply: &[u8], vertex: usize, face: usize) {
    let mark = b"end_header\n";
    let end = ply.windows(mark.len()).position(|w| w == mark).unwrap() + mark.len();
    let (vertices, faces) = counts(std::str::from_utf8(&ply[..end]).unwrap());
    assert!(vertices > 0 && faces > 0);
    assert_eq!(ply.len(), end + vertices * vertex + faces * face);
}

#[test]
fn outputs_are_whole_or_not_there() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.json");
    std::fs::write(&out, "before").unwrap();
    fails(
        cspace(&["export", "no_such_model.toml", "-o", out.to_str().unwrap()]),
        2,
        &["no_such_model.toml"],
    );
    assert_eq!(std::fs::read_to_string(&out).unwrap(), "before");
    let answer = printed(&[
        "slice",
        &model("knee"),
        "--theta",
        "0",
        "--json",
        "-o",
        out.to_str().unwrap(),
    ]);
    assert_eq!(std::fs::read_to_string(&out).unwrap(), answer);
    // Nothing is left beside it.
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
    let nowhere = dir.path().join("no/such/out.json");
    fails(
        cspace(&["export", &model("knee"), "-o", nowhere.to_str().unwrap()]),
        2,
        &["there is no directory"],
    );
}

#[test]
fn usage_and_input_errors_leave_with_2() {
    let file = model("ratchet_pawl");
    fails(cspace(&["compute"]), 2, &["FILE"]);
    fails(cspace(&["slice", &file]), 2, &["--theta"]);
    fails(
        cspace(&["slice", &file, "--theta", "5 degrees"]),
        2,
        &["is no angle"],
    );
    fails(
        cspace(&["compute", &file, "--window", "1,0"]),
        2,
        &["smaller"],
    );
    fails(
        cspace(&["compute", &file, "--pair", "ratchet,pall"]),
        2,
        &["\"pall\"", "ratchet, pawl"],
    );
    fails(
        cspace(&["compute", &file, "--pair", "ratchet"]),
        2,
        &["two names"],
    );
    fails(
        cspace(&["compute", &file, "--pair", "pawl,pawl"]),
        2,
        &["two different"],
    );
    fails(cspace(&["export", &file]), 2, &["-o OUT"]);
    fails(
        cspace(&["export", &file, "-o", "out.xyz"]),
        2,
        &["out.xyz", "extension"],
    );
    fails(cspace(&["simulate"]), 2, &["simulate"]);
}

#[test]
fn formats_that_are_not_written_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    for name in ["a.gltf", "a.dxf", "a.", "glb", "a.ply.gz"] {
        let out = dir.path().join(name);
        fails(
            cspace(&["export", &model("knee"), "-o", out.to_str().unwrap()]),
            2,
            &[name, "the extension", ".ply", ".glb"],
        );
        assert!(!out.exists());
    }
}

#[test]
fn glb_has_the_triangles_of_the_stl() {
    let dir = tempfile::tempdir().unwrap();
    let export = |name: &str| {
        let out = dir.path().join(name);
        let args = ["export", &model("ball_in_c"), "-o", out.to_str().unwrap()];
        let output = cspace(&args)
            .assert()
            .success()
            .stdout("")
            .get_output()
            .clone();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains("closed"), "{said}");
        std::fs::read(out).unwrap()
    };
    let (glb, stl) = (export("a.GLB"), export("a.stl"));
    let word = |bytes: &[u8], at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!(
        (&glb[..4], word(&glb, 8) as usize),
        (&b"glTF"[..], glb.len())
    );
    let json: Value = serde_json::from_slice(&glb[20..20 + word(&glb, 12) as usize]).unwrap();
    assert_eq!(json["accessors"][2]["count"], 3 * word(&stl, 80));
}

#[test]
fn bad_files_are_named() {
    let dir = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| -> String {
        let path: PathBuf = dir.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let broken = write("broken.toml", "name = \n");
    fails(cspace(&["info", &broken]), 2, &["broken.toml"]);
    let three = write(
        "three.toml",
        &["a", "b", "c"]
            .map(|n| format!("[[part]]\nname = \"{n}\"\nloops = [[[0, 0], [1, 0], [0, 1]]]\n"))
            .concat(),
    );
    assert_eq!(json(&["compute", &three]).as_array().unwrap().len(), 3);
    fails(
        cspace(&["slice", &three, "--theta", "0"]),
        2,
        &["3 pairs", "--pair a,b", "--pair a,c", "--pair b,c"],
    );
    printed(&["slice", &three, "--theta", "0.1", "--pair", "c,a"]);
    let old = write("old.json", r#"{"format": "contact-space", "version": 99}"#);
    fails(
        cspace(&["compute", &old]),
        2,
        &["old.json", "version is 99", "cspace export"],
    );
    let empty = write("empty.json", r#"{"format": "contact-space", "version": 1}"#);
    fails(
        cspace(&["compute", &empty]),
        2,
        &["empty.json", "missing field"],
    );
}

#[test]
fn help_has_examples_and_shells_are_completed() {
    for command in [
        "info",
        "compute",
        "slice",
        "classify",
        "export",
        "completions",
    ] {
        let help = printed(&[command, "--help"]);
        assert!(help.contains("Example"), "{command}");
    }
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        assert!(
            printed(&["completions", shell]).contains("classify"),
            "{shell}"
        );
    }
    assert!(printed(&["--version"]).starts_with("cspace "));
}

#[test]
fn info_shows_a_part_alone() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("one.toml");
    std::fs::write(
        &file,
        "[[part]]\nname = \"pin\"\nloops = [[[6, 0, 1], [8, 0, 1]]]\n",
    )
    .unwrap();
    let file = file.to_str().unwrap();
    let text = printed(&["info", file]);
    assert!(text.contains("2 features: 0 lines, 2 arcs"), "{text}");
    assert!(text.contains("none: a pair takes two parts"), "{text}");
    let info = json(&["info", file]);
    assert_eq!(info["parts"][0]["features"]["arcs"], 2);
    assert_eq!(info["pairs"], serde_json::json!([]));
    let out = dir.path().join("out.json");
    for args in [
        &["compute", file] as &[&str],
        &["slice", file, "--theta", "0"],
        &["classify", file],
        &["export", file, "-o", out.to_str().unwrap()],
    ] {
        fails(cspace(args), 2, &["one.toml", "one part", "[[part]]"]);
    }
    assert!(!out.exists());
}

#[test]
fn errors_in_models_name_the_line_and_what_to_do() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("bad.toml");
    std::fs::write(
        &file,
        "[[part]]\nname = \"pin\"\nloops = [[[6, 0, 1],\n  [8, 0, 1, 4]]]\n",
    )
    .unwrap();
    fails(
        cspace(&["info", file.to_str().unwrap()]),
        2,
        &[
            "bad.toml:4:3: part 0 \"pin\", loop 0, vertex 1:",
            "help: a vertex is [x, y] or [x, y, bulge]",
        ],
    );
    fails(
        cspace(&["info", dir.path().to_str().unwrap()]),
        2,
        &["folder"],
    );
}

#[test]
fn angles_may_be_negative_and_have_units() {
    let file = model("peg_hole");
    for theta in ["-0.5", "-0.5rad", " -0.5 ", "-.5"] {
        let slice = json(&["slice", &file, "--theta", theta]);
        assert_eq!(slice["theta"], -0.5, "{theta}");
    }
    for window in [
        "-0.25turn,0.25turn",
        "-90deg,90°",
        "-90deg, 1.5707963267948966",
    ] {
        let result = &json(&["compute", &file, "--window", window])[0];
        assert_eq!(
            result["window"]["lo"],
            -core::f64::consts::FRAC_PI_2,
            "{window}"
        );
        assert_eq!(
            result["window"]["hi"],
            core::f64::consts::FRAC_PI_2,
            "{window}"
        );
    }
    let whole = &json(&["compute", &file, "--window", "0,1turn"])[0];
    assert_eq!(whole["window"]["full_turn"], true);
    for (window, word) in [
        ("0.5,-0.5", "smaller"),
        ("1,1", "smaller"),
        ("0,400deg", "more than a turn"),
        ("nan,1", "is no angle"),
        ("1", "comma"),
    ] {
        fails(cspace(&["compute", &file, "--window", window]), 2, &[word]);
    }
    for theta in ["", "inf", "5grad", "1,2"] {
        fails(
            cspace(&["slice", &file, "--theta", theta]),
            2,
            &["is no angle", "18deg"],
        );
    }
}

#[test]
fn threads_are_a_number_within_reason() {
    let file = model("ball_in_c");
    for threads in ["0", "1", "3"] {
        printed(&["compute", &file, "--threads", threads]);
    }
    for threads in ["-1", "100000", "many"] {
        fails(
            cspace(&["compute", &file, "--threads", threads]),
            2,
            &["--threads"],
        );
    }
}

#[test]
fn places_that_cannot_be_written_are_told_before_the_work() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().to_str().unwrap();
    let mesh = dir.path().join("folder.ply");
    std::fs::create_dir(&mesh).unwrap();
    std::fs::create_dir(dir.path().join("folder.json")).unwrap();
    fails(
        cspace(&[
            "export",
            &model("knee"),
            "-o",
            &format!("{folder}/folder.json"),
        ]),
        2,
        &["is a directory"],
    );
    fails(
        cspace(&["export", &model("knee"), "-o", mesh.to_str().unwrap()]),
        2,
        &["is a directory"],
    );
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2);
}

/// A link stays a link, and leads to what was written.
#[cfg(unix)]
#[test]
fn outputs_go_where_links_lead() {
    let dir = tempfile::tempdir().unwrap();
    let (link, real) = (dir.path().join("link.json"), dir.path().join("real.json"));
    std::os::unix::fs::symlink("real.json", &link).unwrap();
    for _ in 0..2 {
        printed(&["export", &model("knee"), "-o", link.to_str().unwrap()]);
        assert!(link.is_symlink());
        assert!(std::fs::read_to_string(&real).unwrap().contains("checksum"));
    }
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2);
}

/// A reader that has enough is no error.
#[cfg(unix)]
#[test]
fn a_closed_pipe_ends_quietly() {
    use std::process::{Command, Stdio};
    for args in [
        vec!["slice", "--theta", "0.1", "--format", "json"],
        vec!["compute", "--format", "json"],
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_cspace"))
            .env("CSPACE_CACHE", "off")
            .args(&args)
            .arg(model("peg_hole"))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{args:?}");
        assert!(output.stderr.is_empty(), "{args:?}");
    }
}

/// An interrupt ends the work soon, unanswered and with nothing written.
#[cfg(unix)]
#[test]
fn an_interrupt_leaves_nothing_behind() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.csv");
    // Waits for its standard input, which never comes.
    let mut child = Command::new(env!("CARGO_BIN_EXE_cspace"))
        .env("CSPACE_CACHE", "off")
        .args(["classify", &model("knee"), "-o", out.to_str().unwrap()])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let input = child.stdin.take();
    std::thread::sleep(Duration::from_millis(500));
    let begin = Instant::now();
    let interrupt = Command::new("sh")
        .args(["-c", &format!("kill -INT {}", child.id())])
        .status()
        .unwrap();
    assert!(interrupt.success());
    let output = child.wait_with_output().unwrap();
    drop(input);
    assert!(begin.elapsed() < Duration::from_secs(10));
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("interrupted"));
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
}

#[test]
fn obj_and_stl_have_the_triangles_of_the_ply() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let saved = path("space.json");
    printed(&["export", &model("ball_in_c"), "-o", &saved]);
    let export = |name: &str, more: &[&str]| -> Vec<u8> {
        let out = path(name);
        let common = [
            "export",
            &saved,
            "-o",
            &out,
            "--tolerance",
            "0.01",
            "--theta-scale",
            "1",
        ];
        let args = [&common[..], more].concat();
        cspace(&args).assert().success().stdout("");
        std::fs::read(out).unwrap()
    };
    let ply = String::from_utf8(export("a.ply", &["--ascii"])).unwrap();
    let obj = String::from_utf8(export("a.obj", &[])).unwrap();
    let stl = export("a.stl", &[]);
    let text = String::from_utf8(export("b.stl", &["--ascii"])).unwrap();
    let (vertices, faces) = counts(&ply);
    let body: Vec<&str> = ply
        .lines()
        .skip_while(|l| *l != "end_header")
        .skip(1)
        .collect();
    // The vertices of both text files are the same numbers, which lie on the surface.
    let of_obj: Vec<&str> = obj.lines().filter_map(|l| l.strip_prefix("v ")).collect();
    assert_eq!(of_obj, &body[..vertices]);
    let mut patch = "";
    let mut triangles = Vec::new();
    for line in obj.lines() {
        if let Some(name) = line.strip_prefix("g patch_") {
            patch = name;
        } else if let Some(t) = line.strip_prefix("f ") {
            let t = t.split(' ').map(|v| v.parse::<usize>().unwrap() - 1);
            let t: Vec<String> = t.map(|v| v.to_string()).collect();
            triangles.push(format!("3 {} {patch}", t.join(" ")));
        }
    }
    let mut of_ply: Vec<String> = body[vertices..].iter().map(|l| (*l).to_owned()).collect();
    of_ply.sort();
    triangles.sort();
    assert_eq!(triangles, of_ply);
    // STL: fewer only by triangles that single precision makes flat; edges remain matched.
    let n = u32::from_le_bytes(stl[80..84].try_into().unwrap()) as usize;
    assert_eq!(stl.len(), 84 + 50 * n);
    assert!(!stl.starts_with(b"solid"));
    assert!(n <= faces && n * 10 > faces * 9, "{n} of {faces}");
    assert_eq!(text.matches("endfacet").count(), n);
    let mut edges = std::collections::BTreeMap::new();
    let at = |i: usize| f32::from_le_bytes(stl[i..i + 4].try_into().unwrap());
    for t in 0..n {
        let corner = |k: usize| {
            let from = 84 + 50 * t + 12 + 12 * k;
            [0, 4, 8].map(|j| (at(from + j) + 0.0).to_bits())
        };
        for k in 0..3 {
            let (a, b) = (corner(k), corner((k + 1) % 3));
            *edges.entry((a.min(b), a.max(b))).or_insert(0) += if a < b { 1 } else { -1 };
        }
    }
    let theta = |bits: u32| f32::from_bits(bits).abs();
    let is_end = |p: [u32; 3]| (theta(p[2]) - core::f32::consts::PI).abs() < 1e-6;
    let open = edges
        .iter()
        .filter(|(e, sum)| **sum != 0 && !(is_end(e.0) && is_end(e.1)));
    assert_eq!(open.count(), 0);
}

/// Every example that a help text gives is run, with the files it makes.
#[test]
fn the_examples_of_the_help_are_true() {
    let dir = tempfile::tempdir().unwrap();
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let copy = dir.path().join("models");
    std::fs::create_dir(&copy).unwrap();
    for name in MODELS {
        std::fs::copy(model(name), copy.join(format!("{name}.toml"))).unwrap();
    }
    assert!(
        std::path::Path::new(root)
            .join("docs/contact-space.schema.json")
            .is_file()
    );
    let mut run = 0;
    let commands = [
        "",
        "info",
        "compute",
        "slice",
        "classify",
        "export",
        "play",
        "plan",
        "clearance",
        "draw",
    ];
    for command in commands {
        let help = if command.is_empty() {
            printed(&["--help"])
        } else {
            printed(&[command, "--help"])
        };
        let examples = help.lines().map(str::trim).filter(|l| {
            l.starts_with("cspace ") && l.contains("models/") || l.contains(".json -o")
        });
        for line in examples {
            if line.ends_with(".html") && !page::is_bundled() {
                continue;
            }
            let words: Vec<&str> = line.split_whitespace().skip(1).collect();
            let output = cspace(&words).current_dir(dir.path()).output().unwrap();
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(
                matches!(output.status.code(), Some(0 | 1)),
                "{line}: {said}"
            );
            run += 1;
        }
        // The one with a pipe.
        for line in help.lines().filter(|l| l.contains("| cspace classify")) {
            let rows = "x,y,theta\n42,56,0\n";
            assert!(line.contains(&rows.replace('\n', "\\n")), "{line}");
            let file = line.split_whitespace().last().unwrap();
            let mut command = cspace(&["classify", file]);
            let run = command.current_dir(dir.path()).write_stdin(rows);
            run.assert()
                .success()
                .stdout("x,y,theta,class\n42,56,0,free\n");
        }
    }
    assert!(run >= 22, "{run}");
}

/// Each command has a manual page that names its options.
#[test]
fn manual_pages_are_those_of_the_commands() {
    let all = printed(&["man"]);
    assert!(all.starts_with(".ie") && all.contains(".TH cspace 1"));
    for (command, option) in [
        ("compute", "window"),
        ("export", "slices"),
        ("view", "port"),
    ] {
        assert!(all.contains(command), "{command}");
        let page = printed(&["man", command]);
        assert!(page.contains(&format!(".TH cspace-{command} 1")), "{page}");
        assert!(page.contains(option), "{command}");
    }
    let output = cspace(&["man", "comptue"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
}

/// At 80 columns, which most terminals have, no line of a help is broken in two.
#[test]
fn helps_fit_a_terminal() {
    let all = printed(&["-h"]);
    let commands = all.lines().take_while(|l| *l != "Options:");
    let names: Vec<&str> = commands
        .filter_map(|l| l.strip_prefix("  ")?.split(' ').next())
        .collect();
    assert_eq!(names.len(), 20, "{names:?}");
    for name in names {
        let output = cspace(&[name, "--help"])
            .env("COLUMNS", "400")
            .output()
            .unwrap();
        let help = String::from_utf8(output.stdout).unwrap();
        let short = cspace(&[name, "-h"])
            .env("COLUMNS", "100")
            .output()
            .unwrap();
        let lines = short.stdout.iter().filter(|b| **b == b'\n').count();
        assert!(lines <= 40, "{name}: {lines}");
        // What comes after the options is written in lines, and not laid out by the terminal's width.
        let after = help.split("\n\nExample").nth(1).unwrap_or_default();
        let long = after.lines().find(|l| l.chars().count() > 80);
        assert_eq!(long, None, "{name}");
    }
}

/// Files of kinds that a command does not write are refused; others are beside its answer.
#[test]
fn files_are_written_beside_answers() {
    let dir = tempfile::tempdir().unwrap();
    let place = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let file = model("ratchet_pawl");
    for name in ["a.svg", "a.PNG", "a.ply", "a.html", "a.txt", "a.json", "a"] {
        for command in ["compute", "info", "play", "check"] {
            let out = place(name);
            let args = [command, &file, "-o", &out];
            fails(cspace(&args), 2, &["writes no such file", "leave -o out"]);
        }
    }
    for name in ["a.ply", "a.txt", "a.gif", "a", "a.svg.gz", "a.dxf.gz"] {
        let out = place(name);
        let args = ["slice", &file, "--theta", "0", "-o", &out];
        fails(cspace(&args), 2, &["writes no such file", ".svg, .png"]);
    }
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 0);
    for name in ["a.svg", "a.dxf", "a.json"] {
        let answer = printed(&["slice", &file, "--theta", "0"]);
        let out = place(name);
        assert_eq!(
            printed(&["slice", &file, "--theta", "0", "-o", &out]),
            answer
        );
        assert!(std::fs::metadata(&out).unwrap().len() > 100);
    }
    let answer: Value = serde_json::from_slice(&std::fs::read(place("a.json")).unwrap()).unwrap();
    assert_eq!(answer, framed(&["slice", &file, "--theta", "0"]));
}

/// Errors are JSON where JSON is asked for, with their place.
#[test]
fn errors_are_told_as_json() {
    let (_folder, bad) = file("[[part]]\nname = \"pin\"\nloops = [[[6, 0, 1],\n  [8, 0, 1, 4]]]\n");
    let told = |args: &[&str]| -> Value {
        let output = cspace(args).assert().code(2).get_output().clone();
        assert!(output.stderr.starts_with(b"error: "), "{output:?}");
        let told: Value = serde_json::from_slice(&output.stdout).unwrap();
        told["error"].clone()
    };
    let error = told(&["info", &bad, "--json"]);
    assert_eq!(
        (&error["file"], &error["line"], &error["column"]),
        (&bad.clone().into(), &4.into(), &3.into())
    );
    assert!(
        error["message"]
            .as_str()
            .unwrap()
            .contains("loop 0, vertex 1")
    );
    assert!(error["help"].is_string());
    let usage = told(&["compute", "--json", "--threats", "2", &bad]);
    assert!(
        usage["message"]
            .as_str()
            .unwrap()
            .starts_with("unexpected argument")
    );
    assert_eq!(usage["line"], Value::Null);
}

/// A command ends with 1 where the answer is no, and says nothing else; with 2 where there is none.
#[test]
fn codes_of_exit_are_those_of_answers() {
    let (ball, pawl) = (model("ball_in_c"), model("ratchet_pawl"));
    let (_folder, lost) = file(
        "[[part]]\nname = \"a\"\nloops = [[[0, 0], [9, 0], [9, 9], [0, 9]]]\n\
         [[part]]\nname = \"b\"\nloops = [[[1, 1], [20, 1], [20, 8], [1, 8]]]\n",
    );
    for (args, outcome) in [
        (
            &["plan", &ball, "--from", "0,0,0", "--to", "60,0,0"][..],
            "no-path",
        ),
        (
            &[
                "plan",
                &ball,
                "--from",
                "0,0,0",
                "--energy",
                "--gravity=0,-1",
            ],
            "cage",
        ),
        (&["check", &pawl, "--quiet", "--set", "tip=50.5"], "not-met"),
        (&["clearance", &lost], "overlaps"),
        (&["play", &lost], "blocked"),
    ] {
        let output = cspace(&[args, &["--json"]].concat()).assert().code(1);
        let output = output.get_output().clone();
        assert!(output.stderr.is_empty(), "{args:?}: {output:?}");
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(answer["outcome"], outcome, "{args:?}");
    }
    fails(cspace(&["compute", "no.toml"]), 2, &["no.toml"]);
}

/// Warnings can be silenced, and colours asked for; both leave the answer as it is.
#[test]
fn messages_are_coloured_and_silenced_on_request() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("m.toml");
    let text = "[[part]]\nname = \"a\"\nloops = [[[0, 0, 3], [1, 0]]]\n\
        [[part]]\nname = \"b\"\nloops = [[[5, 0], [6, 0], [6, 1]]]\n";
    std::fs::write(&file, text).unwrap();
    let file = file.to_str().unwrap();
    let output = |args: &[&str]| cspace(args).output().unwrap();
    let loud = output(&["info", file]);
    assert!(loud.stderr.starts_with(b"warning: "), "{loud:?}");
    let quiet = output(&["info", file, "--quiet"]);
    assert!(quiet.stderr.is_empty() && quiet.stdout == loud.stdout);
    let coloured = output(&["info", file, "--color", "always"]);
    assert!(coloured.stderr.starts_with(b"\x1b[") && coloured.stdout == loud.stdout);
    let failed = output(&["-q", "info", "nothing.toml"]);
    assert!(failed.stderr.starts_with(b"error: ") && failed.status.code() == Some(2));
}

/// `--snap` makes joints tangent that nearly are, and a note reports how many.
#[test]
fn joints_are_snapped_on_request() {
    let dir = tempfile::tempdir().unwrap();
    let place = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let file = place("m.toml");
    let text = "[[part]]\nname = \"slot\"\nloops = [[[0, 0], [10, 0, 0.9999], [10, 4], [0, 4, 1]]]\n\
        [[part]]\nname = \"b\"\nloops = [[[5, 9], [6, 9], [6, 10]]]\n";
    std::fs::write(&file, text).unwrap();
    let output = |args: &[&str]| cspace(args).output().unwrap();
    let as_drawn = output(&["info", &file]);
    let said = String::from_utf8(as_drawn.stderr).unwrap();
    assert!(
        said.contains("miss tangency") && said.contains("--snap"),
        "{said}"
    );
    let snapped = output(&["info", &file, "--snap"]);
    let said = String::from_utf8(snapped.stderr).unwrap();
    assert!(
        said.starts_with("note: ") && said.contains("part \"slot\": 2 joints made tangent"),
        "{said}"
    );
    assert_ne!(snapped.stdout, as_drawn.stdout);
    let saved = place("s.json");
    assert!(
        output(&["export", &file, "--snap", "-q", "-o", &saved])
            .stderr
            .is_empty()
    );
    fails(
        cspace(&["compute", &saved, "--snap"]),
        2,
        &["--snap is about models"],
    );
}

/// Several files are answered one after the other; one that is wrong does not keep the others back.
#[test]
fn several_files_are_answered() {
    let (a, b) = (model("cam_tappet"), model("peg_hole"));
    let text = printed(&["info", &a, &b]);
    let heads: Vec<&str> = text.lines().filter(|l| l.starts_with("== ")).collect();
    assert_eq!(heads, [format!("== {a}"), format!("== {b}")]);
    assert!(text.contains(printed(&["info", &b]).trim()));
    let all = json(&["compute", &a, &b]);
    let files: Vec<&str> = (all.as_array().unwrap().iter())
        .map(|o| o["file"].as_str().unwrap())
        .collect();
    assert_eq!(files, [&a, &b]);
    let output = cspace(&["compute", &a, "nothing.toml", &b])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let (said, told) = (
        String::from_utf8(output.stderr).unwrap(),
        String::from_utf8(output.stdout).unwrap(),
    );
    assert_eq!(said.matches("error:").count(), 1, "{said}");
    assert!(
        said.contains("nothing.toml")
            && told.contains(&format!("== {a}"))
            && told.contains(&format!("== {b}"))
    );
}

/// An option of other commands is refused with their names, numbers with what they may be, and an error about a file names it in JSON.
#[test]
fn refusals_say_what_to_give_instead() {
    let (pawl, lock) = (model("ratchet_pawl"), model("tolerances/geneva_lock"));
    let named = "`cspace modes` has no option --window";
    fails(
        cspace(&["modes", &lock, "--window", "0,1"]),
        2,
        &[named, "is for classify, compute"],
    );
    for (option, range) in [
        ("--seed=-1", "from 0"),
        ("--samples=x", "from 0 to 100000000"),
    ] {
        let refused = cspace(&["tolerances", &pawl, option]);
        fails(refused, 2, &["give a whole number", range]);
    }
    fails(
        cspace(&["plan", &pawl, "--about", "0"]),
        2,
        &["such as 10,2.5"],
    );
    for (command, words) in [
        (vec!["modes", &lock], "modes are those of three parts"),
        (
            vec!["disassemble", &pawl, "--gap=1e9"],
            "--gap 1000000000: ",
        ),
    ] {
        let refused = cspace(&[&command[..], &["--json"]].concat())
            .assert()
            .code(2);
        let told: Value = serde_json::from_slice(&refused.get_output().stdout).unwrap();
        assert_eq!(told["error"]["file"], command[1], "{told}");
        assert!(
            told["error"]["message"].as_str().unwrap().contains(words),
            "{told}"
        );
    }
}

/// Below the heading of pictures stand options of pictures alone, and options of all commands after those of one.
#[test]
fn help_lists_options_below_their_headings() {
    for name in [
        "modes",
        "simulate",
        "disassemble",
        "plan",
        "sweep",
        "tolerances",
        "slice",
    ] {
        let help = printed(&[name, "--help"]);
        let (own, pictures) = help.split_once("\nPictures (").unwrap();
        for option in ["--json", "--output", "--threads", "--color"] {
            assert!(
                own.contains(option) && !pictures.contains(&format!("{option} ")),
                "{name}"
            );
        }
        assert!(
            own.rfind("\n      --").unwrap() <= own.find("--color <").unwrap(),
            "{name}"
        );
    }
}
