//! `cspace simulate`.

mod force;
mod frames;
mod picture;
mod table;
mod text;

use std::path::PathBuf;

use clap::Args;
use cspace_api::simulate::{Earlier, Outcome, Question};

use super::record;
use crate::args::{CacheArgs, ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;
use crate::picture::{PictureArgs, format};

const HELP: &str = "\
Examples:
  cspace simulate models/geneva.toml --time 2
  cspace simulate models/ratchet_mechanism.toml --time 3 --every 0.01 -o run.csv
  cspace simulate models/gears_on_shafts.toml --time 1 --rates --json
  cspace simulate models/escapement.toml --time 3 -o run.svg

The answer reports whether the motion repeats, what each part does in a cycle,
and how long each contact lasts. -o OUT.csv writes the samples beside it,
-o OUT.svg, .png or .pdf a page: the mechanism at some times, each part's
motion and the contacts over time, the path in the plane of each pair on axes.

The model says what moves it: [[drive]], [[load]] and [[spring]]. In the
kinematic mode drives move slowly, and loads, springs and weights balance at
every instant; other parts go only where contacts push them.

  done          it came to the end
  jammed        what is driven cannot go on: no velocity is allowed by the
                contacts that are listed
  undetermined  how it goes on is not determined, and why

Events are contacts that come (touch) and go (release), ends of ranges that are
reached (limit), and balances that end (snap). Their times do not depend on
--every. The exit code is 1 if it jams, and 2 if it is undetermined.

-o OUT.csv writes the samples: t, then NAME.u of each part that turns or
slides, NAME.x, NAME.y, NAME.theta of others, and with --rates NAME.du or
NAME.vx, NAME.vy, NAME.omega. OUT.json gets the record, which --resume goes on
with and `cspace view --with` plays.";

/// Arguments of `cspace simulate`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct SimulateArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    #[command(flatten)]
    pub(crate) question: Question,
    /// Go on where the motion of a record ends: what `cspace simulate` wrote with -o RECORD.json or .json.gz, of the same model
    #[arg(long, value_name = "RECORD.json")]
    pub(crate) resume: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) cache: CacheArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
    // Last: what follows would stand below its heading.
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

pub(crate) fn run(args: &SimulateArgs) -> Result<(), Failure> {
    let output = args.result.output.as_deref();
    let drawn = format(output);
    if drawn.is_none() {
        args.picture.refuse()?;
    }
    args.result
        .artefact(&["csv", "json", "svg", "png", "pdf"])?;
    output::check(output)?;
    let subject = ask::read(&args.file, &args.values, args.threads)?;
    let file = subject.model("a simulation is of all of its parts")?;
    let model = &file.model.mechanism;
    let options = picture::options(args, model)?;
    let resume = match &args.resume {
        Some(path) => Some(Earlier {
            path: path.clone(),
            answer: record::json(path, model, false)?,
        }),
        None => None,
    };
    let question = Question {
        states: output.is_some_and(|path| output::ends_in(path, "json")),
        resume,
        ..args.question.clone()
    };
    let answer = question.ask(&subject, &Terminal::new(args.cache))?;
    let simulated = &answer.content;
    if let Some(format) = drawn {
        let scene = picture::scene(simulated, &options)?;
        crate::picture::write(output, format, &scene)?;
    } else if let Some(path) = output.filter(|path| output::ends_in(path, "csv")) {
        let csv = table::csv(model, simulated, &question)?;
        output::write(Some(path), &csv)?;
    }
    let printed = super::tell(&args.result, &answer, |text, simulated| {
        text::describe(text, model, &simulated.motion)
    });
    match answer.outcome {
        Outcome::Interrupted => {
            let until = simulated.motion.until;
            Err(interrupted(args, until, question.states))
        }
        _ => printed,
    }
}

/// The failure of an interrupted motion, with the command that resumes it.
fn interrupted(args: &SimulateArgs, until: f64, is_kept: bool) -> Failure {
    let failure = Failure::new(format_args!(
        "interrupted at {until:.6} s of {}",
        args.question.time
    ));
    match &args.result.output {
        Some(record) if is_kept => failure.help(format_args!(
            "what is done is in {0}: go on with --resume {0}",
            record.display()
        )),
        _ => failure
            .help("with -o RECORD.json what is done is kept, and --resume RECORD.json goes on"),
    }
}
