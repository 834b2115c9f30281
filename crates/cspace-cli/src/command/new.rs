//! `cspace new`.

use std::path::Path;

use crate::args::NewArgs;
use crate::failure::Failure;
use crate::output;

pub(crate) fn run(args: &NewArgs) -> Result<(), Failure> {
    let path = args.output.as_deref();
    if let Some(path) = path {
        check_name(path)?;
    }
    output::check(path)?;
    output::write(path, args.template.with(&args.values.set)?.as_bytes())
}

/// TOML has room for comments; under another name the file would not be read as what it is.
fn check_name(path: &Path) -> Result<(), Failure> {
    let is_toml = (path.extension()).is_some_and(|e| e.eq_ignore_ascii_case("toml"));
    // What is no file, such as /dev/stdout, has a name of its own.
    if is_toml || std::fs::metadata(path).is_ok_and(|m| !m.is_file()) {
        return Ok(());
    }
    Err(Failure::new(format_args!(
        "{}: the model is written as TOML",
        path.display()
    ))
    .help("give a name that ends in .toml after -o"))
}
