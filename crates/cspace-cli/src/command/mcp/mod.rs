//! `cspace mcp`: the questions as tools of an assistant, by the Model Context Protocol on standard input and output.
//!
//! `server.rs` speaks the protocol, `tools.rs` says which tools there are and what each takes, `call.rs` answers. What a tool says is the
//! answer of `--json`, shortened (`short.rs`) unless all of it is asked for. Files are read and written below one folder (`folder.rs`).

mod call;
mod drawings;
mod folder;
mod host;
mod reference;
mod server;
mod short;
mod tools;

use std::path::PathBuf;

use clap::Args;

use crate::args::ThreadsArg;
use crate::ask::set_threads;
use crate::failure::Failure;
use folder::Folder;

const HELP: &str = "\
Examples:
  cspace mcp
  cspace mcp --root models

An assistant that speaks the Model Context Protocol starts this command, and
asks by tools: model_info, space, play, plan, clearance, check, solve,
tolerances, simulate, draw, import_drawing, reference. A model is the text of a
model file, or the path of one. Answers are those of --json (docs/answers),
shortened to 4 kB unless `detail` is given; lengths are in the unit that the
answer names, angles in radians. Files are read and written below --root and
nowhere else, and nothing goes over a network.";

/// Arguments of `cspace mcp`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct McpArgs {
    /// The folder below which files are read and written [default: the current one]
    #[arg(long, value_name = "FOLDER")]
    root: Option<PathBuf>,

    #[command(flatten)]
    threads: ThreadsArg,
}

pub(crate) fn run(args: &McpArgs) -> Result<(), Failure> {
    let folder = Folder::new(args.root.as_deref())?;
    set_threads(args.threads)?;
    server::run(folder)
}
