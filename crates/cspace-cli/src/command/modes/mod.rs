//! `cspace modes`.

mod picture;
mod text;

use std::path::PathBuf;

use clap::Args;
use cspace_api::modes::{Found, Question};

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
  cspace modes models/layers/pin_tumbler_lock.toml --set key3=4

Three parts that each turn or slide on an axis have three coordinates u, v, w.
A configuration of all three is free if (u, v), (v, w) and (u, w) are free in
the spaces of their pairs; a pair that the model does not list constrains
nothing. An operating mode is a connected component of the free configurations:
a motion of the three parts leads from one to another if and only if both are
in one mode. More than three parts are taken too where their contacts make a
tree, as of a cam and its followers; their coordinates are u, v, w, q4, q5 ...
Modes are found from the contact curves, not by sampling; openings of less than
1e-11 of the size are closed, as in the spaces of the pairs.

For each mode: the range of each coordinate, a configuration within it, and the
coordinates that turn for ever in it. Where parts turn for ever together the
answer lists the turns: all motions that end where they began turn the parts by
sums of whole multiples of these.

Other parts of the model are not considered; neither are drives and springs.

-o modes.svg, .png or .pdf is a picture: for each mode a row with the
planes of the three pairs, in which the mode's projection is coloured. Modes of
more than three parts have no picture.
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
        let Found::Three(found) = &answer.content.found else {
            return Err(Failure::new(format_args!(
                "modes of {} parts have no picture: it has the planes of three",
                answer.content.parts.len()
            ))
            .help("choose three with --parts A,B,C, or leave out -o"));
        };
        let scene = picture::scene(args, &subject, &answer.content, found);
        pictures::write(output, format, &scene)?;
    }
    super::tell(&args.result, &answer, |text, found| {
        text::describe(text, subject.unit(), found)
    })
}
