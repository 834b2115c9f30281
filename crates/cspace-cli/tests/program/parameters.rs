//! `--set`, on every command that takes a model, and parameters in `info`.

use crate::helpers::{cspace, file, json_beside_notes as json, printed, unframed};

const MODEL: &str = r#"
name = "peg in a slot"
unit = "mm"

[parameter]
peg = { value = 10, tol = 0.02 }
play = 0.1
slot = "peg + play"

[[part]]
name = "block"
loops = [[{ mirror = "y", path = [[0, -25], [30, -25], [30, 0], ["slot/2", 0], ["slot/2", -20]] }]]
motion = { type = "fixed" }

[[part]]
name = "peg"
loops = [[["-peg/2", -18], ["peg/2", -18], ["peg/2", 4], ["-peg/2", 4]]]
motion = { type = "prismatic", direction = [1, 0] }
"#;

fn model() -> (tempfile::TempDir, String) {
    file(MODEL)
}

#[test]
fn info_lists_parameters_and_what_depends_on_them() {
    let (_folder, file) = model();
    let output = cspace(&["info", &file, "--set", "play=0.3"])
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    for line in [
        "peg in a slot (play = 0.3)",
        "  peg  = 10   ± 0.02  used by part \"block\", part \"peg\"",
        "  play = 0.3  set here  used by part \"block\"",
        "  slot = 10.3  = peg + play  used by part \"block\"",
    ] {
        let found = |l: &str| l.split_whitespace().eq(line.split_whitespace());
        assert!(text.lines().any(found), "no {line:?} in:\n{text}");
    }
    let info = json(&["info", &file, "--set", "peg=2*4"]);
    let values: Vec<f64> = (info["parameters"].as_array().unwrap().iter())
        .map(|p| p["value"].as_f64().unwrap())
        .collect();
    assert_eq!(values, [8.0, 0.1, 8.1]);
}

/// Half the play at either side, whatever it is set to.
#[test]
fn answers_are_for_the_values_that_are_set() {
    let (_folder, file) = model();
    for play in [0.1, 0.25, 1e-3] {
        let set = format!("play={play}");
        let played = json(&["play", &file, "--at", "0,0", "--by", "0,1", "--set", &set]);
        let moved = &played[0]["motion"];
        let at = moved["at"]["v"].as_f64().unwrap();
        assert!((at - play / 2.0).abs() < 1e-9, "{play}: {moved}");
    }
}

const REQUIREMENTS: &str = r#"
[[requirement]]
name = "free play"
measure = "play"
of = "v"
limits = [0.05, 0.15]

[[requirement]]
name = "gap"
measure = "clearance"
"#;

/// An arm of a disc that turns by a post, and a peg that floats in a hole.
const RANGES: &str = r#"
[parameter]
far = 5

[[part]]
name = "arm"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 1, at = [0, 2] }]

[[part]]
name = "post"
motion = { type = "fixed" }
loops = [{ circle = 0.5, at = ["far", 0] }, { circle = 1.2, at = ["far + 9", 0] }]

[[part]]
name = "peg"
loops = [{ circle = 1, at = ["far + 12", 0] }]

[[requirement]]
name = "gap"
pair = ["arm", "post"]
measure = "clearance"
over = "ranges"
limits = [1, 2]

[[requirement]]
name = "goes around"
pair = ["arm", "post"]
measure = "reaches"
of = "u"
equals = true

[[requirement]]
name = "room"
pair = ["post", "peg"]
measure = "fits"
within = [0.5, 0, 0]
"#;

