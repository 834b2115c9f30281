//! The development command `cspace-paper`: Figure 5 of Sacks (1999) and the speed-ups of its section 4, measured.
//!
//! `cargo run --release -p cspace-paper -- --help`

mod averages;
mod critical;
mod evaluation;
mod measure;
mod special;
mod text;
mod timing;

use std::error::Error;
use std::io::Write;
use std::process::ExitCode;

use clap::Parser;
use cspace_baseline::SEPARATION;
use cspace_baseline::paper::{PAIRS, PaperPair};

use averages::Averages;
use evaluation::Evaluation;
use measure::{Limits, measure};

/// Measures the pairs of Figure 5 of Sacks, Practical Sliced Configuration Spaces for Curved Planar Pairs (1999), by the general
/// algorithm that the paper improves on and by that of cspace.
#[derive(Debug, Parser)]
#[command(name = "cspace-paper", after_long_help = MEANING)]
struct Args {
    /// Only these pairs, by Figure 5's names, such as cam,ratchet/pawl
    #[arg(long, value_name = "NAMES", value_delimiter = ',', value_parser = named)]
    pairs: Vec<&'static PaperPair>,

    /// How often everything is timed; medians are shown
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    repeat: u16,

    /// Time limit of each of the general algorithm's two searches of critical orientations, for each pair; 0 skips them
    #[arg(long, value_name = "SECONDS", default_value_t = 2.0, value_parser = seconds)]
    criticality_limit: f64,

    /// Print all that was measured as JSON
    #[arg(long)]
    json: bool,
}

const MEANING: &str = "\
The models are reconstructions; Figure 5's numbers are shown beside those
measured.

The general algorithm takes slices 0.005 rad apart and puts a polyhedral
surface through their contours. The old seconds are slices and surface alone:
critical orientations are given to it for nothing. Both algorithms use the same
code for a slice, and one thread. All times are the processor's: other programs
on the machine do not add to them. The search of critical orientations over all
combinations of features is timed on its own, under a limit: with orientations
already known skipped (section 3.3), and with all examined.

A critical orientation is `aligned` where the parts' normals oppose each other
at the ends of features (sides are parallel), `end` where a feature ends at
another contact, `tangent` where two contact curves are, `triple` where three
contacts meet; it can be several. Counted are those of the slices computed.

The errors of the old algorithm: `gap` is the largest distance between its
straight boundary lines and the exact boundary curves, half way between two
slices. The others are of slices without critical orientations given: bands
that no slice falls in, and spaces between two slices in which the surface lets
free and blocked configurations meet.

`special` are times of the pairs with joints and fixed axes among the project's
models, each by its own method and by the one for three degrees of freedom.";

fn main() -> ExitCode {
    match run(&Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(args: &Args) -> Result<(), Box<dyn Error>> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()?;
    let is_chosen = |pair: &PaperPair| args.pairs.is_empty() || args.pairs.contains(&pair);
    let limits = Limits {
        repeat: args.repeat,
        criticality: args.criticality_limit,
    };
    let pairs = (PAIRS.iter().filter(|pair| is_chosen(pair)))
        .map(|pair| measure(pair, limits))
        .collect::<Result<Vec<_>, _>>()?;
    let evaluation = Evaluation {
        separation: SEPARATION,
        repeat: args.repeat,
        criticality_limit: args.criticality_limit,
        threads: rayon::current_num_threads(),
        averages: Averages::of(&pairs),
        pairs,
        survey: special::survey(args.repeat)?,
    };
    let text = if args.json {
        serde_json::to_string_pretty(&evaluation)? + "\n"
    } else {
        text::described(&evaluation)?
    };
    Ok(std::io::stdout().write_all(text.as_bytes())?)
}

/// The pair of a name: `ratchet_pawl` and `Ratchet/Pawl` mean the same.
fn named(name: &str) -> Result<&'static PaperPair, String> {
    fn plain(name: &str) -> String {
        let letters = name.chars().filter(|c| c.is_alphanumeric());
        letters.flat_map(char::to_lowercase).collect()
    }
    let found = PAIRS.iter().find(|pair| plain(pair.name) == plain(name));
    found.ok_or_else(|| {
        let known: Vec<&str> = PAIRS.iter().map(|pair| pair.name).collect();
        format!("the pairs of Figure 5 are {}", known.join(", "))
    })
}

fn seconds(text: &str) -> Result<f64, String> {
    // A day is more than anybody waits for.
    (text.parse().ok().filter(|s| (0.0..=86_400.0).contains(s)))
        .ok_or_else(|| "give a number of seconds, 0 or more".into())
}
