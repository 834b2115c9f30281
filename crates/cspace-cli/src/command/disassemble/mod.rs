//! `cspace disassemble`.

mod picture;
mod text;

use cspace_api::disassemble::Question;

use crate::args::{CacheArgs, DisassembleArgs};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;

pub(crate) fn run(args: &DisassembleArgs) -> Result<(), Failure> {
    let output = args.result.output.as_deref();
    let format = crate::picture::format(output);
    if format.is_none() {
        args.picture.refuse()?;
    }
    args.result.artefact(&["svg", "png", "pdf", "json"])?;
    output::check(output)?;
    let subject = ask::read(&args.file, &args.values, args.threads)?;
    let question = Question { gap: args.gap };
    let answer = question.ask(&subject, &Terminal::new(CacheArgs::default()))?;
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
