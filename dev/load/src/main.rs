//! The development command `cspace-load`: random pairs, judged without end.
//!
//! `cargo run --release -p cspace-load -- --help`

mod args;
mod findings;
mod run;
mod state;
mod watch;

use std::process::ExitCode;

use clap::Parser;
use cspace_load::Source;
use cspace_load::output::{note, print};
use cspace_model::shown;
use cspace_oracle::families;

use args::Args;
use state::State;

fn main() -> ExitCode {
    let args = Args::parse();
    let result = if args.list {
        list().map(|()| true)
    } else {
        load(&args)
    };
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            note(format_args!("error: {}", shown::text(&message)));
            ExitCode::from(2)
        }
    }
}

fn list() -> Result<(), String> {
    let mut text = format!("{}\n", cspace_load::draw::TIES);
    for family in families() {
        text += &format!("{} ({} values)\n", family.name, family.values.len());
    }
    print(&text)
}

/// Runs the load test; returns whether there were no faults.
fn load(args: &Args) -> Result<bool, String> {
    let mut state = match &args.state {
        // A file that cannot be examined is reported when it is read.
        Some(path) if path.try_exists().unwrap_or(true) => State::read(path)?,
        _ => State::new(args.seed, args.family.clone()),
    };
    if let Some(family) = &args.family
        && state.family.as_ref() != Some(family)
    {
        return Err(format!("the state file is not of family {family:?}"));
    }
    let source = Source::new(state.seed, state.family.as_deref())
        .ok_or("there is no such family; --list shows them")?;
    if let Some(number) = args.only {
        state.next = number;
    }
    run::stop_by_signals().map_err(|e| format!("interrupts cannot be caught: {e}"))?;
    run::run(args, &source, &mut state)?;
    let (seed, next) = (state.seed, state.next);
    print(&format!("seed {seed}, next pair {next}\n{}", state.tally))?;
    Ok(state.tally.is_clean())
}
