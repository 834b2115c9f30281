//! The pairs that are compared.

use std::error::Error;
use std::path::{Path, PathBuf};

use cspace::{Configuration, Part};
use cspace_model::model;
use cspace_oracle::shapes::gear;

/// Two parts by name.
pub(crate) struct Pair {
    pub(crate) name: &'static str,
    pub(crate) fixed: Part,
    pub(crate) moving: Part,
    /// Working configuration of the parts, some hundredths clear of contact.
    pub(crate) working: Configuration,
}

/// Files of the repository's models, and where their parts work.
const FILES: [(&str, &str, [f64; 3]); 6] = [
    ("ratchet/pawl", "ratchet_pawl.toml", [42.0, 56.0, 0.0]),
    ("peg in hole", "peg_hole.toml", [0.0, 0.02, 0.0]),
    ("fixture/plate", "fixture_plate.toml", [0.0, 0.0, 0.0]),
    ("snap fastener", "snap_fastener.toml", [0.0, 0.05, 0.0]),
    (
        "fixture (Figure 5)",
        "paper/fixture.toml",
        [0.02, 0.02, 0.0],
    ),
    (
        "crank/slider (Figure 5)",
        "paper/crank_slider.toml",
        [50.0, 0.0, 0.0],
    ),
];

fn models() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models")
}

/// Pairs of the benchmarks; the gears have 10 and 9 teeth, and mesh a little more than half the sum of these apart.
pub(crate) fn pairs() -> Result<Vec<Pair>, Box<dyn Error>> {
    let mut pairs = vec![Pair {
        name: "gears 10/9",
        fixed: gear(10, 1.0),
        moving: gear(9, 1.0),
        working: Configuration::new(9.53, 0.0, 0.0),
    }];
    for (name, file, [x, y, theta]) in FILES {
        let path = models().join(file);
        let text = std::fs::read_to_string(&path)?;
        let model = model::from_toml(&text, &path.display().to_string())?;
        let pair = model.pairs.first().ok_or("a model without a pair")?;
        let part = |index: usize| model.parts[index].part.clone();
        pairs.push(Pair {
            name,
            fixed: part(pair.fixed),
            moving: part(pair.moving),
            working: Configuration::new(x, y, theta),
        });
    }
    Ok(pairs)
}
