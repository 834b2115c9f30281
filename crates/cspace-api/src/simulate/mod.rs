//! The motion of a mechanism.

mod answer;
mod question;
mod resume;

use cspace_model::Mechanism;
use cspace_model::shown::{quoted, text};
use cspace_motion::{Record, Report, Sample, Settings, SimulateError, Simulation, Status, Way};
use cspace_plan::clash::{Assembly, Sample as Placed};
use schemars::JsonSchema;
use serde::Serialize;

use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::host::{Host, spaces};
use crate::outcome::outcomes;
use crate::subject::{ModelFile, Subject};

pub use answer::{InCycle, Motion, Numbers, Period, Reported, Row, States, moving};
pub use question::{Earlier, Mode, Question, Scheme};

/// Number of steps unless their length is given.
const STEPS: f64 = 10_000.0;

outcomes! {
    /// How a motion ended.
    Outcome {
        /// At the end of its time.
        Done = "done" is Yes,
        /// A driven part cannot go on.
        Jammed = "jammed" is No,
        /// It cannot be told how it goes on.
        Undetermined = "undetermined" is Open,
        /// No accelerations and forces satisfy the laws of contact and friction.
        Inconsistent = "inconsistent" is Open,
        /// The asker wanted no more of it.
        Interrupted = "interrupted" is Open,
    }
}

/// A motion, with what it was reported from.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Simulated {
    /// The motion.
    #[serde(flatten)]
    pub motion: Motion,
    /// The mechanism that was ready to move.
    #[serde(skip)]
    pub simulation: Simulation,
    /// The motion as it was recorded.
    #[serde(skip)]
    pub record: Record,
    /// The report on the record.
    #[serde(skip)]
    pub report: Report,
}

impl Content for Simulated {
    const COMMAND: &'static str = "simulate";
    type Outcome = Outcome;
}

