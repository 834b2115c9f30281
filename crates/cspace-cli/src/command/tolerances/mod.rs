//! `cspace tolerances`.

pub(crate) mod answer;
mod text;

use cspace_design::{ToleranceOptions, Variations, tolerances};

use crate::args::{Format, TolerancesArgs};
use crate::failure::Failure;
use crate::input;
use crate::interrupt::catch_interrupts;
use crate::output;
use crate::progress::Bar;
use crate::subject::set_threads;

pub(crate) fn run(args: &TolerancesArgs) -> Result<(), Failure> {
    args.result.check_answer()?;
    let output = args.result.output.as_deref();
    output::check(output)?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (template, mut model) = input::template(&args.file, &args.values)?;
    let file = args.file.display();
    if model.requirements.is_empty() {
        return Err(super::check::no_requirements(&args.file));
    }
    let variations = Variations::of(&model);
    if variations.is_empty() {
        return Err(
            Failure::input(format_args!("{file}: no parameter has a tolerance"))
                .help("give one in [parameter], such as pin = { value = 6.0, tol = 0.02 }"),
        );
    }
    let outside = (model.parameters.iter())
        .find(|p| p.is_set && p.deviations.is_some_and(|(a, b)| a < 0.0 || b < 0.0));
    if let Some(outside) = outside {
        let name = cspace_io::shown::quoted(&outside.name);
        let error = format_args!("{name} is set to a value outside its limits");
        return Err(Failure::input(error).help("set it to a value within them"));
    }
    if !args.requirement.is_empty() {
        super::check::chosen(&mut model, &args.requirement)?;
    }
    let chosen: Vec<&str> = model.requirements.iter().map(|r| r.name.as_str()).collect();
    let options = ToleranceOptions {
        samples: args.samples,
        seed: args.seed,
        requirements: chosen.iter().map(|&name| name.to_owned()).collect(),
    };
    let bar = Bar::new(model.mechanism.name.clone());
    let found = bar
        .watch(|bar| tolerances(&template, &args.values.set, &model, &options, bar))
        .map_err(Failure::work)?;
    let answer = match args.result.format() {
        Format::Json => super::json(&answer::rows(&variations, &found))?,
        Format::Text => {
            let unit = model.mechanism.unit.as_ref();
            let unit = unit.map_or(String::new(), |u| format!(" {u}"));
            text::described(&variations, &found, &unit).into_bytes()
        }
    };
    output::write(output, &answer)
}