#[test]
fn requirements_over_ranges_are_checked() {
    let (_folder, file) = file(RANGES);
    let rows = |set: &str, code: i32| {
        let told = cspace(&["check", &file, "--set", set, "--json"]).assert();
        let told = told.code(code).get_output().clone();
        unframed("check", serde_json::from_slice(&told.stdout).unwrap())
    };
    let number = |row: &serde_json::Value, key: &str| row[key].as_f64().unwrap();
    let free = rows("far=5", 0);
    assert!((number(&free[0], "value") - 1.5).abs() < 1e-11, "{free}");
    assert!((number(&free[0]["at"], "u") + 90_f64.to_radians()).abs() < 1e-5);
    assert_eq!(free[1]["value"], true);
    // It is 0.8 from the disc as drawn, and 0.5 more where it is farthest.
    assert!((number(&free[2], "value") - 1.3).abs() < 1e-7, "{free}");
    assert_eq!(free[2]["dimension"], "length");
    let stopped = rows("far=3", 1);
    assert_eq!(number(&stopped[0], "value"), 0.0);
    assert_eq!(
        (&stopped[1]["value"], &stopped[1]["met"]),
        (&false.into(), &false.into())
    );
    // On both ways around.
    assert_eq!(stopped[1]["touching"].as_array().unwrap().len(), 2);
    let swept = cspace(&["sweep", &file, "--vary", "far=4:5:2"]).assert();
    let swept = String::from_utf8(swept.code(0).get_output().stdout.clone()).unwrap();
    assert!(
        swept.starts_with("far,gap,goes around,room,failure\n4.0,0.5"),
        "{swept}"
    );
}

#[test]
fn requirements_are_checked() {
    let (_folder, file) = file(&format!("{MODEL}{REQUIREMENTS}"));
    let good = cspace(&["check", &file]).output().unwrap();
    assert!(good.status.success(), "{good:?}");
    let text = String::from_utf8(good.stdout).unwrap();
    assert!(
        text.starts_with("free play: met\n  play       0.100000 mm\n"),
        "{text}"
    );
    let told = cspace(&["check", &file, "--set", "play=0.2", "-q"]).assert();
    let told = told.code(1).get_output().clone();
    assert!(told.stderr.is_empty(), "{told:?}");
    let told = String::from_utf8(told.stdout).unwrap();
    assert!(told.starts_with("free play: not-met\n"), "{told}");
    assert!(told.ends_with("\n1 of 2 requirements not met\n"), "{told}");
    let bad = cspace(&["check", &file, "--set", "play=0.2", "--format", "json"])
        .output()
        .unwrap();
    assert_eq!(bad.status.code(), Some(1));
    assert!(!String::from_utf8(bad.stderr).unwrap().contains("error"));
    let framed: serde_json::Value = serde_json::from_slice(&bad.stdout).unwrap();
    assert_eq!(framed["outcome"], "not-met");
    let rows = unframed("check", framed);
    assert_eq!(
        (&rows[0]["outcome"], &rows[1]["outcome"]),
        (&"not-met".into(), &"measured".into())
    );
    assert!(
        (rows[0]["margin"].as_f64().unwrap() + 0.05).abs() < 1e-12,
        "{rows}"
    );
    assert_eq!(
        (&rows[0]["met"], &rows[1]["met"]),
        (&false.into(), &serde_json::Value::Null)
    );
    let same = REQUIREMENTS.replace("free play", "play");
    let (_same, same) = self::file(&format!("{MODEL}{same}"));
    for (args, words) in [
        (
            vec!["check", &file, "--requirement", "paly"],
            "no such requirement",
        ),
        (
            vec!["sweep", &file, "--measure", "paly", "--vary", "play=0:1:2"],
            "no such requirement",
        ),
        (
            vec!["sweep", &file, "--vary", "paly=0:1:2"],
            "no parameter or coordinate",
        ),
        (vec!["sweep", &file, "--vary", "play=0:1"], "NAME=LO:HI:N"),
        (
            vec![
                "sweep",
                &file,
                "--vary",
                "play=0:1:2",
                "--vary",
                "play=0:1:2",
            ],
            "varied twice",
        ),
        (
            vec![
                "sweep",
                &file,
                "--vary",
                "play=0:1:100000",
                "--vary",
                "peg=0:1:1000",
            ],
            "more than",
        ),
        (vec!["sweep", &file], "nothing is varied"),
        (
            vec!["sweep", &same, "--vary", "play=0:1:2"],
            "is both a requirement and",
        ),
        (vec!["check", &file, "--set", "peg=0"], "same place"),
        (vec!["check", "-", "--sensitivities"], "standard input"),
        (
            vec!["solve", &file, "--vary", "paly=0:1", "--so-that", "gap = 1"],
            "no parameter",
        ),
        (
            vec!["solve", &file, "--vary", "play=1:0", "--so-that", "gap = 1"],
            "the range is empty",
        ),
        (
            vec![
                "solve",
                &file,
                "--vary",
                "play=0:1",
                "--so-that",
                "paly = 1",
            ],
            "no requirement",
        ),
        (
            vec!["solve", &file, "--vary", "play=0:1", "--so-that", "gap"],
            "MEASURE = VALUE",
        ),
        (
            vec![
                "solve",
                &file,
                "--vary",
                "play=0:1",
                "--so-that",
                "free play = yes",
            ],
            "is a number",
        ),
        (
            vec![
                "solve",
                &file,
                "--vary",
                "play=0:1",
                "--so-that",
                "free play < 1",
            ],
            "MEASURE = VALUE",
        ),
    ] {
        let output = cspace(&args).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {said}");
        assert!(said.contains(words), "{args:?}: {said}");
    }
}

