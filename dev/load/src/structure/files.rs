//! Pairs of model files.

use std::path::Path;

use cspace::PairClass;
use cspace_model::model;
use cspace_oracle::families::loops_of;

use super::{Change, Specimen};

/// The family of pairs from files.
pub const FILES: &str = "files";

/// First general pair of a model file, or the first pair if there is none: given as `PATH`, or as `PATH=N` where N free
/// regions are expected.
///
/// # Errors
/// If the file is no model, or has no pair.
pub fn specimen(argument: &str) -> Result<Specimen, String> {
    let with_regions = argument.rsplit_once('=');
    let with_regions = with_regions.and_then(|(path, n)| Some((path, n.parse().ok()?)));
    let (path, expected) = match with_regions {
        Some((path, n)) => (path, Some(n)),
        None => (argument, None),
    };
    let model = model::read(path).map_err(|e| e.to_string())?;
    let general = |p: &&cspace_model::PairEntry| model.pair_class(p) == PairClass::General;
    let pairs = &model.pairs;
    let pair = pairs.iter().find(general).or(pairs.first());
    let parts = pair.and_then(|p| {
        let part = |i: usize| Some(loops_of(&model.parts.get(i)?.part));
        Some((part(p.fixed)?, part(p.moving)?, p.window))
    });
    let (fixed, moving, window) = parts.ok_or_else(|| format!("{path}: there is no pair"))?;
    let name = Path::new(path).file_stem();
    Ok(Specimen {
        family: FILES,
        change: Change::None,
        name: name.map_or_else(|| path.to_owned(), |n| n.to_string_lossy().into_owned()),
        fixed,
        moving,
        window,
        expected,
    })
}
