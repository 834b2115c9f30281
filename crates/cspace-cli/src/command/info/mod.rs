//! `cspace info`.

mod dynamics;
mod text;

use cspace_api::Answer;
use cspace_api::info::{Info, Question};

use super::several;
use crate::args::{Common, InfoArgs};
use crate::ask;
use crate::failure::Failure;

pub(crate) fn run(args: &InfoArgs) -> Result<(), Failure> {
    several::run(&args.common, &args.more, |common| answer(common, args))
}

fn answer(common: &Common, args: &InfoArgs) -> Result<(Answer<Info>, String), Failure> {
    let (subject, host) = ask::open(common)?;
    subject.warn(&host);
    ask::tell_traces(&subject);
    let question = Question {
        which: ask::which(common, args.window.window),
    };
    let answer = question.ask(&subject, &host)?;
    let text = several::text(common, |text| text::describe(text, &answer.content))?;
    Ok((answer, text))
}
