//! The pairs that are compared.

use std::error::Error;
use std::path::{Path, PathBuf};

use cspace::Part;
use cspace_io::Model;
use cspace_oracle::shapes::gear;

/// Two parts by name.
pub(crate) struct Pair {
    pub(crate) name: &'static str,
    pub(crate) fixed: Part,
    pub(crate) moving: Part,
}

/// Files of the repository's models.
const FILES: [(&str, &str); 5] = [
    ("ratchet/pawl", "ratchet_pawl.toml"),
    ("peg in hole", "peg_hole.toml"),
    ("fixture/plate", "fixture_plate.toml"),
    ("fixture (Figure 5)", "paper/fixture.toml"),
    ("cam (Figure 5)", "paper/cam.toml"),
];

fn models() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models")
}

/// All pairs; the gears are drawn without clearance to spare, with 10 and 9 teeth.
pub(crate) fn pairs() -> Result<Vec<Pair>, Box<dyn Error>> {
    let mut pairs = vec![Pair {
        name: "gears 10/9",
        fixed: gear(10, 1.0),
        moving: gear(9, 1.0),
    }];
    for (name, file) in FILES {
        let path = models().join(file);
        let text = std::fs::read_to_string(&path)?;
        let model = Model::from_toml(&text, &path.display().to_string())?;
        let pair = model.pairs.first().ok_or("a model without a pair")?;
        let part = |index: usize| model.parts[index].part.clone();
        pairs.push(Pair {
            name,
            fixed: part(pair.fixed),
            moving: part(pair.moving),
        });
    }
    Ok(pairs)
}
