//! `cspace modes`.

mod picture;
mod text;

use std::path::PathBuf;

use clap::Args;
use cspace_api::modes::Question;

use crate::args::{CacheArgs, ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;
use crate::picture::{self as pictures, SheetArgs};

const HELP: &str = "\
Examples:
  cspace modes models/shift_interlock.toml
  cspace modes models/shift_interlock.toml --at u=8 --json
  cspace modes models/shift_interlock.toml -o modes.svg

Three parts that each turn or slide on an axis have three coordinates u, v, w.
A configuration of all three is free if (u, v), (v, w) and (u, w) are free in
the spaces of their pairs; a pair that the model does not list constrains
nothing. An operating mode is a connected component of the free configurations:
a motion of the three parts leads from one to another if and only if both are
in one mode. Modes are found from the contact curves, not by sampling; openings
of less than 1e-11 of the size are closed, as in the spaces of the pairs.

For each mode: the range of each coordinate, a configuration within it, and the
coordinates that turn for ever in it. Where parts turn for ever together the
answer lists the turns: all motions that end where they began turn the parts by
sums of whole multiples of these.

Other parts of the model are not considered; neither are drives and springs.

-o modes.svg, .png or .pdf is a picture: for each mode a row with the
planes of the three pairs, in which the mode's projection is coloured.
";

/// Arguments of `cspace modes`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ModesArgs {
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
    pub(crate) picture: SheetArgs,
}

pub(crate) fn run(args: &ModesArgs) -> Result<(), Failure> {
    let output = args.result.output.as_deref();
    let format = pictures::format(output);
    if format.is_none() {
        args.picture.refuse()?;
    }
    args.result.artefact(&["svg", "png", "pdf"])?;
    output::check(output)?;
    let subject = ask::read(&args.file, &args.values, args.threads)?;
    let answer = args
        .question
        .ask(&subject, &Terminal::new(CacheArgs::default()))?;
    if let Some(format) = format {
        let scene = picture::scene(args, &subject, &answer.content);
        pictures::write(output, format, &scene)?;
    }
    super::tell(&args.result, &answer, |text, found| {
        text::describe(text, subject.unit(), found)
    })
}
