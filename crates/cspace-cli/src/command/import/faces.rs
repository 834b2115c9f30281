//! The faces of a drawing that is refused, and what a user can do with them.

use std::fmt::Display;

use cspace_drawing::{Drawing, DrawnFaces, Reading};

use crate::args::ImportArgs;
use crate::failure::{list, note};
use crate::wording::{count, length};

/// Faces that are printed, at most.
const MOST: usize = 12;

/// The choices listed after the problems of a drawing: its largest faces, each with the option that picks it, and the number of parts
/// that `--partial` gives.
#[derive(Default)]
pub(super) struct Choice {
    faces: DrawnFaces,
    /// The number of parts without what cannot be used; 0 where that was asked for already.
    parts: usize,
}

impl Choice {
    /// The faces of a drawing; nothing where none are asked for or found.
    pub(super) fn of(args: &ImportArgs, drawing: &Drawing, reading: &Reading<'_>) -> Self {
        if drawing.is_measured || !args.pick.is_empty() {
            return Self::default();
        }
        Self {
            faces: reading.faces().unwrap_or_default(),
            parts: match args.partial {
                true => 0,
                false => reading.survey().map_or(0, |s| s.parts.len()),
            },
        }
    }

    /// Prints the faces, a line each.
    pub(super) fn print(&self, file: impl Display) {
        let faces = &self.faces.faces;
        if faces.is_empty() {
            return;
        }
        note(match self.faces.count {
            n if n <= MOST => format!(
                "{file}: {}:",
                count(n, "face is closed", "faces are closed")
            ),
            n => format!("{file}: {n} faces are closed; the largest:"),
        });
        for face in faces.iter().filter(|f| f.refusal.is_none()).take(MOST) {
            let [lo, hi] = [face.bounds.min, face.bounds.max];
            list(format_args!(
                "--pick {},{}  area {}, x {} to {}, y {} to {}",
                face.inside.x,
                face.inside.y,
                length(face.area),
                length(lo.x),
                length(hi.x),
                length(lo.y),
                length(hi.y)
            ));
        }
    }

    /// The help of the failure: `otherwise`, and the options that would make parts of this drawing.
    pub(super) fn help(&self, otherwise: &str) -> String {
        let mut ways = Vec::new();
        if self.parts > 0 {
            ways.push(format!(
                "leave them out with --partial, which gives {}",
                count(self.parts, "part", "parts")
            ));
        }
        if self.faces.faces.iter().any(|f| f.refusal.is_none()) {
            ways.push(
                "make a part of a face with --pick X,Y, once for each part (several faces of one part: --pick 'X,Y;X,Y'), or click the faces in `cspace view DRAWING`".to_owned(),
            );
        }
        match ways.is_empty() {
            true => otherwise.to_owned(),
            false => format!("{otherwise}; or {}", ways.join("; or ")),
        }
    }
}
