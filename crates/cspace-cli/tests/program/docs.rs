//! The pages that teach: every command line in them is run, and prints what the page says.
//!
//! A block of `toml NAME` is the file of that name, a block of `console` has command lines behind `$ ` and what each prints.
//! A block of `console long` takes seconds, and is run where `CSPACE_LONG=1` is set.
//! `CSPACE_DOCS=write cargo test -p cspace-cli docs::` writes what is printed into the pages.

use std::path::Path;
use std::process::Command;

use cspace_oracle::is_long;

use serde_json::Value;

use crate::helpers::{json, json_beside_notes, printed};

/// A page with what the commands print now, and how many there are.
fn run_page(text: &str, folder: &Path) -> (String, usize) {
    let program = Path::new(env!("CARGO_BIN_EXE_cspace"));
    let path = format!(
        "{}:{}",
        program.parent().unwrap().display(),
        std::env::var("PATH").unwrap_or_default()
    );
    let print = |command: &str| {
        let output = Command::new("sh")
            .args(["-c", &format!("{{ {command}\n}} 2>&1")])
            .env("PATH", &path)
            .env("CSPACE_CACHE", "off")
            .current_dir(folder)
            .output()
            .unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let (mut page, mut count) = (String::new(), 0);
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        page += &format!("{line}\n");
        let Some(info) = line.trim_start().strip_prefix("```") else {
            assert!(!line.starts_with("$ "), "a command outside a block: {line}");
            continue;
        };
        let body: Vec<&str> = lines.by_ref().take_while(|l| l.trim() != "```").collect();
        match info.split_whitespace().collect::<Vec<_>>()[..] {
            ["console", "long"] if !is_long() => {
                page.extend(body.iter().map(|l| format!("{l}\n")));
            }
            ["console"] | ["console", "long"] => {
                assert!(body[0].starts_with("$ "), "{}", body[0]);
                for command in body.iter().filter_map(|l| l.strip_prefix("$ ")) {
                    let printed = print(command);
                    let is_wrong = [
                        "unrecognized subcommand",
                        "unexpected argument",
                        "has no option",
                    ];
                    assert!(!is_wrong.iter().any(|w| printed.contains(w)), "{printed}");
                    page += &format!("$ {command}\n{printed}");
                    count += 1;
                }
            }
            ref other => {
                if let ["toml", name] = other[..] {
                    std::fs::write(folder.join(name), body.join("\n") + "\n").unwrap();
                }
                assert!(!body.iter().any(|l| l.starts_with("cspace ")), "{body:?}");
                page.extend(body.iter().map(|l| format!("{l}\n")));
            }
        }
        let indent = &line[..line.len() - line.trim_start().len()];
        page += &format!("{indent}```\n");
    }
    (page, count)
}

/// Seconds are not the same twice.
fn without_seconds(page: &str) -> String {
    let line = |l: &str| match l.starts_with("  time  ") {
        true => "  time\n".to_owned(),
        false => format!("{l}\n"),
    };
    page.lines().map(line).collect()
}

