//! The command, as a user runs it.

#![allow(clippy::unwrap_used)]

use std::path::PathBuf;

use assert_cmd::Command;
use serde_json::Value;

const MODELS: [&str; 10] = [
    "ball_in_c",
    "cam_follower",
    "fixture_plate",
    "gears",
    "gears_on_shafts",
    "geneva",
    "knee",
    "peg_hole",
    "ratchet_pawl",
    "snap_fastener",
];

fn model(name: &str) -> String {
    format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

fn cspace(args: &[&str]) -> Command {
    let mut command = Command::cargo_bin("cspace").unwrap();
    command.args(args);
    command
}

/// What a successful run prints.
fn printed(args: &[&str]) -> String {
    let output = cspace(args).assert().success().get_output().clone();
    assert!(
        output.stderr.is_empty(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).unwrap()
}

fn json(args: &[&str]) -> Value {
    serde_json::from_str(&printed(args)).unwrap()
}

/// A run that fails with this code says something that contains all of `words`, and prints nothing to stdout.
fn fails(mut command: Command, code: i32, words: &[&str]) {
    let output = command.assert().code(code).get_output().clone();
    assert!(
        output.stdout.is_empty(),
        "{}",
        String::from_utf8_lossy(&output.stdout)
    );
    let message = String::from_utf8(output.stderr).unwrap();
    for word in words {
        assert!(message.contains(word), "no {word:?} in: {message}");
    }
}

#[test]
fn info_counts_features_as_the_computation_does() {
    for name in MODELS {
        let file = model(name);
        let info = json(&["info", &file, "--format", "json"]);
        let part = |i: usize| info["parts"][i]["features"]["total"].clone();
        if name == "gears_on_shafts" {
            assert_eq!(info["pairs"][0]["class"], "fixed-axes");
            continue;
        }
        let result = &json(&["compute", &file, "--format", "json"])[0];
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
fn compute_has_the_keys_of_the_contract() {
    let file = model("ratchet_pawl");
    let all = json(&["compute", &file, "--format", "json"]);
    assert_eq!(all.as_array().unwrap().len(), 1);
    let r = &all[0];
    assert_eq!(r["fixed"], "ratchet");
    assert_eq!(r["moving"], "pawl");
    assert_eq!(r["class"], "general");
    assert_eq!(
        r["features"],
        serde_json::json!({"fixed": 80, "moving": 7, "total": 87})
    );
    assert_eq!(r["symmetry"], serde_json::json!({"fixed": 20, "moving": 1}));
    let critical = r["critical_orientations"].as_array().unwrap();
    assert_eq!(r["bands"].as_u64().unwrap() as usize, critical.len());
    assert_eq!(r["slices"], r["bands"]);
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
fn compute_takes_a_window_and_any_number_of_threads() {
    let file = model("ratchet_pawl");
    let run = |threads: &str| {
        let mut value = json(&[
            "compute",
            &file,
            "--theta",
            "-10deg,10deg",
            "--general",
            "--threads",
            threads,
            "--format",
            "json",
        ]);
        value[0]["seconds"] = Value::Null;
        value
    };
    let one = run("1");
    assert_eq!(one, run("4"));
    assert_eq!(one[0]["window"]["full_turn"], false);
    let lo = one[0]["window"]["lo"].as_f64().unwrap();
    assert!((lo + 10f64.to_radians()).abs() < 1e-15);
    let text = printed(&["compute", &file, "--theta=-10deg,10deg"]);
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
    let result = &json(&[
        "compute",
        &model("ball_in_c"),
        "--pair",
        "ball,clip",
        "--format",
        "json",
    ]);
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
    let slice = json(&["slice", &file, "--theta=-0.1", "--format", "json"]);
    assert_eq!(slice["theta"], -0.1);
    assert!(!slice["curves"].as_array().unwrap().is_empty());
    let out = dir.path().join("slice.svg");
    let picture = printed(&["slice", &file, "--theta", "0", "-o", out.to_str().unwrap()]);
    assert_eq!(picture, "");
    assert!(std::fs::read_to_string(out).unwrap().starts_with("<svg"));
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
    let slice = json(&["slice", &file, "--theta", "0.3", "--format", "json"]);
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

#[test]
fn classify_takes_motions_on_fixed_axes() {
    // The Geneva drive as drawn is at dwell, the parts apart.
    let output = cspace(&["classify", &model("geneva"), "--format", "json"])
        .write_stdin("u,v\n0,0\n0.5236,0\n")
        .assert()
        .success();
    let rows: Value = serde_json::from_slice(&output.get_output().stdout).unwrap();
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
    let mut command = cspace(&["classify", &file, "--theta", "-0.1,0.1"]);
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
    let summary = &json(&["compute", &saved, "--format", "json"])[0];
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
    printed(&[
        "compute",
        &model("knee"),
        "--format",
        "json",
        "-o",
        out.to_str().unwrap(),
    ]);
    assert!(std::fs::read_to_string(&out).unwrap().starts_with('['));
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
        cspace(&["compute", &file, "--theta", "1,0"]),
        2,
        &["greater"],
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
    fails(cspace(&["evaluate"]), 2, &["evaluate"]);
}

#[test]
fn formats_of_later_versions_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("a.stl");
    fails(
        cspace(&["export", &model("knee"), "-o", out.to_str().unwrap()]),
        1,
        &["does not write .stl"],
    );
    assert!(!out.exists());
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
    assert_eq!(
        json(&["compute", &three, "--format", "json"])
            .as_array()
            .unwrap()
            .len(),
        3
    );
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
        &["old.json", "version is 99"],
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
