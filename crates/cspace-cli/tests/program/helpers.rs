//! Running the command, and what it says.

use assert_cmd::Command;
use serde_json::Value;

/// A pair of each class, all of one mechanism.
pub(crate) const PAIRS: [(&str, &str); 6] = [
    ("frame,driver", "lower"),
    ("frame,link", "lower"),
    ("frame,ratchet", "lower"),
    ("link,pawl", "lower"),
    ("driver,link", "fixed-axes"),
    ("ratchet,pawl", "symmetric"),
];

pub(crate) fn model(name: &str) -> String {
    format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

pub(crate) fn mechanism() -> String {
    model("ratchet_mechanism")
}

pub(crate) fn cspace(args: &[&str]) -> Command {
    let mut command = Command::cargo_bin("cspace").unwrap();
    command.args(args).env("CSPACE_CACHE", "off");
    command
}

pub(crate) fn printed(args: &[&str]) -> String {
    let output = cspace(args).assert().success().get_output().clone();
    assert!(output.stderr.is_empty(), "{args:?}: {output:?}");
    String::from_utf8(output.stdout).unwrap()
}

pub(crate) fn json(args: &[&str]) -> Value {
    let args = [args, &["--format", "json"]].concat();
    serde_json::from_str(&printed(&args)).unwrap()
}

/// As [`json`], of a run that may print notes to stderr.
pub(crate) fn json_beside_notes(args: &[&str]) -> Value {
    let output = cspace(&[args, &["--format", "json"]].concat())
        .assert()
        .success()
        .get_output()
        .clone();
    serde_json::from_slice(&output.stdout).unwrap()
}

/// A run that fails with this code says all of `words`, and prints nothing to stdout.
#[track_caller]
pub(crate) fn fails(mut command: Command, code: i32, words: &[&str]) {
    let output = command.assert().code(code).get_output().clone();
    assert!(output.stdout.is_empty(), "{output:?}");
    let message = String::from_utf8(output.stderr).unwrap();
    for word in words {
        assert!(message.contains(word), "no {word:?} in: {message}");
    }
}

pub(crate) fn with_rows(args: &[&str], rows: &str) -> Command {
    let mut command = cspace(&[&["classify"], args].concat());
    command.write_stdin(rows.to_owned());
    command
}

/// The classes of rows of numbers.
pub(crate) fn classes(args: &[&str], header: &str, rows: &[Vec<f64>]) -> Vec<String> {
    let mut text = format!("{header}\n");
    for row in rows {
        let row: Vec<String> = row.iter().map(f64::to_string).collect();
        text += &(row.join(",") + "\n");
    }
    let output = with_rows(args, &text)
        .assert()
        .success()
        .get_output()
        .clone();
    let answer = String::from_utf8(output.stdout).unwrap();
    let lines: Vec<&str> = answer.lines().collect();
    assert_eq!(lines[0], format!("{header},class"));
    assert_eq!(lines.len(), rows.len() + 1);
    (lines[1..].iter().zip(text.lines().skip(1)))
        .map(|(line, given)| line.strip_prefix(&format!("{given},")).unwrap().to_owned())
        .collect()
}
