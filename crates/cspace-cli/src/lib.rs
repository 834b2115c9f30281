//! The command `cspace`, as a function of its arguments.

mod args;
mod ask;
mod cache;
mod cli;
mod command;
mod drawing;
mod failure;
mod input;
mod interrupt;
mod output;
mod picture;
mod progress;
mod subject;
mod traces;
pub mod view;
mod wording;

use std::ffi::OsString;

use clap::FromArgMatches;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use cspace_model::shown;

use cli::{Cli, ColorWhen, Colored};
use failure::Failure;

/// Runs the command with its arguments, of which the first is its name, and returns its exit code: 0 where the answer
/// is yes or a value, 1 where it is no, 2 where there is none.
pub fn main(arguments: &[OsString]) -> u8 {
    let wants_json = |argument: &OsString| argument == "--json" || argument == "--format=json";
    let two = [OsString::from("--format"), OsString::from("json")];
    failure::set_json(arguments.iter().any(wants_json) || arguments.windows(2).any(|w| w == two));
    finish(match parsed(arguments) {
        Ok(cli) => run(cli),
        Err(error) => return usage(arguments, &error),
    })
}

/// The command line of its arguments.
fn parsed(
    arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
) -> Result<Cli, clap::Error> {
    Cli::from_arg_matches(&cli::command().try_get_matches_from(arguments)?)
}

fn finish(result: Result<(), Failure>) -> u8 {
    match result {
        Ok(()) => 0,
        Err(failure) => {
            failure.print();
            failure.code()
        }
    }
}

/// Help and version are data for stdout; what is wrong with the command line goes to stderr, with code 2.
fn usage(arguments: &[OsString], error: &clap::Error) -> u8 {
    if !error.use_stderr() {
        return finish(output::printed(error.print()));
    }
    // The message repeats arguments as they are, and a terminal obeys what is in them: it is made again of harmless ones.
    let plain = |argument: &OsString| shown::text(&argument.to_string_lossy()).into_owned();
    let again = (arguments.iter())
        .any(|a| a.to_string_lossy().contains(char::is_control))
        .then(|| parsed(arguments.iter().map(plain)).err())
        .flatten();
    if let Some(failure) = elsewhere(arguments, again.as_ref().unwrap_or(error)) {
        return finish(Err(failure));
    }
    // Where nobody listens nothing can be done.
    let error = again.as_ref().unwrap_or(error);
    let _ = error.print();
    failure::tell(&error.to_string());
    failure::UNANSWERED
}

/// The error for an option that the command does not have, and others do.
fn elsewhere(arguments: &[OsString], error: &clap::Error) -> Option<Failure> {
    let given = match error.get(ContextKind::InvalidArg)? {
        ContextValue::String(given) if error.kind() == ErrorKind::UnknownArgument => given,
        _ => return None,
    };
    let long = given.strip_prefix("--")?;
    let cli = cli::command();
    let own = arguments
        .iter()
        .find_map(|name| cli.find_subcommand(name))?
        .get_name();
    let has = |c: &&clap::Command| {
        let mut options = c.get_arguments().filter(|arg| !arg.is_hide_set());
        !c.is_hide_set() && options.any(|arg| arg.get_long() == Some(long))
    };
    let mut owners: Vec<&str> = cli
        .get_subcommands()
        .filter(has)
        .map(|c| c.get_name())
        .collect();
    owners.sort_unstable();
    (!owners.is_empty()).then(|| {
        Failure::new(format_args!("`cspace {own}` has no option {given}")).help(format_args!(
            "leave it out: {given} is for {}; `cspace {own} --help` lists the options that there are",
            owners.join(", ")
        ))
    })
}

fn run(cli: Cli) -> Result<(), Failure> {
    let mut when = ColorWhen::Auto;
    let mut colors = Vec::new();
    for color in &cli.color {
        match *color {
            Colored::When(given) => when = given,
            Colored::In(color) => colors.push(color),
        }
    }
    anstream::ColorChoice::write_global(when.into());
    failure::set_quiet(cli.quiet);
    cli.command.run(colors)
}
