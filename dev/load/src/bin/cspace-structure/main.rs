//! The development command `cspace-structure`: how certain the structure of contact spaces is.
//!
//! `cargo run --release -p cspace-load --bin cspace-structure -- --help`

mod args;
mod rows;
mod run;

use std::process::ExitCode;

use clap::Parser;
use cspace_load::output::{note, print};
use cspace_load::structure::{Specimen, TABLE, files, specimens};
use cspace_model::shown;

use args::Args;

fn main() -> ExitCode {
    let args = Args::parse();
    match start(&args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            note(format_args!("error: {}", shown::text(&message)));
            ExitCode::from(2)
        }
    }
}

fn start(args: &Args) -> Result<(), String> {
    let chosen = chosen(args)?;
    if args.list {
        let list: Vec<String> = chosen.iter().map(rows::titled).collect();
        return print(&(list.join("\n") + "\n"));
    }
    run::run(args, &chosen)
}

/// The specimens that the arguments ask for.
fn chosen(args: &Args) -> Result<Vec<Specimen>, String> {
    let mut all = Vec::new();
    for file in &args.files {
        all.push(files::specimen(file)?);
    }
    all.extend(specimens(args.seed, args.times));
    let family = args.family.as_deref();
    if let Some(family) = family
        && !all.iter().any(|s| s.family == family)
    {
        let mut names: Vec<&str> = all.iter().map(|s| s.family).collect();
        names.dedup();
        return Err(format!("there is no such family; there are {names:?}"));
    }
    all.retain(|s| match family {
        Some(family) => s.family == family,
        None => !args.table || [TABLE, files::FILES].contains(&s.family),
    });
    if let Some(part) = &args.only {
        let named = |s: &Specimen| format!("{}: {}, {}", s.family, s.name, s.change);
        all.retain(|s| named(s).contains(part));
    }
    if let Some(limit) = args.limit {
        all = spread(all, limit);
    }
    Ok(all)
}

/// Selects at most `limit` of each family and change, evenly, from the first on.
fn spread(all: Vec<Specimen>, limit: usize) -> Vec<Specimen> {
    let group = |s: &Specimen| (s.family, s.change.kind());
    let mut kept = Vec::new();
    for group in all.chunk_by(|a, b| group(a) == group(b)) {
        let n = limit.min(group.len());
        kept.extend((0..n).map(|i| group[i * group.len() / n].clone()));
    }
    kept
}
