//! Places that cannot be written, or only in part.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use super::bounds::{PROGRAM, fails, names, run_to};
use crate::helpers::{cspace, model, printed};

/// Each command, with what it needs.
fn commands() -> Vec<Vec<String>> {
    let file = model("peg_hole");
    [
        &["--help"][..],
        &["--version"],
        &["compute", "--help"],
        &["completions", "bash"],
        &["info", &file],
        &["compute", &file],
        &["compute", &file, "--json"],
        &["compute", &file, "--format", "json"],
        &["plan", &file],
        &["slice", &file, "--theta", "0.1"],
    ]
    .map(|args| args.iter().map(|&a| a.to_owned()).collect())
    .into()
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_told() {
    for args in commands() {
        let args: Vec<&str> = args.iter().map(String::as_str).collect();
        let full = File::options().write(true).open("/dev/full").unwrap();
        let output = run_to(full, &args);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {said}");
        assert!(
            said.starts_with("error: standard output: No space left"),
            "{args:?}: {said}"
        );
    }
    let file = model("peg_hole");
    let dir = tempfile::tempdir().unwrap();
    for (args, name) in [
        (&["slice", &file, "--theta", "0.1"][..], "a.json"),
        (&["slice", &file, "--theta", "0.1"], "a.dxf"),
        (&["plan", &file], "a.csv"),
        (&["draw", &file], "a.svg"),
    ] {
        let place = dir.path().join(name);
        std::os::unix::fs::symlink("/dev/full", &place).unwrap();
        let args = [args, &["-o", place.to_str().unwrap()]].concat();
        fails(&args, 2, &[name, "No space left"]);
    }
    // A mesh that was not written is not told of.
    let mesh = dir.path().join("mesh.ply");
    std::os::unix::fs::symlink("/dev/full", &mesh).unwrap();
    let output = run_to(
        Stdio::piped(),
        &["export", &file, "-o", mesh.to_str().unwrap()],
    );
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.starts_with("error: ") && said.contains("No space left"));
    assert!(!said.contains("vertices"), "{said}");
}

