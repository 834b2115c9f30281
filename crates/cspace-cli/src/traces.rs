//! Parts of very many edges: by how few lines and arcs they could be drawn, and how.

use std::path::Path;

use cspace_drawing::Traced;
use cspace_model::{Mechanism, shown};

use crate::failure::{is_quiet, warning};

/// File name of the simplified model in the commands that the warning suggests.
pub(crate) const OTHER: &str = "traced.toml";

/// The seconds of processor time that computing takes for each pair of edges of two outlines without symmetry: 2e-5 for some hundred
/// edges each, 3e-5 for a thousand, and more beyond.
const SECONDS: f64 = 4e-5;

/// Warns on stderr about each part with very many edges, with the number of lines and arcs that a fit would need; `command` gives the command
/// line for a fit of that tolerance.
pub(crate) fn tell(model: &Mechanism, command: impl Fn(f64) -> String) {
    if is_quiet() {
        return;
    }
    for entry in &model.parts {
        let Some(traced) = Traced::of(&entry.part) else {
            continue;
        };
        let edges = entry.part.edges().count();
        warning(
            format_args!(
                "part {} has {edges} edges; {} lines and arcs within {:?} of them would do: a pair of such parts takes about {} s instead of {} s",
                shown::quoted(entry.part.name()),
                traced.pieces,
                traced.fit,
                seconds(traced.pieces),
                seconds(edges)
            ),
            format_args!("if it is a trace: {}", command(traced.fit)),
        );
    }
}

/// The seconds that a pair of parts of so many edges takes, with one digit.
fn seconds(edges: usize) -> f64 {
    let seconds = SECONDS * (edges * edges) as f64;
    let unit = 10.0_f64.powf(seconds.log10().floor());
    format!("{:.0e}", (seconds / unit).round() * unit)
        .parse()
        .unwrap_or(seconds)
}

/// A path as a shell takes it.
pub(crate) fn quoted(path: &Path) -> String {
    shown::word(&path.display().to_string()).into_owned()
}
