//! The faces of a drawing that is refused, in words.

use cspace_api::import::Refusal;

use crate::failure::{list, note};
use crate::wording::{count, length};

/// Prints the largest faces, a line each with the option that picks it.
pub(super) fn print(refusal: &Refusal) {
    /// Faces that are printed, at most.
    const MOST: usize = 12;
    let faces = &refusal.faces.faces;
    if faces.is_empty() {
        return;
    }
    let file = refusal.path.display();
    note(match refusal.faces.count {
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
