//! The operating modes of three parts or more on axes.

mod answer;

use std::time::Instant;

use cspace::AxisMotion;
use cspace_model::{Mechanism, shown};
use cspace_plan::modes::{ModesError, coordinate_name, moving_parts};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;
use crate::frame::Answer;
use crate::given;
use crate::host::Host;
use crate::subject::{ModelFile, Subject};

pub use answer::{
    Found, Is, Mode, Motion, OperatingModes, Outcome, Pair, Part, PartCoordinates, Reach, Requested,
};

/// The parts whose modes are asked for.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// The parts, three or more, whose coordinates are u, v, w, q4, q5 and so on in that order [default: those that move on axes]
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
    /// If there are no such parts, or they have no modes.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<OperatingModes>, Error> {
        let file = subject.model("modes are those of three parts or more")?;
        let model = &file.model.mechanism;
        let parts = self.chosen(file, host)?;
        let at = self.configuration(model, &parts, host)?;
        let begin = Instant::now();
        let modes = Found::compute(model, &parts).map_err(|e| rejected(file, &e, host))?;
        let place = modes.locate(&at).map_err(Error::new)?;
        let seconds = begin.elapsed().as_secs_f64();
        let found = OperatingModes::of(model, modes, (&at, place), seconds);
        let outcome = match found.modes.is_empty() {
            true => Outcome::Blocked,
            false => Outcome::Done,
        };
        Ok(Answer::new(model.unit.as_deref(), outcome, found))
    }

    /// The parts that are named, or those that move on axes.
    fn chosen(&self, file: &ModelFile, host: &dyn Host) -> Result<Vec<usize>, Error> {
        let model = &file.model.mechanism;
        let option = host.option("parts");
        let Some(names) = &self.parts else {
            return moving_parts(model).map_err(|error| {
                file.error(error)
                    .help("give three parts a motion of type revolute or prismatic")
            });
        };
        // Names may have commas in them: whichever commas separate three of them or more.
        let pieces: Vec<&str> = names.split(',').collect();
        if let Some(found) = named(model, names) {
            return Ok(found);
        }
        if pieces.len() < 3 {
            return Err(Error::new(format_args!(
                "{option} {}: three names are needed, or more, with commas between",
                shown::cut(names)
            ))
            .help(on_axes(model)));
        }
        let mut trimmed = pieces.iter().map(|n| n.trim());
        let message = match trimmed.find(|n| model.part_index(n).is_none()) {
            Some(unknown) => format!("there is no part {}", shown::quoted(unknown)),
            None => format!("{option} names fewer than three parts"),
        };
        Err(file.error(message).help(on_axes(model)))
    }

    /// The configuration that is asked about.
    fn configuration(
        &self,
        model: &Mechanism,
        parts: &[usize],
        host: &dyn Host,
    ) -> Result<Vec<f64>, Error> {
        let mut at = vec![0.0; parts.len()];
        let letters: Vec<String> = (0..parts.len()).map(coordinate_name).collect();
        let Some(text) = &self.at else { return Ok(at) };
        let mut given = vec![false; parts.len()];
        for entry in text.split(',') {
            let wrong = |why: String| {
                let (option, text) = (host.option("at"), shown::cut(text));
                Error::new(format_args!("{option} {text}: {why}")).help(
                    "give coordinates such as u=18deg,v=0,w=2.5; those left out are as drawn, 0",
                )
            };
            let known = entry.split_once('=').and_then(|(name, value)| {
                let k = letters.iter().position(|l| l == name.trim())?;
                Some((k, value.trim()))
            });
            let Some((k, value)) = known else {
                return Err(wrong(format!(
                    "{} is none of u=U, v=V and w=W{}",
                    shown::quoted(entry),
                    match letters.len() {
                        0..=3 => String::new(),
                        4 => ", nor q4=Q".to_owned(),
                        n => format!(", nor of q4=Q to q{n}=Q"),
                    }
                )));
            };
            if given[k] {
                return Err(wrong(format!("{} is given twice", letters[k])));
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

/// The parts that a list of names separated by commas names, three or more; of a name with a comma in it the parts before are tried
/// first. `None` if it names none.
fn named(model: &Mechanism, names: &str) -> Option<Vec<usize>> {
    let commas = names.match_indices(',').map(|(at, _)| at);
    let ends: Vec<usize> = commas.chain([names.len()]).collect();
    // What the text from each beginning on names, from the last one.
    let mut rest: Vec<Option<Vec<usize>>> = vec![None; ends.len() + 1];
    rest[ends.len()] = Some(Vec::new());
    for from in (0..ends.len()).rev() {
        let begin = if from == 0 { 0 } else { ends[from - 1] + 1 };
        rest[from] = (from..ends.len()).find_map(|to| {
            let part = model.part_index(names[begin..ends[to]].trim())?;
            let others = rest[to + 1].as_ref()?;
            Some([&[part], &others[..]].concat())
        });
    }
    rest.swap_remove(0).filter(|parts| parts.len() >= 3)
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

/// Why parts are rejected, with the file.
fn rejected(file: &ModelFile, error: &ModesError, host: &dyn Host) -> Error {
    let failure = file.error(error);
    match error {
        ModesError::Cycle { parts } => failure.help(format_args!(
            "for example {} {}",
            host.option("parts"),
            parts.iter().take(3).cloned().collect::<Vec<_>>().join(",")
        )),
        ModesError::Planar { .. } | ModesError::Still { .. } | ModesError::Joined { .. } => failure
            .help(format_args!(
                "name three with {} A,B,C: {}",
                host.option("parts"),
                on_axes(&file.model.mechanism)
            )),
        _ => failure,
    }
}