#[test]
fn sweeps_are_tables() {
    let (folder, file) = file(&format!("{MODEL}{REQUIREMENTS}"));
    let printed = |args: &[&str]| {
        let output = cspace(args).output().unwrap();
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let text = printed(&[
        "sweep",
        &file,
        "--vary",
        "play=-0.1:0.3:5",
        "--threads",
        "1",
    ]);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!((lines.len(), lines[0]), (6, "play,free play,gap,failure"));
    assert!(
        lines[1].starts_with("-0.1,,,free play: the parts overlap"),
        "{text}"
    );
    assert!(lines[5].starts_with("0.3,0.29999999999999"), "{text}");
    let rows = folder.path().join("rows.csv");
    std::fs::write(&rows, "play,v\n0.2,0.05\n0.2,-0.05\n0.4,0.1\n").unwrap();
    let out = folder.path().join("out.json");
    let asked = [
        "sweep",
        &file,
        "--rows",
        rows.to_str().unwrap(),
        "--measure",
        "gap",
    ];
    let plain = printed(&asked);
    assert!(plain.starts_with("play,v,gap,failure\n"), "{plain}");
    let beside = printed(&[&asked[..], &["-o", out.to_str().unwrap()]].concat());
    assert_eq!(beside, plain, "the answer is printed beside the file");
    let table = serde_json::from_slice(&std::fs::read(out).unwrap()).unwrap();
    let table = unframed("sweep", table);
    assert_eq!(table, json(&asked));
    let gaps: Vec<f64> = table
        .as_array()
        .unwrap()
        .iter()
        .map(|r| r["gap"].as_f64().unwrap())
        .collect();
    for (gap, expected) in gaps.iter().zip([0.05, 0.05, 0.1]) {
        assert!((gap - expected).abs() < 1e-12, "{gaps:?}");
    }
}

#[test]
fn a_sweep_without_a_value_says_so() {
    let (folder, file) = file(&format!("{MODEL}{REQUIREMENTS}"));
    let outcome = |args: &[&str]| {
        let mut output = cspace(&[&["sweep", &file, "--json"], args].concat());
        let output = output.assert().get_output().clone();
        let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let rows = answer["rows"].as_array().unwrap().clone();
        (output.status.code(), answer["outcome"].clone(), rows)
    };
    // The parts overlap where the play is negative: each row says so.
    let (code, word, rows) = outcome(&["--vary", "play=-0.2:-0.1:2"]);
    assert_eq!((code, word), (Some(1), "none".into()));
    assert_eq!(rows.len(), 2);
    assert!(rows.iter().all(|row| row["failure"].is_string()));
    let (code, word, _) = outcome(&["--vary", "play=-0.2:0.1:2"]);
    assert_eq!((code, word), (Some(0), "done".into()));
    // Where something changes, nothing does, and there is nothing.
    let changes = ["--vary", "play=-0.2:-0.1:2", "--changes"];
    assert_eq!(outcome(&changes), (Some(1), "none".into(), Vec::new()));
    let mut said = cspace(&[&["sweep", &file], &changes[..]].concat());
    let said = String::from_utf8(said.assert().code(1).get_output().stderr.clone()).unwrap();
    assert!(said.contains("nothing is measured anywhere: "), "{said}");
    let out = folder.path().join("none.csv");
    let out = out.to_str().unwrap();
    let args = ["sweep", &file, "--vary", "play=-0.2:-0.1:2", "-o", out];
    let text = cspace(&args).assert().code(1).get_output().clone();
    assert_eq!(text.stdout, std::fs::read(out).unwrap());
    assert!(String::from_utf8_lossy(&text.stderr).contains("no row has a value"));
}

#[test]
fn sweeps_go_on_from_what_is_done() {
    let (folder, file) = file(&format!("{MODEL}{REQUIREMENTS}"));
    let out = folder.path().join("out.csv");
    let out = out.to_str().unwrap();
    let run = |vary: &str| {
        let all = ["sweep", &file, "--vary", vary, "--resume", "-o", out];
        let output = cspace(&all).output().unwrap();
        if output.status.success() {
            // What is printed is what is written.
            let printed = String::from_utf8_lossy(&output.stdout);
            assert_eq!(printed, std::fs::read_to_string(out).unwrap());
        }
        output
    };
    assert!(run("play=0.1:0.3:5").status.success());
    let whole = std::fs::read_to_string(out).unwrap();
    // Rows that are there are kept as they are, whatever they say; the others are computed.
    let lines: Vec<&str> = whole.lines().collect();
    let known = format!("{}\n0.1,1,2,kept\n", lines[0]);
    std::fs::write(out, &known).unwrap();
    assert!(run("play=0.1:0.3:5").status.success());
    let resumed = std::fs::read_to_string(out).unwrap();
    assert_eq!(resumed, format!("{known}{}\n", lines[2..].join("\n")));
    // A line without its end is not whole; a file without lines has nothing.
    for part in ["", &known[..known.len() - 3], lines[0]] {
        std::fs::write(out, part).unwrap();
        assert!(run("play=0.1:0.3:5").status.success());
        assert_eq!(std::fs::read_to_string(out).unwrap(), whole);
    }
    std::fs::write(out, &resumed).unwrap();
    // Another sweep is no reason to lose it.
    for (vary, words) in [
        ("play=0.2:0.3:5", "line 2 has other values"),
        ("play=0.1:0.3:9", "line 3 has other values"),
        ("v=0:0.3:5", "columns are those of another sweep"),
    ] {
        let output = run(vary);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(words), "{said}");
        assert_eq!(std::fs::read_to_string(out).unwrap(), resumed);
    }
    // A coordinate that no pair has is no silent column.
    let output = cspace(&["sweep", &file, "--vary", "theta=0:1:2"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2), "{output:?}");
}