/// `cspace … | head -1`: the reader takes one line and goes away.
#[test]
fn a_reader_may_go_after_a_line() {
    for args in commands() {
        let mut child = Command::new(PROGRAM)
            .args(&args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        let mut reader = BufReader::with_capacity(16, child.stdout.take().unwrap());
        reader.read_line(&mut line).unwrap();
        drop(reader);
        let output = child.wait_with_output().unwrap();
        assert!(!line.is_empty(), "{args:?}");
        assert_eq!(output.status.code(), Some(0), "{args:?}");
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{args:?}");
    }
}

#[test]
fn places_that_cannot_be_written_are_told() {
    let dir = tempfile::tempdir().unwrap();
    let place = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let file = model("peg_hole");
    std::fs::create_dir(place("folder.json")).unwrap();
    fails(
        &["export", &file, "-o", &place("folder.json")],
        2,
        &["folder.json", "is a directory", "  help: "],
    );
    fails(
        &["export", &file, "-o", &place("none/a.json")],
        2,
        &["a.json", "no directory"],
    );
    // Nothing can be made in there, not even by the superuser.
    #[cfg(target_os = "linux")]
    fails(
        &["export", &file, "-o", "/proc/a.json"],
        2,
        &["/proc/a.json", "cannot be written", "  help: "],
    );
    std::os::unix::fs::symlink("none/a.json", place("link.json")).unwrap();
    fails(
        &["export", &file, "-o", &place("link.json")],
        2,
        &["link.json", "cannot be written"],
    );
    std::fs::write(place("file"), "").unwrap();
    fails(
        &["export", &file, "-o", &place("file/a.json")],
        2,
        &["a.json", "no directory"],
    );
    assert_eq!(names(dir.path()), ["file", "folder.json", "link.json"]);
}

/// The previous output file remains when the work fails.
#[test]
fn failures_leave_what_was_there() {
    let dir = tempfile::tempdir().unwrap();
    let (file, mechanism) = (model("peg_hole"), model("ratchet_mechanism"));
    for (args, name) in [
        (&["export", "none.toml"][..], "out.ply"),
        (&["export", &mechanism], "out.ply"),
        (&["export", &mechanism, "--pair", "driver,link"], "out.ply"),
        (&["slice", &file], "out.svg"),
        (&["slice", &file, "--theta", "1e12"], "out.json"),
        (&["slice", &file, "--theta", "0"], "out.ply"),
        (&["plan", &file, "--pair", "peg,nut"], "out.csv"),
        (&["plan", &file, "--energy", "--from", "0,0"], "out.json"),
        (&["tolerances", &file], "out.json"),
        (&["sweep", &file, "--vary", "a=0:1:2"], "out.csv"),
        (&["compute", &file], "out.json"),
        // Standard input is empty: there is no row with names.
        (&["classify", &file], "out.csv"),
        (&["classify", &file], "out.json"),
    ] {
        let out = dir.path().join(name);
        let place = out.to_str().unwrap();
        std::fs::write(&out, "before").unwrap();
        fails(&[args, &["-o", place]].concat(), 2, &["error: "]);
        assert_eq!(std::fs::read_to_string(&out).unwrap(), "before", "{args:?}");
        assert_eq!(names(dir.path()), [name], "{args:?}");
        std::fs::remove_file(&out).unwrap();
    }
}

/// Message of a command that writes no file of a kind beside its answer.
const NO_SUCH: &str = "this command writes no such file";

/// Input files are not overwritten, under whatever name.
#[test]
fn inputs_are_not_written_over() {
    let dir = tempfile::tempdir().unwrap();
    let place = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (file, saved) = (place("m.toml"), place("s.json"));
    std::fs::copy(model("peg_hole"), &file).unwrap();
    let written = run_to(Stdio::null(), &["export", &file, "-o", &saved]);
    assert!(written.status.success());
    let (linked, hard) = (place("link.json"), place("hard.json"));
    std::os::unix::fs::symlink(&file, &linked).unwrap();
    std::fs::hard_link(&file, &hard).unwrap();
    let (to_file, picture) = (place("link.toml"), place("link.svg"));
    std::os::unix::fs::symlink(&file, &to_file).unwrap();
    std::os::unix::fs::symlink(&file, &picture).unwrap();
    // A model in JSON, which has a name that answers may have.
    let plain = place("m.json");
    let square = "[[[0, 0], [1, 0], [1, 1], [0, 1]]]";
    let part = |name: &str| format!(r#"{{"name": "{name}", "loops": {square}}}"#);
    let text = format!(r#"{{"part": [{}, {}]}}"#, part("a"), part("b"));
    std::fs::write(&plain, text).unwrap();
    let round = format!("{}/./m.json", dir.path().display());
    let before = |name: &str| std::fs::read(name).unwrap();
    let was = [&file, &saved, &plain].map(|name| before(name));
    const OVER: &str = "the output is the file that is read";
    for (args, why) in [
        (&["slice", &plain, "--theta", "0", "-o", &plain][..], OVER),
        (&["slice", &plain, "--theta", "0", "-o", &round], OVER),
        (&["slice", &file, "--theta", "0", "-o", &linked], OVER),
        (&["slice", &to_file, "--theta", "0", "-o", &hard], OVER),
        (&["slice", &file, "--theta", "0", "-o", &hard], OVER),
        (&["slice", &file, "--theta", "0", "-o", &picture], OVER),
        (&["plan", &file, "-o", &linked], OVER),
        (&["plan", &plain, "-o", &plain], OVER),
        (
            &["plan", &plain, "--energy", "--gravity=0,-1", "-o", &plain],
            OVER,
        ),
        (&["disassemble", &plain, "-o", &plain], OVER),
        (&["modes", &file, "-o", &picture], OVER),
        (&["simulate", &plain, "--time", "1", "-o", &round], OVER),
        (&["sweep", &file, "--vary", "a=0:1:2", "-o", &hard], OVER),
        (&["tolerances", &file, "-o", &hard], OVER),
        (&["draw", &file, "-o", &picture], OVER),
        (&["classify", &plain, "-o", &plain], OVER),
        (&["export", &plain, "-o", &plain], OVER),
        (&["export", &saved, "-o", &saved], OVER),
        (&["slice", &saved, "--theta", "0", "-o", &saved], OVER),
        // Nothing is written by these, whatever the name is.
        (&["compute", &file, "-o", &file], NO_SUCH),
        (&["compute", &plain, "-o", &plain], NO_SUCH),
        (&["info", &file, "-o", &file], NO_SUCH),
        (&["info", &plain, "-o", &plain], NO_SUCH),
        (&["play", &plain, "-o", &plain], NO_SUCH),
        (&["clearance", &plain, "-o", &plain], NO_SUCH),
        (&["check", &plain, "-o", &plain], NO_SUCH),
        (
            &[
                "solve",
                &plain,
                "--vary",
                "a=0:1",
                "--so-that",
                "b = 1",
                "-o",
                &plain,
            ],
            NO_SUCH,
        ),
        (&["slice", &file, "--theta", "0", "-o", &file], NO_SUCH),
    ] {
        let output = args[args.len() - 1];
        fails(args, 2, &[output, why, "  help: "]);
        let is = [&file, &saved, &plain].map(|name| before(name));
        assert!(is == was, "{args:?}");
    }
    let rows = place("rows.csv");
    std::fs::write(&rows, "x,y,theta\n0,0,0\n").unwrap();
    let output = Command::new(PROGRAM)
        .args(["classify", &file, "-o", &rows])
        .stdin(File::open(&rows).unwrap())
        .output()
        .unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("rows.csv") && said.contains("standard input"));
    assert_eq!(before(&rows), b"x,y,theta\n0,0,0\n");
    // A device is no file that could be lost.
    let null = place("null.json");
    std::os::unix::fs::symlink("/dev/null", &null).unwrap();
    let to_null = run_to(Stdio::null(), &["slice", &file, "--theta=0", "-o", &null]);
    assert!(to_null.status.success(), "{to_null:?}");
    let names = names(dir.path());
    assert_eq!(
        names,
        [
            "hard.json",
            "link.json",
            "link.svg",
            "link.toml",
            "m.json",
            "m.toml",
            "null.json",
            "rows.csv",
            "s.json"
        ]
    );
}

/// Whatever else a command reads is not written over either: a model on standard input, a drawing that a model names, records,
/// paths that are judged.
#[cfg(unix)]
#[test]
fn what_is_read_besides_is_not_written_over() {
    let dir = tempfile::tempdir().unwrap();
    let place = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let fails = |args: &[&str], stdin: Stdio, kept: &str, why: &str| {
        let before = std::fs::read(place(kept)).unwrap();
        let output = Command::new(PROGRAM)
            .args(args)
            .stdin(stdin)
            .current_dir(dir.path())
            .output()
            .unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}: {said}");
        let words = [kept, why, "  help: "];
        assert!(words.iter().all(|w| said.contains(w)), "{args:?}: {said}");
        assert!(output.stdout.is_empty(), "{args:?}");
        assert_eq!(std::fs::read(place(kept)).unwrap(), before, "{args:?}");
    };
    let refused = |args: &[&str], stdin: Stdio, kept: &str| {
        fails(args, stdin, kept, "the output is the file that");
    };
    for name in ["peg_hole", "geneva"] {
        let file = place(&format!("{name}.toml"));
        std::fs::copy(model(name), file).unwrap();
    }
    // The same under names that answers may have: what standard input is, its text says.
    for name in ["p.json", "p.svg", "p.csv"] {
        std::fs::copy(model("peg_hole"), place(name)).unwrap();
    }
    let from = |name: &str| Stdio::from(File::open(place(name)).unwrap());
    for (args, name) in [
        (&["slice", "-", "--theta", "0"][..], "p.json"),
        (&["slice", "-", "--theta", "0"], "p.svg"),
        (&["plan", "-"], "p.json"),
        (&["plan", "-"], "p.csv"),
        (&["plan", "-"], "p.svg"),
        (&["plan", "-", "--energy", "--gravity=0,-1"], "p.json"),
        (&["disassemble", "-"], "p.json"),
        (&["draw", "-"], "p.svg"),
        (&["export", "-"], "p.json"),
        (&["simulate", "-", "--time", "1"], "p.csv"),
        (&["modes", "-", "--parts", "a,b,c"], "p.svg"),
    ] {
        refused(&[args, &["-o", name]].concat(), from(name), name);
    }
    for args in [
        &["compute", "-"][..],
        &["info", "-"],
        &["play", "-", "--at", "0,60,0", "--by", "0,-80,0"],
        &["play", "-"],
        &["clearance", "-"],
    ] {
        for name in ["p.json", "peg_hole.toml"] {
            fails(&[args, &["-o", name]].concat(), from(name), name, NO_SUCH);
        }
    }
    // A drawing that the model names, also through a link to its folder.
    let drawing = r#"<svg xmlns="http://www.w3.org/2000/svg"><rect width="4" height="2"/></svg>"#;
    std::fs::write(place("d.svg"), drawing).unwrap();
    std::fs::write(place("m.toml"), "[[part]]\nname = \"a\"\nsvg = \"d.svg\"\n").unwrap();
    std::os::unix::fs::symlink(dir.path(), place("here")).unwrap();
    refused(&["draw", "m.toml", "-o", "d.svg"], Stdio::null(), "d.svg");
    let linked = ["draw", "m.toml", "-o", "here/d.svg"];
    refused(&linked, Stdio::null(), "d.svg");
    refused(&["draw", "d.svg", "-o", "d.svg"], Stdio::null(), "d.svg");
    // A path and records.
    std::fs::write(place("p.csv"), "x,y,theta\n0,60,0\n0,50,0\n").unwrap();
    let judged = ["plan", "peg_hole.toml", "--verify", "p.csv", "-o", "p.csv"];
    refused(&judged, Stdio::null(), "p.csv");
    std::fs::write(place("r.csv"), "t,wheel.u\n0,0\n1,1\n").unwrap();
    let along = ["clearance", "geneva.toml", "--along", "r.csv"];
    let over = [&along[..], &["-o", "here/r.csv"]].concat();
    fails(&over, Stdio::null(), "r.csv", NO_SUCH);
    let model = "[parameter]\nside = 1\n[[part]]\nname = \"a\"\nloops = [[[0, 0], [\"side\", 0], [0, 1]]]\n\
        [[part]]\nname = \"b\"\nloops = [[[3, 0], [4, 0], [3, 1]]]\n\
        [[requirement]]\nname = \"gap\"\nmeasure = \"clearance\"\n";
    std::fs::write(place("m.toml"), model).unwrap();
    std::fs::write(place("r.csv"), "side\n1\n2\n").unwrap();
    let swept = ["sweep", "m.toml", "--rows", "r.csv", "-o", "here/r.csv"];
    refused(&swept, Stdio::null(), "r.csv");
    // The second of several files: nothing is written over it.
    let several = ["info", "m.toml", "peg_hole.toml", "-o", "peg_hole.toml"];
    fails(&several, Stdio::null(), "peg_hole.toml", NO_SUCH);
}

/// A file that is protected is not replaced, although its folder would let it be.
#[test]
fn read_only_files_are_not_replaced() {
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.json");
    std::fs::write(&out, "before").unwrap();
    let mut permissions = std::fs::metadata(&out).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&out, permissions).unwrap();
    let (file, place) = (model("peg_hole"), out.to_str().unwrap());
    for args in [
        &["slice", &file, "--theta", "0", "-o", place][..],
        &["plan", &file, "-o", place],
        &["export", &file, "-o", place],
    ] {
        fails(args, 2, &["out.json", "read-only", "  help: "]);
        assert_eq!(std::fs::read_to_string(&out).unwrap(), "before");
        assert_eq!(names(dir.path()), ["out.json"]);
    }
}

