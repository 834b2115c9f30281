//! Spaces that are kept for the next command on the same pair.

use std::fs;
use std::path::{Path, PathBuf};

use crate::helpers::Command;

use crate::helpers::{cspace, model};

/// A command that keeps every space in a folder, however soon it is computed.
fn keeping(folder: &Path, args: &[&str]) -> Command {
    let mut command = cspace(args);
    command
        .env("CSPACE_CACHE", folder)
        .env("CSPACE_CACHE_AFTER", "0");
    command
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let Ok(files) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut all: Vec<PathBuf> = files.map(|f| f.unwrap().path()).collect();
    all.sort();
    all
}

/// The answer of a command, and whether its notes say that the space was computed before.
fn answer(mut command: Command) -> (String, bool) {
    let output = command.assert().success().get_output().clone();
    let notes = String::from_utf8(output.stderr).unwrap();
    (
        String::from_utf8(output.stdout).unwrap(),
        notes.contains("computed before"),
    )
}

/// An answer without what differs from run to run, and whether it is told that the space was read.
fn without_seconds(text: &str) -> (serde_json::Value, bool) {
    let mut answer: serde_json::Value = serde_json::from_str(text).unwrap();
    let pair = answer["pairs"][0].as_object_mut().unwrap();
    pair.remove("seconds");
    let cached = pair.remove("cached") == Some(true.into());
    (answer, cached)
}

#[test]
fn what_was_kept_is_not_computed_again() {
    let folder = tempfile::tempdir().unwrap();
    let (cache, model) = (folder.path().join("a").join("b"), model("peg_hole"));
    let asked = ["compute", &model, "-v", "--format", "json"];
    let first = answer(keeping(&cache, &asked));
    assert!(!first.1);
    assert_eq!(entries(&cache).len(), 1);
    let second = answer(keeping(&cache, &asked));
    assert!(second.1);
    let (first, second) = (without_seconds(&first.0), without_seconds(&second.0));
    assert_eq!((first.0, false, true), (second.0, first.1, second.1));
    // Another command, on the space that was kept and on one that is computed.
    let asked = ["draw", &model, "--at", "0,18,0", "-o", "-"];
    let kept = answer(keeping(&cache, &asked)).0;
    assert_eq!(entries(&cache).len(), 1);
    assert!(kept.contains("in contact") || kept.contains("free"));
    assert_eq!(kept, answer(cspace(&asked)).0);
    assert_eq!(
        kept,
        answer(keeping(&cache, &[&asked[..], &["--no-cache"]].concat())).0
    );
}

#[test]
fn other_questions_are_computed() {
    let folder = tempfile::tempdir().unwrap();
    let cache = folder.path();
    let path = cache.join("model.toml");
    let square = |name: &str, r: f64| {
        format!(
            "[[part]]\nname = \"{name}\"\nloops = [[[-{r}, -{r}], [{r}, -{r}], [{r}, {r}], [-{r}, {r}]]]\n"
        )
    };
    let cache = cache.join("cache");
    let write = |text: String| fs::write(&path, text).unwrap();
    let ask = |more: &[&str]| {
        let asked = [&["compute", path.to_str().unwrap(), "-v"][..], more].concat();
        answer(keeping(&cache, &asked)).1
    };
    write(square("a", 1.0) + &square("b", 2.0));
    assert!(!ask(&[]) && ask(&[]));
    assert!(!ask(&["--no-cache"]));
    assert!(!ask(&["--general"]) && ask(&["--general"]));
    assert!(!ask(&["--window", "0,1"]) && ask(&["--window", "0,1"]));
    assert!(!ask(&["--window", "0,1.5"]));
    assert!(!ask(&["--pair", "b,a"]));
    assert_eq!(entries(&cache).len(), 5);
    // One last bit of a coordinate.
    let near = f64::from_bits(2.0_f64.to_bits() + 1);
    write(square("a", 1.0) + &square("b", near));
    assert!(!ask(&[]));
    // The unit and the name of the model say nothing of the space.
    write(format!(
        "unit = \"mm\"\n{}{}",
        square("a", 1.0),
        square("b", near)
    ));
    assert!(ask(&[]));
    write(square("a", 1.0) + &square("c", near));
    assert!(!ask(&[]));
}

#[test]
fn damaged_entries_are_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let (cache, model) = (folder.path().to_owned(), model("peg_hole"));
    let ask = || answer(keeping(&cache, &["compute", &model, "-v"])).1;
    assert!(!ask());
    let entry = entries(&cache).remove(0);
    let whole = fs::read(&entry).unwrap();
    let mut flipped = whole.clone();
    let middle = flipped.len() / 2;
    flipped[middle] ^= 1;
    for damaged in [&[][..], &whole[..20], &whole[..whole.len() - 1], &flipped] {
        fs::write(&entry, damaged).unwrap();
        assert!(!ask());
        assert!(ask());
    }
    assert_eq!(entries(&cache), [entry]);
}

/// Where nothing can be kept, the answer is the same.
#[test]
fn a_folder_that_cannot_be_written_does_not_matter() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "no folder").unwrap();
    let model = model("peg_hole");
    let asked = ["draw", &model, "--at", "0,18,0", "-o", "-"];
    let plain = answer(cspace(&asked)).0;
    let mut places = vec![file.clone(), file.join("below")];
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let closed = folder.path().join("closed");
        fs::create_dir(&closed).unwrap();
        fs::set_permissions(&closed, fs::Permissions::from_mode(0o500)).unwrap();
        places.push(closed);
    }
    for place in places {
        let compute = answer(keeping(&place, &["compute", &model, "-v"]));
        assert!(!compute.1);
        assert_eq!(answer(keeping(&place, &asked)).0, plain);
    }
    assert_eq!(fs::read_to_string(&file).unwrap(), "no folder");
    // What is computed soon is not kept, nor anything where that is switched off.
    let cache = folder.path().join("cache");
    let mut command = keeping(&cache, &["compute", &model]);
    answer({
        command.env("CSPACE_CACHE_AFTER", "1e9");
        command
    });
    assert!(entries(&cache).is_empty());
}

/// Requirements and motions are measured on spaces that were kept, with the same answers; all these commands share them.
#[test]
fn requirements_and_motions_use_what_was_kept() {
    let folder = tempfile::tempdir().unwrap();
    let (cache, model) = (folder.path(), model("ratchet_pawl"));
    let pairs = || entries(cache).len();
    let check = ["check", &model];
    let simulate = ["simulate", &model, "--time", "0.1"];
    let plain = [&check[..], &simulate[..]].map(|args| answer(cspace(args)).0);
    answer(keeping(cache, &[&check[..], &["--no-cache"]].concat()));
    answer(keeping(cache, &[&simulate[..], &["--no-cache"]].concat()));
    assert_eq!(pairs(), 0);
    assert_eq!(answer(keeping(cache, &check)).0, plain[0]);
    let kept = pairs();
    assert!(kept > 0);
    assert_eq!(answer(keeping(cache, &check)).0, plain[0]);
    answer(keeping(cache, &[&check[..], &["--sensitivities"]].concat()));
    assert_eq!(pairs(), kept);
    answer(keeping(cache, &simulate));
    let kept = pairs();
    assert_eq!(answer(keeping(cache, &simulate)).0, plain[1]);
    // The command that computes spaces finds them computed.
    assert!(answer(keeping(cache, &["compute", &model, "-v"])).1);
    assert_eq!(pairs(), kept);
}
