//! `cspace new`.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use cspace_api::template::{self, TEMPLATES, Template};

use crate::args::SetArgs;
use crate::failure::Failure;
use crate::output;

const HELP: &str = "\
Examples:
  cspace new latch -o latch.toml
  cspace new peg --set diameter=12 --set clearance=0.05 -o peg.toml
  cspace new gears --set gear=30 --set pinion=18 --set pressure=20deg

The model is TOML with comments. Its dimensions are parameters, in mm or any
other unit: change `unit` in the file. --set changes their values in what is
written. The comment at the top says what the parts do at which configuration.
See docs/model.md for how a model is written.

Parameters, with their values:
";

/// Arguments of `cspace new`.
#[derive(Debug, Args)]
#[command(after_long_help = format!("{HELP}{}", template::dimensions().trim_end()), arg_required_else_help = true)]
pub(crate) struct NewArgs {
    /// Kind of the model
    #[arg(value_name = "KIND", value_parser = template_parser())]
    pub(crate) template: &'static Template,

    #[command(flatten)]
    pub(crate) values: SetArgs,

    /// Write the model to this file, NAME.toml, instead of standard output; whole or not at all
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
}

/// Reads the name of a template.
fn template_parser() -> impl TypedValueParser<Value = &'static Template> {
    let choices = TEMPLATES
        .iter()
        .map(|t| PossibleValue::new(t.name).help(t.title()));
    PossibleValuesParser::new(choices)
        .try_map(|name| Template::named(&name).ok_or("there is no such model"))
}

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
