//! `cspace simulate`.

mod force;
mod frames;
mod picture;
mod resume;
mod scheme;
mod table;
mod text;

use std::path::Path;
use std::time::Instant;

use cspace_io::shown;
use cspace_mechanism::Mechanism;
use cspace_motion::{Record, Report, Settings, SimulateError, Simulation, Status, Way};
use cspace_plan::clash::{Assembly, Sample};

use crate::args::{Mode, SimulateArgs};
use crate::ask::{read_model, set_threads};
use crate::cache;
use crate::failure::{Failure, note, warning};
use crate::interrupt::{catch_interrupts, keep};
use crate::output;
use crate::picture::format;
use crate::progress::Bar;

use crate::legacy::{Answer, Outcome};
use cspace_api::simulate::{Told, Wanted};

pub(crate) fn run(args: &SimulateArgs) -> Result<(), Failure> {
    let output = args.result.output.as_deref();
    let drawn = format(output);
    if drawn.is_none() {
        args.picture.refuse()?;
    }
    args.result
        .artefact(&["csv", "json", "svg", "png", "pdf"])?;
    output::check(output)?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (path, model) = read_model(
        &args.file,
        &args.values,
        "a simulation is of all of its parts",
    )?;
    let mode = mode_of(&path, &model, args)?;
    let options = picture::options(args, &model)?;
    let step = scheme::step(args, mode)?;
    check_names(&path, &model)?;
    let begin = Instant::now();
    let failed = |error: SimulateError| failure(&path, &error);
    let settings = Settings {
        time: args.time,
        every: args.every,
    };
    let way = match (mode, step) {
        (Mode::Kinematic, _) => Way::Kinematic,
        (Mode::Dynamic, None) => Way::Dynamic,
        (Mode::Dynamic, Some(step)) => Way::Stepping(step),
    };
    let earlier = match &args.resume {
        Some(file) => Some(resume::record(file, &model, mode, args.time)?),
        None => None,
    };
    let (simulation, mut record) = Bar::new(shown::text(&model.name).into_owned())
        .watch(|bar| {
            let compute = cache::compute(!args.cache.no_cache, bar);
            let mut simulation = Simulation::new_by(&model, &compute)?;
            if let Some(last) = earlier.as_ref().and_then(Record::last) {
                simulation = simulation.taken_up(last)?;
            }
            keep();
            let record = simulation.kept_with(way, &settings, bar)?;
            Ok((simulation, record))
        })
        .map_err(failed)?;
    if let Some(earlier) = earlier {
        record = record.after(earlier);
    }
    for (a, b) in simulation.pairs().apart() {
        let name = |i: &usize| shown::quoted(model.parts[*i].part.name());
        note(format_args!("{} and {} never meet", name(a), name(b)));
    }
    tell_joined(&model, &simulation, &record);
    let freedom = simulation.freedom();
    if freedom.redundant() > 0 {
        note(format_args!(
            "{} of the {} equations of the joints follow from the others: the mechanism is over-determined, and how its joints share \
             forces is not",
            freedom.redundant(),
            freedom.equations
        ));
    }
    let report = Report::of(&simulation, &record);
    let wanted = Wanted {
        rates: args.rates,
        forces: args.forces,
        states: output.is_some_and(|path| output::ends_in(path, "json")),
    };
    let told = Told::of(
        &model,
        &simulation,
        (&record, &report),
        wanted,
        begin.elapsed().as_secs_f64(),
    )
    .map_err(Failure::new)?;
    if let Some(format) = drawn {
        let scene = picture::scene(&simulation, &record, &report, &options)?;
        crate::picture::write(output, format, &scene)?;
    } else if let Some(path) = output.filter(|path| output::ends_in(path, "csv")) {
        let csv = table::csv(&model, &simulation, &record, wanted)?;
        output::write(Some(path), &csv)?;
    }
    let outcome = match record.status {
        Status::Done => Outcome::yes("done"),
        Status::Jammed => Outcome::no("jammed"),
        Status::Undetermined => Outcome::open("undetermined"),
        Status::Inconsistent => Outcome::open("inconsistent"),
        Status::Interrupted => Outcome::open("interrupted"),
    };
    let unit = model.unit.as_deref();
    let answer = Answer::new("simulate", unit, outcome, &told);
    let printed = super::print(&args.result, &answer, |text| {
        text::describe(text, &model, &told)
    });
    match record.status {
        Status::Interrupted => Err(interrupted(args, record.until, wanted.states)),
        _ => printed,
    }
}

/// Says which parts that a joint connects go through each other: their contact is not part of the motion.
fn tell_joined(model: &Mechanism, simulation: &Simulation, record: &Record) {
    let parts = simulation.system().parts();
    let sample = |s: &cspace_motion::Sample| Sample {
        time: s.t,
        parts: (parts.iter())
            .map(|part| {
                let mut place = [0.0; 3];
                for (to, i) in place.iter_mut().zip(part.indices()) {
                    *to = s.coordinates[i];
                }
                place
            })
            .collect(),
    };
    let samples: Vec<Sample> = record.samples.iter().map(sample).collect();
    for meeting in Assembly::new(model).joined_that_meet(&samples) {
        let [a, b] = meeting
            .parts
            .map(|i| shown::quoted(model.parts[i].part.name()));
        let time = meeting.time.unwrap_or(0.0);
        warning(
            format_args!(
                "{a} and {b} are joined, so that they are not tested for contact, and they go through each other from about {time:.4} s on"
            ),
            "draw them so that they pass, or end the motion before: give the driven part a `range`",
        );
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

/// Without masses the mode is kinematic, unless another is asked for.
fn mode_of(path: &Path, model: &Mechanism, args: &SimulateArgs) -> Result<Mode, Failure> {
    let has_mass = model.has_masses();
    let mode = match args.mode {
        Some(Mode::Dynamic) if !has_mass => {
            note("no part has a mass, so the mode is kinematic");
            Mode::Kinematic
        }
        Some(mode) => mode,
        None if has_mass => Mode::Dynamic,
        None => Mode::Kinematic,
    };
    let is_loaded = cspace_motion::has_forces(model);
    if mode == Mode::Kinematic && !is_loaded && model.dynamics.drives.is_empty() {
        note("nothing moves: the model has no [[drive]], [[load]] or [[spring]]");
    }
    if args.forces && mode == Mode::Kinematic && !is_loaded {
        return Err(Failure::new(format_args!(
            "{}: --forces reports the forces of loads, springs and weights, and the model has none",
            path.display()
        ))
        .help("add a [[load]] or a [[spring]], or leave --forces out"));
    }
    Ok(mode)
}

fn check_names(path: &Path, model: &Mechanism) -> Result<(), Failure> {
    let taken = |name: &&str| ["t", "rates", "forces"].contains(name);
    match model.parts.iter().map(|p| p.part.name()).find(taken) {
        Some(name) => Err(Failure::new(format_args!(
            "{}: a part is called {name}, which is the name of another column of the result",
            path.display()
        ))
        .help("give it another name")),
        None => Ok(()),
    }
}

/// The failure for an error.
fn failure(path: &Path, error: &SimulateError) -> Failure {
    match error.is_interrupted() {
        true => Failure::new("interrupted"),
        false => Failure::new(format_args!("{}: {error}", path.display())),
    }
}
