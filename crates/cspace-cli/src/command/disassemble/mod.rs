//! `cspace disassemble`.

mod picture;
mod text;

use std::path::PathBuf;

use clap::Args;
use cspace_api::disassemble::Question;

use crate::args::{CacheArgs, ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;
use crate::picture::PictureArgs;

const HELP: &str = "\
Examples:
  cspace disassemble models/latch_box.toml
  cspace disassemble models/latch_box.toml --gap 0.01 --json
  cspace disassemble models/latch_box.toml -o steps.svg
  cspace disassemble models/latch_box.toml -o apart.json
  cspace view models/latch_box.toml --with apart.json

One part, or a group as one, moves at a time, while the others stay. Where none
goes out, one part or two make room first: parts on axes (doors, bolts) along
these, others straight; they stay where they have come to. The tree shows what
comes out of what; a step gives the moving parts and their path: x, y, theta of
these parts from where they are before the step, or what a part on an axis does.
A path ends where a line lies between the parts and the others.

  apart    all comes apart, in the order listed
  locked   some parts do not, however the others move: of two parts one encloses
           the other, by the features listed. That is certain
  unknown  no path was found and none is excluded: the answer gives the extent
           of the search, and the smallest set of which none leaves while the
           others stay

Parts on axes never go out; parts joined by a joint move as one. Every two parts
are looked at, whichever pairs the model lists; nothing moves in height. Parts
may touch as drawn: every boundary is moved inward by half of --gap. Parts that
overlap by more are an error.

-o OUT writes the answer as .json, which `cspace view --with OUT.json` plays
with all parts, or a picture with a frame for each step as .svg, .png or .pdf.";

/// Arguments of `cspace disassemble`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct DisassembleArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    #[command(flatten)]
    pub(crate) question: Question,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
    // Last: what follows would stand below its heading.
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

pub(crate) fn run(args: &DisassembleArgs) -> Result<(), Failure> {
    let output = args.result.output.as_deref();
    let format = crate::picture::format(output);
    if format.is_none() {
        args.picture.refuse()?;
    }
    args.result.artefact(&["svg", "png", "pdf", "json"])?;
    output::check(output)?;
    let subject = ask::read(&args.file, &args.values, args.threads)?;
    let answer = args
        .question
        .ask(&subject, &Terminal::new(CacheArgs::default()))?;
    let model = &subject
        .model("an assembly is all of its parts")?
        .model
        .mechanism;
    if let Some(format) = format {
        picture::write(args, model, &answer.content.taken, format)?;
    }
    super::tell(&args.result, &answer, |text, found| {
        text::describe(text, model, found)
    })
}
