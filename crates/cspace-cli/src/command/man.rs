//! `cspace man`.

use clap::CommandFactory;
use clap_mangen::Man;
use cspace_model::shown::quoted;

use crate::args::{Cli, ManArgs};
use crate::failure::Failure;
use crate::output;

pub(crate) fn run(args: &ManArgs) -> Result<(), Failure> {
    let mut cspace = Cli::command();
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
