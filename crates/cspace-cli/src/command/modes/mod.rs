//! `cspace modes`.

pub(crate) mod answer;
mod ask;
mod picture;

use std::time::Instant;

use crate::legacy::{Answer, Outcome};
use cspace_modes::Modes;

use crate::args::ModesArgs;
use crate::ask::{read_model, set_threads};
use crate::failure::Failure;
use crate::interrupt::catch_interrupts;
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
    catch_interrupts();
    set_threads(args.threads)?;
    let (path, model) = read_model(&args.file, &args.values, "modes are those of three parts")?;
    let parts = ask::parts(&path, &model, args.parts.as_deref())?;
    let at = ask::configuration(&model, parts, args.at.as_deref())?;
    let begin = Instant::now();
    let modes =
        Modes::compute(&model, parts).map_err(|error| ask::rejected(&path, &model, &error))?;
    let place = modes.locate(at).map_err(Failure::new)?;
    if let Some(format) = format {
        let scene = picture::scene(args, &model, &modes, (at, place));
        pictures::write(output, format, &scene)?;
    }
    let seconds = begin.elapsed().as_secs_f64();
    let answer = answer::of(&model, &modes, (at, place), seconds);
    let framed = Answer::new("modes", model.unit.as_deref(), Outcome::DONE, &answer);
    super::print(&args.result, &framed, |text| {
        *text = answer::text(&model, &modes, &answer)?;
        Ok(())
    })
}
