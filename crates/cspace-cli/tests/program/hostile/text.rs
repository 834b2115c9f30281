//! Control characters in names, files and arguments: a terminal would obey them.

use std::ffi::OsStr;
use std::os::unix::ffi::OsStrExt;
use std::process::{Command, Stdio};

use serde_json::Value;

use super::bounds::{PROGRAM, fails, run_to};
use crate::helpers::model;

const SQUARE: &str = "[[0, 0], [1, 0], [1, 1], [0, 1]]";

#[test]
fn arguments_are_shown_escaped() {
    let file = model("ratchet_mechanism");
    let evil = "a\u{1b}[2J\nerror: b\u{9b}31m";
    let shown = r"a\u{1b}[2J\nerror: b\u{9b}31m";
    fails(&["info", evil], 2, &[shown]);
    fails(&["info", &format!("{evil}.toml")], 2, &[shown]);
    fails(&["info", &file, "-o", &format!("none/{evil}")], 2, &[shown]);
    fails(&["export", &file, "-o", evil], 2, &[shown]);
    fails(&["compute", &file, "--pair", evil], 2, &[shown]);
    fails(
        &["compute", &file, "--pair", &format!("link,{evil}")],
        2,
        &[r"a\u{1b}[2J\nerror: b"],
    );
    for args in [
        &[evil][..],
        &["info", &file, "--format", evil],
        &["info", &file, "--threads", evil],
        &["info", &file, &format!("--{evil}")],
        &["slice", &file, "--theta", evil],
        &["compute", &file, "--window", &format!("0,{evil}")],
        &["play", &file, "--pair", "driver,link", "--at", evil],
        &["plan", &file, "--gravity", evil],
        &["slice", &file, "--theta=0", "-o", &format!("{evil}.txt")],
        &["export", &file, "--tolerance", evil],
        &["completions", evil],
    ] {
        fails(args, 2, &["error: ", "u{1b}[2J"]);
        // No line is made up.
        let output = run_to(Stdio::piped(), args);
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(!said.contains("\nerror: b"), "{said}");
    }
    // Nor what is no text at all.
    let output = Command::new(PROGRAM)
        .args([OsStr::new("info"), OsStr::from_bytes(b"\xff\x1b[2J.toml")])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(!output.stderr.contains(&0x1b));
}

/// Messages quote only a short piece of an enormous row or name.
#[test]
fn enormous_rows_and_names_are_cut() {
    const LENGTH: usize = 5_000_000;
    let (long, file) = ("z".repeat(LENGTH), model("peg_hole"));
    for rows in [
        "\0".repeat(LENGTH),
        long.clone(),
        format!("x,y,theta\n0,{long},0\n"),
        format!("x,y,theta\n0,0,{long}\n"),
        format!("x,y,theta,{long},{long}\n0,0,0,1,2\n"),
    ] {
        let output = crate::helpers::Command::new(PROGRAM)
            .args(["classify", &file, "--format", "json"])
            .write_stdin(rows)
            .output()
            .unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(said.len() < 1000 && said.contains('…'), "{}", said.len());
    }
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("a.json");
    let loops = "[[[0, 0], [1, 0], [1, 1], [0, 1]]]";
    for text in [
        format!(r#"{{"format": "{long}"}}"#),
        format!(
            r#"{{"part": [{{"name": "{long}", "loops": {loops}}}, {{"name": "b", "loops": {loops}}}]}}"#
        ),
    ] {
        std::fs::write(&file, text).unwrap();
        let output = run_to(
            Stdio::piped(),
            &["compute", file.to_str().unwrap(), "--pair", "b,c"],
        );
        assert_eq!(output.status.code(), Some(2));
        assert!(output.stderr.len() < 20_000, "{}", output.stderr.len());
    }
}

#[test]
fn rows_are_shown_escaped() {
    use crate::helpers::Command;
    for (rows, words) in [
        ("x,y,theta\n0,\u{1b}[2J,0\n", "line 2"),
        ("x,y,theta\n0,0,\u{1b}[2J\n", "line 2"),
        ("x,y,\u{1b}[2J\n0,0,0\n", "line 1"),
        ("\u{7},x\n", "line 1"),
    ] {
        let mut command = Command::new(PROGRAM);
        command
            .args(["classify", &model("peg_hole")])
            .write_stdin(rows);
        let output = command.assert().code(2).get_output().clone();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains(words), "{said}");
        assert!(
            !said.contains(|c: char| c.is_control() && c != '\n'),
            "{said:?}"
        );
    }
}

/// No command takes such a model, so that none writes what is in it.
#[test]
fn names_of_models_and_spaces_are_plain() {
    let dir = tempfile::tempdir().unwrap();
    let place = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let part = |name: &str| format!("[[part]]\nname = \"{name}\"\nloops = [{SQUARE}]\n");
    let good = part("b");
    for (text, words) in [
        (
            format!("name = \"\\u001b[2J\"\n{}{good}", part("a")),
            "`name`",
        ),
        (
            format!("unit = \"\\u009bm\"\n{}{good}", part("a")),
            "`unit`",
        ),
        (format!("{}{good}", part("a\\nb")), r"a\nb"),
    ] {
        let file = place("model.toml");
        std::fs::write(&file, text).unwrap();
        for command in ["info", "compute"] {
            fails(
                &[command, &file],
                2,
                &["model.toml:", "control character", words],
            );
        }
        fails(
            &["export", &file, "-o", &place("a.svg")],
            2,
            &["control character"],
        );
    }
    let saved = place("saved.json");
    assert!(
        run_to(
            Stdio::piped(),
            &["export", &model("peg_hole"), "-o", &saved]
        )
        .status
        .success()
    );
    let space: Value = serde_json::from_slice(&std::fs::read(&saved).unwrap()).unwrap();
    for pointer in ["/fixed/name", "/moving/name", "/name", "/unit"] {
        let mut bad = space.clone();
        *bad.pointer_mut(pointer).unwrap() = "\u{1b}[2J".into();
        std::fs::write(&saved, bad.to_string()).unwrap();
        for command in ["info", "compute"] {
            fails(
                &[command, &saved],
                2,
                &["saved.json", "control character", r"\u{1b}[2J"],
            );
        }
    }
    // A model that is called by its file.
    let file = place("a\u{1b}[2J.toml");
    std::fs::write(&file, part("a") + &good).unwrap();
    let output = run_to(Stdio::piped(), &["compute", &file]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains(r"a\u{1b}[2J") && !text.contains('\u{1b}'),
        "{text}"
    );
    let picture = place("b.svg");
    assert!(
        run_to(Stdio::piped(), &["export", &file, "-o", &picture])
            .status
            .success()
    );
    let picture = std::fs::read_to_string(picture).unwrap();
    assert!(!picture.contains(|c: char| c.is_control() && c != '\n'));
}
