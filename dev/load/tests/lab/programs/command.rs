//! The command line: what makes no sense is refused, and nothing panics where nobody listens.

use std::fs::File;
use std::process::{Command, Output, Stdio};

fn command(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cspace-load"));
    command.args(args).stdin(Stdio::null());
    command
}

/// Checks that a run ends with code 2 and prints all of `words`.
#[track_caller]
fn fails(output: &Output, words: &[&str]) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    for word in words {
        assert!(said.contains(word), "no {word:?} in: {said}");
    }
    assert!(!said.contains("panicked"), "{said}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    for (args, word) in [
        (["--threads", "99999999"], "1024"),
        (["--threads", "-1"], "1024"),
        (["--minutes", "nan"], "0 or more"),
        (["--minutes", "-5"], "0 or more"),
        (["--minutes", "inf"], "0 or more"),
        (["--per-pair", "0"], "1..=1000000"),
        (["--per-pair", "4000000000"], "1..=1000000"),
        (["--only", "18446744073709551615"], "is not in 0.."),
    ] {
        fails(&command(&args).output().unwrap(), &[args[0], word]);
    }
}

#[test]
fn the_last_number_is_a_pair_too() {
    let args = ["--only", "18446744073709551614", "--per-pair", "1"];
    let output = command(&args).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(said.contains("next pair 18446744073709551615"), "{said}");
}

#[test]
fn a_state_is_a_small_regular_file() {
    let folder = tempfile::tempdir().unwrap();
    let (large, path) = (folder.path().join("large"), folder.path());
    // It has holes: nothing of it is on the disk.
    File::create(&large).unwrap().set_len(1 << 40).unwrap();
    for (state, word) in [
        ("/dev/zero", "regular file"),
        (path.to_str().unwrap(), "regular file"),
        (large.to_str().unwrap(), "too large"),
        ("/dev/null/state", "Not a directory"),
    ] {
        let output = command(&["--state", state, "--pairs", "0"]).output();
        fails(&output.unwrap(), &[state, word]);
    }
    let new = path.join("new");
    let args = ["--pairs", "1", "--per-pair", "1", "--state"];
    for _ in 0..2 {
        let output = command(&args).arg(&new).output().unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert!(new.is_file());
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_told() {
    for args in [&["--list"][..], &["--pairs", "0"]] {
        let full = || File::options().write(true).open("/dev/full").unwrap();
        let output = command(args).stdout(full()).output().unwrap();
        fails(&output, &["error: standard output: No space left"]);
        // Not even that can be said.
        let output = command(args).stdout(full()).stderr(full()).output();
        assert_eq!(output.unwrap().status.code(), Some(2));
    }
}

#[test]
fn a_reader_may_go_before_the_end() {
    for args in [&["--list"][..], &["--pairs", "1", "--per-pair", "1"]] {
        let mut child = command(args)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{args:?}");
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{args:?}");
    }
}