/// A proof is a file like others: it is written over nothing that is read or protected.
#[test]
fn proofs_are_not_written_over_what_is_kept() {
    let dir = tempfile::tempdir().unwrap();
    let place = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let (ball, kept) = (place("ball.toml"), place("kept.json"));
    std::fs::copy(model("ball_in_c"), &ball).unwrap();
    let before = std::fs::read(&ball).unwrap();
    let ends = ["plan", &ball, "--from", "0,0,0", "--to", "60,0,0"];
    let proved = |more: &[&str], words: &[&str]| {
        fails(&[&ends[..], more].concat(), 2, words);
    };
    let words = [
        "ball.toml",
        "the output is the file that is read",
        "  help: ",
    ];
    proved(&["--proof", &ball], &words);
    assert_eq!(std::fs::read(&ball).unwrap(), before);
    std::fs::create_dir(place("folder.json")).unwrap();
    proved(
        &["--proof", &place("folder.json")],
        &["folder.json", "  help: "],
    );
    proved(&["--proof", &place("none/a.json")], &["a.json", "  help: "]);
    std::fs::write(&kept, "before").unwrap();
    let mut permissions = std::fs::metadata(&kept).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&kept, permissions).unwrap();
    proved(&["--proof", &kept], &["kept.json", "read-only", "  help: "]);
    assert_eq!(std::fs::read_to_string(&kept).unwrap(), "before");
    // Nor is the answer written over the proof.
    let one = place("one.json");
    proved(&["--proof", &one, "-o", &one], &["one.json", "  help: "]);
    assert_eq!(names(dir.path()), ["ball.toml", "folder.json", "kept.json"]);
}