#[test]
fn every_command_that_takes_a_model_sets_values() {
    let (folder, file) = model();
    let picture = folder.path().join("a.svg").to_str().unwrap().to_owned();
    let space = folder.path().join("a.json").to_str().unwrap().to_owned();
    for command in [
        vec!["info", &file],
        vec!["compute", &file],
        vec!["play", &file, "--at", "0,0"],
        vec!["play", &file, "--at", "0,0", "--by", "0,1"],
        vec!["plan", &file, "--from", "0,0", "--to", "0,0.04"],
        vec!["draw", &file, "-o", &picture],
        vec!["export", &file, "-o", &space],
        vec!["clearance", &file],
        vec!["simulate", &file, "--time", "0.1"],
    ] {
        let with = |set: &str| {
            let mut args = command.clone();
            args.extend(["--set", set]);
            cspace(&args).output().unwrap()
        };
        let good = with("play=0.2");
        let said = String::from_utf8(good.stderr).unwrap();
        assert!(good.status.success(), "{command:?}: {said}");
        assert!(said.contains("with play = 0.2"), "{command:?}: {said}");
        let bad = with("paly=0.2");
        let said = String::from_utf8(bad.stderr).unwrap();
        assert_eq!(bad.status.code(), Some(2), "{command:?}");
        assert!(said.contains("did you mean `play`?"), "{command:?}: {said}");
    }
    let picture = std::fs::read_to_string(picture).unwrap();
    assert!(picture.contains("play = 0.2"), "its title says so");
    for (args, what) in [
        (
            vec!["compute", &space, "--set", "play=0.2"],
            "saved contact space",
        ),
        (
            vec!["sweep", &space, "--vary", "play=0:1:2"],
            "saved contact space",
        ),
        (vec!["tolerances", &space], "saved contact space"),
        (vec!["compute", &file, "--set", "play"], "NAME=VALUE"),
        (
            vec!["compute", &file, "--set", "play=peg/0"],
            "division by zero",
        ),
    ] {
        let output = cspace(&args).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(said.contains(what), "{args:?}: {said}");
    }
}

