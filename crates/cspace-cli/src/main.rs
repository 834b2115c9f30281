//! The command `cspace`.

mod angle;
mod args;
mod command;
mod failure;
mod output;
mod progress;
mod subject;
mod wording;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};
use failure::Failure;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        // Help and version are data; clap prints them to stdout and leaves with 0, all else to stderr with 2.
        Err(error) => error.exit(),
    };
    match run(cli) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.print();
            failure.exit_code()
        }
    }
}

fn run(cli: Cli) -> Result<(), Failure> {
    match cli.command {
        Command::Info(args) => command::info::run(&args),
        Command::Compute(args) => command::compute::run(&args),
        Command::Slice(args) => command::slice::run(&args),
        Command::Classify(args) => command::classify::run(&args),
        Command::Export(args) => command::export::run(&args),
        Command::Evaluate(args) => command::evaluate::run(&args),
        Command::Completions(args) => command::completions::run(&args),
    }
}
