//! Pairs by the names of their parts.

use std::path::Path;

use cspace_model::{Mechanism, PairEntry};

use crate::error::Error;
use crate::host::Host;

/// The pair with the parts of these names, with a comma between; its window is that of the file where it lists the pair, in either order.
///
/// # Errors
/// If there are no such two parts.
pub fn named_pair(
    path: &Path,
    model: &Mechanism,
    names: &str,
    host: &dyn Host,
) -> Result<PairEntry, Error> {
    let option = host.option("pair");
    let known = || {
        let list: Vec<&str> = model.parts.iter().map(|p| p.part.name()).collect();
        format!("the parts are {}", list.join(", "))
    };
    if !names.contains(',') {
        return Err(Error::new(format_args!(
            "{option} {names}: two names are needed, with a comma between"
        ))
        .help(known()));
    }
    // Names may have commas in them: whichever comma separates two of them.
    let found = names.match_indices(',').find_map(|(at, _)| {
        let fixed = model.part_index(names[..at].trim())?;
        let moving = model.part_index(names[at + 1..].trim())?;
        Some((fixed, moving))
    });
    let Some((fixed, moving)) = found else {
        let missing = names
            .split(',')
            .map(str::trim)
            .find(|n| model.part_index(n).is_none())
            .unwrap_or(names);
        let what = format_args!("there is no part {missing:?}");
        return Err(Error::in_file(path, what).help(known()));
    };
    if fixed == moving {
        return Err(Error::new(format_args!(
            "{option} {names}: a pair is of two different parts"
        ))
        .help(known()));
    }
    let listed = |fixed, moving| {
        (model.pairs.iter())
            .find(|p| p.fixed == fixed && p.moving == moving)
            .copied()
    };
    let exchanged = |p: PairEntry| p.window.map(|(lo, hi)| (-hi, -lo));
    Ok(listed(fixed, moving).unwrap_or(PairEntry {
        fixed,
        moving,
        window: listed(moving, fixed).and_then(exchanged),
    }))
}
