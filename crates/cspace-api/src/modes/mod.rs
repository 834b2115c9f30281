//! The operating modes of three parts on axes.

mod answer;

use std::time::Instant;

use cspace::AxisMotion;
use cspace_model::{Mechanism, shown};
use cspace_plan::modes::{Modes, ModesError, moving_parts};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;
use crate::frame::Answer;
use crate::given;
use crate::host::Host;
use crate::subject::{ModelFile, Subject};

pub use answer::{
    Is, Letter, Mode, Motion, OperatingModes, Outcome, Pair, Part, Reach, Requested,
    ThreeCoordinates,
};

/// The parts whose modes are asked for.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// The three parts, whose coordinates are u, v and w in that order [default: those that move on axes, if there are three]
    #[cfg_attr(feature = "command", arg(long, value_name = "A,B,C"))]
    pub parts: Option<String>,
    /// The configuration of which the mode is requested; coordinates left out are as drawn [default: all as drawn]
    #[cfg_attr(
        feature = "command",
        arg(long, value_name = "u=U,v=V,w=W", allow_hyphen_values = true)
    )]
    pub at: Option<String>,
}

impl Question {
    /// Finds the modes.
    ///
    /// # Errors
    /// If there are no such three parts, or they have no modes.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<OperatingModes>, Error> {
        let file = subject.model("modes are those of three parts")?;
        let model = &file.model.mechanism;
        let parts = self.three(file, host)?;
        let at = self.configuration(model, parts, host)?;
        let begin = Instant::now();
        let modes = Modes::compute(model, parts).map_err(|e| rejected(file, &e, host))?;
        let place = modes.locate(at).map_err(Error::new)?;
        let seconds = begin.elapsed().as_secs_f64();
        let found = OperatingModes::of(model, modes, (at, place), seconds);
        let outcome = match found.modes.is_empty() {
            true => Outcome::Blocked,
            false => Outcome::Done,
        };
        Ok(Answer::new(model.unit.as_deref(), outcome, found))
    }

    /// The three parts that are named, or those that move on axes.
    fn three(&self, file: &ModelFile, host: &dyn Host) -> Result<[usize; 3], Error> {
        let model = &file.model.mechanism;
        let option = host.option("parts");
        let Some(names) = &self.parts else {
            return moving_parts(model).map_err(|error| {
                let help = match &error {
                    ModesError::NotThree { parts } if parts.len() > 3 => {
                        format!("choose three: {option} {}", parts[..3].join(","))
                    }
                    _ => "give three parts a motion of type revolute or prismatic".to_owned(),
                };
                file.error(error).help(help)
            });
        };
        // Names may have commas in them: whichever commas separate three of them.
        let commas: Vec<usize> = names.match_indices(',').map(|(at, _)| at).collect();
        let named = |from: usize, to: usize| model.part_index(names[from..to].trim());
        for (k, &first) in commas.iter().enumerate() {
            for &second in &commas[k + 1..] {
                let found = (
                    named(0, first),
                    named(first + 1, second),
                    named(second + 1, names.len()),
                );
                if let (Some(a), Some(b), Some(c)) = found {
                    return Ok([a, b, c]);
                }
            }
        }
        if commas.len() < 2 {
            return Err(Error::new(format_args!(
                "{option} {}: three names are needed, with commas between",
                shown::cut(names)
            ))
            .help(on_axes(model)));
        }
        let unknown = names
            .split(',')
            .map(str::trim)
            .find(|n| model.part_index(n).is_none());
        let message = match (unknown, commas.len()) {
            (Some(unknown), _) => format!("there is no part {}", shown::quoted(unknown)),
            (None, n) => format!(
                "{option} names {} parts, and modes are those of three",
                n + 1
            ),
        };
        Err(file.error(message).help(on_axes(model)))
    }

    /// The configuration that is asked about.
    fn configuration(
        &self,
        model: &Mechanism,
        parts: [usize; 3],
        host: &dyn Host,
    ) -> Result<[f64; 3], Error> {
        let mut at = [0.0; 3];
        let Some(text) = &self.at else { return Ok(at) };
        let mut given = [false; 3];
        for entry in text.split(',') {
            let wrong = |why: String| {
                let (option, text) = (host.option("at"), shown::cut(text));
                Error::new(format_args!("{option} {text}: {why}")).help(
                    "give coordinates such as u=18deg,v=0,w=2.5; those left out are as drawn, 0",
                )
            };
            let known = entry.split_once('=').and_then(|(name, value)| {
                let k = Letter::ALL.iter().position(|l| l.name() == name.trim())?;
                Some((k, value.trim()))
            });
            let Some((k, value)) = known else {
                return Err(wrong(format!(
                    "{} is none of u=U, v=V and w=W",
                    shown::quoted(entry)
                )));
            };
            if given[k] {
                return Err(wrong(format!("{} is given twice", Letter::ALL[k].name())));
            }
            given[k] = true;
            let axis = model.parts[parts[k]].axis;
            let turns = axis.is_some_and(|a| matches!(a.motion, AxisMotion::Revolute { .. }));
            at[k] = if turns {
                given::angle(value).map_err(wrong)?
            } else {
                (value.parse().ok())
                    .filter(|x: &f64| x.is_finite())
                    .ok_or_else(|| wrong(format!("{} is no number", shown::quoted(value))))?
            };
        }
        Ok(at)
    }
}

/// The help for parts that have no modes: those that move on axes.
fn on_axes(model: &Mechanism) -> String {
    let moves = model
        .parts
        .iter()
        .filter(|p| p.axis.is_some_and(|axis| axis.motion != AxisMotion::Fixed));
    let names: Vec<&str> = moves.map(|p| p.part.name()).collect();
    match names.is_empty() {
        true => "no part of the model moves on an axis: give three parts a motion of type revolute or prismatic".to_owned(),
        false => format!("the parts that move on axes are {}", names.join(", ")),
    }
}

/// Why three parts are rejected, with the file.
fn rejected(file: &ModelFile, error: &ModesError, host: &dyn Host) -> Error {
    let failure = file.error(error);
    match error {
        ModesError::Planar { .. } | ModesError::Still { .. } | ModesError::Joined { .. } => failure
            .help(format_args!(
                "name three with {} A,B,C: {}",
                host.option("parts"),
                on_axes(&file.model.mechanism)
            )),
        _ => failure,
    }
}
