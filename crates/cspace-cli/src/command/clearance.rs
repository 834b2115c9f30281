//! `cspace clearance`.

use std::fmt::{self, Write};
use std::path::PathBuf;

use clap::Args;
use cspace_api::Outcome as _;
use cspace_api::clearance::{Clearances, Outcome, Question};
use cspace_model::shown;

use super::record;
use crate::args::{CacheArgs, ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::wording::{count, length};

const HELP: &str = "\
Examples:
  cspace clearance models/peg_hole.toml
  cspace clearance models/ratchet_mechanism.toml --within 2
  cspace simulate models/geneva.toml --time 2 -o run.csv
  cspace clearance models/geneva.toml --along run.csv --json

Every two parts as they are drawn, the worst first. No contact space is
computed.

  overlaps  with the depth: the length of the shortest translation of the
            second part that separates the two, neither of them turned; and by
            how much smaller it would be clear, where that is less
  meets     with --along: the boundaries meet between two samples at which the
            parts are apart
  touches   the gap or the depth is --touch or less
  clear     with the gap: the minimum distance
  joined    a joint connects the two, so they may overlap: they are not judged

Features and points are those that are nearest, in the assembly's frame; of an
overlap those that touch after the translation, the point of the second part
where it is before. All parts are taken to lie in one plane, whichever pairs
the model lists.

With --along the gap is the minimum over the whole motion, with its time:
between two samples all coordinates are taken to change at constant rates, and
the gap is bounded there, not sampled. Depths are those at the samples.

The exit code is 1 if parts overlap. See docs/clearance.md.";

/// Arguments of `cspace clearance`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ClearanceArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    #[command(flatten)]
    pub(crate) question: Question,
    /// Over the motion that `cspace simulate` wrote to this file with -o, CSV or JSON, in place of the parts as drawn
    #[arg(long, value_name = "RECORD")]
    pub(crate) along: Option<PathBuf>,
    /// As drawn
    #[arg(long, conflicts_with = "along")]
    pub(crate) drawn: bool,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

/// In the order in which pairs are counted.
const OUTCOMES: [Outcome; 5] = [
    Outcome::Overlaps,
    Outcome::Meets,
    Outcome::Touches,
    Outcome::Clear,
    Outcome::Joined,
];

pub(crate) fn run(args: &ClearanceArgs) -> Result<(), Failure> {
    args.result.artefact(&[])?;
    let subject = ask::read(&args.file, &args.values, args.threads)?;
    let model = subject.model("clashes are found between all of its parts")?;
    let along = (args.along.as_ref())
        .map(|file| record::samples(file, &model.model.mechanism))
        .transpose()?;
    let question = Question {
        along,
        ..args.question.clone()
    };
    let answer = question.ask(&subject, &Terminal::new(CacheArgs::default()))?;
    super::tell(&args.result, &answer, |text, found| {
        describe(text, subject.unit(), found)
    })
}

fn describe(text: &mut String, unit: Option<&str>, found: &Clearances) -> fmt::Result {
    let unit = unit.map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let counts: Vec<String> = (OUTCOMES.iter())
        .filter_map(|&outcome| {
            let pairs = found.pairs.iter();
            let n = pairs.filter(|p| p.outcome == outcome).count();
            (n > 0).then(|| format!("{n} {}", outcome.word()))
        })
        .collect();
    let pairs = found.pairs.len() + found.beyond;
    let mut line = format!(
        "{}, {}",
        count(found.parts, "part", "parts"),
        count(pairs, "pair", "pairs")
    );
    if !counts.is_empty() {
        write!(line, ": {}", counts.join(", "))?;
    }
    if let (true, Some(within)) = (found.beyond > 0, found.within) {
        let more = if counts.is_empty() { ": " } else { ", " };
        let within = length(within);
        write!(
            line,
            "{more}{} clear by {within}{unit} or more",
            found.beyond
        )?;
    }
    writeln!(text, "{line}")?;
    for answer in &found.pairs {
        let [a, b] = [&answer.fixed, &answer.moving].map(|name| shown::text(name));
        let pair = &answer.content;
        let far = match (pair.depth, pair.gap) {
            (Some(l), _) | (None, Some(l)) => format!("{}{unit}", length(l)),
            (None, None) => String::new(),
        };
        write!(text, "{:<8} {far:>14}  {a}, {b}", answer.outcome.word())?;
        if let Some(time) = pair.at {
            write!(text, "  t {}", length(time))?;
        }
        if let (Some([f, g]), Some([p, q])) = (&pair.touching, pair.points) {
            let at = |[x, y]: [f64; 2]| format!("({}, {})", length(x), length(y));
            let (f, g) = (shown::text(f), shown::text(g));
            write!(text, "  {f} at {}, {g} at {}", at(p), at(q))?;
        }
        // What a translation of the same length does need not be said.
        if let (Some(offset), Some(depth)) = (pair.offset, pair.depth)
            && offset < 0.999 * depth
        {
            write!(
                text,
                "  clear if {b} is {}{unit} smaller all around",
                length(offset)
            )?;
        }
        writeln!(text)?;
    }
    Ok(())
}