/// Whenever an interrupt comes, what is there is whole: the old file or the new one, and nothing beside it.
#[test]
fn an_interrupt_while_writing_leaves_a_whole_file() {
    const OLD: &str = "\"old\"";
    let dir = tempfile::tempdir().unwrap();
    let out = dir.path().join("out.json");
    let args = [
        "export",
        &model("ratchet_pawl"),
        "--general",
        "-o",
        out.to_str().unwrap(),
    ];
    let (mut old, mut new) = (0, 0);
    for attempt in 0..24 {
        std::fs::write(&out, OLD).unwrap();
        let mut child = Command::new(PROGRAM)
            .args(args)
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // As soon as there is a file beside it, which is when the writing begins; every other time at some earlier moment.
        let begin = Instant::now();
        let early = (attempt % 2 == 1).then(|| Duration::from_millis(4 * attempt));
        while names(dir.path()).len() == 1
            && child.try_wait().unwrap().is_none()
            && early.is_none_or(|t| begin.elapsed() < t)
        {
            std::thread::sleep(Duration::from_micros(100));
        }
        let signal = ["INT", "TERM"][usize::from(attempt % 4 < 2)];
        // It may be over by now.
        let _ = Command::new("sh")
            .args(["-c", &format!("kill -{signal} {} 2>&-", child.id())])
            .status();
        let output = child.wait_with_output().unwrap();
        let text = std::fs::read_to_string(&out).unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        if text == OLD {
            old += 1;
            // Until the command listens, the signal itself ends it.
            #[cfg(unix)]
            let signalled = std::os::unix::process::ExitStatusExt::signal(&output.status);
            #[cfg(not(unix))]
            let signalled = None::<i32>;
            match signalled {
                Some(number) => {
                    assert!(early.is_some() && said.is_empty(), "{attempt}: {said}");
                    assert_eq!(number, if signal == "INT" { 2 } else { 15 }, "{attempt}");
                }
                None => {
                    assert_eq!(output.status.code(), Some(2), "{attempt}: {said}");
                    assert!(said.contains("interrupted"), "{attempt}: {said}");
                }
            }
        } else {
            new += 1;
            assert_eq!(output.status.code(), Some(0), "{attempt}: {said}");
            assert!(!said.contains("interrupted"), "{attempt}: {said}");
            let value: Value = serde_json::from_str(&text).unwrap();
            assert_eq!(value["format"], "contact-space", "{attempt}");
        }
        // Until the command listens, a signal ends it before anything was made.
        assert_eq!(names(dir.path()), ["out.json"], "{attempt}: {output:?}");
    }
    println!("{old} old, {new} new");
}