#[test]
fn sweeps_are_pictures() {
    let (folder, file) = file(&format!("{MODEL}{REQUIREMENTS}"));
    let picture = folder.path().join("sweep.svg").display().to_string();
    let vary = ["--vary", "peg=5:6:2", "--vary", "play=-0.1:0.3:9"];
    let args = ["sweep", &file, "-o", &picture, "--changes"];
    let done = cspace(&[&args[..], &vary[..]].concat()).assert().success();
    let told = &done.get_output().stdout;
    assert!(told.starts_with(b"peg,play,measure,before,after\n"));
    let drawn = std::fs::read_to_string(&picture).unwrap();
    for words in ["free play", "gap", "peg = 6", ">play<"] {
        assert!(drawn.contains(words), "{words}: {drawn}");
    }
    for (more, words) in [
        (&["--format", "csv"][..], "possible values: text, json"),
        (&["--vary", "play=0:1:2"], "varied twice"),
        (&["--size", "1x1"], "width x height"),
    ] {
        let all = [&args[..], &vary[..], more].concat();
        let output = cspace(&all).output().unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(words), "{said}");
    }
    let table = cspace(&["sweep", &file, "--vary", "play=0:1:2", "--title", "a"])
        .output()
        .unwrap();
    assert_eq!(table.status.code(), Some(2));
}

/// A shaft of 20 g6 in a bore of 20 H7: the nominal size is outside the shaft's limits, and the tolerances are about their middle.
#[test]
fn limits_need_not_enclose_the_nominal() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("fit.toml");
    // H7 and g6 of 20 mm, in three forms.
    for (bore, shaft) in [
        ("plus = 0.021, minus = 0", "limits = [19.980, 19.993]"),
        ("limits = [20, 20.021]", "plus = -0.007, minus = 0.020"),
        ("tol = \"H7\"", "tol = \"g6\""),
    ] {
        let text = format!(
            "unit = \"mm\"\n[parameter]\nbore = {{ value = 20, {bore} }}\nshaft = {{ value = 20, {shaft} }}\n\
            [[part]]\nname = \"hub\"\nloops = [[[-20, -20], [20, -20], [20, 20], [-20, 20]], {{ circle = \"bore/2\", at = [0, 0] }}]\n\
            [[part]]\nname = \"shaft\"\nloops = [{{ circle = \"shaft/2\", at = [0, 0] }}]\n\
            [[requirement]]\nname = \"fit\"\nmeasure = \"play\"\nof = \"x\"\nlimits = [0, 0.05]\n"
        );
        std::fs::write(&file, text).unwrap();
        let file = file.to_str().unwrap();
        let found = &json(&["tolerances", file])[0];
        let value = |end: &str| found["exact"][end]["value"].as_f64().unwrap();
        assert!((value("lo") - 0.007).abs() < 1e-9, "{found}");
        assert!((value("hi") - 0.041).abs() < 1e-9, "{found}");
    }
    let file = file.to_str().unwrap();
    // As drawn the value counts.
    let info = printed(&["info", file]);
    assert!(info.contains("within 19.98 to 19.993"), "{info}");
}

/// A wheel on which a torque may act that nothing stops: what becomes of it then is not determined.
const UNSTOPPED: &str = r#"
[parameter]
torque = 3
[[part]]
name = "wheel"
motion = { type = "revolute", center = [0, 0] }
loops = [{ circle = 1, at = [0, 0] }]
[[part]]
name = "knob"
motion = { type = "revolute", center = [20, 0] }
loops = [{ circle = 1, at = [20, 0] }]
[[drive]]
part = "knob"
rate = 1
[[load]]
part = "wheel"
torque = "max(0, torque)"
[[requirement]]
name = "turned"
measure = "stroke"
part = "knob"
time = 1
limits = [0, 2]
"#;

