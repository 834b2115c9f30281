//! The models that come with the project.

use std::fs;
use std::path::{Path, PathBuf};

use cspace::{Options, PairSpace};
use cspace_model::Mechanism;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models")
}

pub(crate) fn read(text: &str) -> Mechanism {
    cspace_model::model::from_toml(text, "test.toml").unwrap()
}

/// The space of a pair of a model: of its first if it is not said which.
pub(crate) fn space(model: &str) -> PairSpace {
    let mechanism = read(&fs::read_to_string(folder().join(model)).unwrap());
    space_of(&mechanism, 0)
}

pub(crate) fn space_of(mechanism: &Mechanism, pair: usize) -> PairSpace {
    let options = Options::default();
    mechanism.compute(&mechanism.pairs[pair], &options).unwrap()
}

/// All pairs that are not joined, with what they are called; of models that the variable MODELS names, if it is set, by parts of their
/// names.
pub(crate) fn all() -> impl Iterator<Item = (String, PairSpace)> {
    let of = |folder: PathBuf| {
        let entries = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
        let mut found: Vec<PathBuf> = entries
            .filter(|p| p.extension().is_some_and(|e| e == "toml"))
            .collect();
        found.sort();
        found
    };
    let files = of(folder()).into_iter().chain(of(folder().join("paper")));
    let asked = files.filter(|file| is_asked(&file.to_string_lossy()));
    asked.flat_map(|file| {
        let mechanism = read(&fs::read_to_string(&file).unwrap());
        let name = file.file_stem().unwrap().to_string_lossy().into_owned();
        let pairs = 0..mechanism.pairs.len();
        pairs.filter_map(move |i| {
            let space = space_of(&mechanism, i);
            let names = (space.fixed().name(), space.moving().name());
            let called = format!("{name} {},{}", names.0, names.1);
            (!matches!(space, PairSpace::Lower(_))).then_some((called, space))
        })
    })
}

fn is_asked(name: &str) -> bool {
    std::env::var("MODELS").map_or(true, |only| only.split(',').any(|part| name.contains(part)))
}
