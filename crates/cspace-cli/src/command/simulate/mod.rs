//! `cspace simulate`.

mod answer;
mod scheme;
mod table;

use std::fmt::{self, Write};
use std::path::Path;
use std::time::Instant;

use cspace::{ComputeError, Mechanism, MechanismError, PairError};
use cspace_io::shown;
use cspace_motion::{Event, EventKind, Settings, SimulateError, Simulation, Status, What};

use crate::args::{Format, Mode, SimulateArgs};
use crate::failure::{Failure, note};
use crate::output;
use crate::progress::{Bar, catch_interrupts};
use crate::subject::{read_model, set_threads};
use crate::wording::{count, degrees, length};

use answer::{Numbers, Told};

pub(crate) fn run(args: &SimulateArgs) -> Result<(), Failure> {
    args.result.check_answer()?;
    let output = args.result.output.as_deref();
    output::check(output)?;
    output::check_apart(output, &args.file)?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (path, model) = read_model(&args.file, "a simulation is of all of its parts")?;
    let mode = mode_of(&model, args.mode);
    let step = scheme::step(args, mode)?;
    check_names(&path, &model)?;
    let begin = Instant::now();
    let failed = |error: SimulateError| failure(&path, error);
    let settings = Settings {
        time: args.time,
        every: args.every,
    };
    let (simulation, record) = Bar::new(shown::text(&model.name).into_owned())
        .watch(|bar| {
            let simulation = Simulation::new_with(&model, bar)?;
            let record = match (mode, step) {
                (Mode::Kinematic, _) => simulation.kinematic_with(&settings, bar)?,
                (Mode::Dynamic, None) => simulation.dynamic_with(&settings, bar)?,
                (Mode::Dynamic, Some(step)) => simulation.stepping_with(&settings, step, bar)?,
            };
            Ok((simulation, record))
        })
        .map_err(failed)?;
    for (a, b) in simulation.pairs().apart() {
        let name = |i: &usize| shown::quoted(model.parts[*i].part.name());
        note(format_args!("{} and {} never meet", name(a), name(b)));
    }
    let system = simulation.system();
    let csv = match is_csv(output) {
        true => Some(table::csv(&model, system, &record, args.rates)?),
        false => None,
    };
    let told = Told::of(
        &model,
        system,
        record,
        args.rates,
        begin.elapsed().as_secs_f64(),
    );
    let answer = match args.result.format() {
        Format::Json => super::json(&told)?,
        Format::Text => {
            let mut text = String::new();
            describe(&mut text, &model, &told).map_err(Failure::work)?;
            text.into_bytes()
        }
    };
    // A table is written beside the answer.
    match csv {
        Some(csv) => {
            output::write(output, &csv)?;
            output::write(None, &answer)
        }
        None => output::write(output, &answer),
    }
}

fn is_csv(path: Option<&Path>) -> bool {
    (path.and_then(Path::extension)).is_some_and(|e| e.eq_ignore_ascii_case("csv"))
}

/// Without masses the mode is kinematic, unless another is asked for.
fn mode_of(model: &Mechanism, mode: Option<Mode>) -> Mode {
    let has_mass = (0..model.parts.len()).any(|i| model.dynamics.part(i).mass.is_some());
    match mode {
        Some(Mode::Dynamic) if !has_mass => {
            note("no part has a mass, so the mode is kinematic");
            Mode::Kinematic
        }
        Some(mode) => mode,
        None if has_mass => Mode::Dynamic,
        None => Mode::Kinematic,
    }
}

/// A sample has its time and its rates beside the parts.
fn check_names(path: &Path, model: &Mechanism) -> Result<(), Failure> {
    let taken = |name: &&str| ["t", "rates"].contains(name);
    match model.parts.iter().map(|p| p.part.name()).find(taken) {
        Some(name) => Err(Failure::input(format_args!(
            "{}: a part is called {name}, which is the name of another column of the result",
            path.display()
        ))
        .help("give it another name")),
        None => Ok(()),
    }
}

/// What the model cannot be asked is bad input; what could not be computed is not.
fn failure(path: &Path, error: SimulateError) -> Failure {
    match error {
        SimulateError::Interrupted
        | SimulateError::Mechanism(MechanismError::Pair {
            error: PairError::Compute(ComputeError::Interrupted),
            ..
        }) => Failure::work("interrupted"),
        SimulateError::Mechanism(_) | SimulateError::Query { .. } => {
            Failure::work(format_args!("{}: {error}", path.display()))
        }
        _ => Failure::input(format_args!("{}: {error}", path.display())),
    }
}

fn describe(text: &mut String, model: &Mechanism, told: &Told) -> fmt::Result {
    /// More of them are for programs.
    const MOST: usize = 40;
    let unit = (model.unit.as_deref()).map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let until = shown::number(told.until);
    match told.status {
        Status::Done => writeln!(text, "done: {until} s")?,
        Status::Jammed => writeln!(text, "jammed at {until:.9} s")?,
        Status::Undetermined => writeln!(text, "undetermined from {until:.9} s on")?,
        Status::Inconsistent => writeln!(text, "inconsistent at {until:.9} s")?,
    }
    if let Some(reason) = &told.reason {
        writeln!(text, "  {}", shown::text(reason))?;
    }
    if let (Some(first), Some(last)) = (told.samples.first(), told.samples.last()) {
        for name in &told.parts {
            let turns = model.parts.iter().any(|p| {
                p.part.name() == name
                    && (p.axis)
                        .is_some_and(|a| matches!(a.motion, cspace::AxisMotion::Revolute { .. }))
            });
            let shown_at = |n: &Numbers| match n {
                Numbers::One(u) if turns => degrees(*u),
                Numbers::One(u) => format!("{}{unit}", length(*u)),
                Numbers::Three([x, y, theta]) => format!(
                    "x {}, y {}{unit}, theta {}",
                    length(*x),
                    length(*y),
                    degrees(*theta)
                ),
            };
            if let (Some(a), Some(b)) = (first.parts.get(name), last.parts.get(name)) {
                let name = shown::text(name);
                writeln!(text, "{name}: from {} to {}", shown_at(a), shown_at(b))?;
            }
        }
    }
    writeln!(text, "{}", count(told.events.len(), "event", "events"))?;
    for event in told.events.iter().take(MOST) {
        describe_event(text, event)?;
    }
    if told.events.len() > MOST {
        let more = told.events.len() - MOST;
        writeln!(text, "  {more} more; --format json has all")?;
    }
    Ok(())
}

fn describe_event(text: &mut String, event: &Event) -> fmt::Result {
    let kind = match event.kind {
        EventKind::Impact => "impact",
        EventKind::Touch => "touch",
        EventKind::Release => "release",
        EventKind::Stick => "stick",
        EventKind::Slip => "slip",
        EventKind::Limit => "limit",
        EventKind::Rest => "rest",
    };
    write!(text, "  {:.6} s {kind:7} ", event.t)?;
    match &event.what {
        What::Contact {
            fixed,
            moving,
            features: [f, m],
        } => {
            let [fixed, moving, f, m] = [fixed, moving, f, m].map(|t| shown::text(t));
            writeln!(text, "{f} of {fixed} and {m} of {moving}")
        }
        What::Limit { part, limit } => writeln!(text, "{limit} end of {}", shown::text(part)),
    }
}
