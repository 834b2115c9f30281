//! The command line.

use clap::Parser;

/// Computes contact spaces of pairs drawn on a grid, and of the same with noise, and prints how certain their structure is.
///
/// A row for each pair, then totals. Free regions are compared with how many there are, where that is known.
#[derive(Debug, Parser)]
#[command(name = "cspace-structure")]
pub(crate) struct Args {
    /// Model files, TOML or JSON: of each the first general pair. FILE=N says that there are N free regions.
    #[arg(value_name = "FILE[=N]")]
    pub(crate) files: Vec<String>,

    /// Only pairs of this family.
    #[arg(long, value_name = "NAME")]
    pub(crate) family: Option<String>,

    /// Only pairs in whose family, name or change this occurs: `T-slot 3`, `noise 1e-08`, `as drawn`.
    #[arg(long, value_name = "SUBSTRING")]
    pub(crate) only: Option<String>,

    /// Only the family `table`, whose numbers of free regions are known, and the files given.
    #[arg(long, conflicts_with = "family")]
    pub(crate) table: bool,

    /// At most so many pairs of each family and size of noise, evenly chosen.
    #[arg(long, value_name = "N")]
    pub(crate) limit: Option<usize>,

    /// Which noise: the same seed moves vertices in the same way.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,

    /// How often each pair is drawn with noise of each size.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(..=1000), allow_negative_numbers = true)]
    pub(crate) times: u32,

    /// Pairs at a time, each computed by one thread; 0 is as many as there are processors.
    #[arg(long, default_value_t = 0, value_parser = clap::value_parser!(u16).range(..=1024), allow_negative_numbers = true)]
    pub(crate) threads: u16,

    /// Compare the free regions with a flood fill, which takes long.
    #[arg(long)]
    pub(crate) flood: bool,

    /// Boxes of the flood fill are halved so often along each axis.
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u32).range(1..=9), allow_negative_numbers = true)]
    pub(crate) depth: u32,

    /// Compute each pair with fixed and moving exchanged, too, and compare the numbers of free regions.
    #[arg(long)]
    pub(crate) inverse: bool,

    /// Give a pair up after so many seconds.
    #[arg(long, value_name = "S", default_value_t = 600)]
    pub(crate) patience: u64,

    /// Print totals only.
    #[arg(long)]
    pub(crate) totals: bool,

    /// Show the pairs and end.
    #[arg(long)]
    pub(crate) list: bool,
}
