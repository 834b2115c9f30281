//! The arguments of `cspace modes`: the parts, and the requested configuration.

use std::path::Path;

use cspace::AxisMotion;
use cspace_io::shown;
use cspace_mechanism::Mechanism;
use cspace_modes::{ModesError, moving_parts};

use crate::failure::Failure;
use cspace_api::given;

/// Names of the coordinates.
pub(super) const LETTERS: [&str; 3] = ["u", "v", "w"];

fn moving(model: &Mechanism) -> String {
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

/// The three parts that are named, or those that move on axes.
pub(super) fn parts(
    path: &Path,
    model: &Mechanism,
    names: Option<&str>,
) -> Result<[usize; 3], Failure> {
    let Some(names) = names else {
        return moving_parts(model).map_err(|error| {
            let help = match &error {
                ModesError::NotThree { parts } if parts.len() > 3 => {
                    format!("choose three: --parts {}", parts[..3].join(","))
                }
                _ => "give three parts a motion of type revolute or prismatic".to_owned(),
            };
            Failure::new(format_args!("{}: {error}", path.display())).help(help)
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
        return Err(Failure::new(format_args!(
            "--parts {}: three names are needed, with commas between",
            shown::cut(names)
        ))
        .help(moving(model)));
    }
    let unknown = names
        .split(',')
        .map(str::trim)
        .find(|n| model.part_index(n).is_none());
    let message = match (unknown, commas.len()) {
        (Some(unknown), _) => format!("there is no part {}", shown::quoted(unknown)),
        (None, n) => format!(
            "--parts names {} parts, and modes are those of three",
            n + 1
        ),
    };
    Err(Failure::new(format_args!("{}: {message}", path.display())).help(moving(model)))
}

/// Why three parts are rejected, with the file.
pub(super) fn rejected(path: &Path, model: &Mechanism, error: &ModesError) -> Failure {
    let failure = Failure::new(format_args!("{}: {error}", path.display()));
    match error {
        ModesError::Planar { .. } | ModesError::Still { .. } | ModesError::Joined { .. } => failure
            .help(format_args!(
                "name three with --parts A,B,C: {}",
                moving(model)
            )),
        _ => failure,
    }
}

/// The requested configuration; coordinates that are not given are as drawn.
pub(super) fn configuration(
    model: &Mechanism,
    parts: [usize; 3],
    text: Option<&str>,
) -> Result<[f64; 3], Failure> {
    let mut at = [0.0; 3];
    let Some(text) = text else { return Ok(at) };
    let mut given = [false; 3];
    for entry in text.split(',') {
        let wrong = |why: String| {
            Failure::new(format_args!("--at {}: {why}", shown::cut(text)))
                .help("give coordinates such as u=18deg,v=0,w=2.5; those left out are as drawn, 0")
        };
        let known = entry.split_once('=').and_then(|(name, value)| {
            let k = LETTERS.iter().position(|l| *l == name.trim())?;
            Some((k, value.trim()))
        });
        let Some((k, value)) = known else {
            return Err(wrong(format!(
                "{} is none of u=U, v=V and w=W",
                shown::quoted(entry)
            )));
        };
        if given[k] {
            return Err(wrong(format!("{} is given twice", LETTERS[k])));
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
