//! Findings, written as model files.

use std::fmt::Write as _;
use std::path::Path;

use cspace_model::{Mechanism, PairEntry, PartEntry, model};
use cspace_oracle::Case;

/// Configurations in the comment of one file.
const SHOWN: usize = 8;

/// Writes the pair of a number into the folder, with the remarks above.
pub(crate) fn write(
    folder: &Path,
    number: u64,
    name: &str,
    kind: &str,
    case: &Case,
    said: &[String],
) -> Result<(), String> {
    let failed = |e: std::io::Error| format!("{}: {e}", folder.display());
    std::fs::create_dir_all(folder).map_err(failed)?;
    let mut text = format!("# PairEntry {number}: {name}.\n");
    for line in said.iter().take(SHOWN) {
        let _ = writeln!(text, "# {line}");
    }
    if said.len() > SHOWN {
        let _ = writeln!(text, "# … {} more", said.len() - SHOWN);
    }
    let entry = |part: &cspace::Part| PartEntry::planar(part.clone());
    let model = Mechanism {
        name: name.to_owned(),
        parts: vec![entry(&case.fixed), entry(&case.moving)],
        pairs: vec![PairEntry {
            fixed: 0,
            moving: 1,
            window: case.window,
        }],
        ..Mechanism::default()
    };
    text.push_str(&model::to_toml(&model));
    std::fs::write(folder.join(format!("{number}-{kind}.toml")), text).map_err(failed)
}
