//! Slices by CGAL, in a program of its own that is compiled here if CGAL is installed.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use cspace::{Configuration, Part};

use super::{Found, Outcome, Stacker, slot};
use crate::polygons::{pieces, rings};

const SOURCE: &str = include_str!("../../cgal/stack.cpp");

/// The compiled program.
pub(super) struct Program {
    path: PathBuf,
}

/// The program with a pair for its input.
pub(super) struct Cgal<'a> {
    program: &'a Program,
    input: String,
    /// Faces of less area come from rounding.
    least_area: f64,
}

impl Program {
    /// Compiles the program beside this one, with optimisation, unless that is done already; returns the reason if it
    /// is not possible.
    pub(super) fn build() -> Result<Self, String> {
        let own = std::env::current_exe().map_err(|e| e.to_string())?;
        let (path, source) = (
            own.with_file_name("cgal-stack"),
            own.with_file_name("cgal-stack.cpp"),
        );
        let done = std::fs::read_to_string(&source).is_ok_and(|s| s == SOURCE);
        if done && path.exists() {
            return Ok(Self { path });
        }
        let fresh = own.with_file_name("cgal-stack-new.cpp");
        std::fs::write(&fresh, SOURCE).map_err(|e| e.to_string())?;
        let compiler = std::env::var("CXX").unwrap_or_else(|_| "g++".into());
        let output = Command::new(&compiler)
            .args(["-std=c++17", "-O3", "-DNDEBUG", "-o"])
            .arg(&path)
            .arg(&fresh)
            .args(["-lgmp", "-lmpfr"])
            .output()
            .map_err(|e| format!("{compiler} cannot be run ({e}); install g++ and libcgal-dev"))?;
        if output.status.success() {
            // The source of the compiled program is recorded from now on.
            std::fs::rename(&fresh, &source).map_err(|e| e.to_string())?;
            return Ok(Self { path });
        }
        let told = String::from_utf8_lossy(&output.stderr);
        let first = told.lines().find(|l| l.contains("error")).unwrap_or("");
        Err(format!(
            "its program does not compile; install libcgal-dev ({})",
            first.trim()
        ))
    }

    pub(super) fn with(&self, fixed: &Part, moving: &Part, chord: f64) -> Cgal<'_> {
        let mut input = String::new();
        for part in [fixed, moving] {
            let rings = rings(part, chord);
            let pieces = pieces(&rings);
            // Writing to a string does not fail.
            let _ = writeln!(input, "{}", pieces.len());
            for piece in pieces {
                let _ = writeln!(input, "{}", piece.len());
                for ring in piece {
                    let _ = write!(input, "{}", ring.len());
                    for p in ring {
                        let _ = write!(input, " {:?} {:?}", p.x, p.y);
                    }
                    input.push('\n');
                }
            }
        }
        Cgal {
            program: self,
            input,
            least_area: chord * chord,
        }
    }
}

impl Stacker for Cgal<'_> {
    fn name(&self) -> &'static str {
        "CGAL"
    }

    fn run(
        &self,
        slices: usize,
        seconds: f64,
        working: Configuration,
    ) -> Result<Option<Outcome>, String> {
        let mut child = Command::new(&self.program.path)
            .args([slices.to_string(), seconds.to_string()])
            .arg(slot(working.theta, slices).to_string())
            .args([working.x, working.y, self.least_area].map(|v| format!("{v:?}")))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|e| e.to_string())?;
        if let Some(mut stdin) = child.stdin.take() {
            stdin
                .write_all(self.input.as_bytes())
                .map_err(|e| e.to_string())?;
        }
        let output = child.wait_with_output().map_err(|e| e.to_string())?;
        if !output.status.success() {
            return Err(format!("CGAL's program failed: {}", output.status));
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let mut words = text.split_whitespace();
        let mut number = || words.next().and_then(|w| w.parse::<f64>().ok());
        // It says nothing if it was too late.
        let Some(regions) = number() else {
            return Ok(None);
        };
        match (number(), number(), number()) {
            (Some(place), Some(seconds), Some(slice_seconds)) => Ok(Some(Outcome {
                regions: regions as usize,
                working: match place {
                    0.0 => Found::Blocked,
                    1.0 => Found::Open,
                    _ => Found::Caged,
                },
                seconds,
                slice_seconds,
            })),
            _ => Err(format!("CGAL's program said {text:?}")),
        }
    }
}
