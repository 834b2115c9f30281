//! `cspace info`.

mod dynamics;
mod text;

use std::path::PathBuf;

use clap::Args;
use cspace_api::Answer;
use cspace_api::info::{Info, Question};

use super::several;
use crate::args::Common;
use crate::ask;
use crate::failure::Failure;

const HELP: &str = "\
Examples:
  cspace info models/ratchet_pawl.toml
  cspace info models/geneva.toml --json

A model of one part is shown as well; the other commands need two.

The class is what the motions and joints of the model make of a pair: lower,
fixed-axes or general; symmetric is a general pair of which a part is mapped to
itself by a rotation about its centre. Symmetry is found from the outlines.
With --window the class is shown that the pair has in those orientations; pairs
without orientations are shown as they are. Features are lines, arcs and
vertices that are not smooth joints.";

/// Arguments of `cspace info`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct InfoArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) question: Question,
    /// More files, answered one after the other
    #[arg(value_name = "FILE")]
    pub(crate) more: Vec<PathBuf>,
}

pub(crate) fn run(args: &InfoArgs) -> Result<(), Failure> {
    several::run(&args.common, &args.more, |common| answer(common, args))
}

fn answer(common: &Common, args: &InfoArgs) -> Result<(Answer<Info>, String), Failure> {
    let (subject, host) = ask::open(common)?;
    subject.warn(&host);
    ask::tell_traces(&subject);
    let answer = args.question.ask(&subject, &host)?;
    let text = several::text(common, |text| text::describe(text, &answer.content))?;
    Ok((answer, text))
}
