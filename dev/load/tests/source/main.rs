//! Rules that the sources keep: imports in one direction, English, constants that are explained.
#![allow(clippy::unwrap_used, clippy::panic)]

mod english;
mod imports;
mod tolerances;

use std::path::{Path, PathBuf};

/// Files in Rust below a folder in the order of their names, without those that builds leave.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("target") && !path.ends_with("node_modules") {
            all.extend(files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            all.push(path);
        }
    }
    all.sort();
    all
}
