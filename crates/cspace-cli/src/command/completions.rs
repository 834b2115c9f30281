//! `cspace completions`.

use clap::{Args, Command};

use crate::failure::Failure;
use crate::output;

const HELP: &str = "\
Example:
  cspace completions bash > ~/.local/share/bash-completion/completions/cspace";

/// Arguments of `cspace completions`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    pub(crate) shell: clap_complete::Shell,
}

pub(crate) fn run(args: &CompletionsArgs, mut cspace: Command) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut cspace, "cspace", &mut script);
    output::write(None, &script)
}