/// A model and a saved space from standard input, results to standard output by name.
#[test]
fn a_dash_is_standard_input_or_output() {
    let text = std::fs::read_to_string(model("peg_hole")).unwrap();
    let info = printed(&["info", &model("peg_hole")]);
    let from = |text: &str, args: &[&str]| {
        let output = cspace(args).write_stdin(text.to_owned()).output().unwrap();
        (
            output.status.code(),
            String::from_utf8(output.stdout).unwrap(),
            String::from_utf8(output.stderr).unwrap(),
        )
    };
    assert_eq!(from(&text, &["info", "-"]).1, info);
    let drawn = printed(&["draw", &model("peg_hole")]);
    assert_eq!(from(&text, &["draw", "-"]).1, drawn);
    assert_eq!(from(&text, &["draw", "-", "-o", "-"]).1, drawn);
    // An answer is on standard output anyway.
    let (code, told, error) = from(&text, &["info", "-", "-o", "-"]);
    assert!(code == Some(2) && told.is_empty(), "{told}");
    assert!(error.contains(NO_SUCH), "{error}");
    let dir = tempfile::tempdir().unwrap();
    let saved = dir.path().join("space.json");
    printed(&["export", &model("peg_hole"), "-o", saved.to_str().unwrap()]);
    let saved = std::fs::read_to_string(saved).unwrap();
    let (code, told, _) = from(&saved, &["compute", "-"]);
    assert!(code == Some(0) && told.contains("peg"), "{told}");
    let (code, _, error) = from("[[part]]\nnmae = \"a\"\n", &["info", "-"]);
    assert!(
        code == Some(2) && error.contains("standard input:2:1"),
        "{error}"
    );
    let (code, _, error) = from(&text, &["classify", "-"]);
    assert!(code == Some(2) && error.contains("both"), "{error}");
}

