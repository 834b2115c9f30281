//! Output of the two programs when there is nothing to check.

#![allow(clippy::unwrap_used)]

use std::process::{Command, Output};

fn said(output: &Output) -> String {
    let text = [&output.stdout, &output.stderr].map(|b| String::from_utf8_lossy(b).into_owned());
    text.concat()
}

fn checker(argument: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_cspace-check");
    Command::new(program).arg(argument).output().unwrap()
}

/// The program in Python; none where that is not there.
fn python(argument: &str) -> Option<Output> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/check.py");
    Command::new("python3")
        .args([script, argument])
        .output()
        .ok()
}

/// Both programs refuse a file that holds `text`, and say what is expected of them.
#[track_caller]
fn refused(text: &str, words: &[&str]) {
    let file = std::env::temp_dir().join(format!(
        "cspace-check-{}-{}.json",
        std::process::id(),
        text.len()
    ));
    std::fs::write(&file, text).unwrap();
    let path = file.to_str().unwrap();
    let outputs = [Some(checker(path)), python(path)];
    std::fs::remove_file(&file).unwrap();
    for output in outputs.iter().flatten() {
        let said = said(output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(!said.contains("Traceback"), "{said}");
        assert!(words.iter().all(|w| said.contains(w)), "{said}");
    }
}

#[test]
fn an_answer_without_proof_says_so() {
    refused(
        r#"{ "answer": "plan", "pairs": [{ "verdict": "path", "path": [] }] }"#,
        &["this answer holds no proof: its verdict is path"],
    );
    refused(
        r#"{ "verdict": "no-path", "unproved": "too large" }"#,
        &["this answer holds no proof", "no-path", "too large"],
    );
}

#[test]
fn what_is_no_proof_at_all_is_refused() {
    refused("{}", &["error"]);
    refused("[1]", &["error"]);
    refused(r#"{ "version": 1 }"#, &["error"]);
    refused(r#"{ "proof": { "version": 1, "fixed": 3 } }"#, &["error"]);
    assert!(said(&checker("no such file")).contains("no such file"));
}

#[test]
fn help_tells_how_it_is_used() {
    let help = checker("--help");
    assert!(help.status.success());
    assert!(said(&help).contains("usage: cspace-check PROOF.json"));
    let without = Command::new(env!("CARGO_BIN_EXE_cspace-check"))
        .output()
        .unwrap();
    assert_eq!(without.status.code(), Some(1));
    assert!(said(&without).contains("usage"));
}
