//! The command line.

use std::path::PathBuf;

use clap::Parser;

/// Draws pairs of parts, computes their contact spaces and compares them with brute force.
///
/// The exit code is 0 if nothing was found that must not be, 1 if something was, 2 if it could not begin or end.
#[derive(Debug, Parser)]
#[command(name = "cspace-load")]
pub(crate) struct Args {
    /// Which pairs: the same seed gives the same pairs. A state file has its own.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,

    /// Stop when so many pairs are done, those in the state file included.
    #[arg(long, default_value_t = 20_000)]
    pub(crate) pairs: u64,

    /// Configurations to ask at each pair.
    #[arg(long, default_value_t = 500, value_parser = clap::value_parser!(u32).range(1..=1_000_000), allow_negative_numbers = true)]
    pub(crate) per_pair: u32,

    /// Only pairs of this family.
    #[arg(long, value_name = "NAME")]
    pub(crate) family: Option<String>,

    /// Show the families and end.
    #[arg(long)]
    pub(crate) list: bool,

    /// Where to go on from, and where to write how far it went. Interrupted by Ctrl-C, it is written too.
    #[arg(long, value_name = "FILE")]
    pub(crate) state: Option<PathBuf>,

    /// Stop after so many minutes.
    #[arg(long, value_name = "M", value_parser = minutes, allow_negative_numbers = true)]
    pub(crate) minutes: Option<f64>,

    /// A folder for model files of what was found, with the configurations in comments.
    #[arg(long, value_name = "DIR")]
    pub(crate) findings: Option<PathBuf>,

    /// Pairs at a time, each computed by one thread; 0 is as many as there are processors.
    #[arg(long, default_value_t = 0, value_parser = clap::value_parser!(u16).range(..=1024), allow_negative_numbers = true)]
    pub(crate) threads: u16,

    /// Every so many pairs are also computed with two threads and the other way round, and tried with a classifier.
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) thorough: u64,

    /// Before a pair is written into the folder of findings, leave out what its fault does not need.
    #[arg(long, requires = "findings")]
    pub(crate) shrink: bool,

    /// Only the pair of this number.
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u64).range(..u64::MAX))]
    pub(crate) only: Option<u64>,
}

fn minutes(text: &str) -> Result<f64, String> {
    text.parse::<f64>()
        .ok()
        .filter(|m| m.is_finite() && *m >= 0.0)
        .ok_or_else(|| "give a number of minutes, 0 or more".to_owned())
}
