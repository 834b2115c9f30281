//! The unit of an imported model, and how drawings are converted to it.

use std::path::Path;

use cspace_drawing::{Conversion, Drawing};

use crate::args::ImportArgs;
use crate::failure::{self, Failure};

/// The unit that the model names: as asked for, or that of the first drawing that names one.
pub(super) fn of_model(args: &ImportArgs, drawings: &[Drawing]) -> Result<Option<String>, Failure> {
    if args.unit.is_some() {
        return Ok(args.unit.clone());
    }
    let mut named = drawings.iter().filter_map(|d| d.unit);
    let first = named.next();
    let Some(scale) = args.scale else {
        return Ok(first.map(|u| u.label().to_owned()));
    };
    if let (Some(first), Some(other)) = (first, named.find(|u| Some(*u) != first)) {
        return Err(Failure::input(format_args!(
            "one drawing is in {:?}, another in {:?}, and --scale multiplies both by the same",
            first.label(),
            other.label()
        ))
        .help(
            "leave out --scale to have them converted, or name the unit of the result with --unit",
        ));
    }
    // What is scaled is no longer in the drawing's unit.
    let kept = first.filter(|_| scale == 1.0);
    Ok(kept.map(|u| u.label().to_owned()))
}

/// What the lengths of a drawing are multiplied by.
pub(super) fn factor(args: &ImportArgs, path: &Path, drawing: &Drawing, unit: Option<&str>) -> f64 {
    if let Some(scale) = args.scale {
        return scale;
    }
    let conversion = Conversion::new(drawing.unit, unit);
    if let Some(note) = conversion.note("--scale 1") {
        failure::note(format_args!("{}: {note}", path.display()));
    }
    conversion.factor()
}
