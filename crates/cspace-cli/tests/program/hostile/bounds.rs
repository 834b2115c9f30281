//! Running the command with little time and memory.

use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

/// Address space of a run, in kilobytes. What the largest files take is less.
const MEMORY: u32 = 4_000_000;
/// Processor time of a run, in seconds; most take a hundredth.
const WORK: u32 = 40;
/// Time limit of a run, which even a busy machine reaches only if the command hangs.
const PATIENCE: Duration = Duration::from_secs(300);

pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_cspace");

/// Runs the command with its standard output there.
pub(crate) fn run_to(out: impl Into<Stdio>, args: &[&str]) -> Output {
    let begin = Instant::now();
    let script = format!("ulimit -v {MEMORY}; ulimit -t {WORK}; exec \"$0\" \"$@\"");
    let child = Command::new("sh")
        .args(["-c", &script, PROGRAM])
        .args(args)
        // Every thread has address space of its own, and some machines have many.
        .env("RAYON_NUM_THREADS", "2")
        .stdin(Stdio::null())
        .stdout(out)
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(
        begin.elapsed() < PATIENCE,
        "{args:?}: {:?}",
        begin.elapsed()
    );
    output
}

/// A run that fails with this code, says all of `words`, prints nothing else, and sends the terminal nothing to obey.
#[track_caller]
pub(crate) fn fails(args: &[&str], code: i32, words: &[&str]) {
    let output = run_to(Stdio::piped(), args);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(code), "{args:?}: {said}");
    assert!(output.stdout.is_empty(), "{args:?}");
    for word in words {
        assert!(said.contains(word), "{args:?}: no {word:?} in: {said}");
    }
    assert!(
        !said.contains(|c: char| c.is_control() && c != '\n'),
        "{said:?}"
    );
    assert!(said.len() < 2000 && !said.contains("panicked"), "{said}");
}

/// The names of all files in a folder.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let name = |e: std::io::Result<std::fs::DirEntry>| e.unwrap().file_name();
    let mut names: Vec<String> = (std::fs::read_dir(folder).unwrap())
        .map(|e| name(e).to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}