impl Question {
    /// The motion. Of an interrupted question what is done by then is the answer.
    ///
    /// # Errors
    /// If the model cannot be set in motion as asked for, or the motion of the earlier answer not go on.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Simulated>, Error> {
        let file = subject.model("a simulation is of all of its parts")?;
        let model = &file.model.mechanism;
        let mode = self.mode(file, host)?;
        let way = self.way(mode, host)?;
        check_names(file)?;
        let earlier = (self.resume.as_ref())
            .map(|earlier| resume::record(earlier, model, (mode, self.time), host))
            .transpose()?;
        let settings = Settings {
            time: self.time,
            every: self.every,
        };
        let progress = host.begin(&text(&model.name));
        let begin = progress.seconds();
        let failed = |error: SimulateError| match error.is_interrupted() {
            true => Error::new("interrupted"),
            false => file.error(error),
        };
        let made = Simulation::new_by(model, &spaces(host, &*progress));
        let mut simulation = made.map_err(failed)?;
        if let Some(last) = earlier.as_ref().and_then(Record::last) {
            simulation = simulation.taken_up(last).map_err(failed)?;
        }
        host.keep();
        let mut record = (simulation.kept_with(way, &settings, &*progress)).map_err(failed)?;
        let seconds = progress.seconds() - begin;
        drop(progress);
        if let Some(earlier) = earlier {
            record = record.after(earlier);
        }
        remark(model, &simulation, &record, host);
        let report = Report::of(&simulation, &record);
        let reported = Reported {
            rates: self.rates,
            forces: self.forces,
            states: self.states,
        };
        let motion = Motion::of(model, &simulation, (&record, &report), reported, seconds)
            .map_err(Error::new)?;
        let outcome = match record.status {
            Status::Done => Outcome::Done,
            Status::Jammed => Outcome::Jammed,
            Status::Undetermined => Outcome::Undetermined,
            Status::Inconsistent => Outcome::Inconsistent,
            Status::Interrupted => Outcome::Interrupted,
        };
        let simulated = Simulated {
            motion,
            simulation,
            record,
            report,
        };
        Ok(Answer::new(subject.unit(), outcome, simulated))
    }

    /// Without masses the mode is kinematic, unless another is asked for.
    fn mode(&self, file: &ModelFile, host: &dyn Host) -> Result<Mode, Error> {
        let model = &file.model.mechanism;
        let has_mass = model.has_masses();
        let mode = match self.mode {
            Some(Mode::Dynamic) if !has_mass => {
                host.note(&"no part has a mass, so the mode is kinematic");
                Mode::Kinematic
            }
            Some(mode) => mode,
            None if has_mass => Mode::Dynamic,
            None => Mode::Kinematic,
        };
        let is_loaded = cspace_motion::has_forces(model);
        if mode == Mode::Kinematic && !is_loaded && model.dynamics.drives.is_empty() {
            host.note(&"nothing moves: the model has no [[drive]], [[load]] or [[spring]]");
        }
        if self.forces && mode == Mode::Kinematic && !is_loaded {
            let option = host.option("forces");
            return Err(file
                .error(format_args!(
                    "{option} reports the forces of loads, springs and weights, and the model has none"
                ))
                .help(format_args!(
                    "add a [[load]] or a [[spring]], or leave {option} out"
                )));
        }
        Ok(mode)
    }

    /// How the motion is computed: by the scheme, and with the steps, of the dynamic mode.
    fn way(&self, mode: Mode, host: &dyn Host) -> Result<Way, Error> {
        let (scheme, step) = (host.option("scheme"), host.option("step"));
        match (self.scheme, self.step) {
            (Scheme::Event, Some(_)) => Err(Error::new(format_args!(
                "{step} is of {scheme} stepping; from event to event steps are as long as accuracy allows"
            ))
            .help(format_args!("add {scheme} stepping, or leave {step} out"))),
            (Scheme::Stepping, _) if mode == Mode::Kinematic => Err(Error::new(format_args!(
                "{scheme} stepping is of the dynamic mode, and the mode is kinematic"
            ))
            .help(format_args!(
                "give the parts a mass or a density, or leave {scheme} out"
            ))),
            (Scheme::Stepping, step) => Ok(Way::Stepping(step.unwrap_or(self.time / STEPS))),
            (Scheme::Event, None) if mode == Mode::Kinematic => Ok(Way::Kinematic),
            (Scheme::Event, None) if self.strict => Ok(Way::Strict),
            (Scheme::Event, None) => Ok(Way::Dynamic),
        }
    }
}

/// Refuses parts that are called what other keys and columns of a sample are.
fn check_names(file: &ModelFile) -> Result<(), Error> {
    let taken = |name: &&str| ["t", "rates", "forces"].contains(name);
    let parts = &file.model.mechanism.parts;
    match parts.iter().map(|p| p.part.name()).find(taken) {
        Some(name) => Err(file
            .error(format_args!(
                "a part is called {name}, which is the name of another column of the result"
            ))
            .help("give it another name")),
        None => Ok(()),
    }
}

/// Notes which parts never meet, which that are joined go through each other, and of joints that share forces in no certain way.
fn remark(model: &Mechanism, simulation: &Simulation, record: &Record, host: &dyn Host) {
    let name = |i: usize| quoted(model.parts[i].part.name());
    for &(a, b) in simulation.pairs().apart() {
        host.note(&format_args!("{} and {} never meet", name(a), name(b)));
    }
    let parts = simulation.system().parts();
    let placed = |s: &Sample| Placed {
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
    let samples: Vec<Placed> = record.samples.iter().map(placed).collect();
    for meeting in Assembly::new(model).joined_that_meet(&samples) {
        let [a, b] = meeting.parts.map(name);
        let time = meeting.time.unwrap_or(0.0);
        host.warn(
            &Error::new(format_args!(
                "{a} and {b} are joined, so that they are not tested for contact, and they go through each other from about {time:.4} s on"
            ))
            .help(
                "draw them so that they pass, or end the motion before: give the driven part a `range`",
            ),
        );
    }
    let freedom = simulation.freedom();
    if freedom.redundant() > 0 {
        host.note(&format_args!(
            "{} of the {} equations of the joints follow from the others: the mechanism is over-determined, and how its joints share \
             forces is not",
            freedom.redundant(),
            freedom.equations
        ));
    }
}
