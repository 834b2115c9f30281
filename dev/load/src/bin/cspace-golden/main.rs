//! The development command `cspace-golden`: whether a change of the code changes an answer.
//!
//! `freeze` writes what the library answers of many pairs, `compare` computes it again and says what differs:
//!
//! ```sh
//! cargo run --release -p cspace-load --bin cspace-golden -- freeze target/golden
//! cargo run --release -p cspace-load --bin cspace-golden -- compare target/golden
//! ```

mod answers;
mod compare;
mod items;
mod motion;
mod queries;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::{Parser, Subcommand};
use cspace_load::output::{note, print};
use rayon::prelude::*;

use answers::{Answers, answers};
use compare::{Difference, difference};
use items::{Item, items};

/// Freezes answers of the library, and compares later ones with them.
#[derive(Parser)]
struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Writes the answers to a folder.
    Freeze(Options),
    /// Computes the answers again and says which differ: exit code 1 if any does.
    Compare {
        #[command(flatten)]
        options: Options,
        /// Pairs pass whose structure is the same and whose numbers differ by less than this, relative to the larger of 1
        /// and the number.
        #[arg(long, value_name = "TOLERANCE")]
        within: Option<f64>,
    },
}

#[derive(clap::Args)]
struct Options {
    /// The folder of the answers.
    folder: PathBuf,
    /// So many drawn pairs, besides those of models and regressions.
    #[arg(long, default_value_t = 2000)]
    pairs: u64,
    /// The seed of the drawn pairs.
    #[arg(long, default_value_t = 20)]
    seed: u64,
    /// The folder that holds `models` and `tests/regression`.
    #[arg(long, default_value = ".")]
    root: PathBuf,
}

fn main() -> ExitCode {
    let result = match Args::parse().command {
        Command::Freeze(options) => freeze(&options).map(|()| true),
        Command::Compare { options, within } => compare_all(&options, within),
    };
    match result {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(message) => {
            note(format_args!("error: {message}"));
            ExitCode::from(2)
        }
    }
}

/// Calls `with` for the answers of every item, on all processors; the results by name.
fn all<T: Send>(
    options: &Options,
    with: impl Fn(&Item, Answers) -> Result<T, String> + Sync,
) -> Result<BTreeMap<String, T>, String> {
    let items = items(&options.root, options.seed, options.pairs)?;
    let done = AtomicUsize::new(0);
    let found = Mutex::new(BTreeMap::new());
    (items.par_iter().with_max_len(1)).try_for_each(|item| {
        let result = with(item, answers(item))?;
        let n = done.fetch_add(1, Ordering::Relaxed) + 1;
        if n.is_multiple_of(200) {
            note(format_args!("{n} of {}", items.len()));
        }
        let mut found = found.lock().map_err(|e| e.to_string())?;
        found.insert(item.name.clone(), result);
        Ok::<(), String>(())
    })?;
    found.into_inner().map_err(|e| e.to_string())
}

fn file(folder: &Path, item: &Item) -> PathBuf {
    let plain = |c: char| if c.is_alphanumeric() { c } else { '_' };
    let name: String = item.name.chars().map(plain).collect();
    folder.join(format!("{name}.json"))
}

fn freeze(options: &Options) -> Result<(), String> {
    let folder = &options.folder;
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let written = all(options, |item, answers| {
        let path = file(folder, item);
        std::fs::write(&path, answers.to_json()).map_err(|e| format!("{}: {e}", path.display()))
    })?;
    print(&format!("{} items written\n", written.len()))
}

fn compare_all(options: &Options, within: Option<f64>) -> Result<bool, String> {
    let found = all(options, |item, answers| {
        let path = file(&options.folder, item);
        let frozen =
            std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        difference(&frozen, &answers, within)
    })?;
    let count = |kind: fn(&Difference) -> bool| found.values().filter(|d| kind(d)).count();
    let mut text = String::new();
    for (name, difference) in &found {
        if let Difference::Structure(what) = difference {
            text += &format!("{name}: {what}\n");
        }
    }
    let differ = count(|d| matches!(d, Difference::Structure(_)));
    text += &format!(
        "{} items: {} equal to the last bit, {} within the tolerance, {differ} differ\n",
        found.len(),
        count(|d| matches!(d, Difference::None)),
        count(|d| matches!(d, Difference::Places)),
    );
    print(&text)?;
    Ok(differ == 0)
}
