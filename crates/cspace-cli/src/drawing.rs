//! Drawings as the options for them say: what is read, in which unit, how curves are joined and fitted.

use std::fmt::Write;
use std::path::Path;

use cspace_api::import::Finding;
use cspace_drawing::{Drawing, DrawingError, Source};
use cspace_model::shown;

use crate::args::SourceArgs;
use crate::failure::Failure;
use crate::input;

/// The drawing in a file.
pub(crate) fn read(args: &SourceArgs, path: &Path) -> Result<Drawing, Failure> {
    input::drawing(path, &source(args))?.map_err(|e| failed(path, &e))
}

/// The drawing in a file, and the file's bytes.
pub(crate) fn read_with_bytes(
    args: &SourceArgs,
    path: &Path,
) -> Result<(Drawing, Vec<u8>), Failure> {
    let bytes = input::drawing_bytes(path)?.map_err(|e| failed(path, &e))?;
    let drawing = cspace_drawing::named(path, &bytes, &source(args));
    Ok((drawing.map_err(|e| failed(path, &e))?, bytes))
}

/// The failure of a command whose drawing is rejected: the reason, and how to fix it.
pub(crate) fn failed(path: &Path, error: &DrawingError) -> Failure {
    Failure::new(format_args!("{}: {error}", path.display())).help(error.help())
}

fn source(args: &SourceArgs) -> Source {
    Source {
        layers: args.layer.clone(),
        ids: args.id.clone(),
        colors: args.colors.clone(),
        linetypes: args.linetype.clone(),
        hatches: args.hatches,
    }
}

/// Refuses options about formats that none of the drawings has.
pub(crate) fn check_options<'p>(
    args: &SourceArgs,
    drawings: impl Iterator<Item = &'p Path> + Clone,
) -> Result<(), Failure> {
    let given = [
        ("--layer", "dxf", !args.layer.is_empty()),
        ("--hatches", "dxf", args.hatches),
        ("--linetype", "dxf", !args.linetype.is_empty()),
        ("--id", "svg", !args.id.is_empty()),
    ];
    for (option, format, is_given) in given {
        check_option(option, format, is_given, drawings.clone())?;
    }
    Ok(())
}

/// Refuses an option that is given, and about a format that none of the drawings has.
pub(crate) fn check_option<'p>(
    option: &str,
    format: &str,
    is_given: bool,
    mut drawings: impl Iterator<Item = &'p Path> + Clone,
) -> Result<(), Failure> {
    let is_of = |path: &Path| {
        path.extension()
            .is_some_and(|e| e.eq_ignore_ascii_case(format))
    };
    if is_given && !drawings.clone().any(is_of) {
        let first = drawings.next().unwrap_or(Path::new(""));
        return Err(Failure::new(format_args!(
            "{option} is about {} drawings, and {} is none",
            format.to_uppercase(),
            first.display()
        ))
        .help(format_args!("leave out {option}")));
    }
    Ok(())
}

/// The options that were given, as a shell takes them, each with a space before.
pub(crate) fn options(args: &SourceArgs, finding: &Finding) -> String {
    let mut text = String::new();
    let texts = (args.layer.iter().map(|l| ("--layer", l)))
        .chain(args.id.iter().map(|id| ("--id", id)))
        .chain(args.linetype.iter().map(|name| ("--linetype", name)))
        .chain(finding.lengths.unit.iter().map(|unit| ("--unit", unit)));
    for (option, value) in texts {
        // A String takes everything.
        let _ = write!(text, " {option} {}", shown::word(value));
    }
    for color in &args.colors {
        let _ = write!(text, " --color {}", shown::word(&color.to_string()));
    }
    if args.hatches {
        text.push_str(" --hatches");
    }
    if finding.without_sheet {
        text.push_str(" --without-sheet");
    }
    let lengths = [
        ("--scale", finding.lengths.scale),
        ("--join", finding.join),
        ("--fit", finding.fit),
    ];
    for (option, value) in lengths {
        let _ = value.map(|x| write!(text, " {option} {x:?}"));
    }
    text
}

/// An option that was given.
pub(crate) fn first_given(args: &SourceArgs, finding: &Finding) -> Option<String> {
    let given = options(args, finding);
    given.split_whitespace().next().map(str::to_owned)
}
