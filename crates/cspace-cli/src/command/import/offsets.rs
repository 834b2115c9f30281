//! Imported parts made larger or smaller all around.

use std::path::Path;

use cspace_drawing::Outlines;
use cspace_model::shown::quoted;

use crate::args::ImportArgs;
use crate::failure::{self, Failure};

/// Replaces the parts by those at a distance; of one that is divided every piece is a part, unless all of a layer or drawing are to be one.
pub(super) fn apply(
    args: &ImportArgs,
    path: &Path,
    outlines: &mut Outlines,
    by: f64,
) -> Result<(), Failure> {
    let file = path.display();
    let mut parts = Vec::with_capacity(outlines.parts.len());
    for part in &outlines.parts {
        let name = quoted(part.name());
        let made = cspace_drawing::offset(part, by, args.split)
            .map_err(|e| Failure::new(format_args!("{file}: part {name}: {e}")).help(e.help()))?;
        for change in &made.changes {
            failure::note(format_args!(
                "{file}: part {name}: with the offset, {change}"
            ));
        }
        if args.part.is_some() || args.by_layer {
            parts.push(made.part);
        } else {
            parts.extend(made.pieces().map_err(Failure::new)?);
        }
    }
    outlines.parts = parts;
    Ok(())
}
