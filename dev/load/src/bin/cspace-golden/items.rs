//! The pairs whose answers are frozen: of models, of regressions, and drawn ones.

use std::path::{Path, PathBuf};

use cspace::{Axis, Part, Point, Relation, Vector};
use cspace_load::Source;
use cspace_model::{Document, Dynamics, Mechanism};
use rand::Rng;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

/// Pairs with more products of edge counts are left out of the drawn ones: they take seconds each.
const LARGEST: usize = 40_000;

/// A pair, or what could not be read.
pub(crate) struct Item {
    pub(crate) name: String,
    pub(crate) what: Result<Asked, String>,
    /// For the random numbers of its questions.
    pub(crate) seed: u64,
}

/// Question to the library.
pub(crate) enum Asked {
    Pair(Box<Question>),
    /// The motion of a whole mechanism.
    Motion(Box<Mechanism>),
}

/// A pair and how it is computed.
pub(crate) struct Question {
    pub(crate) fixed: Part,
    pub(crate) moving: Part,
    pub(crate) relation: Relation,
    pub(crate) window: Option<(f64, f64)>,
}

pub(crate) fn items(root: &Path, seed: u64, pairs: u64) -> Result<Vec<Item>, String> {
    let mut all = Vec::new();
    for folder in ["models", "tests/regression"] {
        for path in files(&root.join(folder))? {
            of_file(root, &path, &mut all);
        }
    }
    let source = Source::new(seed, None).ok_or("there are no families")?;
    all.extend((0..pairs).flat_map(|number| drawn(&source, number)));
    Ok(all)
}

/// Model files in a folder and the folders within, in order.
fn files(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let told = |e: std::io::Error| format!("{}: {e}", folder.display());
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(told)? {
        let path = entry.map_err(told)?.path();
        let kind = path.extension().and_then(|e| e.to_str()).unwrap_or("");
        if path.is_dir() {
            found.extend(files(&path)?);
        } else if ["toml", "json"].contains(&kind) {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

fn of_file(root: &Path, path: &Path, all: &mut Vec<Item>) {
    let short = path
        .strip_prefix(root)
        .unwrap_or(path)
        .display()
        .to_string();
    let model = match cspace_model::read(path) {
        Ok(Document::Model(model)) => Box::new(model.mechanism),
        Ok(Document::Space(_)) => return,
        Err(error) => {
            let what = Err(error
                .to_string()
                .replace(&path.display().to_string(), &short));
            let (name, seed) = (short, 0);
            all.push(Item { name, what, seed });
            return;
        }
    };
    if moves(&model) {
        all.push(Item {
            name: format!("{short} motion"),
            what: Ok(Asked::Motion(model.clone())),
            seed: 0,
        });
    }
    for (i, pair) in (0..).zip(&model.pairs) {
        let relation = model.relation(pair);
        for (kind, relation) in [("", Some(relation)), (" general", general(relation))] {
            let Some(relation) = relation else { continue };
            all.push(Item {
                name: format!("{short} {i}{kind}"),
                what: Ok(Asked::Pair(Box::new(question(&model, pair, relation)))),
                seed: i,
            });
        }
    }
}

/// Whether a mechanism has any dynamics.
fn moves(model: &Mechanism) -> bool {
    model.dynamics != Dynamics::default()
}

/// The general method for a pair of another class.
fn general(relation: Relation) -> Option<Relation> {
    (relation != Relation::Planar).then_some(Relation::Planar)
}

fn question(model: &Mechanism, pair: &cspace_model::PairEntry, relation: Relation) -> Question {
    let part = |i: usize| model.parts[i].part.clone();
    Question {
        fixed: part(pair.fixed),
        moving: part(pair.moving),
        relation,
        window: pair.window.filter(|_| relation == Relation::Planar),
    }
}

/// A drawn pair, in the plane and every third on fixed axes too.
fn drawn(source: &Source, number: u64) -> Vec<Item> {
    let drawn = source.draw(number);
    let Ok(case) = drawn.case else {
        return Vec::new();
    };
    if case.fixed.edges().count() * case.moving.edges().count() > LARGEST {
        return Vec::new();
    }
    let mut rng = ChaCha8Rng::seed_from_u64(number);
    let mut axis = || match rng.random_range(0..3) {
        0 => Axis::prismatic(Vector::from_angle(rng.random_range(-3.0..3.0))),
        1 => {
            let angle = f64::from(rng.random_range(0..12)) * core::f64::consts::FRAC_PI_6;
            Axis::prismatic(Vector::from_angle(angle)).within(-2.0, 2.0)
        }
        _ => {
            let mut lattice = || 0.25 * f64::from(rng.random_range(-6..6));
            Axis::revolute(Point::new(lattice(), lattice()))
        }
    };
    let on_axes = Relation::Axes {
        fixed: axis(),
        moving: axis(),
    };
    let mut all = vec![("", Relation::Planar, case.window)];
    if number.is_multiple_of(3) {
        all.push((" axes", on_axes, None));
    }
    all.into_iter()
        .map(|(kind, relation, window)| Item {
            name: format!("{number}{kind} {}", drawn.name),
            what: Ok(Asked::Pair(Box::new(Question {
                fixed: case.fixed.clone(),
                moving: case.moving.clone(),
                relation,
                window,
            }))),
            seed: number,
        })
        .collect()
}
