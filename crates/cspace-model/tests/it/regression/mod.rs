//! Regression tests: the files of `tests/regression`, each with its expectations beside it.
//!
//! `NAME.expect.toml` contains the expectations for the pair in `NAME.toml` or `NAME.json`: [`expectation`] has all
//! keys. Tests without a key are in [`named`]. `CSPACE_REGRESSION=PART_OF_A_NAME` runs some of the files.

mod axes;
mod expectation;
mod named;
mod planar;

use std::fs;
use std::panic::catch_unwind;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

use cspace::Part;
use cspace_model::model;
use expectation::Expectation;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// The two parts of a file of this project.
fn parts(file: &str) -> [Part; 2] {
    let model = model::read(format!("{ROOT}/{file}")).unwrap();
    [0, 1].map(|i| model.parts[i].part.clone())
}

fn check(path: &PathBuf) {
    let name = path.file_stem().unwrap().to_str().unwrap();
    let text = fs::read_to_string(path.with_file_name(format!("{name}.expect.toml")));
    let text = text.unwrap_or_else(|e| panic!("{name}.expect.toml: {e}"));
    let expected: Expectation =
        toml::from_str(&text).unwrap_or_else(|e| panic!("{name}.expect.toml: {e}"));
    let model = model::read(path).unwrap();
    for planar in &expected.planar {
        planar::check(&model, planar);
    }
    if let Some(axes) = &expected.axes {
        axes::check(&model, axes);
    }
    if let Some(test) = &expected.named_test {
        let there = include_str!("named.rs").contains(&format!("#[test]\nfn {test}()"));
        assert!(there, "{name}: no test {test}");
    }
    let some = !expected.planar.is_empty() || expected.axes.is_some();
    assert!(some || expected.named_test.is_some(), "nothing is expected");
}

#[test]
fn files_are_as_expected() {
    let only = std::env::var("CSPACE_REGRESSION").unwrap_or_default();
    let (mut models, mut expectations) = (Vec::new(), 0);
    for entry in fs::read_dir(format!("{ROOT}/tests/regression")).unwrap() {
        let path = entry.unwrap().path();
        if path.to_str().unwrap().ends_with(".expect.toml") {
            expectations += 1;
        } else {
            models.push(path);
        }
    }
    assert_eq!(models.len(), expectations);
    models.sort();
    models.retain(|path| path.to_str().unwrap().contains(&only));
    // As many at a time as there are processors.
    let next = AtomicUsize::new(0);
    let work = || {
        let mut failed = Vec::new();
        while let Some(path) = models.get(next.fetch_add(1, Ordering::Relaxed)) {
            if catch_unwind(|| check(path)).is_err() {
                failed.push(path.display().to_string());
            }
        }
        failed
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let failed: Vec<String> = std::thread::scope(|s| {
        let all: Vec<_> = (0..threads).map(|_| s.spawn(work)).collect();
        all.into_iter().flat_map(|t| t.join().unwrap()).collect()
    });
    assert!(failed.is_empty(), "not as expected:\n{}", failed.join("\n"));
}
