//! `cspace simulate`.

mod force;
mod frames;
mod picture;
mod table;
mod text;

use cspace_api::simulate::{Earlier, Outcome, Question};

use super::record;
use crate::args::SimulateArgs;
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;
use crate::picture::format;

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
        time: args.time,
        every: args.every,
        mode: args.mode.map(Into::into),
        scheme: args.scheme.into(),
        step: args.step,
        rates: args.rates,
        forces: args.forces,
        states: output.is_some_and(|path| output::ends_in(path, "json")),
        resume,
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
    let failure = Failure::new(format_args!("interrupted at {until:.6} s of {}", args.time));
    match &args.result.output {
        Some(record) if is_kept => failure.help(format_args!(
            "what is done is in {0}: go on with --resume {0}",
            record.display()
        )),
        _ => failure
            .help("with -o RECORD.json what is done is kept, and --resume RECORD.json goes on"),
    }
}
