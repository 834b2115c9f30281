//! The cspace library against what a user would take instead: see README.md.

mod checks;
mod grids;
mod memory;
mod models;
mod polygons;
mod stack;
mod text;

use std::io::Write;
use std::process::ExitCode;

use clap::{Parser, ValueEnum};
use serde::Serialize;

/// Error, for people.
pub(crate) type Failure = Box<dyn std::error::Error>;

/// Compare the cspace library with stacks of polygon Minkowski sums and with collision checkers, and count its memory
#[derive(Parser)]
struct Args {
    /// Only this part
    #[arg(long, value_enum)]
    only: Option<Section>,

    /// Only pairs whose names contain this
    #[arg(long, value_name = "NAME", default_value = "")]
    pair: String,

    /// How long each tool may refine its stack of each pair
    #[arg(long, value_name = "SECONDS", default_value_t = 60.0)]
    limit: f64,

    /// How to print the result
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Section {
    /// Stacks of Minkowski sums
    Stacks,
    /// Single configurations
    Checks,
    /// Grids of configurations of pairs on fixed axes
    Grids,
    /// Bytes allocated
    Memory,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// For programs
    Json,
}

/// Measurements; a part that was not requested is empty.
#[derive(Serialize, Default)]
pub(crate) struct Results {
    /// Largest distance of chords from arcs, as a share of the larger part's size.
    pub(crate) chord: f64,
    /// Seconds that each tool had to refine a stack.
    pub(crate) limit: f64,
    pub(crate) stacks: Vec<stack::Row>,
    pub(crate) checks: Vec<checks::Row>,
    pub(crate) grids: Vec<grids::Row>,
    pub(crate) memory: Vec<memory::Row>,
    /// Benchmarks that were left out, and why.
    pub(crate) left_out: Vec<String>,
}

/// The middle one; 0 of none.
pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

fn run(args: &Args) -> Result<Results, Failure> {
    let mut results = Results {
        chord: stack::CHORD,
        limit: args.limit,
        ..Results::default()
    };
    let asked = |section| args.only.is_none_or(|only| only == section);
    let mut pairs = models::pairs()?;
    pairs.retain(|p| p.name.contains(&args.pair));
    if asked(Section::Memory) {
        results.memory = memory::measure()?;
    }
    // Times are compared thread by thread.
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()?;
    if asked(Section::Checks) {
        for pair in &pairs {
            eprintln!("checks: {}", pair.name);
            results.checks.extend(checks::measure(pair)?);
        }
    }
    if asked(Section::Grids) {
        eprintln!("grids");
        results.grids = grids::measure(&args.pair)?;
    }
    if asked(Section::Stacks) {
        let tools = stack::Tools::find(&mut |why| {
            eprintln!("{why}");
            results.left_out.push(why);
        });
        for pair in &pairs {
            eprintln!("stacks: {}", pair.name);
            results
                .stacks
                .push(stack::measure(pair, &tools, args.limit)?);
        }
    }
    Ok(results)
}

fn main() -> ExitCode {
    let args = Args::parse();
    let print = |results: &Results| -> Result<(), Failure> {
        let mut out = std::io::stdout().lock();
        match args.format {
            Format::Json => writeln!(out, "{}", serde_json::to_string_pretty(results)?)?,
            Format::Text => write!(out, "{}", text::describe(results)?)?,
        }
        Ok(())
    };
    match run(&args).and_then(|results| print(&results)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            eprintln!("error: {e}");
            ExitCode::FAILURE
        }
    }
}
