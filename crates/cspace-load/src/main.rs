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
use cspace_oracle::families;

use args::Args;
use state::State;

fn main() -> ExitCode {
    let args = Args::parse();
    if args.list {
        println!("{}", cspace_load::draw::TIES);
        for family in families() {
            println!("{} ({} values)", family.name, family.values.len());
        }
        return ExitCode::SUCCESS;
    }
    match load(&args) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

/// Whether nothing was found that must not be.
fn load(args: &Args) -> Result<bool, String> {
    let mut state = match &args.state {
        Some(path) if path.exists() => State::read(path)?,
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
    ctrlc::set_handler(run::stop).map_err(|e| format!("interrupts cannot be caught: {e}"))?;
    run::run(args, &source, &mut state)?;
    println!("seed {}, next pair {}", state.seed, state.next);
    print!("{}", state.tally);
    Ok(state.tally.is_clean())
}