#[test]
fn what_is_not_decided_is_neither_met_nor_not_met() {
    let (_folder, file) = file(UNSTOPPED);
    let check = |set: &str| {
        cspace(&["check", &file, "--format", "json", "--set", set])
            .output()
            .unwrap()
    };
    let answer = |output: &std::process::Output| -> serde_json::Value {
        let framed: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        // Of one requirement the outcome is that of all.
        let all = framed["outcome"].clone();
        let rows = unframed("check", framed);
        assert_eq!(rows[0]["outcome"], all);
        rows
    };
    let open = check("torque=3");
    assert_eq!(open.status.code(), Some(2));
    assert_eq!(answer(&open)[0]["met"], serde_json::Value::Null);
    assert_eq!(answer(&open)[0]["undecided"], true);
    assert_eq!(answer(&open)[0]["outcome"], "undecided");
    let told = cspace(&["check", &file, "--set", "torque=3"]).assert();
    let told = String::from_utf8(told.code(2).get_output().stdout.clone()).unwrap();
    assert!(told.starts_with("turned: undecided\n"), "{told}");
    let closed = check("torque=-3");
    assert_eq!(closed.status.code(), Some(0));
    assert_eq!(answer(&closed)[0]["met"], true);
    assert_eq!(answer(&closed)[0]["outcome"], "met");
    assert!(answer(&closed)[0].get("undecided").is_none());
    let solved = json(&[
        "solve",
        &file,
        "--vary",
        "torque=-2:4",
        "--so-that",
        "turned >= 0.5",
    ]);
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let [is, open] = ["ranges", "undecided"].map(|key| &solved[key][0]);
    assert!(
        (number(&is[0]) + 2.0).abs() < 1e-9 && number(&is[1]).abs() < 1e-9,
        "{solved}"
    );
    assert!(
        number(&open[0]).abs() < 1e-9 && (number(&open[1]) - 4.0).abs() < 1e-9,
        "{solved}"
    );
}

/// A latch closes between two angles of its bolt: atan f, below which it jams, and the one at which the upper corner of its slant, at
/// 12 − 6 / tan, meets the strike's round where that slopes by atan f, at 4.5 − 1.5 sin(atan f).
#[test]
fn a_latch_closes_between_two_angles() {
    let latch = format!(
        "{}/tests/models/spring_latch.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    let latch = latch.as_str();
    let so = [
        "--set",
        "half=3",
        "--so-that",
        "closes <= 1",
        "--samples",
        "9",
    ];
    let solved = json(&[&["solve", latch, "--vary", "slant=8deg:45deg"], &so[..]].concat());
    let ranges = solved["ranges"].as_array().unwrap();
    assert!(
        ranges.len() == 1 && solved.get("undecided").is_none(),
        "{solved}"
    );
    let [lo, hi] = [0, 1].map(|k| ranges[0][k].as_f64().unwrap());
    assert!((lo - 0.2_f64.atan()).abs() < 1e-9, "{solved}");
    let corner = 4.5 - 1.5 * 0.2_f64.atan().sin();
    assert!(
        (hi - (6.0 / (12.0 - corner)).atan()).abs() < 1e-9,
        "{solved}"
    );
    let output = cspace(&["check", latch, "--set", "half=3", "--set", "slant=0.34"])
        .output()
        .unwrap();
    let told = String::from_utf8(output.stdout).unwrap();
    assert!(told.contains("closes: met"), "{told}");
}

/// Solutions and reasons have as many digits as are told of other answers, angles in degrees, and the outcome.
#[test]
fn solutions_are_told_as_other_answers_are() {
    let lock = crate::helpers::model("tolerances/geneva_lock");
    let solve = |goal: &str| {
        let run = cspace(&["solve", &lock, "--vary", "r=19:20", "--so-that", goal]).assert();
        String::from_utf8(run.get_output().stdout.clone()).unwrap()
    };
    let none = solve("dwell = 50deg");
    assert!(
        none.starts_with("none: in the range the quantity is between "),
        "{none}"
    );
    assert!(
        none.contains(" deg and ") && none.contains(" deg off the value"),
        "{none}"
    );
    let longest = |text: &str| {
        let digits = text.split(|c: char| !c.is_ascii_digit());
        digits.map(str::len).max().unwrap()
    };
    assert!(longest(&none) <= 6, "{none}");
}
