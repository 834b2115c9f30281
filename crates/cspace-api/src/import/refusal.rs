//! Drawings that are refused: all that is wrong with them, and what can be done.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::path::{Path, PathBuf};

use cspace_drawing::{Drawing, DrawingError, DrawnFaces, Problem, Reading};

use crate::error::Error;
use crate::host::Host;

/// Why drawings make no model.
#[derive(Debug)]
pub struct Refusal {
    /// Things that cannot be used, where these are several: one of each kind.
    pub problems: Vec<Error>,
    /// The closed faces of the drawing, of which parts may be picked; without any where none are to be picked.
    pub faces: DrawnFaces,
    /// The drawing with these faces.
    pub path: PathBuf,
    /// Why there is no model.
    pub error: Error,
}

impl From<Error> for Box<Refusal> {
    fn from(error: Error) -> Self {
        Self::new(Refusal {
            problems: Vec::new(),
            faces: DrawnFaces::default(),
            path: PathBuf::new(),
            error,
        })
    }
}

/// Choices that were made already.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chosen {
    /// Whether what cannot be used is left out.
    pub(super) is_partial: bool,
    /// Whether parts are picked.
    pub(super) is_picked: bool,
}

impl Refusal {
    /// The refusal of a drawing for an error.
    pub(super) fn of(
        path: &Path,
        error: &DrawingError,
        (drawing, reading): (&Drawing, &Reading<'_>),
        chosen: Chosen,
        host: &dyn Host,
    ) -> Box<Self> {
        /// Maximum number of kinds of problems that are listed.
        const MOST: usize = 20;
        let file = path.display();
        let (faces, parts) = match drawing.is_measured || chosen.is_picked {
            true => (DrawnFaces::default(), 0),
            false => (
                reading.faces().unwrap_or_default(),
                match chosen.is_partial {
                    true => 0,
                    false => reading.survey().map_or(0, |s| s.parts.len()),
                },
            ),
        };
        let help = |otherwise: &str| help(otherwise, &faces, parts, host);
        let (problems, error) = match error {
            DrawingError::Entities(all) if all.len() > 1 => {
                let kinds = alike(all);
                let listed = kinds.iter().take(MOST).map(|(problem, more)| {
                    let more = match more {
                        0 => String::new(),
                        n => format!("; and {n} more of this kind"),
                    };
                    Error::new(format_args!("{file}: {problem}{more}")).help(&problem.help)
                });
                let rest = match kinds.len().saturating_sub(MOST) {
                    0 => String::new(),
                    more => format!(", {more} of which are not shown"),
                };
                let error = Error::new(format_args!(
                    "{file}: {} things cannot be used{rest}",
                    all.len()
                ));
                (listed.collect(), error.help(help("mend the drawing")))
            }
            error => {
                let told = Error::new(format_args!("{file}: {error}"));
                (Vec::new(), told.help(help(error.help())))
            }
        };
        Box::new(Self {
            problems,
            faces,
            path: path.to_owned(),
            error,
        })
    }
}

/// `otherwise`, and the options that would make parts of this drawing; `parts` is the number without what cannot be used, 0 where that was
/// asked for.
fn help(otherwise: &str, faces: &DrawnFaces, parts: usize, host: &dyn Host) -> String {
    let mut ways = Vec::new();
    if parts > 0 {
        let option = host.option("partial");
        let many = if parts == 1 { "part" } else { "parts" };
        ways.push(format!(
            "leave them out with {option}, which gives {parts} {many}"
        ));
    }
    if faces.faces.iter().any(|f| f.refusal.is_none()) {
        let option = host.option("pick");
        ways.push(format!(
            "make a part of a face with {option} X,Y, once for each part (several faces of one part: {option} 'X,Y;X,Y'), or click the faces in `cspace view DRAWING`"
        ));
    }
    match ways.is_empty() {
        true => otherwise.to_owned(),
        false => format!("{otherwise}; or {}", ways.join("; or ")),
    }
}

/// Problems; those that concern one entity alone once for each type and reason, with how many more there are of the kind.
fn alike(problems: &[Problem]) -> Vec<(&Problem, usize)> {
    let mut kinds: Vec<(&Problem, usize)> = Vec::new();
    let mut places: HashMap<(&str, &str), usize> = HashMap::new();
    for problem in problems {
        if problem.to.is_some() || !problem.with.is_empty() {
            kinds.push((problem, 0));
            continue;
        }
        match places.entry((&problem.origin.kind, &problem.reason)) {
            Entry::Occupied(at) => kinds[*at.get()].1 += 1,
            Entry::Vacant(at) => {
                at.insert(kinds.len());
                kinds.push((problem, 0));
            }
        }
    }
    kinds
}
