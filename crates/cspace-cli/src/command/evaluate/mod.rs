//! `cspace evaluate`: section 4 of Sacks (1999), measured here.

mod averages;
mod critical;
mod embedded;
mod evaluation;
mod measure;
mod special;
mod text;
mod timing;

use cspace_baseline::paper::{self, PaperPair};

use crate::args::{EvaluateArgs, Format};
use crate::failure::Failure;
use crate::interrupt::catch_interrupts;
use crate::output;
use crate::progress::Steps;
use crate::subject::set_threads;

use averages::Averages;
use evaluation::Evaluation;
use measure::measure;

pub(crate) fn run(args: &EvaluateArgs) -> Result<(), Failure> {
    args.result.check_answer()?;
    output::check(args.result.output.as_deref())?;
    let chosen = chosen(&args.pairs)?;
    // A wrong separation is reported before anything is measured.
    cspace_baseline::evenly(args.separation).map_err(|e| {
        Failure::new(format_args!("--separation: {e}")).help("give an angle such as 0.005")
    })?;
    catch_interrupts();
    set_threads(args.threads)?;
    let steps = Steps::new(chosen.len() + 1);
    let pairs = (chosen.iter())
        .map(|pair| steps.step(pair.name, || measure(pair, args)))
        .collect::<Result<Vec<_>, _>>()?;
    let survey = steps.step("special pairs", || special::survey(args.repeat))?;
    drop(steps);
    let evaluation = Evaluation {
        separation: args.separation,
        repeat: args.repeat,
        criticality_limit: args.criticality_limit,
        threads: rayon::current_num_threads(),
        averages: Averages::of(&pairs),
        pairs,
        survey,
    };
    let bytes = match args.result.format() {
        Format::Json => super::json(&evaluation)?,
        Format::Text => {
            let mut text = String::new();
            text::describe(&mut text, &evaluation).map_err(Failure::new)?;
            text.into_bytes()
        }
    };
    output::write(args.result.output.as_deref(), &bytes)
}

/// The pairs of these names, in Figure 5's order; all if none is named.
fn chosen(names: &[String]) -> Result<Vec<&'static PaperPair>, Failure> {
    /// `ratchet_pawl` and `Ratchet/Pawl` mean the same.
    fn plain(name: &str) -> String {
        let letters = name.chars().filter(|c| c.is_alphanumeric());
        letters.flat_map(char::to_lowercase).collect()
    }
    let all = || paper::PAIRS.iter();
    for name in names {
        if !all().any(|p| plain(p.name) == plain(name)) {
            let known: Vec<&str> = all().map(|p| p.name).collect();
            return Err(
                Failure::new(format_args!("--pairs: Figure 5 has no pair {name:?}"))
                    .help(format_args!("the pairs are {}", known.join(", "))),
            );
        }
    }
    Ok(all()
        .filter(|p| names.is_empty() || names.iter().any(|n| plain(n) == plain(p.name)))
        .collect())
}
