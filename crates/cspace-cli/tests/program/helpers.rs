//! Running the command, and what it says.

use std::ffi::OsStr;
use std::io::Write;
use std::path::Path;
use std::process::{Output, Stdio};

use serde_json::Value;

/// The program that is tested.
pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_cspace");

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
    let mut command = Command::new(PROGRAM);
    command.args(args).env("CSPACE_CACHE", "off");
    command
}

/// Program to run, with what it reads.
pub(crate) struct Command {
    command: std::process::Command,
    input: Vec<u8>,
}

impl Command {
    pub(crate) fn new(program: impl AsRef<OsStr>) -> Self {
        Self {
            command: std::process::Command::new(program),
            input: Vec::new(),
        }
    }

    pub(crate) fn args<A: AsRef<OsStr>>(&mut self, args: impl IntoIterator<Item = A>) -> &mut Self {
        self.command.args(args);
        self
    }

    pub(crate) fn arg(&mut self, arg: impl AsRef<OsStr>) -> &mut Self {
        self.args([arg])
    }

    pub(crate) fn env(&mut self, name: &str, value: impl AsRef<OsStr>) -> &mut Self {
        self.command.env(name, value);
        self
    }

    pub(crate) fn current_dir(&mut self, folder: impl AsRef<Path>) -> &mut Self {
        self.command.current_dir(folder);
        self
    }

    pub(crate) fn write_stdin(&mut self, input: impl Into<Vec<u8>>) -> &mut Self {
        self.input = input.into();
        self
    }

    /// Output of the run, once it has ended.
    pub(crate) fn output(&mut self) -> std::io::Result<Output> {
        let piped = (self.command.stdin(Stdio::piped()))
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = piped.spawn()?;
        let (stdin, input) = (child.stdin.take(), self.input.clone());
        // It may print before it has read all, or end without reading.
        let writer = std::thread::spawn(move || stdin.map(|mut s| s.write_all(&input)));
        let output = child.wait_with_output();
        drop(writer.join());
        output
    }

    pub(crate) fn assert(&mut self) -> Ended {
        let run = format!("{:?}", self.command);
        let output = self.output().unwrap_or_else(|e| panic!("{run}: {e}"));
        Ended { run, output }
    }
}

/// A run that has ended.
pub(crate) struct Ended {
    run: String,
    output: Output,
}

impl Ended {
    #[track_caller]
    pub(crate) fn success(self) -> Self {
        self.code(0)
    }

    #[track_caller]
    pub(crate) fn code(self, code: i32) -> Self {
        let Output { status, stderr, .. } = &self.output;
        let message = String::from_utf8_lossy(stderr);
        assert_eq!(status.code(), Some(code), "{}: {message}", self.run);
        self
    }

    #[track_caller]
    pub(crate) fn stdout(self, expected: impl AsRef<[u8]>) -> Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let (found, expected) = (&self.output.stdout, expected.as_ref());
        assert_eq!(text(found), text(expected), "{}", self.run);
        self
    }

    pub(crate) fn get_output(&self) -> &Output {
        &self.output
    }
}

/// Output of a run that answers with yes or no, and says nothing else.
#[track_caller]
pub(crate) fn printed(args: &[&str]) -> String {
    let output = answered(args);
    assert!(output.stderr.is_empty(), "{args:?}: {output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// A run that answers with yes or no.
#[track_caller]
fn answered(args: &[&str]) -> Output {
    let output = cspace(args).output().unwrap();
    // These have answers that are a no; the others have values.
    const ASKED: [&str; 10] = [
        "check",
        "clearance",
        "disassemble",
        "modes",
        "plan",
        "play",
        "simulate",
        "solve",
        "sweep",
        "tolerances",
    ];
    let most = i32::from(ASKED.contains(&args[0]));
    let code = output.status.code();
    assert!(code.is_some_and(|c| c <= most), "{args:?}: {output:?}");
    output
}

/// The answer of a command in its frame.
#[track_caller]
pub(crate) fn framed(args: &[&str]) -> Value {
    let args = [args, &["--json"]].concat();
    let output = answered(&args);
    assert!(output.stderr.is_empty(), "{args:?}: {output:?}");
    of_code(&output)
}

/// The answer of a run, whose exit code is 1 where the outcome is a no, and 0 elsewhere.
#[track_caller]
fn of_code(output: &Output) -> Value {
    const NO: [&str; 13] = [
        "blocked",
        "cage",
        "fails",
        "from-blocked",
        "jammed",
        "jams",
        "locked",
        "no-path",
        "none",
        "not-met",
        "overlaps",
        "stopped",
        "to-blocked",
    ];
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    let is_no = NO.iter().any(|no| answer["outcome"] == *no);
    let code = output.status.code();
    assert_eq!(code, Some(i32::from(is_no)), "{}", answer["outcome"]);
    answer
}

/// Content of an answer without its frame: of commands on pairs the list of these, of commands on one pair that.
#[track_caller]
pub(crate) fn json(args: &[&str]) -> Value {
    unframed(args[0], framed(args))
}

/// As [`json`], of a run that may print notes to stderr.
#[track_caller]
pub(crate) fn json_beside_notes(args: &[&str]) -> Value {
    let output = answered(&[args, &["--json"]].concat());
    unframed(args[0], of_code(&output))
}

/// Content of a command's answer, whose frame has all its keys.
#[track_caller]
pub(crate) fn unframed(command: &str, mut framed: Value) -> Value {
    assert_eq!(framed["answer"], command);
    assert_eq!(framed["version"], 1);
    assert_eq!(framed["units"]["angle"], "rad");
    assert!(framed["outcome"].is_string(), "{framed}");
    match command {
        _ if framed["files"].is_array() => framed["files"].take(),
        "compute" | "play" => framed["pairs"].take(),
        "plan" | "slice" => framed["pairs"][0].take(),
        "classify" => framed["pairs"][0]["rows"].take(),
        "sweep" => framed["rows"].take(),
        "tolerances" if framed["pairs"].is_array() => framed["pairs"][0].take(),
        "check" | "tolerances" if framed["requirements"].is_array() => {
            framed["requirements"].take()
        }
        _ => framed,
    }
}

/// A run that fails with this code says all of `words`, and prints nothing to stdout but the error, where that is to be JSON.
#[track_caller]
pub(crate) fn fails(mut command: Command, code: i32, words: &[&str]) {
    let output = command.assert().code(code).get_output().clone();
    let error = || serde_json::from_slice::<Value>(&output.stdout).ok();
    let is_error = || error().is_some_and(|e| e["error"]["message"].is_string());
    assert!(output.stdout.is_empty() || is_error(), "{output:?}");
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

/// A model file of a text, in a folder of its own.
pub(crate) fn file(text: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.toml");
    std::fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}