/// An option that says nothing about what is written is a slip.
#[test]
fn options_without_use_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    for (name, option) in [
        ("a.json", "--slices=3"),
        ("a.ply", "--slices=3"),
        ("a.svg", "--tolerance=0.1"),
        ("a.json", "--theta-scale=2"),
        ("a.svg", "--ascii"),
        ("a.glb", "--ascii"),
        ("a.html", "--ascii"),
    ] {
        let out = dir.path().join(name);
        let args = [
            "export",
            &model("peg_hole"),
            option,
            "-o",
            out.to_str().unwrap(),
        ];
        let output = cspace(&args).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{name} {option}");
        let error = String::from_utf8(output.stderr).unwrap();
        let option = option.split('=').next().unwrap();
        assert!(error.contains(option) && error.contains("help:"), "{error}");
        assert!(!out.exists());
    }
}

/// The third coordinate of a mesh is what is asked for.
#[test]
fn theta_is_scaled() {
    let dir = tempfile::tempdir().unwrap();
    let z = |name: &str, more: &[&str]| -> f64 {
        let out = dir.path().join(name);
        let path = out.to_str().unwrap();
        let name = model("ball_in_c");
        let args = [&["export", &name, "-o", path], more].concat();
        cspace(&args).assert().success();
        let text = std::fs::read_to_string(&out).unwrap();
        let lines = text.lines().filter_map(|l| l.strip_prefix("v "));
        let heights = lines.map(|l| l.split(' ').next_back().unwrap().parse::<f64>().unwrap());
        heights.fold(f64::MIN, f64::max)
    };
    let pi = core::f64::consts::PI;
    assert!((z("a.obj", &["--theta-scale", "1"]) - pi).abs() < 1e-9);
    assert!((z("a.obj", &["--theta-scale", "2.5"]) - 2.5 * pi).abs() < 1e-9);
    assert!((z("a.obj", &[]) - pi).abs() > 0.1);
}
