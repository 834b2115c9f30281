//! `cspace tolerances`.

mod allocation;
mod along;
pub(crate) mod answer;
mod text;
mod zones;

use crate::legacy::{Answer, Outcome};
use cspace_design::{ToleranceOptions, Tolerances, Variations, allocate, tolerances_with};
use std::path::Path;

use crate::args::TolerancesArgs;
use crate::ask::set_threads;
use crate::failure::Failure;
use crate::input;
use crate::interrupt::{self, catch_interrupts};
use crate::output;
use crate::progress::Bar;

pub(crate) fn run(args: &TolerancesArgs) -> Result<(), Failure> {
    let is_picture = crate::picture::format(args.result.output.as_deref()).is_some();
    if !is_picture && !args.zones {
        args.picture.refuse()?;
    }
    args.result.artefact(&["json", "svg", "png", "pdf"])?;
    output::check(args.result.output.as_deref())?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (template, mut model) = input::template(&args.file, &args.values)?;
    let file = args.file.display();
    if model.requirements.is_empty() {
        return Err(no_requirements(&args.file));
    }
    if Variations::of(&model).is_empty() {
        return Err(
            Failure::new(format_args!("{file}: no parameter has a tolerance"))
                .help("give one in [parameter], such as pin = { value = 6.0, tol = 0.02 }"),
        );
    }
    // What is outside its limits has its tolerance about their middle.
    let mut values = args.values.clone();
    (values.set, model) = (template.about_middles(&values.set, model)).map_err(Failure::new)?;
    let variations = Variations::of(&model);
    let outside = (model.parameters.iter())
        .find(|p| p.has_limits && p.deviations.is_some_and(|(a, b)| a < 0.0 || b < 0.0));
    if let Some(outside) = outside {
        let name = cspace_io::shown::quoted(&outside.name);
        let (below, above) = outside.deviations.unwrap_or_default();
        let [lo, hi] = [outside.value - below, outside.value + above].map(cspace_io::shown::number);
        let error = format_args!("{name} is set to a value outside its limits, {lo} to {hi}");
        return Err(Failure::new(error).help("set it to a value within them"));
    }
    if !args.requirement.is_empty() {
        chosen(&mut model, &args.requirement)?;
    }
    let chosen: Vec<&str> = model.requirements.iter().map(|r| r.name.as_str()).collect();
    let options = ToleranceOptions {
        samples: args.samples,
        seed: args.seed,
        requirements: chosen.iter().map(|&name| name.to_owned()).collect(),
        without_proof: args.no_proof,
    };
    let model_unit = model.mechanism.unit.as_deref();
    let unit = model_unit.map_or(String::new(), |u| format!(" {u}"));
    let bar = Bar::new(model.mechanism.name.clone());
    if args.at.is_some() && !args.zones && !is_picture {
        return Err(Failure::new("--at is the orientation of contact zones")
            .help("give --zones or -o OUT.svg, or leave it out"));
    }
    if is_picture && (args.allocate.is_some() || args.samples > 0) {
        return Err(
            Failure::new("-o: a picture shows contact zones, or values along a motion")
                .help("leave --allocate and --samples out, or let the name end in .txt or .json"),
        );
    }
    if args.zones || is_picture && args.along.is_none() {
        let printed = zones::run(args, &values.set, (&template, &model));
        // Without --zones they are a picture beside the answer.
        if args.zones || printed.is_err() {
            return printed;
        }
    }
    if let Some(vary) = &args.along {
        return along::run(
            args,
            &values.set,
            vary,
            (&template, &model, &variations),
            &options,
        );
    }
    if let Some(criterion) = args.allocate {
        let costs = costs(&variations, &args.cost)?;
        let found = bar.watch(|bar| {
            let (set, wanted) = (&values.set, (criterion, costs.as_slice()));
            allocate(&template, set, &model, &options, wanted, bar)
        });
        let found = found.map_err(|error| allocation::failure(&file, error))?;
        let answer = allocation::answer(criterion, &costs, &found);
        let framed = Answer::new("tolerances", model_unit, Outcome::DONE, &answer);
        return super::print(&args.result, &framed, |text| {
            let given = (&variations, costs.as_slice());
            *text = allocation::text(criterion, given, &found, (&model.mechanism, &unit));
            Ok(())
        });
    }
    interrupt::keep();
    let found = bar
        .watch(|bar| {
            let known = |known: &[Tolerances]| bar.tell(text::at_once(&variations, known, &unit));
            tolerances_with(&template, &values.set, &model, &options, &known, bar)
        })
        .map_err(Failure::new)?;
    let rows = answer::rows(&variations, &found);
    let outcome = Outcome::worst(rows.iter().map(|row| row.outcome));
    let framed = Answer::new(
        "tolerances",
        model_unit,
        outcome,
        super::Requirements { requirements: rows },
    );
    let printed = super::print(&args.result, &framed, |text| {
        *text = text::described(&model.mechanism, &variations, &found, &unit);
        Ok(())
    });
    if found.iter().any(|of| of.interrupted) {
        return Err(Failure::new("interrupted: what is known is written"));
    }
    printed
}

/// The cost of each variation's tolerance: 1 unless given.
fn costs(variations: &Variations, given: &[(String, f64)]) -> Result<Vec<f64>, Failure> {
    let mut costs = vec![1.0; variations.len()];
    for (name, cost) in given {
        let mut all = variations.list.iter();
        let Some(i) = all.position(|v| v.parameter.name == *name) else {
            let quoted = cspace_io::shown::quoted(name);
            let names = variations.list.iter().map(|v| v.parameter.name.as_str());
            let names = names.collect::<Vec<_>>().join(", ");
            return Err(Failure::new(format_args!(
                "--cost {quoted}: no parameter of this name has a tolerance"
            ))
            .help(format_args!("parameters with tolerances are {names}")));
        };
        costs[i] = *cost;
    }
    Ok(costs)
}

/// A model without requirements.
fn no_requirements(file: &Path) -> Failure {
    let error = format_args!("{}: the model has no requirements", file.display());
    Failure::new(error)
        .help("add [[requirement]] tables with name, measure and limits: see docs/design.md")
}

/// Leaves the requirements of these names.
fn chosen(model: &mut cspace_io::Model, names: &[String]) -> Result<(), Failure> {
    if let Some(unknown) = names
        .iter()
        .find(|n| model.requirements.iter().all(|r| r.name != **n))
    {
        return Err(Failure::new(format_args!(
            "--requirement {}: the model has no such requirement",
            cspace_io::shown::quoted(unknown)
        ))
        .help(crate::command::requirements_of(model)));
    }
    model.requirements.retain(|r| names.contains(&r.name));
    Ok(())
}