#[track_caller]
fn is_true(name: &str, least: usize) {
    let file = format!("{}/../../docs/{name}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&file).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let (page, count) = run_page(&text, folder.path());
    assert!(count >= least, "{count} commands in {name}");
    if std::env::var("CSPACE_DOCS").is_ok_and(|v| v == "write") {
        std::fs::write(file, page).unwrap();
        return;
    }
    let (expected, found) = (without_seconds(&text), without_seconds(&page));
    for (n, (expected, found)) in expected.lines().zip(found.lines()).enumerate() {
        assert_eq!(
            found,
            expected,
            "{name}:{}: see the top of this test's file",
            n + 1
        );
    }
    assert_eq!(found.lines().count(), expected.lines().count(), "{name}");
}

#[test]
fn how_a_model_is_written() {
    is_true("model.md", 8);
}

#[test]
fn designs() {
    is_true("design.md", 4);
}

#[test]
fn tolerances() {
    is_true("tolerances.md", 1);
}

#[test]
fn three_first_models() {
    is_true("first-models.md", 14);
}

#[test]
fn ways() {
    is_true("planning.md", 7);
}

#[test]
fn taking_apart() {
    is_true("assembly.md", 3);
}

#[test]
fn clearances() {
    is_true("clearance.md", 1);
}

#[test]
fn operating_modes() {
    is_true("modes.md", 6);
}

#[test]
fn cages_and_escape() {
    is_true("escape.md", 2);
}

#[test]
fn motion() {
    is_true("motion.md", 6);
}

#[test]
fn a_skill_for_assistants() {
    is_true("../skills/cspace/SKILL.md", 7);
}

/// The page, and its models against the forces of statics, for several angles.
#[test]
fn wedges_and_screws() {
    is_true("wedges-and-screws.md", 5);
    let page = format!(
        "{}/../../docs/wedges-and-screws.md",
        env!("CARGO_MANIFEST_DIR")
    );
    let page = std::fs::read_to_string(page).unwrap();
    let block = |name: &str| -> String {
        let (_, rest) = page.split_once(&format!("```toml {name}\n")).unwrap();
        rest.split_once("```").unwrap().0.to_owned()
    };
    let folder = tempfile::tempdir().unwrap();
    let moved = |model: &str, set: &[&str]| {
        let file = folder.path().join("model.toml");
        std::fs::write(&file, model).unwrap();
        let set: Vec<&str> = set.iter().flat_map(|set| ["--set", set]).collect();
        let asked = ["simulate", file.to_str().unwrap(), "--time", "1"];
        json_beside_notes(&[&asked[..], &["--every", "0.25"], &set[..]].concat())
    };
    let number = |value: &Value| value.as_f64().unwrap();
    let near = |what: &str, found: f64, known: f64| {
        assert!(
            (found / known - 1.0).abs() < 1e-9,
            "{what}: {found} {known}"
        );
    };
    let peak = |answer: &Value, of: &str| number(&answer["peaks"]["drives"][0][of]["value"]);
    let at_end = |answer: &Value, part: &str| {
        number(&answer["samples"].as_array().unwrap().last().unwrap()[part])
    };
    let slips = |angle: f64| {
        let answer = moved(&block("wedge.toml"), &[&format!("angle={angle:?}")]);
        let mut events = answer["events"].as_array().unwrap().iter();
        events.any(|e| e["kind"] == "snap")
    };
    let phi = f64::atan(0.1);
    assert!(!slips(phi * (1.0 - 1e-3)) && slips(phi * (1.0 + 1e-3)));
    let lift = block("wedge.toml") + &block("drive.toml");
    for angle in [2.0_f64, 10.0, 30.0].map(f64::to_radians) {
        let answer = moved(&lift, &[&format!("angle={angle:?}")]);
        let force = peak(&answer, "force");
        near("force", force, 1e6 * (angle + phi).tan());
        let gain = 1e6 * at_end(&answer, "jack") / (force * at_end(&answer, "wedge"));
        near("efficiency", gain, angle.tan() / (angle + phi).tan());
    }
    let phi = f64::atan(0.12);
    for lead in [2.0, 4.0, 8.0, 12.0] {
        let alpha = f64::atan(lead / (core::f64::consts::PI * 18.0));
        for (turns, along) in [(1.0, phi), (-1.0, -phi)] {
            let set = [format!("lead={lead:?}"), format!("turns={turns:?}")];
            let answer = moved(&block("screw.toml"), &[&set[0], &set[1]]);
            near("rise", at_end(&answer, "nut"), turns * lead);
            let force = 2e6 * (alpha + along).tan();
            near("force", peak(&answer, "force"), force);
            // In N·mm, by what a turn takes.
            let torque = peak(&answer, "power") / (core::f64::consts::TAU * turns * 1e3);
            near("torque", torque, force * 9.0 / 1e3);
        }
    }
}

/// The README shows a model and what is computed of it.
#[test]
fn the_first_model() {
    let file = format!("{}/../../README.md", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(file).unwrap();
    let block = |opening: &str| -> String {
        let (_, rest) = text.split_once(opening).unwrap();
        rest.split_once("```").unwrap().0.to_owned()
    };
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("latch.toml");
    std::fs::write(&model, block("```toml\n")).unwrap();
    let shown = block("```console\n$ cspace compute latch.toml\n");
    let computed = printed(&["compute", model.to_str().unwrap()]);
    assert_eq!(without_seconds(&shown), without_seconds(&computed));
    let document = |name: &str| {
        let file = format!("{}/../../{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(file).unwrap()
    };
    // The documents know one latch.
    let first = document("docs/first-models.md");
    assert!(first.contains(&block("```toml\n")), "docs/first-models.md");
    let counted = &json(&["compute", model.to_str().unwrap()])[0]["statistics"];
    let architecture = document("ARCHITECTURE.md").replace(',', "");
    for (row, key) in [
        ("sheets", "sheets"),
        ("pairs", "pairs"),
        ("pair events", "pair_events"),
        ("branches", "branches"),
        ("triple events", "triple_events"),
        ("clusters", "clusters"),
        ("cells", "cells"),
    ] {
        let line = format!("| {row} | {} |", counted[key]);
        assert!(architecture.contains(&line), "ARCHITECTURE.md: {line}");
    }
}
