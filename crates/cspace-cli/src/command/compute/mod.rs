//! `cspace compute`.

mod answer;
mod text;

use cspace_api::compute::{Question, Summary, summed_up};
use cspace_api::subject::Source;
use cspace_api::{Answer, Pairs};

use super::several;
use crate::args::{Common, ComputeArgs};
use crate::ask;
use crate::failure::{Failure, note};

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
    let question = Question {
        which: ask::which(common, args.window.window),
        clearance: args.clearance,
    };
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
