//! `cspace man`.

use clap::{Args, Command};
use clap_mangen::Man;
use cspace_model::shown::quoted;

use crate::failure::Failure;
use crate::output;

const HELP: &str = "\
Example:
  mkdir -p ~/.local/share/man/man1
  cspace man > ~/.local/share/man/man1/cspace.1
  cspace man compute > ~/.local/share/man/man1/cspace-compute.1
  man cspace-compute";

/// Arguments of `cspace man`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ManArgs {
    /// The subcommand; without one, the page of `cspace` itself
    #[arg(value_name = "COMMAND")]
    pub(crate) command: Option<String>,
}

pub(crate) fn run(args: &ManArgs, mut cspace: Command) -> Result<(), Failure> {
    cspace.build();
    let page = match &args.command {
        None => cspace,
        Some(name) => {
            let Some(found) = cspace.find_subcommand(name) else {
                let names: Vec<&str> = cspace.get_subcommands().map(|c| c.get_name()).collect();
                let failure = Failure::new(format_args!("there is no command {}", quoted(name)));
                return Err(failure.help(format_args!("the commands are {}", names.join(", "))));
            };
            found.clone()
        }
    };
    let mut text = Vec::new();
    // The page is called as people ask for it: man cspace-compute.
    let title = page.get_display_name().unwrap_or("cspace").to_owned();
    Man::new(page)
        .title(title)
        .render(&mut text)
        .map_err(Failure::new)?;
    output::write(None, &text)
}
