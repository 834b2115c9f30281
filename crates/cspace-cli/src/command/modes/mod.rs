//! `cspace modes`.

mod picture;
mod text;

use cspace_api::modes::Question;

use crate::args::{CacheArgs, ModesArgs};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;
use crate::picture as pictures;

pub(crate) fn run(args: &ModesArgs) -> Result<(), Failure> {
    let output = args.result.output.as_deref();
    let format = pictures::format(output);
    if format.is_none() {
        args.picture.refuse()?;
    }
    args.result.artefact(&["svg", "png", "pdf"])?;
    output::check(output)?;
    let subject = ask::read(&args.file, &args.values, args.threads)?;
    let question = Question {
        parts: args.parts.clone(),
        at: args.at.clone(),
    };
    let answer = question.ask(&subject, &Terminal::new(CacheArgs::default()))?;
    if let Some(format) = format {
        let scene = picture::scene(args, &subject, &answer.content);
        pictures::write(output, format, &scene)?;
    }
    super::tell(&args.result, &answer, |text, found| {
        text::describe(text, subject.unit(), found)
    })
}
