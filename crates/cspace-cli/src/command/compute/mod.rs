//! `cspace compute`.

mod answer;
mod text;

use std::path::PathBuf;

use clap::Args;
use cspace_api::compute::{Question, Summary, summed_up};
use cspace_api::subject::Source;
use cspace_api::{Answer, Pairs};

use super::several;
use crate::args::Common;
use crate::ask;
use crate::failure::{Failure, note};

const HELP: &str = "\
Examples:
  cspace compute models/ratchet_pawl.toml
  cspace compute models/ratchet_pawl.toml --window=-10deg,10deg
  cspace compute models/fixture_plate.toml --json
  cspace compute models/ratchet_mechanism.toml --pair driver,link

All pairs of the file are computed, or the one that --pair names. The class in
the result is the method that was used: `lower` for two parts that a joint
connects, whose patches are permanent contacts; `fixed-axes` for two of which
each turns, slides or stands still, in (u, v); `symmetric` if one slab of
orientations was computed and the others are copies; else `general`. `slices`
are the bands that were computed. `cspace info` shows the class of the pair
itself.

--window is for the pairs that have orientations; the others are computed as if
it were not given, and a note on standard error says so. It is an error if
--pair names one of them.

A clearance that is too small counts as none: such a channel is blocked. The
summary says how small.";

/// Arguments of `cspace compute`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ComputeArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) question: Question,
    /// More files, answered one after the other
    #[arg(value_name = "FILE")]
    pub(crate) more: Vec<PathBuf>,
    /// Say as well how certain the structure is, and which spaces were computed before and kept
    #[arg(short, long, hide_short_help = true)]
    pub(crate) verbose: bool,
}

pub(crate) fn run(args: &ComputeArgs) -> Result<(), Failure> {
    several::run(&args.common, &args.more, |common| answer(common, args))
}

fn answer(
    common: &Common,
    args: &ComputeArgs,
) -> Result<(Answer<Pairs<Summary>>, String), Failure> {
    let (subject, host) = ask::open(common)?;
    subject.warn(&host);
    ask::tell_traces(&subject);
    let question = &args.question;
    let pairs = subject.pairs(&question.which, &host)?;
    let mut spaces = Vec::new();
    for pair in &pairs {
        let space = question.space(pair)?;
        if args.verbose && space.source == Source::Kept {
            note(format_args!(
                "pair {}: its space was computed before and kept; --no-cache computes it",
                pair.names()
            ));
        }
        spaces.push(space);
    }
    let answer = summed_up(&pairs, &spaces);
    let text = several::text(common, |text| {
        let summaries = answer.content.pairs.iter().map(|pair| &pair.content);
        for (i, ((pair, space), summary)) in pairs.iter().zip(&spaces).zip(summaries).enumerate() {
            if i > 0 {
                text.push('\n');
            }
            text::describe(text, pair, space, summary, args.verbose)?;
        }
        Ok(())
    })?;
    Ok((answer, text))
}
